//! The energy of a lattice: its bonds, and what completes them at edges.

use super::body::LatticeBody;
use super::bond::PlaneBond;
use super::edges::{BorderShares, border_shares, cut_shares};
use crate::model::ModelSizes;
use crate::stiffness::Term;

impl<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>> LatticeBody<D, M, S, B> {
    /// Terms of the energy.
    pub(in super::super) fn terms(&self) -> Vec<Box<dyn Term<D>>> {
        let mut terms: Vec<Box<dyn Term<D>>> = vec![Box::new(self.bonds.clone())];
        match (&self.border, &self.cut) {
            (Some(border), _) if border.bonds.count() > 0 => terms.push(Box::new(border.bonds.clone())),
            (_, Some(cut)) if cut.families.count() > 0 => terms.push(Box::new(cut.families.clone())),
            (None, None) if !self.triangles.list().is_empty() => terms.push(Box::new(self.triangles.clone())),
            _ => {}
        }
        terms
    }

    /// Number of elements that complete edges.
    pub(in super::super) fn completing(&self) -> usize {
        match (&self.border, &self.cut) {
            (Some(border), _) => border.bonds.count(),
            (_, Some(cut)) => cut.families.count(),
            _ => self.triangles.list().len(),
        }
    }

    /// How places on the border move, where bonds end on it.
    pub(in super::super) fn border_shares(&self) -> Option<BorderShares<'_>> {
        let cuts = || self.cuts.iter().copied().collect();
        match (&self.border, &self.cut) {
            (Some(_), _) => Some(border_shares(&self.lattice, &self.mirrors, &self.hood, cuts())),
            (_, Some(_)) => Some(cut_shares(&self.lattice, &self.mirrors, &self.hood, cuts())),
            _ => None,
        }
    }

    /// Their sizes.
    pub(in super::super) fn sizes(&self) -> ModelSizes {
        let bonds = ModelSizes::of(&self.bonds, self.bonds.elements());
        match (&self.border, &self.cut) {
            (Some(border), _) => bonds.join(ModelSizes::of(&border.bonds, border.bonds.pairs())),
            (_, Some(cut)) => bonds.join(ModelSizes::of(&cut.families, cut.families.pairs())),
            _ => bonds.join(ModelSizes::of(&self.triangles, 3 * self.triangles.elements())),
        }
    }
}
