//! Isotropic plates of central bonds, static and linear.
//!
//! A bond of length ξ and direction n between points i and j resists its elongation `e = n·(u_j − u_i)` alone. Its energy
//! is `½ k e²`; on a square lattice `k = a V/ξ²` with the volume V of a point and one weight a, Pa, per offset, so that a
//! uniform strain ε has the energy density `½ εᵀ C ε`, `C = Σ a N Nᵀ` over half of the offsets, `N = (n_x², n_y², n_x n_y)`.
//! Central bonds have `C12 = C66`: ν = 1/3 in plane stress, ν = 1/4 in plane strain.
//!
//! Stress of a point: the virial of its bonds and of its overlay triangles, `σ_k = (1/V_k) [½ Σ_j k ξ N e + Σ V_k/n D E]`,
//! which is exact for every uniform strain where nothing is missing or the overlay replaces it; strain is `C⁻¹ σ`.
//!
//! Not here: finite rotations, other Poisson ratios.

mod bond;
mod breaking;
mod calibration;
mod cloud;
mod error;
mod in_plane;
mod material;
mod motion;
mod neighbourhood;
mod parameters;
mod softening;
#[cfg(test)]
pub(super) mod tests;
mod toughness;
mod trapping;

pub use bond::CentralBond;
pub use error::BondPlaneError;
pub use material::{PlaneMaterial, PlaneState};
pub use parameters::{Influence, PlaneParameters, VolumeFactor, Weights};
pub use softening::{failure_stretch, yield_stretch};
pub use toughness::{critical_stretch, crossing_bonds, growth_stretch, published_critical_stretch};

pub(super) use calibration::overlap::cell_in_disc;
pub(super) use calibration::published::radial_part;

use super::cloud::CloudBody;
use super::plane::{BorderShares, Edges, Kind, LatticeBody, Mirrors, Mixture, PlaneModel, in_plane};
use crate::body::{Cell, SquareLattice};
use crate::model::solid::TENSOR;
use crate::model::{BodyFields, BodyModel};
use crate::stiffness::Families;
use neighbourhood::neighbourhood;
use std::sync::Arc;

/// A plate of central bonds.
#[derive(Clone, Debug)]
pub struct BondPlane {
    parameters: PlaneParameters,
    body: Body,
}

#[derive(Clone, Debug)]
enum Body {
    Lattice(Box<LatticeBody<2, 1, 3, CentralBond>>),
    Cloud(CloudBody<2, 3>),
}

impl BondPlane {
    /// One of each pair of opposite offsets to the neighbours of a point on a lattice: the first number of a cut is an
    /// index into them. They hold those of all bonds and the possible sides of triangles.
    ///
    /// # Errors
    /// [`BondPlaneError`], all that does not speak of clouds.
    pub fn offsets(parameters: &PlaneParameters) -> Result<Vec<Cell>, BondPlaneError> {
        Ok(neighbourhood(parameters)?.offsets)
    }

    /// Rows or columns of images that a lattice needs beyond a line of symmetry: the depth of [`Mirrors::extended`].
    ///
    /// # Errors
    /// As [`offsets`](Self::offsets).
    pub fn depth(parameters: &PlaneParameters) -> Result<i32, BondPlaneError> {
        Ok(parameters.edges.depth(neighbourhood(parameters)?.reach()))
    }

    /// A lattice of points, images in `mirrors` among them ([`Mirrors::extended`] by [`depth`](Self::depth)). A cut is an
    /// index into [`offsets`](Self::offsets) and the lower point of a bond; images of cuts are cuts.
    ///
    /// # Errors
    /// As [`offsets`](Self::offsets).
    ///
    /// # Panics
    /// A cut has no such offset or point.
    pub fn on_lattice(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: PlaneParameters,
        cuts: &[(usize, usize)],
    ) -> Result<Self, BondPlaneError> {
        Self::mixed(lattice, mirrors, parameters, cuts, Vec::new())
    }

    /// The same of several materials: `factors` are Young's moduli of the points over that of the parameters, > 0, images having
    /// those of their points; none where all are one. Edges are completed.
    ///
    /// # Errors
    /// As [`on_lattice`](Self::on_lattice).
    ///
    /// # Panics
    /// As [`on_lattice`](Self::on_lattice); or there is not one factor for every point.
    pub fn mixed(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: PlaneParameters,
        cuts: &[(usize, usize)],
        factors: Vec<f64>,
    ) -> Result<Self, BondPlaneError> {
        assert!(factors.is_empty() || factors.len() == lattice.points(), "one factor per point");
        let neighbourhood = neighbourhood(&parameters)?;
        let PlaneMaterial { thickness, .. } = parameters.material;
        let kind = Kind {
            bond: CentralBond { volume: lattice.spacing().powi(2) * thickness },
            edges: parameters.edges,
            thickness,
            stretch_moduli: [parameters.material.c11(); 2],
        };
        let body = LatticeBody::mixed(lattice, mirrors, neighbourhood, kind, cuts, Mixture::new(factors));
        Ok(Self { parameters, body: Body::Lattice(Box::new(body)) })
    }

