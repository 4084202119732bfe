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
//! Not here: bond breaking, finite rotations, other Poisson ratios.

mod bond;
mod calibration;
mod cloud;
mod edges;
mod error;
mod fields;
mod lattice;
mod load;
mod material;
mod motion;
mod neighbourhood;
mod parameters;
#[cfg(test)]
mod tests;

pub use bond::CentralBond;
pub use error::BondPlaneError;
pub use fields::PlaneFields;
pub use material::{PlaneMaterial, PlaneState};
pub use parameters::{Calibration, Edges, Influence, PlaneParameters, VolumeFactor};

use super::plane::Mirrors;
use crate::body::{Cell, SquareLattice};
use cloud::CloudBody;
use lattice::LatticeBody;
use neighbourhood::Neighbourhood;
use std::sync::Arc;

/// Finds the cuts on a lattice: indices into the offsets, and lower points.
pub type FindCuts<'a> = dyn Fn(&SquareLattice, &[Cell]) -> Vec<(usize, usize)> + 'a;

/// A plate of central bonds.
#[derive(Clone, Debug)]
pub struct BondPlane {
    parameters: PlaneParameters,
    body: Body,
}

#[derive(Clone, Debug)]
enum Body {
    Lattice(LatticeBody),
    Cloud(CloudBody),
}

impl BondPlane {
    /// One of each pair of opposite offsets to the neighbours of a point on a lattice: the first number of a cut is an
    /// index into them. They hold those of all bonds and the possible sides of triangles.
    ///
    /// # Errors
    /// [`BondPlaneError`], all that does not speak of clouds.
    pub fn offsets(parameters: &PlaneParameters) -> Result<Vec<Cell>, BondPlaneError> {
        Ok(Neighbourhood::new(parameters)?.offsets)
    }

    /// Rows or columns of images that a lattice needs beyond a line of symmetry: the depth of [`Mirrors::extended`].
    ///
    /// # Errors
    /// As [`offsets`](Self::offsets).
    pub fn depth(parameters: &PlaneParameters) -> Result<i32, BondPlaneError> {
        Ok(Neighbourhood::new(parameters)?.reach())
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
        let hood = Neighbourhood::new(&parameters)?;
        let body = LatticeBody::new(lattice, mirrors, hood, &parameters, cuts);
        Ok(Self { parameters, body: Body::Lattice(body) })
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
        let body = CloudBody::new(positions, areas, horizon, &parameters, cut)?;
        Ok(Self { parameters, body: Body::Cloud(body) })
    }

    /// The same body on a lattice of twice the spacing with the same horizon ratio; none of a cloud. `cuts` finds the cuts
    /// on a lattice, given the offsets. A line of symmetry through coarse cells moves outwards.
    pub fn coarser(&self, cuts: &FindCuts) -> Option<Self> {
        let Body::Lattice(body) = &self.body else { return None };
        let body = body.coarser(&self.parameters, cuts);
        Some(Self { parameters: self.parameters, body: Body::Lattice(body) })
    }

    /// The parameters.
    pub fn parameters(&self) -> &PlaneParameters {
        &self.parameters
    }

    /// The lattice, images included, and its lines of symmetry; none of a cloud.
    pub fn lattice(&self) -> Option<(&Arc<SquareLattice>, &Mirrors)> {
        match &self.body {
            Body::Lattice(body) => Some((&body.lattice, &body.mirrors)),
            Body::Cloud(_) => None,
        }
    }

    /// Numbers of the points that are images, in order.
    pub fn ghosts(&self) -> &[u32] {
        match &self.body {
            Body::Lattice(body) => &body.ghosts,
            Body::Cloud(_) => &[],
        }
    }

    /// Number of points, images included.
    pub fn points(&self) -> usize {
        match &self.body {
            Body::Lattice(body) => body.lattice.points(),
            Body::Cloud(body) => body.positions.len(),
        }
    }

    /// Position of a point in the plane, m.
    pub fn place(&self, point: usize) -> [f64; 2] {
        match &self.body {
            Body::Lattice(body) => body.lattice.position(point),
            Body::Cloud(body) => body.positions[point],
        }
    }

    /// Volume of a point, m³; an image has none.
    pub fn volume(&self, point: usize) -> f64 {
        match &self.body {
            Body::Lattice(body) if body.ghosts.binary_search(&(point as u32)).is_ok() => 0.0,
            _ => self.real_volume(point),
        }
    }

    /// Number of overlay triangles.
    pub fn triangles(&self) -> usize {
        self.overlay().list().len()
    }

    /// Number of points that lack bonds for which the overlay found no triangle: they are too soft. Points by themselves
    /// or in a single straight row are such, and points whose triangles all are crossed by cracks.
    pub fn uncorrected(&self) -> usize {
        match &self.body {
            Body::Lattice(body) => body.uncorrected,
            Body::Cloud(body) => body.uncorrected,
        }
    }

    /// Cut share of the family volume of every point, 0 to 1.
    pub fn damage(&self) -> Vec<f64> {
        let damaged = match &self.body {
            Body::Lattice(body) => &body.damage,
            Body::Cloud(body) => &body.damage,
        };
        let mut damage = vec![0.0; self.points()];
        damaged.iter().for_each(|&(point, share)| damage[point] = share);
        damage
    }

    fn overlay(&self) -> &Arc<crate::stiffness::Families<2, 3, 2>> {
        match &self.body {
            Body::Lattice(body) => &body.triangles,
            Body::Cloud(body) => &body.triangles,
        }
    }
}
