//! Models whose bonds can break.

use super::Model;
use crate::stiffness::Term;

/// A model whose bonds can break. Every bond has a number that stays the same whatever breaks.
pub trait Breakable<const D: usize>: Model<D> {
    /// At which strains bonds break.
    type Critical;

    /// Above the number of any bond.
    fn bond_numbers(&self) -> u64;

    /// The two points of a bond.
    fn ends(&self, bond: u64) -> [usize; 2];

    /// Index of the offset of a bond on a lattice; zero elsewhere.
    fn offset(&self, _bond: u64) -> usize {
        0
    }

    /// Calls `visit` with every bond that is there and the ratio of its strain to the critical one: where it is one, the
    /// bond breaks; it grows in proportion to `u`. Bonds that do not break under such a strain, however large, are left
    /// out.
    fn for_each_ratio(&self, u: &[f64], critical: &Self::Critical, visit: &mut dyn FnMut(u64, f64));

    /// What would be gone with some bonds: these, and whatever spans them.
    fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<D>>>;

    /// Removes bonds and whatever spans them, from this model and the terms that it gives from now on.
    fn break_bonds(&mut self, bonds: &[u64]);
}
