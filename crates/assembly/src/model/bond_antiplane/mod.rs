//! Plates of bonds in antiplane shear: points move across the plane alone, static and linear.
//!
//! A bond of length ξ and direction n between points i and j resists the difference `e = w_j − w_i` of their displacements
//! along z. Its energy is `½ k e²`; on a square lattice `k = a V/ξ²` with the volume V of a point and one weight a, Pa, per
//! offset, so that a uniform strain `γ = (γ_xz, γ_yz)` has the energy density `½ γᵀ C γ`, `C = Σ a n nᵀ` over half of the
//! offsets. What a square lattice has of any weights that depend on the length is isotropic, `C = ½ Σ a`: one number makes
//! the shear modulus exact, `Σ a = 2G`.
//!
//! Strains and stresses of points are `[xz, yz, 0]` where other models of the plane have `[xx, yy, xy]`; edges and cracks
//! are theirs.

mod bond;
mod model;
mod parameters;
#[cfg(test)]
mod tests;

pub use bond::ShearBond;
pub use parameters::{AntiplaneError, AntiplaneParameters};

use super::plane::{Kind, LatticeBody, Mirrors, Mixture};
use crate::body::{Cell, SquareLattice};
use std::sync::Arc;

/// Component of the displacement along z.
pub const W: usize = 0;

/// A plate in antiplane shear.
#[derive(Clone, Debug)]
pub struct BondAntiplane {
    parameters: AntiplaneParameters,
    body: LatticeBody<1, 1, 3, ShearBond>,
}

impl BondAntiplane {
    /// One of each pair of opposite offsets to the neighbours of a point: the first number of a cut is an index into them.
    /// They hold those of all bonds and the possible sides of triangles.
    ///
    /// # Errors
    /// [`AntiplaneError`].
    pub fn offsets(parameters: &AntiplaneParameters) -> Result<Vec<Cell>, AntiplaneError> {
        Ok(parameters.neighbourhood()?.offsets)
    }

    /// Rows or columns of images that a lattice needs beyond a line of symmetry: the depth of [`Mirrors::extended`].
    ///
    /// # Errors
    /// [`AntiplaneError`].
    pub fn depth(parameters: &AntiplaneParameters) -> Result<i32, AntiplaneError> {
        Ok(parameters.edges.depth(parameters.neighbourhood()?.reach()))
    }

    /// A lattice of points, images in `mirrors` among them ([`Mirrors::extended`] by [`depth`](Self::depth)). A cut is an
    /// index into [`offsets`](Self::offsets) and the lower point of a bond; images of cuts are cuts.
    ///
    /// # Errors
    /// [`AntiplaneError`].
    ///
    /// # Panics
    /// A cut has no such offset or point.
    pub fn on_lattice(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: AntiplaneParameters,
        cuts: &[(usize, usize)],
    ) -> Result<Self, AntiplaneError> {
        Self::mixed(lattice, mirrors, parameters, cuts, Vec::new())
    }

    /// The same of several materials: `factors` are shear moduli of the points over that of the parameters, > 0, images having
    /// those of their points; none where all are one. Edges are completed.
    ///
    /// # Errors
    /// [`AntiplaneError`].
    ///
    /// # Panics
    /// As [`on_lattice`](Self::on_lattice); or there is not one factor for every point.
    pub fn mixed(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: AntiplaneParameters,
        cuts: &[(usize, usize)],
        factors: Vec<f64>,
    ) -> Result<Self, AntiplaneError> {
        assert!(factors.is_empty() || factors.len() == lattice.points(), "one factor per point");
        let neighbourhood = parameters.neighbourhood()?;
        let kind = Kind {
            bond: ShearBond { volume: lattice.spacing().powi(2) * parameters.thickness },
            edges: parameters.edges,
            thickness: parameters.thickness,
            stretch_moduli: [parameters.shear_modulus; 2],
        };
        let body = LatticeBody::mixed(lattice, mirrors, neighbourhood, kind, cuts, Mixture::new(factors));
        Ok(Self { parameters, body })
    }

    /// The parameters.
    pub fn parameters(&self) -> &AntiplaneParameters {
        &self.parameters
    }
}
