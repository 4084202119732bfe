//! What supports do to a beam.

use crate::scene::beam::{BeamScene, HeldPoint, How, Motion};
use peristat_assembly::model::Points;
use peristat_assembly::stiffness::Spring;
use serde::{Deserialize, Serialize};

/// What a support does to a line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reaction {
    /// Position.
    pub x: f64,
    /// Force along w.
    pub force: f64,
    /// Moment along φ.
    pub moment: f64,
    /// Force along the axis, where the support holds it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial: Option<f64>,
}

/// What a support does to a frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JointReaction {
    /// What is held, such as ``joint `A` ``.
    pub place: String,
    /// Position in the plane.
    pub position: [f64; 2],
    /// Force along x.
    pub force_x: f64,
    /// Force along y.
    pub force_y: f64,
    /// Moment, counter-clockwise.
    pub moment: f64,
    /// Force in the direction that an inclined support holds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inclined: Option<f64>,
}

/// Force and moment of a support in the plane.
#[derive(Clone, Debug, Default)]
pub(super) struct HeldForce {
    /// Number of the point.
    pub(super) point: usize,
    /// Force along x and y of the plane.
    pub(super) force: [f64; 2],
    /// Moment.
    pub(super) moment: f64,
    inclined: Option<f64>,
    holds_axis: bool,
}

/// Forces of the supports on points, in the order of the case. The first multipliers are those of what they prescribe, in
/// this order; the first springs are theirs.
pub(super) fn forces(
    scene: &BeamScene,
    multipliers: &[f64],
    springs: &[Spring],
    u: &[f64],
) -> Vec<HeldForce> {
    let (n, mut multipliers, mut springs) = (scene.beam.points(), multipliers.iter(), springs.iter());
    let mut of = |held: &HeldPoint, point: usize| {
        let mut sum = HeldForce { point, ..Default::default() };
        for hold in &held.holds {
            let value = match hold.how {
                // What the scene knows to be at rest has no equation and no spring.
                _ if hold.terms.is_empty() => 0.0,
                How::Prescribed(_) => multipliers.next().copied().unwrap_or(0.0),
                How::Spring(_) => {
                    let stiffness = springs.next().map_or(0.0, |spring| spring.stiffness);
                    let moved: f64 = hold.terms.iter().map(|&(c, share)| share * u[c * n + hold.point]).sum();
                    -stiffness * moved
                }
            };
            match hold.motion {
                Motion::Rotation => sum.moment += value,
                Motion::Direction([x, y]) => {
                    (sum.force[0], sum.force[1]) = (sum.force[0] + x * value, sum.force[1] + y * value);
                    sum.holds_axis |= x != 0.0;
                    if x != 0.0 && y != 0.0 {
                        sum.inclined = Some(value);
                    }
                }
            }
        }
        sum
    };
    scene.held.iter().filter_map(|h| Some(of(h, h.point?))).collect()
}

/// The forces as reactions of a line.
pub(super) fn of_lines(scene: &BeamScene, forces: &[HeldForce]) -> Vec<Reaction> {
    if scene.frame.is_some() {
        return Vec::new();
    }
    let held = scene.held.iter().filter(|h| h.point.is_some());
    let reaction = |(h, f): (&HeldPoint, &HeldForce)| Reaction {
        x: h.x,
        force: f.force[1],
        moment: f.moment,
        axial: f.holds_axis.then_some(f.force[0]),
    };
    held.zip(forces).map(reaction).collect()
}

/// The forces as reactions of a frame.
pub(super) fn of_joints(scene: &BeamScene, forces: &[HeldForce]) -> Vec<JointReaction> {
    if scene.frame.is_none() {
        return Vec::new();
    }
    let reaction = |(h, f): (&HeldPoint, &HeldForce)| {
        let [x, y, _] = scene.beam.position(f.point);
        JointReaction {
            place: h.name.clone(),
            position: [x, y],
            force_x: f.force[0],
            force_y: f.force[1],
            moment: f.moment,
            inclined: f.inclined,
        }
    };
    scene.held.iter().filter(|h| h.point.is_some()).zip(forces).map(reaction).collect()
}
