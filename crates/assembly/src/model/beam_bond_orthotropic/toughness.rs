//! Critical stretches of bonds along the fibres and of all others, from energy release rates.

use super::super::plane::toughness::{self, CrossingBonds};
use super::{BeamNeighbourhood, OrthotropicError, OrthotropicMaterial};
use crate::body::Cell;

/// Energy release rates of cracks, J/m².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReleaseRates {
    /// Of a crack across the fibres.
    pub fibre: f64,
    /// Of a crack along the fibres.
    pub matrix: f64,
}

/// Stretches at which bonds break.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalStretches {
    /// Of bonds along the fibres.
    pub fibre: f64,
    /// Of all other bonds.
    pub matrix: f64,
}

/// The bonds that cracks along interfaces cut, along rows and along columns alike.
pub fn crossing_bonds(bonds: &BeamNeighbourhood) -> CrossingBonds {
    let along_rows = bonds.offsets().iter().copied();
    let along_columns = along_rows.clone().map(|[x, y, z]| [y, x, z]);
    let offsets: Vec<Cell> = along_rows.chain(along_columns).collect();
    let stretch: Vec<f64> = bonds.weights().iter().map(|[a, ..]| *a).collect();
    CrossingBonds::new(&stretch.repeat(2), &offsets)
}

impl CriticalStretches {
    /// The formula of the isotropic continuum with the modulus of each direction, as published; δ = `horizon`, m. It does
    /// not release the energy that it is given.
    pub fn published(rates: ReleaseRates, material: &OrthotropicMaterial, horizon: f64) -> Self {
        let of = toughness::published_critical_stretch;
        Self {
            fibre: of(rates.fibre, material.youngs_modulus_1, horizon),
            matrix: of(rates.matrix, material.youngs_modulus_2, horizon),
        }
    }

    /// Stretches with which straight cracks along and across the fibres of a lattice release exactly the energy given. A
    /// crack along the fibres cuts other bonds only; one across cuts both.
    ///
    /// # Errors
    /// No bonds lie along the fibres, or the other bonds alone release all that a crack across them shall.
    pub fn by_energy(
        rates: ReleaseRates,
        bonds: &BeamNeighbourhood,
        spacing: f64,
    ) -> Result<Self, OrthotropicError> {
        let is_fibre = bonds.is_fibre();
        if !is_fibre.contains(&true) {
            let horizon_ratio = bonds.horizon_ratio();
            let degrees = bonds.relative_angle().to_degrees();
            let what = "a critical stretch of fibres";
            return Err(OrthotropicError::NoFibreBonds { horizon_ratio, degrees, what });
        }
        let of_class = |fibre: bool| -> Vec<f64> {
            bonds
                .weights()
                .iter()
                .zip(is_fibre)
                .map(|([a, ..], f)| if *f == fibre { *a } else { 0.0 })
                .collect()
        };
        let (others, fibres, offsets) = (of_class(false), of_class(true), bonds.offsets());
        let [c, s] = bonds.direction();
        let matrix = toughness::critical_stretch(rates.matrix, &others, offsets, spacing, [-s, c]);
        let critical = vec![matrix; offsets.len()];
        let released = toughness::energy_release_rate(&others, offsets, spacing, &critical, [c, s]);
        if released >= rates.fibre {
            return Err(OrthotropicError::FibreReleaseTooSmall { matrix: released, required: rates.fibre });
        }
        let rest = rates.fibre - released;
        let fibre = toughness::critical_stretch(rest, &fibres, offsets, spacing, [c, s]);
        Ok(Self { fibre, matrix })
    }

    /// Energy release rates of straight cracks across and along the fibres with these stretches.
    pub fn release_rates(&self, bonds: &BeamNeighbourhood, spacing: f64) -> ReleaseRates {
        let axial: Vec<f64> = bonds.weights().iter().map(|[a, ..]| *a).collect();
        let each = bonds.is_fibre().iter().map(|f| if *f { self.fibre } else { self.matrix });
        let critical: Vec<f64> = each.collect();
        let [c, s] = bonds.direction();
        let across =
            |normal| toughness::energy_release_rate(&axial, bonds.offsets(), spacing, &critical, normal);
        ReleaseRates { fibre: across([c, s]), matrix: across([-s, c]) }
    }
}
