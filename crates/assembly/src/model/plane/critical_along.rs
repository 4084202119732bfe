//! How far the bonds of a lattice of several materials stretch until they break.

use super::edges::Path;
use super::mixture::Mixture;
use super::{CriticalStretch, Mirrors};
use crate::body::{Cell, SquareLattice, minus, plus};

/// A part of a bond that ends on the border: the cells that it has on the path of the bond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct PartOfPath {
    /// Places of the first one on the path, and of the first one behind the last.
    pub(in super::super) pieces: [u8; 2],
    /// One of them, by its place on the path, and its point.
    pub(in super::super) known: (u8, u32),
}

/// Critical stretches of bonds between the points of a lattice, by the materials that they pass.
pub(in super::super) struct CriticalAlong<'a> {
    critical: &'a CriticalStretch,
    body: (&'a SquareLattice, &'a Mirrors),
    mixture: Option<&'a Mixture>,
    /// By offset, the cells that a bond passes, from its lower point, with their parts of it; nothing where materials do not matter.
    paths: Vec<Vec<(Cell, f64)>>,
}

impl<'a> CriticalAlong<'a> {
    /// Those of bonds of the offsets of a neighbourhood.
    pub(in super::super) fn new(
        critical: &'a CriticalStretch,
        body: (&'a SquareLattice, &'a Mirrors),
        mixture: Option<&'a Mixture>,
        offsets: &[Cell],
    ) -> Self {
        let path = |offset: &Cell| Path::of(*offset).pieces().collect();
        let paths = if critical.has_materials() { offsets.iter().map(path).collect() } else { Vec::new() };
        Self { critical, body, mixture, paths }
    }

    /// How many times further a bond from a point, of the offset with an index, stretches than one of the base material.
    pub(in super::super) fn ratio(&self, offset: usize, lower: usize) -> f64 {
        let Some(path) = self.paths.get(offset) else { return 1.0 };
        let lattice = self.body.0;
        let first = lattice.cell(lower);
        let passed = || path.iter().map(|&(step, part)| (plus(first, step), part));
        let modulus = || self.mixture.map_or(1.0, |mixture| mixture.through(self.body, passed()).weights[0]);
        self.critical.ratio(passed().filter_map(|(cell, _)| lattice.number(cell)), modulus)
    }

    /// The same of a part of a bond of that offset, with its modulus over that of the base material.
    pub(in super::super) fn ratio_of_part(&self, offset: usize, part: PartOfPath, modulus: f64) -> f64 {
        let Some(path) = self.paths.get(offset) else { return 1.0 };
        let lattice = self.body.0;
        let [from, to] = part.pieces.map(usize::from);
        let (place, point) = part.known;
        let start = minus(lattice.cell(point as usize), path[usize::from(place)].0);
        let passed = path[from..to].iter().filter_map(|(step, _)| lattice.number(plus(start, *step)));
        self.critical.ratio(passed, || modulus)
    }
}
