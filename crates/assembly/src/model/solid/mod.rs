//! What models of solids share: bonds on a lattice of cubes, families that feel a change of volume, what is done about what
//! points near faces lack, stresses and the loads that belong to them, images in planes of symmetry.
//!
//! A point k of volume V_k has the energy density
//!
//! `W_k = ½ A ϑ_k² + ¼ Σ_j (a_j/ξ_j²) e_kj²`, `ϑ_k = Σ_j d_j e_kj`
//!
//! with the elongations `e_kj = n·(u_j − u_k)` of its bonds, their weights a, Pa, and, where a model has any, its dilatation ϑ:
//! bonds are seen from both ends. Strains are `E = (ε_xx, ε_yy, ε_zz, γ_yz, γ_xz, γ_xy)`, `N = (n_x², n_y², n_z², n_y n_z,
//! n_x n_z, n_x n_y)`, so that `e = ξ N·E` in a uniform strain, and `C = Σ a N Nᵀ` over half of the offsets is what bonds
//! have of the stiffness. A model is a [`SolidLaw`]: the weights of its offsets.

mod body;
mod bond;
mod border;
mod breaking;
mod corners;
mod damage;
mod dilatation;
mod fields;
mod interface;
mod isotropic;
mod law;
mod model;
#[cfg(test)]
pub(in crate::model) mod tests;
mod tetrahedra;
pub mod toughness;

pub use bond::SolidBond;
pub use law::{SolidEdges, SolidError, SolidLaw, SolidMaterial};
pub use model::Solid;

pub(super) use bond::direction_product;
pub(super) use isotropic::Isotropic;
pub(super) use law::{Dilatation, part, reach_of};
pub(super) use tetrahedra::strain_rows;

use super::{BodyFields, BodyModel, Component, RigidMotion};
use crate::body::Cell;
use crate::bonds::{Mat, Point};
use crate::stiffness::NodedBonds;

/// Number of components of strain and stress.
pub const TENSOR: usize = 6;

/// Their names.
pub const TENSOR_COMPONENTS: [&str; TENSOR] = ["xx", "yy", "zz", "yz", "xz", "xy"];

/// The unknowns of a point of a solid.
pub(super) const COMPONENTS: [Component; 3] =
    [Component::displacement("ux", 0), Component::displacement("uy", 1), Component::displacement("uz", 2)];

/// The rigid motions of a solid.
pub(super) const RIGID_MOTIONS: [RigidMotion; 6] = [
    RigidMotion::translation("translation along x", "move along {direction}"),
    RigidMotion::translation("translation along y", "move along {direction}"),
    RigidMotion::translation("translation along z", "move along {direction}"),
    RigidMotion::rotation("rotation about x", "turn about {centre}"),
    RigidMotion::rotation("rotation about y", "turn about {centre}"),
    RigidMotion::rotation("rotation about z", "turn about {centre}"),
];

/// Displacements of a place under a unit motion of these.
pub(super) fn rigid_motion(kind: usize, at: Point, centre: Point) -> [f64; 3] {
    let [x, y, z] = [0, 1, 2].map(|k| at[k] - centre[k]);
    match kind {
        0 => [1.0, 0.0, 0.0],
        1 => [0.0, 1.0, 0.0],
        2 => [0.0, 0.0, 1.0],
        3 => [0.0, -z, y],
        4 => [z, 0.0, -x],
        _ => [-y, x, 0.0],
    }
}

/// Fields by component planes; images have zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidFields {
    /// Stresses, Pa, of every point, in the order of [`TENSOR_COMPONENTS`].
    pub stress: [Vec<f64>; TENSOR],
    /// Strain energy density, J/m³, of every point.
    pub energy_density: Vec<f64>,
}

impl SolidFields {
    /// Those of planes of stresses and one of energy densities.
    pub(super) fn of(mut sums: Vec<f64>) -> Self {
        let n = sums.len() / (TENSOR + 1);
        let energy_density = sums.split_off(TENSOR * n);
        Self { stress: std::array::from_fn(|q| sums[q * n..(q + 1) * n].to_vec()), energy_density }
    }
}

impl From<SolidFields> for BodyFields {
    fn from(SolidFields { stress, energy_density }: SolidFields) -> Self {
        Self { stress: stress.into(), energy_density, across: Vec::new() }
    }
}

/// A solid with its bonds, whatever they are.
pub trait SolidModel: BodyModel {
    /// What is done about what points near faces lack.
    fn faces(&self) -> SolidEdges;

    /// Offsets of half of the bonds of a point, cells, and their stiffnesses, N/m.
    fn bonds_of_a_point(&self) -> Vec<(Cell, f64)>;

    /// Steps and lower points of those that are cut or broken.
    fn cut_bonds(&self) -> Vec<(Cell, usize)>;

    /// Bonds that end on the border.
    fn bonds_on_border(&self) -> Option<&NodedBonds<3, 1>>;

    /// Stiffness of the material, Pa, from strains to stresses.
    fn stiffness(&self) -> Mat<TENSOR, TENSOR>;

    /// Strains of stresses: its inverse.
    fn strain_of(&self, stress: [f64; TENSOR]) -> [f64; TENSOR];

    /// Stresses and energy densities of a state, `[ux, uy, uz]` in planes, m.
    fn fields(&self, u: &[f64]) -> SolidFields;

    /// Adds the forces `Σ_k t_k·V_k σ_k` per unit strain, with the strains `t`, six planes: the adjoint of the stresses. What t
    /// says of images is not read.
    fn add_strain_work(&self, t: &mut [f64], force: &mut [f64]);

    /// Adds the forces `Σ_k V_k S_k : E_k` of a stress S, Pa, with E the strain of a point: with one stress for all points and
    /// the tractions that it has at the faces, the linear displacement that belongs to it is the solution to rounding. The
    /// forces have no resultant: `V div S` has to be added by the caller.
    fn add_stress_load(&self, stress_at: &dyn Fn(usize, Point) -> [f64; TENSOR], force: &mut [f64]) {
        let n = self.points();
        let mut t = vec![0.0; TENSOR * n];
        for point in 0..n {
            let strain = self.strains_at(point, stress_at(point, self.position(point)), 0.0);
            (0..TENSOR).for_each(|q| t[q * n + point] = strain[q]);
        }
        self.add_strain_work(&mut t, force);
    }
}
