//! What acts one way, measured on a solution: forces of the wrong sign, and penetrations.

use super::acting::Acting;
use crate::run::workspace::{StateSolution, size};
use crate::scene::beam::{BeamScene, OneWay, OneWayKind, Part};
use serde::{Deserialize, Serialize};

/// A force of the wrong sign or a penetration below this, over the largest end action and the largest displacement, is rounding.
const ROUNDING: f64 = 1e-9;

/// Which of what acts one way does act in a state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OneWayState {
    /// By kind.
    pub parts: Vec<OneWayCount>,
    /// Systems that were solved to find them.
    pub solves: usize,
    /// Whether no force has the wrong sign and nothing penetrates, but for rounding.
    pub settled: bool,
}

/// How many of a kind act, and how well that is known.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OneWayCount {
    /// The kind.
    pub kind: OneWayKind,
    /// Those that act.
    pub act: usize,
    /// All of them.
    pub all: usize,
    /// Largest force of the wrong sign of those that act, over the largest end action of a bond.
    pub wrong_force: f64,
    /// Largest way past their places of those that do not act, over the largest displacement.
    pub penetration: f64,
}

/// What is wrong with every part, relative; not positive where nothing is.
pub(super) fn wrongs<const D: usize>(
    scene: &BeamScene,
    acting: &Acting,
    (solution, multipliers): (&StateSolution, &[f64]),
    scales: &[f64; D],
) -> Vec<f64> {
    let (n, u) = (scene.beam.points(), &solution.u);
    let largest = size(u, scales);
    let of = |(part, &acts): (&OneWay, &bool)| {
        let (component, motion, force) = match part.part {
            Part::Equation(k) => {
                let terms = &scene.equations[k].terms;
                let motion: f64 = terms.iter().map(|(at, c)| c * u[at.component * n + at.point]).sum();
                (terms[0].0.component, motion - acting.target(part, k), multipliers[k])
            }
            Part::Spring(k) => {
                let spring = &scene.springs[k];
                let motion: f64 =
                    spring.shares.iter().map(|&(c, share)| share * u[c * n + spring.point]).sum();
                (spring.shares[0].0, motion, -spring.stiffness * motion)
            }
        };
        let (scale, past) = (scales[component], -part.sign * motion);
        match acts {
            true => over(-part.sign * force * scale, solution.action),
            false => over(past / scale, largest.max(part.gap / scale)),
        }
    };
    scene.one_way.iter().zip(&acting.acts).map(of).collect()
}

fn over(value: f64, size: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value / size }
}

/// The parts that are wrong by more than rounding.
pub(super) fn wrong(wrongs: &[f64]) -> Vec<usize> {
    (0..wrongs.len()).filter(|&k| wrongs[k] > ROUNDING).collect()
}

/// What there is to say of a state.
pub(super) fn state(scene: &BeamScene, acts: &[bool], wrongs: &[f64], solves: usize) -> OneWayState {
    let of = |kind: OneWayKind| {
        let own =
            scene.one_way.iter().zip(acts).zip(wrongs).filter(|((part, _), _)| part.origin.kind() == kind);
        let worst = |acting: bool| {
            let such = own.clone().filter(|((_, acts), _)| **acts == acting);
            such.fold(0.0, |worst: f64, (_, wrong)| worst.max(*wrong))
        };
        OneWayCount {
            kind,
            act: own.clone().filter(|((_, acts), _)| **acts).count(),
            all: own.clone().count(),
            wrong_force: worst(true),
            penetration: worst(false),
        }
    };
    let parts = OneWayKind::ALL.map(of).into_iter().filter(|count| count.all > 0).collect();
    OneWayState { parts, solves, settled: wrong(wrongs).is_empty() }
}
