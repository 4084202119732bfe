//! How much of its family every point of a lattice has lost.

use super::body::LatticeBody;
use super::bond::PlaneBond;
use super::near::at;

impl<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>> LatticeBody<D, M, S, B> {
    /// Makes cut bonds, by offsets of the neighbourhood and lower points, ones that never were: families do not count them.
    pub(in super::super) fn never_joined(&mut self, bonds: &[(usize, usize)]) {
        self.apart.extend(bonds);
        self.apart.sort_unstable();
        self.apart.dedup();
    }

    fn is_apart(&self, bond: (usize, usize)) -> bool {
        self.apart.binary_search(&bond).is_ok()
    }

    /// Cut shares of the family volumes of all points.
    pub(in super::super) fn damage(&self) -> Vec<f64> {
        let mut damage = vec![0.0; self.lattice.points()];
        let known = |cut: &&(usize, usize)| self.neighbourhood.has_bonds(cut.0) && !self.is_apart(**cut);
        for &(offset, lower) in self.cuts.iter().filter(known) {
            if let Some(upper) =
                self.lattice.number(at(self.lattice.cell(lower), self.neighbourhood.offsets[offset], true))
            {
                [lower, upper].into_iter().for_each(|p| damage[p] += self.neighbourhood.parts[offset]);
            }
        }
        for (point, share) in damage.iter_mut().enumerate().filter(|d| *d.1 > 0.0) {
            *share = if self.is_ghost(point) { 0.0 } else { *share / self.family(point) };
        }
        damage
    }

    /// Parts of the family of a point, summed.
    fn family(&self, point: usize) -> f64 {
        let cell = self.lattice.cell(point);
        let sides = self.neighbourhood.bonded().flat_map(|k| [(k, true), (k, false)]);
        let present = sides.filter(|&(k, up)| {
            let other = self.lattice.number(at(cell, self.neighbourhood.offsets[k], up));
            other.is_some_and(|other| !self.is_apart((k, if up { point } else { other })))
        });
        present.map(|(k, _)| self.neighbourhood.parts[k]).sum()
    }
}
