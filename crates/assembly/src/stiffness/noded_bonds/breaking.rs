//! Bonds between points and nodes that break one by one. They keep their numbers.

use super::{NodedBonds, PlacedBond, PlacedBonds};
use std::collections::HashMap;

/// What moves the bonds, by their numbers.
#[derive(Clone, Debug, Default)]
pub struct BondPoints {
    /// Per bond: the two points that have the largest parts in the relative displacement of its ends, one on either side.
    pub foremost: Vec<[u32; 2]>,
    /// Per bond: the point that one of its ends is, if it is one.
    pub own: Vec<Option<u32>>,
    /// Per point: the bonds whose middle it moves, ascending.
    moved: HashMap<u32, Vec<u32>>,
}

impl BondPoints {
    /// The bonds whose middles both of two points move, ascending.
    pub fn moved_by_both(&self, pair: [u32; 2]) -> impl Iterator<Item = usize> + '_ {
        let [first, second] = pair.map(|point| self.moved.get(&point).map_or(&[][..], Vec::as_slice));
        first.iter().filter(|bond| second.binary_search(bond).is_ok()).map(|bond| *bond as usize)
    }
}

impl<const D: usize, const M: usize> NodedBonds<D, M> {
    /// Whether a bond has broken.
    pub fn is_broken(&self, bond: usize) -> bool {
        self.factors.get(bond).is_some_and(|factor| *factor == 0.0)
    }

    /// Removes bonds by their numbers, which the others keep.
    pub fn break_bonds(&mut self, bonds: &[usize]) {
        if self.factors.is_empty() && !bonds.is_empty() {
            self.factors = vec![1.0; self.count()];
        }
        bonds.iter().for_each(|&bond| self.factors[bond] = 0.0);
    }

    /// Some of the bonds, ascending numbers, as far as they have not broken.
    pub fn part(&self, bonds: &[usize]) -> PlacedBonds<D, M> {
        let mut part = PlacedBonds::new(self.points);
        self.for_each_of(bonds, |_, _, bond| _ = part.push(bond));
        part
    }

    /// Calls `visit` with some of the bonds, ascending numbers, as far as they have not broken: their kind and the point that one of
    /// their ends is, if it is one.
    pub fn for_each_of(
        &self,
        bonds: &[usize],
        mut visit: impl FnMut(usize, Option<usize>, &PlacedBond<D, M>),
    ) {
        if bonds.is_empty() {
            return;
        }
        let places = self.places();
        self.for_each_numbered(|number, kind, ends| {
            if bonds.binary_search(&number).is_ok() {
                let own = self.own(kind, ends).map(|own| own as usize);
                visit(kind, own, &self.placed(&places, kind, ends));
            }
        });
    }

    /// The point that an end of a bond is, if one is.
    fn own(&self, kind: usize, ends: [&[u32]; 2]) -> Option<u32> {
        let own = ends.into_iter().zip(&self.shares[kind]).find(|(_, shares)| shares.is_empty());
        own.map(|(ids, _)| ids[0])
    }

    /// What moves all bonds.
    pub fn points(&self) -> BondPoints {
        let (places, mut found) = (self.places(), BondPoints::default());
        found.foremost = vec![[0; 2]; self.count()];
        found.own = vec![None; self.count()];
        self.for_each_numbered(|number, kind, ends| {
            let mut one = PlacedBonds::new(self.points);
            found.own[number] = self.own(kind, ends);
            found.foremost[number] = one.push(&self.placed(&places, kind, ends));
            for (point, _) in one.middle(0) {
                found.moved.entry(point as u32).or_default().push(number as u32);
            }
        });
        found
    }
}
