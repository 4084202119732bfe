//! What a model says of its bonds on a lattice, and in the plane.

use crate::bonds::{BondGeometry, BondModel, Mat};

/// Bonds of a body on a lattice: `D` unknowns per point, `M` measures per bond.
///
/// A uniform state of a body has `S` numbers, its strains first: in the plane `[ε_xx, ε_yy, γ_xy]` and, for points that turn,
/// how far the rotation of the body runs ahead of theirs, `r = ω − θ`; in a solid the six strains.
pub trait LatticeBond<const D: usize, const M: usize, const S: usize>: BondModel<D, M> + Clone {
    /// Measures of a bond in a uniform state, `[measure][number]`.
    fn in_uniform_state(&self, bond: &BondGeometry) -> Mat<M, S>;

    /// Moduli of the part `share` of a bond that is left of it as a bond of its own: uniform states have this part of its
    /// energy, and so have states that bend it.
    fn part_moduli(&self, whole: &BondGeometry, share: f64) -> [f64; M] {
        self.moduli(&BondGeometry { xi: whole.xi.map(|x| share * x) }).map(|modulus| share * modulus)
    }

    /// The stretch of a bond per unit of its first measure.
    fn stretch_per_measure(&self, bond: &BondGeometry) -> f64;

    /// The same bond on a lattice of twice the spacing; rotations keep the length that multiplies them.
    fn coarser(&self) -> Self;
}

/// Bonds of a body in the plane.
pub trait PlaneBond<const D: usize, const M: usize, const S: usize>: LatticeBond<D, M, S> {
    /// Signs of the strains of an image, from those of its displacements along x and y.
    fn image_signs([x, y]: [f64; 2]) -> [f64; 3] {
        [1.0, 1.0, x * y]
    }

    /// Rows that make the numbers of the state of a triangle: from the unknowns of the two points that lie at `first` and
    /// `second` (m) from its own one, relative to those of the own one, and from these.
    fn triangle(&self, first: [f64; 2], second: [f64; 2]) -> ([Mat<S, D>; 2], Mat<S, D>);
}
