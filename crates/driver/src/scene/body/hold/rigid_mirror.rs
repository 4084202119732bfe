//! Rigid regions that mirrors halve, or that reach joined sides.

use super::rigid::{RIGID_KEYS, RigidPoints};
use crate::diagnostic::{Faults, root};
use crate::scene::body::site::model_inputs::ModelInputs;
use peristat_assembly::body::PointBody;

/// A fault for every rigid region that reaches a mirror and could turn, or leave the mirror: with its image it is one
/// rigid body then, which moves along the mirror only. One that reaches joined sides cannot turn either.
pub(crate) fn check(rigid: &[RigidPoints], inputs: &ModelInputs, faults: &mut Faults) {
    let PointBody::Lattice(lattice) = &inputs.body else { return };
    // Bodies of revolution have no rigid regions, and were refused.
    if inputs.material.is_revolved() {
        return;
    }
    let mirrors = inputs.symmetry.mirrors;
    for (k, region) in rigid.iter().enumerate() {
        let reaches = |axis: usize, lines: [Option<i32>; 2]| {
            let [low, high] = lines;
            region.points.iter().any(|&p| {
                let at = lattice.cell(p as usize)[axis];
                low.is_some_and(|l| at == l) || high.is_some_and(|h| at + 1 == h)
            })
        };
        let met = [0, 1].map(|axis| reaches(axis, mirrors.lines[axis]));
        if met == [false; 2] {
            continue;
        }
        let is_halved = |axis: &usize| met[*axis] && !mirrors.joined[*axis];
        let needed: Vec<usize> = [0, 1].into_iter().filter(is_halved).chain([2]).collect();
        if needed.iter().all(|&key| region.prescribed[key] == Some(0.0)) {
            continue;
        }
        let keys: Vec<String> = needed.iter().map(|&key| format!("\"{}\": 0", RIGID_KEYS[key])).collect();
        faults
            .error(
                root("rigid").index(k),
                match needed.len() {
                    1 => "this rigid region goes on behind joined sides: it cannot turn",
                    _ => "a mirror halves this rigid region: with its image it can neither turn nor move across the mirror",
                },
            )
            .hint(format!("add {} to it", keys.join(", ")));
    }
}
