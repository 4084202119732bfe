//! The energy of a lattice: its bonds, and what completes them at edges.

use super::body::LatticeBody;
use super::bond::PlaneBond;
use super::edges::{BorderShares, By, Section, border_shares, cut_shares, left_to_triangles};
use super::interface::Interface;
use crate::body::Cell;
use crate::model::ModelSizes;
use crate::stiffness::Term;

impl<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>> LatticeBody<D, M, S, B> {
    /// Terms of the energy.
    pub(in super::super) fn terms(&self) -> Vec<Box<dyn Term<D>>> {
        let mut terms: Vec<Box<dyn Term<D>>> = vec![Box::new(self.bonds.clone())];
        if let Some(interface) = self.interface.as_ref().filter(|i| !i.families.list().is_empty()) {
            terms.push(Box::new(interface.families.clone()));
        }
        if self.completing() == 0 {
            return terms;
        }
        terms.push(match &self.border.by {
            By::Points => Box::new(self.triangles.clone()),
            By::Bonds(border) => Box::new(border.bonds.clone()),
            By::Triangles(families) => Box::new(families.clone()),
        });
        terms
    }

    /// Number of elements that complete edges.
    pub(in super::super) fn completing(&self) -> usize {
        match &self.border.by {
            By::Points => self.triangles.list().len(),
            By::Bonds(border) => border.bonds.count(),
            By::Triangles(families) => families.count(),
        }
    }

    /// How places on the border move, where bodies end on it.
    pub(in super::super) fn border_shares(&self) -> Option<BorderShares<'_>> {
        let cuts = || self.cuts.iter().copied().collect();
        match (self.border.is_none(), self.border.is_cut()) {
            (true, _) => None,
            (_, false) => Some(border_shares(&self.lattice, &self.mirrors, &self.neighbourhood, cuts())),
            (_, true) => {
                let parted = (cuts(), !self.apart.is_empty());
                Some(cut_shares(&self.lattice, &self.mirrors, &self.neighbourhood, parted))
            }
        }
    }

    /// What bonds leave to the triangles that the border cuts, in the order of these: parts of one bond per offset that has bonds.
    pub(in super::super) fn left_to_triangles(&self) -> Vec<Vec<f64>> {
        let cuts = self.cuts.iter().copied().collect();
        left_to_triangles((&self.lattice, &self.mirrors), &self.neighbourhood, &cuts)
    }

    /// What lies around some points of a body whose border cuts blocks.
    pub(in super::super) fn section(&self, points: impl Iterator<Item = usize>) -> Section {
        let cells: Vec<Cell> = points.map(|point| self.lattice.cell(point)).collect();
        Section::new(&self.lattice, &self.mirrors, &cells)
    }

    /// Their sizes.
    pub(in super::super) fn sizes(&self) -> ModelSizes {
        let mut bonds = ModelSizes::of(&self.bonds, self.bonds.elements());
        if let Some(Interface { families, .. }) = self.interface.as_deref() {
            bonds = bonds.join(ModelSizes::of(families, 3 * families.elements()));
        }
        bonds.join(match &self.border.by {
            By::Points => ModelSizes::of(&self.triangles, 3 * self.triangles.elements()),
            By::Bonds(border) => ModelSizes::of(&border.bonds, border.bonds.pairs()),
            By::Triangles(families) => ModelSizes::of(families, families.pairs()),
        })
    }
}
