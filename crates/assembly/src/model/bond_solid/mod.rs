//! Isotropic solids of central bonds, static and linear: ν = 1/4.
//!
//! A bond resists its elongation alone, with the energy `½ k e²`, `k = a V/ξ²`; how a lattice of such bonds becomes a body is
//! in [`solid`](super::solid). The calibration `matched` finds weights a with which the lattice has the moduli of the material
//! to rounding, `published` has `k = c ω β V²/ξ` with `c = 9K/(2π ∫ω r³ dr)`, for ω = 1 the `18K/(πδ⁴)` of Silling and Askari
//! (2005), and the part β of the neighbour inside the horizon. Points may also be listed: [`BondSolidCloud`].
//!
//! Not here: finite rotations, other Poisson ratios.

mod cloud;
mod matched;
#[cfg(test)]
mod tests;

pub use cloud::BondSolidCloud;

use super::bond_plane::{Influence, VolumeFactor, Weights};
use super::plane::{Calibration, Neighbourhood, half_offsets, length};
use super::solid::{Isotropic, Solid, SolidEdges, SolidError, SolidLaw, SolidMaterial, part, reach_of};
use std::f64::consts::PI;

/// A solid of central bonds.
pub type BondSolid = Solid<BondSolidParameters>;

/// Poisson's ratio of central bonds.
pub const POISSON_RATIO: f64 = 0.25;

/// Material and bonds of a solid of central bonds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondSolidParameters {
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// Horizon per spacing; not read where points are listed.
    pub horizon_ratio: f64,
    /// Stiffness over length.
    pub influence: Influence,
    /// Where the stiffness comes from.
    pub calibration: Calibration,
    /// Which of all exact bonds are taken, by the calibration `matched`.
    pub weights: Weights,
    /// Parts of neighbours inside the horizon; the calibration `matched` needs none.
    pub volume_factor: VolumeFactor,
    /// Treatment of faces.
    pub edges: SolidEdges,
}

impl SolidMaterial for BondSolidParameters {
    fn law(&self) -> Result<SolidLaw, SolidError> {
        let m = self.horizon_ratio;
        // No number of layers: those of a body can be fewer.
        let offsets = half_offsets(reach_of(self.calibration, self.volume_factor, m), i32::MAX);
        let (weights, parts) = match self.calibration {
            Calibration::Matched => {
                let weights = matched::weights(self, &offsets)?;
                let parts = weights.iter().map(|&a| f64::from(a > 0.0)).collect();
                (weights, parts)
            }
            Calibration::Published if self.edges.is_exact() => {
                return Err(SolidError::EdgesNeedMatched);
            }
            Calibration::Published => self.published(&offsets),
        };
        if weights.iter().all(|&a| a <= 0.0) {
            return Err(SolidError::NoNeighbours { horizon_ratio: m });
        }
        let weights: Vec<[f64; 1]> = weights.into_iter().map(|a| [a]).collect();
        Ok(SolidLaw {
            neighbourhood: Neighbourhood::new(&offsets, &weights, &parts),
            dilatation: None,
            material: self.material(),
            edges: self.edges,
        })
    }
}

impl BondSolidParameters {
    /// The material.
    fn material(&self) -> Isotropic {
        Isotropic { youngs_modulus: self.youngs_modulus, poisson_ratio: POISSON_RATIO }
    }

    /// Micromodulus `c = 9K/(2π ∫ω r³ dr)`, N/m⁶, of a horizon δ, m: `c ω s` is the force density of a bond of stretch s.
    fn micromodulus(&self, horizon: f64) -> f64 {
        let bulk = 2.0 / 3.0 * self.youngs_modulus;
        9.0 * bulk / (2.0 * PI * self.influence.third_moment() * horizon.powi(4))
    }

    /// Weights of the offsets, `a = c ω β V ξ`, Pa, and the parts β of the neighbours' volumes.
    fn published(&self, offsets: &[[i32; 3]]) -> (Vec<f64>, Vec<f64>) {
        let m = self.horizon_ratio;
        // In spacings: V = 1, ξ = |offset|.
        let c = self.micromodulus(m);
        let parts: Vec<f64> = offsets.iter().map(|&step| part(self.volume_factor, m, step)).collect();
        let weight =
            |(&step, part): (&[i32; 3], &f64)| c * self.influence.at(length(step) / m) * part * length(step);
        (offsets.iter().zip(&parts).map(weight).collect(), parts)
    }
}
