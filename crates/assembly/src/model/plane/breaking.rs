//! Breaking bonds of a lattice.

use super::body::LatticeBody;
use super::bond::PlaneBond;
use super::geometry;
use super::near::at;
use crate::stiffness::{Bond, Bonds, Families, Family, GridBonds, Term};
use std::collections::HashSet;
use std::sync::Arc;

/// Critical stretches of the bonds of every offset, infinite where none break; of a cloud there is one.
///
/// A bond fails in tension alone: where its stretch, the elongation over its length, reaches the critical one.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalStretch(pub Vec<f64>);

impl<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>> LatticeBody<D, M, S, B> {
    /// Above the number of any bond: a bond has the number `offset · points + lower point`, the offset that of the
    /// neighbourhood.
    pub(in super::super) fn bond_numbers(&self) -> u64 {
        (self.hood.offsets.len() * self.lattice.points()) as u64
    }

    /// Offset and lower point of a bond.
    fn place_of(&self, bond: u64) -> (usize, usize) {
        let (bond, points) = (bond as usize, self.lattice.points());
        (bond / points, bond % points)
    }

    pub(in super::super) fn ends(&self, bond: u64) -> [usize; 2] {
        let (offset, lower) = self.place_of(bond);
        let upper = self.lattice.number(at(self.lattice.cell(lower), self.hood.offsets[offset], true));
        [lower, upper.unwrap_or(lower)]
    }

    pub(in super::super) fn for_each_ratio(
        &self,
        u: &[f64],
        critical: &CriticalStretch,
        visit: &mut dyn FnMut(u64, f64),
    ) {
        let points = self.lattice.points();
        let offsets: Vec<usize> = self.hood.bonded().collect();
        let ratios: Vec<f64> = offsets
            .iter()
            .map(|&k| {
                let bond = geometry(&self.lattice, self.hood.offsets[k]);
                self.kind.bond.stretch_per_measure(&bond) / critical.0[k]
            })
            .collect();
        self.bonds.for_each_measured(u, |index, lower, s| {
            let ratio = ratios[index] * s[0];
            if ratio > 0.0 {
                visit((offsets[index] * points + lower) as u64, ratio);
            }
        });
    }

    /// Indices of the offsets among those that have bonds.
    fn classes(&self) -> Vec<Option<usize>> {
        let mut next = 0..;
        (0..self.hood.offsets.len())
            .map(|k| if self.hood.has_bonds(k) { next.next() } else { None })
            .collect()
    }

    pub(in super::super) fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<D>>> {
        let classes = self.classes();
        let listed = |&bond: &u64| {
            let (offset, lower) = self.place_of(bond);
            self.bonds.bond(classes[offset]?, lower)
        };
        let listed: Vec<Bond<D, M>> = bonds.iter().filter_map(listed).collect();
        let spanning = spanning(&self.triangles, &listed);
        let n = self.lattice.points();
        vec![Box::new(Bonds::new(n, listed.into_iter())), Box::new(Families::new(n, spanning))]
    }

    /// Removes bonds of a body without images; bits of other bonds do not change.
    ///
    /// # Panics
    /// The body has images.
    pub(in super::super) fn break_bonds(&mut self, bonds: &[u64]) {
        assert!(self.ghosts.is_empty(), "the image of a bond would not break with it");
        let classes = self.classes();
        let places: Vec<(usize, usize)> = bonds.iter().map(|&bond| self.place_of(bond)).collect();
        let of_grid = |&(offset, lower): &(usize, usize)| Some((classes[offset]?, lower));
        let grid: Vec<(usize, usize)> = places.iter().filter_map(of_grid).collect();
        let broken: Vec<Bond<D, M>> =
            grid.iter().filter_map(|&(k, lower)| self.bonds.bond(k, lower)).collect();
        Arc::<GridBonds<D, M, B>>::make_mut(&mut self.bonds).break_bonds(grid);
        remove_spanning(&mut self.triangles, &broken);
        self.cuts.extend(places);
    }
}

/// The triangles that span one of some bonds.
pub(in super::super) fn spanning<const D: usize, const M: usize, const S: usize>(
    triangles: &Families<D, S, 2>,
    bonds: &[Bond<D, M>],
) -> Vec<Family<D, S, 2>> {
    if triangles.list().is_empty() {
        return Vec::new();
    }
    let pairs: HashSet<[u32; 2]> = bonds.iter().map(|b| b.points).collect();
    triangles.list().iter().filter(|t| spans(t, &pairs)).copied().collect()
}

/// Removes the triangles that span one of some bonds.
pub(in super::super) fn remove_spanning<const D: usize, const M: usize, const S: usize>(
    triangles: &mut Arc<Families<D, S, 2>>,
    bonds: &[Bond<D, M>],
) {
    if !triangles.list().is_empty() {
        let pairs: HashSet<[u32; 2]> = bonds.iter().map(|b| b.points).collect();
        Arc::make_mut(triangles).retain(|t| !spans(t, &pairs));
    }
}

/// Whether a side of a triangle is one of some pairs, the lower point first.
fn spans<const D: usize, const S: usize>(triangle: &Family<D, S, 2>, pairs: &HashSet<[u32; 2]>) -> bool {
    let ([a, b], p) = (triangle.others, triangle.point);
    [[p, a], [p, b], [a, b]].into_iter().any(|[i, j]| pairs.contains(&[i.min(j), i.max(j)]))
}
