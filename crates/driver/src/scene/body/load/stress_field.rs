//! Stresses that act by the rows of the bonds.

use peristat_assembly::model::BodyModel;
use std::fmt::Debug;
use std::sync::Arc;

/// A stress over a body.
pub(crate) trait Stress: Debug + Send + Sync {
    /// `[S_xx, S_yy, S_xy]` at a position, Pa.
    fn at(&self, position: [f64; 2]) -> [f64; 3];
}

/// A stress, and where it can be other than zero.
#[derive(Clone, Debug)]
pub(crate) struct StressField {
    /// Points where it can be other than zero; none for all.
    pub(crate) points: Option<Vec<usize>>,
    stress: Arc<dyn Stress>,
}

/// One stress everywhere.
#[derive(Debug)]
struct Uniform([f64; 3]);

impl Stress for Uniform {
    fn at(&self, _: [f64; 2]) -> [f64; 3] {
        self.0
    }
}

/// A stress along y that goes like a cosine along it.
#[derive(Debug)]
struct Hoop {
    stress: f64,
    wave_number: f64,
}

impl Stress for Hoop {
    fn at(&self, [_, y]: [f64; 2]) -> [f64; 3] {
        [0.0, self.stress * (self.wave_number * y).cos(), 0.0]
    }
}

impl StressField {
    /// One stress for all points.
    pub(crate) fn uniform(stress: [f64; 3]) -> Self {
        Self { points: None, stress: Arc::new(Uniform(stress)) }
    }

    /// The hoop stress of a pressure on a cylinder, with a wave number, 1/m, along its circumference.
    pub(crate) fn hoop(stress: f64, wave_number: f64) -> Self {
        Self { points: None, stress: Arc::new(Hoop { stress, wave_number }) }
    }

    /// A stress that is zero but at some points.
    pub(crate) fn at_points(points: Vec<usize>, stress: impl Stress + 'static) -> Self {
        Self { points: Some(points), stress: Arc::new(stress) }
    }

    /// The same with the numbers that points have in the model.
    pub(crate) fn numbered(&self, number: &dyn Fn(u32) -> u32) -> Self {
        let renumber = |points: &Vec<usize>| points.iter().map(|&p| number(p as u32) as usize).collect();
        Self { points: self.points.as_ref().map(renumber), stress: self.stress.clone() }
    }

    /// Adds what it does times a factor to forces on the unknowns of a model.
    pub(crate) fn add_to(&self, model: &dyn BodyModel, factor: f64, force: &mut [f64]) {
        let at = |_: usize, position: [f64; 2]| self.stress.at(position).map(|s| factor * s);
        if let Some(plane) = model.as_plane() {
            plane.add_stress_load(self.points.as_deref(), &at, force);
        }
    }
}

/// The traction of a stress on a border with a normal.
pub(crate) fn traction_of([xx, yy, xy]: [f64; 3], [x, y]: [f64; 2]) -> [f64; 2] {
    [xx * x + xy * y, xy * x + yy * y]
}
