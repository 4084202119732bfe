//! What supports, rigid regions and lines or planes of symmetry do to a body.

use crate::case::Vector;
use crate::scene::Resultant;
use crate::scene::body::{BodyScene, BodySupport, RigidPoints};
use peristat_assembly::body::SIDES;
use peristat_assembly::sum::Sum;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Force of a support, or of what is prescribed of a rigid region, on the body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BodyReaction {
    /// What is held, such as ``the region `left` ``.
    pub place: String,
    /// Force along x.
    pub force_x: f64,
    /// Force along y.
    pub force_y: f64,
    /// Moment about z, in the plane counter-clockwise: about the centre of a rigid region that cannot turn; or, of a support that holds
    /// rotations, the sum of what it does to those of its points, without that of its forces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment: Option<f64>,
    /// Moment about x through the centre of a rigid region of a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment_x: Option<f64>,
    /// The same about y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment_y: Option<f64>,
    /// Force across the plane, outwards on a shell.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force_w: Option<f64>,
    /// Force along z, of a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force_z: Option<f64>,
    /// Centre of a rigid region.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre: Option<Vector>,
}

/// Force of the mirrored half on the body, across a line of symmetry.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MirrorReaction {
    /// The side of the body: `left`, `right`, `bottom`, `top`, of a solid `back` or `front`.
    pub side: Cow<'static, str>,
    /// Force across the line or plane.
    pub force: f64,
}

/// Forces of supports from the multipliers of all equations and the unknowns.
pub(super) fn of_supports(scene: &BodyScene, multipliers: &[f64], u: &[f64]) -> Vec<BodyReaction> {
    let n = scene.model.points();
    // A solid has a third force whether or not it is held.
    let is_solid = scene.body().axes() > 2;
    let of = |support: &BodySupport| {
        let mut sums = [0; 6].map(|_| Sum::default());
        let mut holds = [false; 6];
        for (equations, shares) in &support.equations {
            for (motion, share) in shares.iter().enumerate().filter(|(_, share)| **share != 0.0) {
                holds[motion] = true;
                multipliers[equations.clone()].iter().for_each(|m| sums[motion].add(share * m));
            }
        }
        for spring in &scene.conditions.springs[support.springs.clone()] {
            for (unknown, force) in spring.forces(n, u) {
                let of = scene.model.components()[unknown / n];
                sums[of.axis + if of.is_rotation { 3 } else { 0 }].add(-force);
            }
        }
        let origin = support.path.to_string();
        let rigid = scene.conditions.rigid.iter().find(|r| r.origin == origin);
        let total = |motion: usize| sums[motion].total();
        let held = |motion: usize| holds[motion].then(|| total(motion));
        BodyReaction {
            place: support.name.clone(),
            force_x: total(0),
            force_y: total(1),
            moment: held(5),
            moment_x: held(3),
            moment_y: held(4),
            force_w: held(2).filter(|_| !is_solid),
            force_z: is_solid.then(|| total(2)),
            centre: rigid.map(|RigidPoints { centre: [x, y, z], .. }| match is_solid {
                true => [*x, *y, *z].into(),
                false => [*x, *y].into(),
            }),
        }
    };
    scene.supports.iter().map(of).collect()
}

/// Resultant of supports, springs and lines of symmetry.
pub(super) fn resultant(
    scene: &BodyScene,
    multipliers: &[f64],
    u: &[f64],
    mirrors: &[MirrorReaction],
) -> Resultant {
    let n = scene.model.points();
    let mut forces = vec![0.0; u.len()];
    for (equation, multiplier) in scene.equations.iter().zip(multipliers) {
        for (unknown, coefficient) in &equation.terms {
            forces[unknown.component * n + unknown.point] += coefficient * multiplier;
        }
    }
    for (unknown, force) in scene.conditions.springs.iter().flat_map(|spring| spring.forces(n, u)) {
        forces[unknown] -= force;
    }
    // A row that reaches over a line of symmetry holds its place of the border with its whole force: what acts on an image is no
    // more mirrored than the row is.
    if let Some((lattice, lines)) = scene.model.lattice().filter(|(_, mirrors)| !mirrors.is_none()) {
        for &ghost in scene.model.ghosts() {
            let (_, signs) = lines.image(lattice.cell(ghost as usize));
            for (axis, sign) in signs.into_iter().enumerate() {
                if let Some(component) = scene.model.along(axis) {
                    forces[component * n + ghost as usize] *= sign;
                }
            }
        }
    }
    let mut sum = scene.resultant(&forces);
    for mirror in mirrors {
        let across = |k: usize| if SIDES[2 * k..][..2].contains(&&*mirror.side) { mirror.force } else { 0.0 };
        sum.add([across(0), across(1), across(2)], [0.0; 3]);
    }
    sum
}

/// Forces through lines of symmetry: the equation `u_ghost + u_real = 0` of the component across a line holds with the same
/// force on both of its points. What a stress does to images is part of what goes through the line; what loads do to it at once,
/// `taken` by images, is not.
pub(super) fn of_mirrors(
    scene: &BodyScene,
    multipliers: &[f64],
    load: &[f64],
    taken: &[(u32, [f64; 3])],
) -> Vec<MirrorReaction> {
    let Some((lattice, mirrors)) = scene.model.lattice().filter(|(_, mirrors)| !mirrors.is_none()) else {
        return Vec::new();
    };
    let lines = mirrors.lines;
    let mut sums = [const { None }; 6];
    for (k, line) in lines.as_flattened().iter().enumerate() {
        // Nothing goes through the axis of a body of revolution.
        let is_axis = scene.material().surface().axis() == Some(k);
        sums[k] = line.filter(|_| !mirrors.joined[k / 2] && !is_axis).map(|_| Sum::default());
    }
    let of_ghosts = &multipliers[scene.equations.len()..];
    let mut at_once = BTreeMap::<u32, [f64; 3]>::new();
    for (ghost, force) in taken {
        let sum = at_once.entry(*ghost).or_default();
        (0..3).for_each(|k| sum[k] += force[k]);
    }
    for (&ghost, held) in
        scene.model.ghosts().iter().zip(of_ghosts.chunks_exact(scene.model.components().len()))
    {
        let cell = lattice.cell(ghost as usize);
        let (_, signs) = mirrors.image(cell);
        let taken = at_once.get(&ghost).copied().unwrap_or_default();
        for axis in 0..3 {
            let beyond = match lines[axis] {
                [Some(low), _] if cell[axis] < low => 0,
                [_, Some(high)] if cell[axis] >= high => 1,
                _ => continue,
            };
            if let Some(sum) = &mut sums[2 * axis + beyond] {
                let Some(component) = scene.model.along(axis) else { continue };
                let loaded = load[component * scene.model.points() + ghost as usize];
                sum.add((1.0 - signs[axis]) * (held[component] + loaded) - taken[axis]);
            }
        }
    }
    let named = SIDES.into_iter().zip(sums);
    named.filter_map(|(side, sum)| Some(MirrorReaction { side: side.into(), force: sum?.total() })).collect()
}
