//! What assembly, operator, reactions and checks see of an energy.

use super::BlockMatrix;
use super::ConnectedParts;
use super::Twofold;
use crate::bonds::Mat;
use crate::sum::Sum;
use std::array::from_fn;
use std::sync::Arc;

/// What one sweep over the elements tells of a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Survey<const D: usize> {
    /// Stored energy, J.
    pub energy: f64,
    /// Largest magnitude of an element's end action, per component: the scale that residuals are measured on.
    pub largest_action: [f64; D],
}

impl<const D: usize> Survey<D> {
    /// Of no elements.
    pub const EMPTY: Self = Self { energy: 0.0, largest_action: [0.0; D] };

    /// Of so many elements by their numbers, in blocks: the error of a long sum grows with its number of terms.
    pub(super) fn of_all(count: usize, of: impl Fn(usize) -> Self) -> Self {
        const BLOCK: usize = 256;
        let block = |from: usize| (from..count.min(from + BLOCK)).map(&of).fold(Self::EMPTY, Self::join);
        (0..count).step_by(BLOCK).map(block).fold(Self::EMPTY, Self::join)
    }

    /// Of the elements of both.
    pub fn join(self, other: Self) -> Self {
        let largest = |c: usize| self.largest_action[c].max(other.largest_action[c]);
        Self { energy: self.energy + other.energy, largest_action: from_fn(largest) }
    }
}

/// Takes the forces on a few consecutive points: the number of the first, the forces and the part of a vector to be
/// written that belongs to these points, both by component.
pub type TakeForces<'a, const D: usize, R = f64> = &'a (dyn Fn(usize, [&[R]; D], [&mut [R]; D]) + Sync);

/// An unknown in a sum: component, point, coefficient.
pub type Share = (usize, usize, f64);

/// One part of the energy, `E = Σ_e ½ s_eᵀ C_e s_e` with measures `s_e = B_e u`: one object per shape and law, never
/// one per bond.
///
/// Vectors hold `D` component planes, `u[c · points + p]`.
pub trait Term<const D: usize>: Send + Sync {
    /// Visits every pair of different points that an element couples, in any order.
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize));

    /// Largest difference of the numbers of two coupled points.
    fn reach(&self) -> usize {
        let mut reach = 0;
        self.couplings(&mut |i, j| reach = reach.max(i.abs_diff(j)));
        reach
    }

    /// Joins the points that hang together.
    fn join(&self, parts: &mut ConnectedParts) {
        self.couplings(&mut |i, j| parts.join(i, j));
    }

    /// Visits the motions that this term holds to the ground, each a sum of unknowns with coefficients.
    fn ground_motions(&self, _visit: &mut dyn FnMut(&[Share])) {}

    /// Whether this term holds motions to the ground.
    fn is_grounded(&self) -> bool {
        let mut found = false;
        self.ground_motions(&mut |_| found = true);
        found
    }

    /// Adds the internal force `Σ B_eᵀ C_e (B_e u)`, element by element. For a linear term this is also the product
    /// of its tangent with `u`.
    fn add_force(&self, u: &[f64], force: &mut [f64]);

    /// Adds the internal force of unknowns in two parts, in twice the precision. `false` if the term cannot.
    fn add_force_twofold(&self, _u: Twofold<'_>, _force: &mut [Sum]) -> bool {
        false
    }

    /// Hands the internal force to `take`, stretch by stretch over all points, each with its part of `out`: what is made
    /// of the forces is then written while they are at hand. `false` if the term does not go from point to point.
    fn sweep(&self, _u: &[f64], _out: &mut [f64], _take: TakeForces<'_, D>) -> bool {
        false
    }

    /// The same in numbers of 32 bits.
    fn sweep_in_single(&self, _u: &[f32], _out: &mut [f32], _take: TakeForces<'_, D, f32>) -> bool {
        false
    }

    /// Whether it can do that.
    fn sweeps_in_single(&self) -> bool {
        false
    }

    /// Energy and largest end action of the elements.
    fn survey(&self, u: &[f64]) -> Survey<D>;

    /// Adds the blocks `B_eᵀ C_e B_e`.
    fn add_tangent(&self, tangent: &mut BlockMatrix<D>);

    /// Adds the diagonal block of every point, `[point][row][column]`.
    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]);

    /// Number of elements (bonds, families, springs).
    fn elements(&self) -> usize;

    /// Whether elements join so many points each that their blocks, assembled, are far more than they are.
    fn joins_many(&self) -> bool {
        false
    }

    /// Numbers stored per element: zero where a lattice shares them all.
    fn stored_factors(&self) -> usize {
        0
    }
}

/// A term that its owner keeps, too.
impl<const D: usize, T: Term<D> + ?Sized> Term<D> for Arc<T> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        (**self).couplings(visit);
    }

    fn reach(&self) -> usize {
        (**self).reach()
    }

    fn join(&self, parts: &mut ConnectedParts) {
        (**self).join(parts);
    }

    fn ground_motions(&self, visit: &mut dyn FnMut(&[Share])) {
        (**self).ground_motions(visit);
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        (**self).add_force(u, force);
    }

    fn add_force_twofold(&self, u: Twofold<'_>, force: &mut [Sum]) -> bool {
        (**self).add_force_twofold(u, force)
    }

    fn sweep(&self, u: &[f64], out: &mut [f64], take: TakeForces<'_, D>) -> bool {
        (**self).sweep(u, out, take)
    }

    fn sweep_in_single(&self, u: &[f32], out: &mut [f32], take: TakeForces<'_, D, f32>) -> bool {
        (**self).sweep_in_single(u, out, take)
    }

    fn sweeps_in_single(&self) -> bool {
        (**self).sweeps_in_single()
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        (**self).survey(u)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        (**self).add_tangent(tangent);
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        (**self).add_diagonal(blocks);
    }

    fn elements(&self) -> usize {
        (**self).elements()
    }

    fn joins_many(&self) -> bool {
        (**self).joins_many()
    }

    fn stored_factors(&self) -> usize {
        (**self).stored_factors()
    }
}
