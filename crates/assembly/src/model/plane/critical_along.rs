//! How far the bonds of a lattice of several materials stretch until they break.

use super::edges::Path;
use super::mixture::Mixture;
use super::{CriticalStretch, Mirrors};
use crate::body::{Cell, SquareLattice, plus};

/// Critical stretches of bonds between the points of a lattice, by the materials that they pass.
pub(in super::super) struct CriticalAlong<'a> {
    critical: &'a CriticalStretch,
    body: (&'a SquareLattice, &'a Mirrors),
    mixture: Option<&'a Mixture>,
    /// By offset, the cells that a bond passes, from its lower point, with their parts of it; nothing where materials do not matter.
    paths: Vec<Vec<(Cell, f64)>>,
}

impl<'a> CriticalAlong<'a> {
    /// Those of bonds of some offsets.
    pub(in super::super) fn new(
        critical: &'a CriticalStretch,
        (body, mixture): ((&'a SquareLattice, &'a Mirrors), Option<&'a Mixture>),
        offsets: impl Iterator<Item = Cell>,
    ) -> Self {
        let path = |offset: Cell| Path::of(offset).pieces().collect();
        let paths = if critical.has_materials() { offsets.map(path).collect() } else { Vec::new() };
        Self { critical, body, mixture, paths }
    }

    /// How many times further a bond from a point, of the offset with an index, stretches than one of the base material.
    pub(in super::super) fn ratio(&self, index: usize, lower: usize) -> f64 {
        let Some(path) = self.paths.get(index) else { return 1.0 };
        let lattice = self.body.0;
        let first = lattice.cell(lower);
        let passed = || path.iter().map(|&(step, part)| (plus(first, step), part));
        let modulus = || self.mixture.map_or(1.0, |mixture| mixture.through(self.body, passed()).weights[0]);
        self.critical.ratio(passed().filter_map(|(cell, _)| lattice.number(cell)), modulus)
    }
}
