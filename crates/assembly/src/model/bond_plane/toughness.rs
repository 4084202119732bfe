//! Critical stretches of central bonds from energy release rates.

use super::super::plane::toughness::{self, CrossingBonds};
use super::neighbourhood::neighbourhood;
use super::trapping::trapping;
use super::{BondPlaneError, PlaneParameters, PlaneState};
use std::f64::consts::PI;

/// The critical stretch with which a straight crack along the rows of a lattice releases exactly the energy release rate,
/// J/m², whatever the influence function; `spacing` in m.
///
/// # Errors
/// As [`super::BondPlane::offsets`].
pub fn critical_stretch(
    release_rate: f64,
    parameters: &PlaneParameters,
    spacing: f64,
) -> Result<f64, BondPlaneError> {
    let neighbourhood = neighbourhood(parameters)?;
    let weights: Vec<f64> = neighbourhood.weights.iter().map(|[a]| *a).collect();
    Ok(toughness::critical_stretch(release_rate, &weights, &neighbourhood.offsets, spacing, [0.0, 1.0]))
}

/// The critical stretch with which a long crack grows at the energy release rate, J/m², in any direction to a few percent:
/// that of [`critical_stretch`] over the lattice trapping; `spacing` in m.
///
/// # Errors
/// As [`super::BondPlane::offsets`].
pub fn growth_stretch(
    release_rate: f64,
    parameters: &PlaneParameters,
    spacing: f64,
) -> Result<f64, BondPlaneError> {
    let energy = critical_stretch(release_rate, parameters, spacing)?;
    Ok(energy / trapping(parameters))
}

/// The bonds that a crack along an interface between rows cuts.
///
/// # Errors
/// As [`super::BondPlane::offsets`].
pub fn crossing_bonds(parameters: &PlaneParameters) -> Result<CrossingBonds, BondPlaneError> {
    let neighbourhood = neighbourhood(parameters)?;
    let weights: Vec<f64> = neighbourhood.weights.iter().map(|[a]| *a).collect();
    Ok(CrossingBonds::new(&weights, &neighbourhood.offsets))
}

/// The critical stretch of the continuum with the influence function 1, `√(4πG/(9Eδ))` in plane stress and
/// `√(5πG/(12Eδ))` in plane strain; `horizon` δ in m.
pub fn published_critical_stretch(release_rate: f64, parameters: &PlaneParameters, horizon: f64) -> f64 {
    let e = parameters.material.youngs_modulus;
    match parameters.material.state {
        PlaneState::Stress => toughness::published_critical_stretch(release_rate, e, horizon),
        PlaneState::Strain => (5.0 * PI * release_rate / (12.0 * e * horizon)).sqrt(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::bond_plane::{Influence, PlaneMaterial, VolumeFactor, Weights};
    use crate::model::plane::{Calibration, Edges};

    fn parameters(state: PlaneState, horizon_ratio: f64) -> PlaneParameters {
        PlaneParameters {
            material: PlaneMaterial { youngs_modulus: 73100.0, thickness: 25.0, state },
            horizon_ratio,
            influence: Influence::Constant,
            calibration: Calibration::Matched,
            weights: Weights::Nearest,
            volume_factor: VolumeFactor::Ramp,
            edges: Edges::Overlay,
        }
    }

    #[test]
    fn published_stretches_release_the_energy_of_a_crack() {
        // Plane stress √(4π·2/(9·73100·3)), plane strain √(5π·2/(12·73100·3)).
        for (state, expected) in [(PlaneState::Stress, 3.568_447_9e-3), (PlaneState::Strain, 3.455_134_8e-3)]
        {
            let found = published_critical_stretch(2.0, &parameters(state, 3.0), 3.0);
            assert!((found / expected - 1.0).abs() < 1e-6, "{found:e}");
        }
    }

    #[test]
    fn fine_lattices_break_like_the_continuum() {
        for state in [PlaneState::Stress, PlaneState::Strain] {
            let ratio = |m: f64| {
                let parameters = parameters(state, m);
                critical_stretch(2.0, &parameters, 3.0 / m).unwrap()
                    / published_critical_stretch(2.0, &parameters, 3.0)
            };
            let found = [3.0, 6.0].map(ratio);
            assert!(found.iter().all(|r| (r - 1.0).abs() < 0.1), "{found:?}");
        }
    }
}
