//! Material and bonds of a plate in antiplane shear.

use super::super::bond_plane::Influence;
use super::super::plane::{Edges, Neighbourhood, half_offsets, is_within, length};
use thiserror::Error;

/// Why a plate in antiplane shear cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum AntiplaneError {
    /// The horizon reaches no other point.
    #[error("a horizon of {horizon_ratio} spacings reaches no other point; increase the horizon ratio")]
    NoNeighbours {
        /// Horizon per spacing.
        horizon_ratio: f64,
    },
}

/// Material and bonds of a plate in antiplane shear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AntiplaneParameters {
    /// Shear modulus G, Pa.
    pub shear_modulus: f64,
    /// Thickness, m.
    pub thickness: f64,
    /// Horizon per spacing.
    pub horizon_ratio: f64,
    /// Stiffness over length.
    pub influence: Influence,
    /// Treatment of edges.
    pub edges: Edges,
}

impl AntiplaneParameters {
    /// The neighbours of a point with the weights `a = ω ξ` of their bonds, Pa, scaled to `Σ a = 2G` over a half.
    pub(super) fn neighbourhood(&self) -> Result<Neighbourhood<1>, AntiplaneError> {
        let m = self.horizon_ratio;
        let offsets = half_offsets(m, 1);
        let of = |&step: &[i32; 3]| {
            let length = length(step);
            if is_within(step, m) { self.influence.at((length / m).min(1.0)) * length } else { 0.0 }
        };
        let shape: Vec<f64> = offsets.iter().map(of).collect();
        let sum: f64 = shape.iter().sum();
        if sum <= 0.0 {
            return Err(AntiplaneError::NoNeighbours { horizon_ratio: m });
        }
        let weights: Vec<[f64; 1]> = shape.iter().map(|a| [2.0 * self.shear_modulus * a / sum]).collect();
        let parts: Vec<f64> = shape.iter().map(|&a| f64::from(a > 0.0)).collect();
        Ok(Neighbourhood::new(&offsets, &weights, &parts))
    }
}
