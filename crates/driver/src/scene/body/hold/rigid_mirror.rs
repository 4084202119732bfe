//! Rigid regions that mirrors cut, or that reach joined sides.

use super::rigid::{MOTIONS, RigidPoints, key};
use crate::diagnostic::{Faults, root};
use crate::scene::body::site::model_inputs::ModelInputs;
use peristat_assembly::body::PointBody;

/// A fault for every rigid region that reaches a mirror and could leave it, or turn otherwise than about the axis across it: with
/// its image it is one rigid body then. One that reaches joined sides cannot turn so, either.
pub(crate) fn check(rigid: &[RigidPoints], inputs: &ModelInputs, faults: &mut Faults) {
    let (PointBody::Lattice(lattice) | PointBody::Solid(lattice)) = &inputs.body else { return };
    // Bodies of revolution have no rigid regions, and were refused.
    if inputs.material.surface().axis().is_some() {
        return;
    }
    let axes = inputs.body.axes();
    let mirrors = inputs.symmetry.mirrors;
    for (k, region) in rigid.iter().enumerate() {
        let reaches = |axis: usize| {
            let [low, high] = mirrors.lines[axis];
            region.points.iter().any(|&p| {
                let at = lattice.cell(p as usize)[axis];
                low.is_some_and(|l| at == l) || high.is_some_and(|h| at + 1 == h)
            })
        };
        let met = [0, 1, 2].map(reaches);
        let is_halved = [0, 1, 2].map(|axis| met[axis] && !mirrors.joined[axis]);
        let is_barred = |&motion: &usize| match motion {
            axis @ 0..3 => is_halved[axis],
            turn => (0..3).any(|axis| met[axis] && axis != turn - 3),
        };
        let barred: Vec<usize> =
            (0..MOTIONS).filter(|&motion| key(motion, axes).is_some()).filter(is_barred).collect();
        if barred.iter().all(|&motion| region.prescribed[motion] == Some(0.0)) {
            continue;
        }
        let keys = barred.iter().filter_map(|&motion| Some(format!("\"{}\": 0", key(motion, axes)?)));
        let keys: Vec<String> = keys.collect();
        let message = match (is_halved.contains(&true), axes > 2) {
            (false, false) => "this rigid region goes on behind joined sides: it cannot turn",
            (false, true) => "this rigid region goes on behind joined sides: it cannot turn away from them",
            (true, false) => {
                "a mirror halves this rigid region: with its image it can neither turn nor move across the mirror"
            }
            (true, true) => {
                "a plane of symmetry cuts this rigid region: with its image it can neither move across the plane nor turn away from it"
            }
        };
        faults.error(root("rigid").index(k), message).hint(format!("add {} to it", keys.join(", ")));
    }
}