    /// Points anywhere, with areas in m² and a horizon in m; `cut` tells whether something separates two positions. The
    /// horizon ratio of the parameters is not read.
    ///
    /// # Errors
    /// [`BondPlaneError`], all that does not speak of lattices.
    pub fn on_cloud(
        positions: Vec<[f64; 2]>,
        areas: Vec<f64>,
        horizon: f64,
        parameters: PlaneParameters,
        cut: &dyn Fn([f64; 2], [f64; 2]) -> bool,
    ) -> Result<Self, BondPlaneError> {
        let body = cloud::body(positions, areas, horizon, &parameters, cut)?;
        Ok(Self { parameters, body: Body::Cloud(body) })
    }

    /// The parameters.
    pub fn parameters(&self) -> &PlaneParameters {
        &self.parameters
    }

    /// Young's modulus of a point over that of the parameters.
    pub fn factor(&self, point: usize) -> f64 {
        match &self.body {
            Body::Lattice(body) => body.factor(point),
            Body::Cloud(_) => 1.0,
        }
    }

    fn overlay(&self) -> &Arc<Families<2, 3, 2>> {
        match &self.body {
            Body::Lattice(body) => &body.triangles,
            Body::Cloud(body) => &body.overlay,
        }
    }
}

impl BodyModel for BondPlane {
    fn volume(&self, point: usize) -> f64 {
        match &self.body {
            Body::Lattice(body) => body.volume(point),
            Body::Cloud(body) => body.sites.volume(point),
        }
    }

    fn lattice(&self) -> Option<(&Arc<SquareLattice>, &Mirrors)> {
        match &self.body {
            Body::Lattice(body) => Some((&body.lattice, &body.mirrors)),
            Body::Cloud(_) => None,
        }
    }

    fn ghosts(&self) -> &[u32] {
        match &self.body {
            Body::Lattice(body) => &body.ghosts,
            Body::Cloud(_) => &[],
        }
    }

    fn edges(&self) -> Option<Edges> {
        match &self.body {
            Body::Lattice(body) => Some(body.kind.edges),
            Body::Cloud(_) if self.parameters.edges.is_exact() => Some(Edges::Overlay),
            Body::Cloud(_) => Some(self.parameters.edges),
        }
    }

    fn border_shares(&self) -> Option<BorderShares<'_>> {
        match &self.body {
            Body::Lattice(body) => body.border_shares(),
            Body::Cloud(_) => None,
        }
    }

    fn triangles(&self) -> usize {
        self.overlay().list().len()
    }

    fn completing(&self) -> usize {
        match &self.body {
            Body::Lattice(body) => body.completing(),
            Body::Cloud(body) => body.overlay.list().len(),
        }
    }

    fn uncorrected(&self) -> usize {
        match &self.body {
            Body::Lattice(body) => body.uncorrected,
            Body::Cloud(body) => body.uncorrected,
        }
    }

    fn damage(&self) -> Vec<f64> {
        match &self.body {
            Body::Lattice(body) => body.damage(),
            Body::Cloud(body) => body.damage(),
        }
    }

    fn never_joined(&mut self, bonds: &[(usize, usize)]) {
        if let Body::Lattice(body) = &mut self.body {
            body.never_joined(bonds);
        }
    }

    fn prepare_to_break(&mut self) {
        if let Body::Lattice(body) = &mut self.body {
            body.prepare_to_break();
        }
    }

    fn strains_of(&self, stress: [f64; TENSOR], across: f64) -> [f64; TENSOR] {
        in_plane(self, stress, across)
    }

    fn strains_at(&self, point: usize, stress: [f64; TENSOR], across: f64) -> [f64; TENSOR] {
        let factor = self.factor(point);
        self.strains_of(stress, across).map(|strain| strain / factor)
    }

    fn across_of(&self, [x, y, shear, ..]: [f64; TENSOR]) -> f64 {
        self.stress_across([x, y, shear])
    }

    fn recover(&self, u: &[f64]) -> BodyFields {
        self.fields(u).into()
    }

    fn as_plane(&self) -> Option<&dyn PlaneModel> {
        Some(self)
    }
}
