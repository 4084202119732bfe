//! Ordinary state-based solids, static and linear, for any Poisson ratio between −1 and 1/2.
//!
//! With weights w of the neighbours, lengths x in spacings, elongations e and `q = Σ w x²`, a point has
//!
//! `W = ½ (K − 5G/3) ϑ² + (15G/2q) Σ w e²`, `ϑ = (3/q) Σ w x e`,
//!
//! which is `½ K ϑ² + (15G/2q) Σ w (e − ϑx/3)²` of Silling et al. (2007). It is never negative while no weight is, whatever the
//! sign of `K − 5G/3`, and while q stays that of the intact family. How points become a body is in [`solid`](super::solid).
//!
//! The weights of the calibration `published` are `ω β` with the part β of the neighbour inside the horizon: on a lattice the
//! shear modulus is off by several percent and depends on the direction. `matched` multiplies them by `c₀ + c₁ H`,
//! `H = n_x⁴+n_y⁴+n_z⁴ − 3/5`, so that `Σ w x² (1, H) = (q, 0)`: then all moduli are exact. Where `K = 5G/3`, ν = 1/4, no
//! point feels more than its bonds and no family is made.
//!
//! Not here: finite rotations, a mean dilatation of several points, which a ratio close to 1/2 would need.

#[cfg(test)]
mod tests;

use super::bond_plane::{Influence, VolumeFactor};
use super::plane::{Calibration, Neighbourhood, half_offsets, is_within, length};
use super::solid::{
    Dilatation, Isotropic, Solid, SolidEdges, SolidError, SolidLaw, SolidMaterial, part, reach_of,
};
use crate::body::Cell;

/// A state-based solid.
pub type StateSolid = Solid<StateSolidParameters>;

/// Material and families of a state-based solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateSolidParameters {
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
    /// Horizon per spacing.
    pub horizon_ratio: f64,
    /// Weight over length.
    pub influence: Influence,
    /// Where the weights come from.
    pub calibration: Calibration,
    /// Parts of neighbours inside the horizon; the calibration `matched` needs none.
    pub volume_factor: VolumeFactor,
    /// Treatment of faces.
    pub edges: SolidEdges,
}

/// Weights of the offsets of a half, and `q` of the whole family, spacings².
#[derive(Clone, Debug)]
struct Weights {
    of: Vec<f64>,
    q: f64,
}

/// Square of the length of an offset, spacings².
fn squared(step: Cell) -> f64 {
    f64::from(step.iter().map(|k| k * k).sum::<i32>())
}

/// `H = n_x⁴+n_y⁴+n_z⁴ − 3/5`.
fn cubic(step: Cell) -> f64 {
    let fourth = step.iter().map(|&k| f64::from(k).powi(4)).sum::<f64>();
    fourth / squared(step).powi(2) - 0.6
}

impl StateSolidParameters {
    fn weights(&self, offsets: &[Cell], parts: &[f64]) -> Result<Weights, SolidError> {
        let m = self.horizon_ratio;
        let of = |(&step, part): (&Cell, &f64)| part * self.influence.at(length(step) / m);
        let mut weights: Vec<f64> = offsets.iter().zip(parts).map(of).collect();
        // Half of the offsets stand for all.
        let sum = |weights: &[f64], of: &dyn Fn(Cell) -> f64| {
            2.0 * weights.iter().zip(offsets).map(|(w, &step)| w * squared(step) * of(step)).sum::<f64>()
        };
        let q = sum(&weights, &|_| 1.0);
        if q <= 0.0 {
            return Err(SolidError::NoNeighbours { horizon_ratio: m });
        }
        if self.calibration == Calibration::Matched {
            let (first, second) = (sum(&weights, &cubic), sum(&weights, &|step| cubic(step).powi(2)));
            let determinant = q * second - first * first;
            let [c0, c1] = [q * second / determinant, -q * first / determinant];
            weights.iter_mut().zip(offsets).for_each(|(w, &step)| *w *= c0 + c1 * cubic(step));
            let residual = sum(&weights, &cubic).abs().max((sum(&weights, &|_| 1.0) - q).abs()) / q;
            // Six neighbours have but one H.
            let is_exact = residual < 1e-12 && weights.iter().all(|w| *w >= 0.0);
            if !is_exact {
                return Err(SolidError::NotRepresentable { horizon_ratio: m, residual });
            }
        }
        Ok(Weights { of: weights, q })
    }

    /// Part of the volume of the neighbour at an offset.
    fn part_of(&self, step: Cell) -> f64 {
        match self.calibration {
            Calibration::Matched => f64::from(is_within(step, self.horizon_ratio)),
            Calibration::Published => part(self.volume_factor, self.horizon_ratio, step),
        }
    }
}

impl SolidMaterial for StateSolidParameters {
    fn law(&self) -> Result<SolidLaw, SolidError> {
        let poisson_ratio = self.poisson_ratio;
        if !(poisson_ratio > -1.0 && poisson_ratio < 0.5) {
            return Err(SolidError::PoissonRatio { poisson_ratio });
        }
        if self.calibration == Calibration::Published && self.edges.is_exact() {
            return Err(SolidError::EdgesNeedMatched);
        }
        let reach = reach_of(self.calibration, self.volume_factor, self.horizon_ratio);
        let offsets = half_offsets(reach, i32::MAX);
        let parts: Vec<f64> = offsets.iter().map(|&step| self.part_of(step)).collect();
        let Weights { of: weights, q } = self.weights(&offsets, &parts)?;
        let mut law = SolidLaw {
            neighbourhood: Neighbourhood {
                offsets: Vec::new(),
                weights: Vec::new(),
                others: Vec::new(),
                along: Vec::new(),
                parts: Vec::new(),
            },
            dilatation: None,
            material: Isotropic { youngs_modulus: self.youngs_modulus, poisson_ratio },
            edges: self.edges,
        };
        let (shear, bulk) = (law.material.shear_modulus(), law.material.bulk_modulus());
        let of = |(w, &step): (&f64, &Cell)| [30.0 * shear * w * squared(step) / q];
        let stiffness: Vec<[f64; 1]> = weights.iter().zip(&offsets).map(of).collect();
        law.neighbourhood = Neighbourhood::new(&offsets, &stiffness, &parts);
        let modulus = bulk - 5.0 * shear / 3.0;
        // What rounding leaves at ν = 1/4.
        if modulus.abs() > 1e-12 * shear {
            let weight_at = |step: &Cell| offsets.iter().position(|o| o == step).map_or(0.0, |k| weights[k]);
            let shares = law.neighbourhood.offsets.iter().map(|step| 3.0 * weight_at(step) / q).collect();
            law.dilatation = Some(Dilatation { shares, modulus });
        }
        Ok(law)
    }
}
