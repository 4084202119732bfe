//! Laminae: parts of a body whose fibres run at other angles.

use super::OrthotropicParameters;
use crate::bonds::Mat;

/// The laminae of a body beside that of its parameters.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Laminae {
    /// Angles of their fibres from x, counter-clockwise, rad.
    pub angles: Vec<f64>,
    /// The lamina of every point: zero is that of the parameters, others follow from one on. None where all points are of that.
    pub of: Vec<u8>,
}

/// What a lamina has in uniform states.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moduli {
    /// Pa, from strains to stresses along x and y.
    pub(super) stiffness: Mat<3, 3>,
    /// 1/Pa, from stresses to strains.
    pub(super) compliance: Mat<3, 3>,
}

impl Moduli {
    /// Those of the parameters, and of laminae with other angles.
    pub(super) fn of(parameters: &OrthotropicParameters, angles: &[f64]) -> Vec<Self> {
        let at = |&angle: &f64| Self {
            stiffness: parameters.material.stiffness_at(angle),
            compliance: parameters.material.compliance_at(angle),
        };
        [parameters.fibre_angle].iter().chain(angles).map(at).collect()
    }
}

impl Laminae {
    /// The most angles beside that of the parameters.
    pub const MOST: usize = 64;

    /// # Panics
    /// There are more than [`MOST`](Self::MOST) angles, a point is of a lamina that is not there, or there is not one for every point.
    pub(super) fn check(&self, points: usize) {
        assert!(self.angles.len() <= Self::MOST, "not too many other angles");
        assert!(self.of.is_empty() || self.of.len() == points, "one lamina per point");
        assert!(self.of.iter().all(|own| usize::from(*own) <= self.angles.len()), "a lamina of the body");
    }
}
