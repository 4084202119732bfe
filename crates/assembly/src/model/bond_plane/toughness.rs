//! Critical stretches of central bonds from energy release rates.

use super::super::plane::toughness;
use super::neighbourhood::neighbourhood;
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
    let hood = neighbourhood(parameters)?;
    let weights: Vec<f64> = hood.weights.iter().map(|[a]| *a).collect();
    Ok(toughness::critical_stretch(release_rate, &weights, &hood.offsets, spacing, [0.0, 1.0]))
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
