//! Points with one of several tables of weights.

use super::chunks::Chunks;
use crate::body::{Cell, SquareLattice, plus};

/// Most tables beside that of the offsets.
pub(super) const MOST: usize = 254;

/// Bonds of a lattice whose points do not all have the same weights.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tables<'a, const M: usize> {
    /// Table of every point: zero has the weights of the offsets themselves.
    pub of: &'a [u8],
    /// Weights by offset of the tables from one on.
    pub others: &'a [Vec<[f64; M]>],
    /// Bonds between points of two tables.
    pub between: &'a [Between<M>],
}

/// A bond between points of two tables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Between<const M: usize> {
    /// Index of the offset.
    pub offset: usize,
    /// Lower point.
    pub lower: usize,
    /// Multiply the moduli of the bond, >= 0.
    pub weights: [f64; M],
}

impl<const M: usize> Tables<'_, M> {
    /// The chunks of a lattice, with the bonds between tables; `known` are the weights of all tables.
    pub(super) fn chunks(&self, lattice: &SquareLattice, steps: &[Cell], known: &[&[[f64; M]]]) -> Chunks {
        let mut chunks = Chunks::new(lattice, (steps, M));
        chunks.take_tables(self.of, known);
        for bond in self.between {
            let upper = lattice.number(plus(lattice.cell(bond.lower), steps[bond.offset]));
            for (side, point) in [Some(bond.lower), upper].into_iter().flatten().enumerate() {
                chunks.weigh((2 * bond.offset + side, point), bond.weights, (self.of, known));
            }
        }
        chunks
    }
}
