//! Neighbours of a point of a lattice with central bonds.

use super::super::plane::{Calibration, Neighbourhood, half_offsets};
use super::calibration::{matched, published};
use super::{BondPlaneError, PlaneParameters, VolumeFactor};

/// The neighbours of a point, with the weight `a`, Pa, of each: the stiffness of a bond is `a V/ξ²` with the volume V of a
/// point.
///
/// # Errors
/// All of [`BondPlaneError`] that do not speak of clouds.
pub(super) fn neighbourhood(parameters: &PlaneParameters) -> Result<Neighbourhood<1>, BondPlaneError> {
    let offsets = half_offsets(reach_of(parameters), 1);
    let (weights, parts) = match parameters.calibration {
        Calibration::Matched => {
            let weights = matched::weights(parameters, &offsets)?;
            let parts = weights.iter().map(|&a| f64::from(a > 0.0)).collect();
            (weights, parts)
        }
        Calibration::Published if parameters.edges.is_exact() => {
            return Err(BondPlaneError::OverlayNeedsMatched);
        }
        Calibration::Published => published::weights(parameters, &offsets),
    };
    if weights.iter().all(|&a| a <= 0.0) {
        return Err(BondPlaneError::NoNeighbours { horizon_ratio: parameters.horizon_ratio });
    }
    let weights: Vec<[f64; 1]> = weights.into_iter().map(|a| [a]).collect();
    Ok(Neighbourhood::new(&offsets, &weights, &parts))
}

/// Offsets of all bonds that can exist, spacings.
fn reach_of(parameters: &PlaneParameters) -> f64 {
    let m = parameters.horizon_ratio;
    let beyond = match (parameters.calibration, parameters.volume_factor) {
        (Calibration::Published, VolumeFactor::Ramp) => 0.5,
        // Half a diagonal of a cell.
        (Calibration::Published, VolumeFactor::Area) => 0.75,
        _ => 0.0,
    };
    m + beyond
}
