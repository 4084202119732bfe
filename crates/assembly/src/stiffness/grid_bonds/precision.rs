//! The numbers that products are made of.

use super::{Class, GridBonds};
use peristat_vector::Lanes;

/// Numbers in which every class of bonds is kept.
pub(super) trait Precision: Lanes {
    /// The classes of a lattice.
    fn classes<const D: usize, const M: usize, B>(bonds: &GridBonds<D, M, B>) -> &[Class<D, M, Self>];
}

impl Precision for f64 {
    #[inline(always)]
    fn classes<const D: usize, const M: usize, B>(bonds: &GridBonds<D, M, B>) -> &[Class<D, M>] {
        &bonds.classes
    }
}

impl Precision for f32 {
    #[inline(always)]
    fn classes<const D: usize, const M: usize, B>(bonds: &GridBonds<D, M, B>) -> &[Class<D, M, f32>] {
        &bonds.in_single
    }
}
