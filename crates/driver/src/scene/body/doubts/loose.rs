//! Points that their bonds do not hold: with one bond, or bonds on one line, in space in one plane, they can move without any force.

use crate::diagnostic::{Faults, root};
use crate::scene::body::hold::conditions::Conditions;
use crate::scene::body::scene::BodyScene;
use crate::scene::body::site::body;
use crate::scene::words;
use nalgebra::Matrix3;
use peristat_assembly::model::Model;
use std::collections::{BTreeMap, BTreeSet};

/// A block is singular if its determinant is this small beside the square of its trace.
const SINGULAR: f64 = 1e-10;

/// Adds a fault for the points whose own stiffness is singular and that conditions do not hold, one for each reason.
pub(crate) fn check<const D: usize>(scene: &BodyScene, model: &dyn Model<D>, faults: &mut Faults) {
    let held = held_points(&scene.conditions, D);
    let mut blocks = vec![[[0.0; D]; D]; model.points()];
    let mut loose: Vec<usize> =
        scene.real_points().filter(|point| !held.contains(&(*point as u32))).collect();
    // Bonds of listed points in space can lie in one plane.
    let is_listed = scene.body().is_solid() && scene.body().cells().is_none();
    let directions = if is_listed { held_directions(&scene.conditions) } else { BTreeMap::new() };
    let is_free = |point: usize, block: &[[f64; D]; D]| match is_listed {
        true => is_free_in_space(block, directions.get(&(point as u32)).map_or(&[], Vec::as_slice)),
        false => is_singular(block),
    };
    for term in model.terms() {
        // What holds a point without the other terms holds it with them.
        if loose.is_empty() {
            return;
        }
        term.add_diagonal(&mut blocks);
        loose.retain(|point| is_free(*point, &blocks[*point]));
    }
    let (on_lines, without): (Vec<usize>, Vec<usize>) =
        loose.into_iter().partition(|&point| trace(&blocks[point]) > 0.0);
    let cut = !scene.case.cracks.is_empty();
    let path = if cut { root("cracks") } else { body::path(&scene.case) };
    let mut complain = |points: &[usize], why: &str, of_cracks: &str| {
        let Some(&first) = points.first() else { return };
        let place = words::place(scene.model.position(first), scene.body());
        let message = match points.len() {
            1 => format!("the point at {place} has {why}, so nothing holds it"),
            n => format!("{n} points have {why}, so nothing holds them; the first is at {place}"),
        };
        let thin = "use a smaller spacing or a longer horizon where the body is thin";
        faults.error(path.clone(), message).hint(if cut { of_cracks } else { thin });
    };
    complain(
        &without,
        "no bonds",
        "a crack through a point cuts all of its bonds: move the crack by half a spacing",
    );
    complain(
        &on_lines,
        if is_listed { "bonds in one plane only" } else { "bonds on one line only" },
        "cracks cut what else would hold it: move them away from the point, or use a smaller spacing",
    );
}

/// Whether a point with a stiffness can move without any force.
fn is_singular<const D: usize>(block: &[[f64; D]; D]) -> bool {
    let (a, b, d) = in_plane(block);
    let trace = a + d;
    // A single bond that resists turning holds its point.
    let is_held = D > 2 && trace > 0.0;
    !is_held && a * d - b * b <= SINGULAR * trace * trace
}

/// Whether a point in space with a stiffness can move without any force, where supports hold it in some directions, unit vectors.
fn is_free_in_space<const D: usize>(block: &[[f64; D]; D], held: &[[f64; 3]]) -> bool {
    let scale = if trace(block) > 0.0 { trace(block) } else { 1.0 };
    let of_bonds = |r: usize, c: usize| block.get(r).and_then(|row| row.get(c)).copied().unwrap_or_default();
    let of_supports = |r: usize, c: usize| scale * held.iter().map(|d| d[r] * d[c]).sum::<f64>();
    let whole = Matrix3::from_fn(|r, c| of_bonds(r, c) + of_supports(r, c));
    whole.determinant() <= SINGULAR * scale.powi(3)
}

/// The directions in which supports hold points.
fn held_directions(conditions: &Conditions) -> BTreeMap<u32, Vec<[f64; 3]>> {
    let mut directions: BTreeMap<u32, Vec<[f64; 3]>> = BTreeMap::new();
    for hold in &conditions.holds {
        hold.points.iter().for_each(|&point| directions.entry(point).or_default().push(hold.direction));
    }
    directions
}

/// The sum of the stiffnesses of a point.
fn trace<const D: usize>(block: &[[f64; D]; D]) -> f64 {
    (0..D).map(|k| block[k][k]).sum()
}

/// The stiffness of a point along two axes; where it has one unknown, every bond resists all of its motion.
fn in_plane<const D: usize>(block: &[[f64; D]; D]) -> (f64, f64, f64) {
    match block.as_slice() {
        [only] => (only[0], 0.0, only[0]),
        [first, second, ..] => (first[0], first[1], second[1]),
        [] => (0.0, 0.0, 0.0),
    }
}

/// Points all of whose unknowns supports hold, or that belong to rigid regions.
fn held_points(conditions: &Conditions, unknowns: usize) -> BTreeSet<u32> {
    let mut held: BTreeSet<u32> = conditions.rigid.iter().flat_map(|r| r.points.iter().copied()).collect();
    let mut times: BTreeMap<u32, usize> = BTreeMap::new();
    for &point in conditions.holds.iter().flat_map(|hold| &hold.points) {
        *times.entry(point).or_default() += 1;
    }
    held.extend(times.into_iter().filter(|(_, times)| *times >= unknowns).map(|(point, _)| point));
    held
}
