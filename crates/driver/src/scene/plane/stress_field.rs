//! Stresses that act by the rows of the bonds.

use super::fading::Fading;
use super::round::Round;
use peristat_assembly::model::plane::PlaneModel;

/// A stress that acts by the rows of the bonds.
#[derive(Clone, Debug)]
pub(super) struct StressField {
    /// Points where it can be other than zero; none for all.
    pub(super) points: Option<Vec<usize>>,
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    Uniform([f64; 3]),
    /// Stress along y, a cosine of this wave number, 1/m, along y.
    Hoop {
        stress: f64,
        wave_number: f64,
    },
    Faded(Fading),
    Round(Round),
}

impl StressField {
    pub(super) fn uniform(stress: [f64; 3]) -> Self {
        Self { points: None, kind: Kind::Uniform(stress) }
    }

    /// The stress along the circumference of a shell, a wave along it.
    pub(super) fn hoop(stress: f64, wave_number: f64) -> Self {
        Self { points: None, kind: Kind::Hoop { stress, wave_number } }
    }

    pub(super) fn faded(points: Vec<usize>, fading: Fading) -> Self {
        Self { points: Some(points), kind: Kind::Faded(fading) }
    }

    pub(super) fn round(points: Vec<usize>, round: Round) -> Self {
        Self { points: Some(points), kind: Kind::Round(round) }
    }

    /// The same with the numbers that points have in the model.
    pub(super) fn numbered(&self, number: &dyn Fn(u32) -> u32) -> Self {
        let renumber = |points: &Vec<usize>| points.iter().map(|&p| number(p as u32) as usize).collect();
        Self { points: self.points.as_ref().map(renumber), kind: self.kind.clone() }
    }

    /// Adds its load times a factor to `force`, N, component by component.
    pub(super) fn add_to(&self, model: &dyn PlaneModel, factor: f64, force: &mut [f64]) {
        let at = |position: [f64; 2]| self.at(position).map(|s| factor * s);
        model.add_stress_load(self.points.as_deref(), &at, force);
    }

    /// `[S_xx, S_yy, S_xy]` at a position, Pa.
    pub(super) fn at(&self, position: [f64; 2]) -> [f64; 3] {
        match &self.kind {
            Kind::Uniform(stress) => *stress,
            Kind::Hoop { stress, wave_number } => [0.0, stress * (wave_number * position[1]).cos(), 0.0],
            Kind::Faded(fading) => fading.stress(position),
            Kind::Round(round) => round.stress(position),
        }
    }
}
