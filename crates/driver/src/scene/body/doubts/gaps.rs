//! Gaps that bonds reach across.
//!
//! Bonds know cells, not the outline: a slot or notch narrower than the horizon leaves bonds from one of its sides to the
//! other, as if there were material. A crack drawn along it cuts them.

use crate::scene::body::scene::BodyScene;
use peristat_assembly::body::{CRACK_SLACK, Cell, SquareLattice, plus};
use peristat_assembly::model::plane::Edges;

/// A place in a gap and the width of the gap in cells, if gaps narrower than the horizon go on for as long as two horizons.
/// The flat top of a round hole is shorter than that.
pub(crate) fn narrow(scene: &BodyScene) -> Option<([f64; 3], i32)> {
    let (lattice, _) = scene.model.lattice()?;
    if scene.model.edges() == Some(Edges::Border) {
        // Bonds that leave the body end there.
        return None;
    }
    let reach = scene.inputs.material.about().horizon_ratio.floor() as i32;
    let steps = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let mut along = steps[..scene.body().axes()].iter().map(|step| places(scene, lattice, *step, reach));
    let found = along.find(|places| places.len() as i32 >= 2 * reach)?;
    found.get(found.len() / 2).copied()
}

/// Where a step leaves the body and enters it again within the reach, and no crack lies between.
fn places(scene: &BodyScene, lattice: &SquareLattice, step: Cell, reach: i32) -> Vec<([f64; 3], i32)> {
    let slack = CRACK_SLACK * lattice.spacing();
    let mut found = Vec::new();
    for run in lattice.runs() {
        // Along rows only the end of a run can be beside a gap.
        let from = if step[0] != 0 { run.columns.end - 1 } else { run.columns.start };
        for column in from..run.columns.end {
            let at = |k: i32| plus(run.cell(column), step.map(|s| k * s));
            if lattice.number(at(1)).is_some() {
                continue;
            }
            let Some(width) = (2..=reach).find(|&k| lattice.number(at(k)).is_some()) else { continue };
            let [a, b] = [0, width].map(|k| lattice.centre(at(k)));
            if !scene.cracks.iter().any(|c| c.crack.cuts([a[0], a[1]], [b[0], b[1]], slack)) {
                found.push(([0, 1, 2].map(|k| 0.5 * (a[k] + b[k])), width - 1));
            }
        }
    }
    found
}
