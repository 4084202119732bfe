//! Reactions along lines that supports hold, per length, and the forces that are left at their ends.
//!
//! A support that holds the slope along its line twists the plate by t per length. Kirchhoff and Thomson's effective reaction does
//! the same work with the deflection alone, `V = r − dt/ds`, and leaves a force `± t` at every end: that of a corner. Of points,
//! the moment T of one is that of two forces `± T/(2h)` on those beside it, or `± T/h` at an end of the line, so that the forces
//! along all lines and at their ends have the resultant of the reactions. Where a line ends at a clamp across it the plate does not
//! twist, and the moment of its last point is what the clamp bends the plate with. At a corner the force of both lines is known, and how
//! much of it is along them is continued from inside.

use crate::scene::PlateScene;
use crate::scene::plate::{HeldLine, PlateSupport};
use peristat_assembly::model::plate_bending::W;
use std::collections::{BTreeMap, HashMap};

/// Reactions of a line that is held, at its points.
#[derive(Clone, Debug, PartialEq)]
pub struct LineReaction {
    /// Effective force along w, per length.
    pub force: Vec<f64>,
    /// Moment per length that does work with the rotation across the line.
    pub moment: Vec<f64>,
}

/// Reactions of all lines of a plate.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AlongLines {
    /// In the order of the lines of the scene.
    pub lines: Vec<LineReaction>,
    /// Forces at the ends of lines, by their points.
    pub corners: BTreeMap<u32, f64>,
}

/// Forces and moments by the numbers of their unknowns.
type Forces = HashMap<usize, f64>;

/// Reactions along lines from the multipliers of all equations and the unknowns.
pub(super) fn along_lines(scene: &PlateScene, multipliers: &[f64], u: &[f64]) -> AlongLines {
    let mut found = AlongLines::default();
    if scene.held_lines.is_empty() {
        return found;
    }
    let (n, h) = (scene.plate.nodes().points(), scene.plate.nodes().spacing());
    let own: Vec<Forces> = scene.supports.iter().map(|s| forces(scene, s, multipliers, u)).collect();
    // All that holds the deflection of a point counts, and of what holds its rotations that which holds the line.
    let deflection = |point: u32| own.iter().filter_map(|forces| forces.get(&(W * n + point as usize))).sum();
    for line in &scene.held_lines {
        let of = |component: usize, point: u32| match component {
            W => deflection(point),
            _ => {
                let supports = line.supports.iter().map(|&k| &own[k]);
                supports.filter_map(|forces| forces.get(&(component * n + point as usize))).sum::<f64>()
            }
        };
        let (force, at_ends) = effective(line, h, &of);
        for (end, rest) in at_ends.into_iter().enumerate().filter(|(end, _)| !line.is_mirrored[*end]) {
            // What holds the point itself counts once, whatever lines end there.
            let point = line.ends()[end];
            *found.corners.entry(point).or_insert_with(|| deflection(point)) += rest;
        }
        let moment =
            |(k, &point): (usize, &u32)| line.outward * of(line.across(), point) / (line.weight(k) * h) + 0.0;
        let moment = line.points.iter().enumerate().map(moment).collect();
        found.lines.push(LineReaction { force, moment: continued(moment, line.is_mirrored) });
    }
    found
}

/// What a support does to the unknowns; nothing of a line of symmetry.
fn forces(scene: &PlateScene, support: &PlateSupport, multipliers: &[f64], u: &[f64]) -> Forces {
    let mut forces = Forces::new();
    if support.is_mirror {
        return forces;
    }
    let n = scene.plate.nodes().points();
    for k in support.equations.clone() {
        for (unknown, share) in &scene.equations[k].terms {
            *forces.entry(unknown.component * n + unknown.point).or_default() += share * multipliers[k];
        }
    }
    let springs = scene.springs[support.springs.clone()].iter().flat_map(|spring| spring.forces(n, u));
    springs.for_each(|(unknown, force)| *forces.entry(unknown).or_default() -= force);
    forces
}

/// The effective force of a line per length at its points, and what its twist and its length leave of forces at its ends.
fn effective(line: &HeldLine, h: f64, of: &dyn Fn(usize, u32) -> f64) -> (Vec<f64>, [f64; 2]) {
    let last = line.points.len() - 1;
    let end = |k: usize| [k == 0, k == last].iter().position(|is_end| *is_end);
    let is_mirror = |k: usize| end(k).is_some_and(|end| line.is_mirrored[end]);
    let own = |(k, &point): (usize, &u32)| if end(k).is_none() || is_mirror(k) { of(W, point) } else { 0.0 };
    let mut forces: Vec<f64> = line.points.iter().enumerate().map(own).collect();
    let meets_clamp = |k: usize| end(k).is_some_and(|end| line.meets_clamp[end]);
    let twisted = |k: &usize| !is_mirror(*k) && !meets_clamp(*k);
    for (k, &point) in line.points.iter().enumerate().filter(|(k, _)| twisted(k)) {
        let share = end(k).map_or(1.0, |end| 1.0 / line.sharing[end] as f64);
        let [before, behind] = [k.saturating_sub(1), (k + 1).min(last)];
        let force = share * of(line.along, point) / ((behind - before) as f64 * h);
        forces[before] -= force;
        forces[behind] += force;
    }
    let at_ends = [forces[0], forces[last]];
    let per_length = forces.iter().enumerate().map(|(k, force)| force / (line.weight(k) * h)).collect();
    let per_length = continued(per_length, line.is_mirrored);
    let rest = [(0, at_ends[0]), (last, at_ends[1])].map(|(k, force)| force - 0.5 * h * per_length[k]);
    (per_length, rest)
}

/// Values along a line, those at ends that are not known continued from inside.
fn continued(mut values: Vec<f64>, is_known: [bool; 2]) -> Vec<f64> {
    let last = values.len() - 1;
    let inner = usize::from(!is_known[0])..values.len() - usize::from(!is_known[1]);
    let at = |near: usize, far: usize| match inner.len() {
        0 => 0.0,
        1 => values[near],
        _ => 2.0 * values[near] - values[far],
    };
    let (first, end) = (at(1, 2.min(last)), at(last.saturating_sub(1), last.saturating_sub(2)));
    if !is_known[0] {
        values[0] = first;
    }
    if !is_known[1] {
        values[last] = end;
    }
    values
}
