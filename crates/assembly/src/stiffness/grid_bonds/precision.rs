//! The numbers that products are made of.

use super::chunks::Chunk;
use super::{Class, GridBonds};
use peristat_vector::Lanes;

/// Numbers in which every class of bonds is kept.
pub(super) trait Precision: Lanes {
    /// The classes of a lattice, table by table.
    fn classes<const D: usize, const M: usize, B>(bonds: &GridBonds<D, M, B>) -> &[Class<D, M, Self>];

    /// Those of the points of a chunk.
    #[inline(always)]
    fn classes_of<'a, const D: usize, const M: usize, B>(
        bonds: &'a GridBonds<D, M, B>,
        chunk: &Chunk,
    ) -> &'a [Class<D, M, Self>] {
        let first = chunk.table() * bonds.offsets;
        &Self::classes(bonds)[first..first + bonds.offsets]
    }
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
