//! Breaking bonds of state-based bodies.
//!
//! A bond breaks where its stretch reaches the critical one. It is gone from the families of both of its points, whose
//! weighted volumes stay those of the undamaged families: what they lack makes them softer, and no energy is negative.
//! Ghosts are continuations of unbroken bodies: with a bond between two points of its fit a ghost is gone, and all of its
//! bonds with it. Bonds across a line of symmetry, or across the axis, do not break.

use super::super::plane::CriticalStretch;
use super::StateBased;
use super::body::StateBody;
use crate::body::{Cell, plus};
use crate::model::Breakable;
use crate::stiffness::{Bonds, FamilyRows, Term};
use std::collections::{BTreeMap, BTreeSet, HashSet};

/// Offset of the half and lower point.
type Place = (usize, usize);

impl StateBody {
    /// Ghosts that have two points in their fits between which one of some bonds was.
    fn lost_ghosts(&self, bonds: &[Place]) -> Vec<Cell> {
        let pairs: HashSet<[Cell; 2]> = bonds
            .iter()
            .filter_map(|&(offset, lower)| {
                let upper = self.upper(offset, lower)?;
                Some([self.lattice.cell(lower), self.lattice.cell(upper)])
            })
            .collect();
        let has_both = |fit: &[(Cell, f64)]| {
            let cells = || fit.iter().map(|(cell, _)| *cell);
            cells().any(|a| cells().any(|b| pairs.contains(&[a, b])))
        };
        self.fits.iter().filter(|(_, fit)| has_both(fit)).map(|(cell, _)| *cell).collect()
    }

    /// Some bonds, with all bonds of the ghosts that go with them.
    fn with_ghosts(&self, bonds: &[Place], ghosts: &[Cell]) -> Vec<Place> {
        let mut all: BTreeSet<Place> = bonds.iter().copied().collect();
        let half = self.families.offsets.len() / 2;
        // Images of a ghost go with it.
        let is_lost = |own: &&u32| {
            let (cell, _) = self.mirrors.image(self.lattice.cell(**own as usize));
            ghosts.binary_search(&cell).is_ok()
        };
        for &own in self.ghosts.iter().filter(|_| !ghosts.is_empty()).filter(is_lost) {
            let (own, cell) = (own as usize, self.lattice.cell(own as usize));
            for (k, step) in self.families.offsets.iter().enumerate() {
                let Some(other) = self.lattice.number(plus(cell, *step)) else { continue };
                all.insert(if k < half { (k, own) } else { (k - half, other) });
            }
        }
        all.into_iter().collect()
    }

    /// Rows of the points at the ends of some bonds without them.
    fn rows_without(&self, bonds: &[Place]) -> Vec<(usize, FamilyRows)> {
        let mut changed: BTreeMap<usize, FamilyRows> = BTreeMap::new();
        for &(offset, lower) in bonds {
            let Some(upper) = self.upper(offset, lower) else { continue };
            for (point, offset) in [(lower, offset), (upper, self.families.opposite(offset))] {
                let Some(set) = self.families.set_of[point] else { continue };
                let own = || self.dilatation_rows(&self.families.sets[set as usize]);
                changed.entry(point).or_insert_with(own)[offset] = [0.0; 2];
            }
        }
        changed.into_iter().collect()
    }
}

impl StateBased {
    fn place_of(&self, bond: u64) -> Place {
        let (bond, points) = (bond as usize, self.body.lattice.points());
        (bond / points, bond % points)
    }

    /// Places with indices among the offsets that have bonds.
    fn in_grid(&self, bonds: &[Place]) -> Vec<Place> {
        let bonded: Vec<usize> = self.body.bonded().collect();
        let index = |k: usize| bonded.iter().position(|b| *b == k);
        bonds.iter().filter_map(|&(k, lower)| Some((index(k)?, lower))).collect()
    }

    /// Bonds that go when some break.
    fn gone(&self, bonds: &[u64]) -> (Vec<Place>, Vec<Cell>) {
        let places: Vec<Place> = bonds.iter().map(|&bond| self.place_of(bond)).collect();
        let ghosts = self.body.lost_ghosts(&places);
        (self.body.with_ghosts(&places, &ghosts), ghosts)
    }
}

impl Breakable<2> for StateBased {
    type Critical = CriticalStretch;

    fn bond_numbers(&self) -> u64 {
        (self.body.families.offsets.len() / 2 * self.body.lattice.points()) as u64
    }

    fn ends(&self, bond: u64) -> [usize; 2] {
        let (offset, lower) = self.place_of(bond);
        [lower, self.body.upper(offset, lower).unwrap_or(lower)]
    }

    fn offset(&self, bond: u64) -> usize {
        self.place_of(bond).0
    }

    fn for_each_ratio(&self, u: &[f64], critical: &CriticalStretch, visit: &mut dyn FnMut(u64, f64)) {
        let Some(bonds) = self.body.term.bonds() else { return };
        let (lattice, mirrors) = (&self.body.lattice, &self.body.mirrors);
        let points = lattice.points();
        let bonded: Vec<usize> = self.body.bonded().collect();
        let is_own = |p: usize| mirrors.is_none() || mirrors.is_real(lattice.cell(p));
        bonds.for_each_measured(u, |index, [lower, _], [elongation]| {
            let k = bonded[index];
            let [a, b, _] = lattice.vector(self.body.families.offsets[k]);
            let ratio = elongation / (a.hypot(b) * critical.by_offset()[k]);
            if ratio > 0.0 && is_own(lower) && self.body.upper(k, lower).is_some_and(is_own) {
                visit((k * points + lower) as u64, ratio);
            }
        });
    }

    fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<2>>> {
        let (gone, _) = self.gone(bonds);
        let n = self.body.lattice.points();
        let mut part: Vec<Box<dyn Term<2>>> = Vec::new();
        if let Some(grid) = self.body.term.bonds() {
            let listed = self.in_grid(&gone).into_iter().filter_map(|(k, lower)| grid.bond(k, lower));
            part.push(Box::new(Bonds::new(n, listed)));
        }
        let rows = self.body.rows_without(&gone);
        for before in self.body.term.families() {
            let mut after = (**before).clone();
            after.set_rows(&rows);
            part.push(Box::new(before.clone()));
            part.push(Box::new(after.negated()));
        }
        part
    }

    fn break_bonds(&mut self, bonds: &[u64]) {
        let (gone, ghosts) = self.gone(bonds);
        let rows = self.body.rows_without(&gone);
        self.body.term.change(&self.in_grid(&gone), &rows);
        self.body.remove(&gone);
        ghosts.iter().for_each(|ghost| _ = self.body.fits.remove(ghost));
    }
}
