//! Breaking central bonds.

use super::super::plane::CriticalStretch;
use super::{Body, BondPlane};
use crate::model::Breakable;
use crate::stiffness::Term;

impl Breakable<2> for BondPlane {
    type Critical = CriticalStretch;

    fn bond_numbers(&self) -> u64 {
        match &self.body {
            Body::Lattice(body) => body.bond_numbers(),
            Body::Cloud(body) => body.bond_numbers(),
        }
    }

    fn ends(&self, bond: u64) -> [usize; 2] {
        match &self.body {
            Body::Lattice(body) => body.ends(bond),
            Body::Cloud(body) => body.ends(bond),
        }
    }

    fn offset(&self, bond: u64) -> usize {
        match &self.body {
            Body::Lattice(body) => body.offset_of(bond),
            Body::Cloud(_) => 0,
        }
    }

    fn for_each_ratio(&self, u: &[f64], critical: &CriticalStretch, visit: &mut dyn FnMut(u64, f64)) {
        match &self.body {
            Body::Lattice(body) => body.for_each_ratio(u, critical, visit),
            Body::Cloud(body) => body.for_each_ratio(u, critical, visit),
        }
    }

    fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<2>>> {
        match &self.body {
            Body::Lattice(body) => body.part(bonds),
            Body::Cloud(body) => body.part(bonds),
        }
    }

    /// # Panics
    /// The body has images in lines of symmetry.
    fn break_bonds(&mut self, bonds: &[u64]) {
        match &mut self.body {
            Body::Lattice(body) => body.break_bonds(bonds),
            Body::Cloud(body) => body.break_bonds(bonds),
        }
    }
}
