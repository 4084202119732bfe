//! Solids of central bonds whose points are listed.

mod model;
#[cfg(test)]
mod tests;

use super::super::cloud::{CloudBody, Horizon, Overlay, Sites, overlay, scale};
use super::super::plane::Calibration;
use super::super::solid::{Isotropic, SolidEdges, SolidError, TENSOR};
use super::{BondSolidParameters, VolumeFactor};

/// A solid of points anywhere with the bonds between them: bonds of any cloud have the stiffness of the material nowhere exactly, so
/// they have no more of it than there is, and tetrahedra have the rest.
///
/// A bond has `k = c ω β V_i V_j/ξ`, as published. By the calibration `matched` it is multiplied by the smaller scale g of its
/// ends, the largest with `C − g M >= 0`, where `M = (1/V) ½ Σ k ξ² N Nᵀ`, Pa. Every point gives what it lacks, `C − M` of the
/// bonds as they are, to tetrahedra that it makes with near neighbours, so that
///
/// `½ Σ k e² + ½ Σ (V/n) E:(C − M):E = ½ ε:C:ε V`
///
/// for every uniform strain ε.
#[derive(Clone, Debug)]
pub struct BondSolidCloud {
    material: Isotropic,
    edges: SolidEdges,
    body: CloudBody<3, TENSOR>,
}

impl BondSolidCloud {
    /// Points at `positions`, m, with `volumes`, m³, one each, and a horizon in m; `cut` tells whether something separates two
    /// positions. Edges that are completed have an overlay. The horizon ratio and the weights of the parameters are not read.
    ///
    /// # Errors
    /// [`SolidError::EdgesNeedMatched`], [`SolidError::AreaNeedsCells`], [`SolidError::Coincident`], or
    /// [`SolidError::NoNeighbours`] where no point has any.
    pub fn new(
        positions: Vec<[f64; 3]>,
        volumes: Vec<f64>,
        horizon: f64,
        parameters: BondSolidParameters,
        cut: &dyn Fn([f64; 3], [f64; 3]) -> bool,
    ) -> Result<Self, SolidError> {
        let BondSolidParameters { influence, calibration, volume_factor, .. } = parameters;
        let edges = match parameters.edges {
            SolidEdges::Border | SolidEdges::Overlay => SolidEdges::Overlay,
            SolidEdges::None => SolidEdges::None,
        };
        let published = calibration == Calibration::Published;
        if published && edges.is_exact() {
            return Err(SolidError::EdgesNeedMatched);
        }
        if published && volume_factor == VolumeFactor::Area {
            return Err(SolidError::AreaNeedsCells);
        }
        let sites = Sites { positions, sizes: volumes, thickness: 1.0 };
        let reach = Horizon::new(horizon, influence, calibration, volume_factor);
        let coincident = |[first, second]: [usize; 2]| SolidError::Coincident { first, second };
        let mut pairs = sites.pairs(&reach, parameters.micromodulus(horizon)).map_err(coincident)?;
        if pairs.is_empty() {
            let mean = sites.sizes.iter().sum::<f64>() / sites.sizes.len() as f64;
            return Err(SolidError::NoNeighbours { horizon_ratio: horizon / mean.cbrt() });
        }
        let material = parameters.material();
        if !published {
            scale(&mut pairs, &sites, &material.stiffness());
        }
        let overlay = match edges.is_exact() {
            true => overlay(&sites, &pairs, &material.stiffness(), cut),
            false => Overlay::default(),
        };
        Ok(Self { material, edges, body: CloudBody::new(sites, reach, &pairs, overlay, cut) })
    }
}
