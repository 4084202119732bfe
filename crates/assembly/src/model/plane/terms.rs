//! The energy of a lattice: its bonds, and what completes them at edges.

use super::body::LatticeBody;
use super::bond::PlaneBond;
use super::edges::{BorderShares, border_shares};
use crate::model::ModelSizes;
use crate::stiffness::Term;

impl<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>> LatticeBody<D, M, S, B> {
    /// Terms of the energy.
    pub(in super::super) fn terms(&self) -> Vec<Box<dyn Term<D>>> {
        let mut terms: Vec<Box<dyn Term<D>>> = vec![Box::new(self.bonds.clone())];
        match &self.border {
            Some(border) if border.bonds.count() > 0 => terms.push(Box::new(border.bonds.clone())),
            None if !self.triangles.list().is_empty() => terms.push(Box::new(self.triangles.clone())),
            _ => {}
        }
        terms
    }

    /// Number of elements that complete edges.
    pub(in super::super) fn completing(&self) -> usize {
        match &self.border {
            Some(border) => border.bonds.count(),
            None => self.triangles.list().len(),
        }
    }

    /// How places on the border move, where bonds end on it.
    pub(in super::super) fn border_shares(&self) -> Option<BorderShares<'_>> {
        self.border.as_ref()?;
        let cuts = self.cuts.iter().copied().collect();
        Some(border_shares(&self.lattice, &self.mirrors, &self.hood, cuts))
    }

    /// Their sizes.
    pub(in super::super) fn sizes(&self) -> ModelSizes {
        let bonds = ModelSizes::of(&self.bonds, self.bonds.elements());
        match &self.border {
            Some(border) => bonds.join(ModelSizes::of(&border.bonds, border.bonds.pairs())),
            None => bonds.join(ModelSizes::of(&self.triangles, 3 * self.triangles.elements())),
        }
    }
}
