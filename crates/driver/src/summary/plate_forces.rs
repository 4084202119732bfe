//! What holds a plate in bending, as the record of a run has it.

use super::Located;
use crate::run::plate::{PlateReaction, PlateResult};
use crate::scene::PlateScene;
use serde::{Deserialize, Serialize};

/// Forces of what holds a plate in bending.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlateForces {
    /// Forces of supports on the plate, in the order of the case, lines of symmetry last.
    pub reactions: Vec<PlateReaction>,
    /// The same along straight lines, per length.
    #[serde(default)]
    pub held_lines: Vec<LineForces>,
    /// What is left at their ends.
    #[serde(default)]
    pub corner_forces: Vec<CornerForce>,
}

/// What supports do along a straight line of points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LineForces {
    /// What is held, such as ``the edge `left` ``.
    pub place: String,
    /// Its ends.
    pub ends: [[f64; 2]; 2],
    /// Force along w over the whole line, without those at its ends.
    pub force: f64,
    /// Smallest and largest force per length.
    pub range: [Located; 2],
}

/// A force along w at an end of a line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CornerForce {
    /// Position.
    pub x: f64,
    /// Position.
    pub y: f64,
    /// The force on the plate.
    pub force: f64,
}

/// The forces of a state.
pub(super) fn of(scene: &PlateScene, result: &PlateResult) -> PlateForces {
    let (nodes, found) = (scene.plate.nodes(), &result.along_lines);
    let place = |point: u32| nodes.place(point as usize);
    let lines = scene.held_lines.iter().zip(&found.lines).filter_map(|(line, found)| {
        let values = || found.force.iter().copied().zip(&line.points);
        let located = |(value, point): (f64, &u32)| {
            let [x, y] = place(*point);
            Located { value, x, y: Some(y), z: None, member: None }
        };
        let [smallest, largest] =
            [values().min_by(|a, b| a.0.total_cmp(&b.0)), values().max_by(|a, b| a.0.total_cmp(&b.0))];
        let lengths = (0..line.points.len()).map(|k| nodes.spacing() * line.weight(k));
        Some(LineForces {
            place: line.name.clone(),
            ends: line.ends().map(place),
            force: found.force.iter().zip(lengths).map(|(force, length)| force * length).sum(),
            range: [located(smallest?), located(largest?)],
        })
    });
    let corner = |(&point, &force): (&u32, &f64)| {
        let [x, y] = place(point);
        CornerForce { x, y, force }
    };
    PlateForces {
        reactions: result.reactions.clone(),
        held_lines: lines.collect(),
        corner_forces: found.corners.iter().map(corner).collect(),
    }
}
