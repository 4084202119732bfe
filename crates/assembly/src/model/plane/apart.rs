//! Bonds that never were, because nothing of the body lies between their points.

use super::Mirrors;
use super::near::near_points;
use crate::body::{Cell, Chains, SquareLattice, minus, parted_bonds, plus};
use std::collections::HashSet;

/// The bonds of a lattice that its body parts, images among them, by index of their offset and lower point, sorted.
pub(in super::super) fn apart_bonds(
    lattice: &SquareLattice,
    mirrors: &Mirrors,
    offsets: &[Cell],
) -> Vec<(usize, usize)> {
    if is_box(lattice) {
        return Vec::new();
    }
    let reach = offsets.iter().flat_map(|o| o.map(i32::abs)).max().unwrap_or(0);
    let has = |cell: Cell| is_there(lattice, mirrors, cell);
    let chains = Chains { has: &has, is_open: &|_, _| true };
    parted_bonds(lattice, &chains, offsets, &near_points(lattice, reach))
}

/// Pairs of cells that the body parts, beside bonds that it parts.
pub(in super::super) struct Apart<'a> {
    lattice: &'a SquareLattice,
    mirrors: &'a Mirrors,
    /// Cells of these bonds.
    ends: HashSet<Cell>,
}

impl<'a> Apart<'a> {
    /// Those beside the bonds of some offsets. The lattice has its images.
    pub(in super::super) fn new(
        lattice: &'a SquareLattice,
        mirrors: &'a Mirrors,
        offsets: &[Cell],
    ) -> (Self, Vec<[Cell; 2]>) {
        let ends = |(k, lower): (usize, usize)| {
            let cell = lattice.cell(lower);
            [cell, plus(cell, offsets[k])]
        };
        let bonds: Vec<[Cell; 2]> =
            apart_bonds(lattice, mirrors, offsets).into_iter().map(ends).collect();
        (Self { lattice, mirrors, ends: bonds.iter().flatten().copied().collect() }, bonds)
    }

    /// Whether the body parts two cells, of which one has lost a bond.
    pub(in super::super) fn parts(&self, from: Cell, to: Cell) -> bool {
        if !self.ends.contains(&from) && !self.ends.contains(&to) {
            return false;
        }
        let has = |cell: Cell| is_there(self.lattice, self.mirrors, cell);
        let chains = Chains { has: &has, is_open: &|_, _| true };
        from != to && !chains.join(from, minus(to, from), 2)
    }
}

/// Whether a lattice has a cell, stored or an image.
fn is_there(lattice: &SquareLattice, mirrors: &Mirrors, cell: Cell) -> bool {
    let image = if mirrors.is_none() { cell } else { mirrors.image(cell).0 };
    lattice.number(image).is_some()
}

/// Whether cells fill a box: then a bond lies in the body.
fn is_box(lattice: &SquareLattice) -> bool {
    let sides = [lattice.columns(), lattice.rows(), lattice.layers()];
    sides.iter().map(|side| side.len()).product::<usize>() == lattice.points()
}
