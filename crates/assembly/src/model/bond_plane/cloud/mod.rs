//! Plates whose points are listed.

mod breaking;
mod treat;

use super::super::cloud::{CloudBody, Cut, Horizon, Overlay, Sites, overlay, scale};
use super::super::plane::Calibration;
use super::calibration::published::micromodulus;
use super::{BondPlaneError, PlaneParameters, VolumeFactor};

/// Points with areas, m², and the bonds between them.
pub(super) fn body(
    positions: Vec<[f64; 2]>,
    areas: Vec<f64>,
    horizon: f64,
    parameters: &PlaneParameters,
    cut: &Cut<2>,
) -> Result<CloudBody<2, 3>, BondPlaneError> {
    let PlaneParameters { material, influence, calibration, volume_factor, edges, .. } = *parameters;
    let published = calibration == Calibration::Published;
    if published && edges.is_exact() {
        return Err(BondPlaneError::OverlayNeedsMatched);
    }
    if published && volume_factor == VolumeFactor::Area {
        return Err(BondPlaneError::AreaNeedsCells);
    }
    let sites = Sites { positions, sizes: areas, thickness: material.thickness };
    let reach = Horizon::new(horizon, influence, calibration, volume_factor);
    let coincident = |[first, second]: [usize; 2]| BondPlaneError::Coincident { first, second };
    let mut pairs = sites.pairs(&reach, micromodulus(parameters, horizon)).map_err(coincident)?;
    if !published {
        scale(&mut pairs, &sites, &material.stiffness());
    }
    treat::treat(&mut pairs, &sites, horizon, parameters);
    let overlay = match edges.is_exact() {
        true => overlay(&sites, &pairs, &material.stiffness(), cut),
        false => Overlay::default(),
    };
    Ok(CloudBody::new(sites, reach, &pairs, overlay, cut))
}
