//! The energy of a state-based body: its bonds and what its families have beside them.
//!
//! One term, not two: families alone can have a negative energy (ν < 1/4), with their bonds they have not. Without families
//! it is that of the bonds, and couples no points but those of a bond.

use super::super::bond_plane::CentralBond;
use crate::bonds::Mat;
use crate::stiffness::{
    BlockMatrix, ConnectedParts, FamilyRows, GridBonds, GridFamilies, Survey, TakeForces, Term,
};
use std::sync::Arc;

/// Bonds and families.
#[derive(Clone, Debug)]
pub(super) struct StateTerm {
    bonds: Option<Arc<GridBonds<2, 1, CentralBond>>>,
    /// By material, where that has any.
    families: Vec<Arc<GridFamilies>>,
}

impl StateTerm {
    /// Of no body yet.
    pub(super) fn empty() -> Self {
        Self { bonds: None, families: Vec::new() }
    }

    pub(super) fn new(bonds: GridBonds<2, 1, CentralBond>, families: Vec<GridFamilies>) -> Self {
        Self { bonds: Some(Arc::new(bonds)), families: families.into_iter().map(Arc::new).collect() }
    }

    /// Whether there are families beside the bonds.
    pub(super) fn has_families(&self) -> bool {
        !self.families.is_empty()
    }

    /// The bonds.
    pub(super) fn bonds(&self) -> Option<&Arc<GridBonds<2, 1, CentralBond>>> {
        self.bonds.as_ref()
    }

    /// The families of every material that has any.
    pub(super) fn families(&self) -> &[Arc<GridFamilies>] {
        &self.families
    }

    /// Removes bonds, by index of their offset and lower point, and gives points new rows.
    pub(super) fn change(&mut self, bonds: &[(usize, usize)], rows: &[(usize, FamilyRows)]) {
        if let Some(own) = &mut self.bonds {
            Arc::make_mut(own).break_bonds(bonds.iter().copied());
        }
        for own in &mut self.families {
            Arc::make_mut(own).set_rows(rows);
        }
    }

    fn parts(&self) -> impl Iterator<Item = &dyn Term<2>> {
        let bonds = self.bonds.iter().map(|bonds| &**bonds as &dyn Term<2>);
        bonds.chain(self.families.iter().map(|families| &**families as &dyn Term<2>))
    }
}

impl Term<2> for StateTerm {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        self.parts().for_each(|part| part.couplings(visit));
    }

    fn reach(&self) -> usize {
        self.parts().map(Term::reach).max().unwrap_or(0)
    }

    /// Families join what their bonds join.
    fn join(&self, parts: &mut ConnectedParts) {
        self.bonds.iter().for_each(|bonds| bonds.join(parts));
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        self.parts().for_each(|part| part.add_force(u, force));
    }

    fn sweep(&self, u: &[f64], out: &mut [f64], take: TakeForces<'_, 2>) -> bool {
        match (&self.bonds, &self.families[..]) {
            (Some(bonds), []) => bonds.sweep(u, out, take),
            _ => false,
        }
    }

    fn sweep_in_single(&self, u: &[f32], out: &mut [f32], take: TakeForces<'_, 2, f32>) -> bool {
        match (&self.bonds, &self.families[..]) {
            (Some(bonds), []) => bonds.sweep_in_single(u, out, take),
            _ => false,
        }
    }

    fn sweeps_in_single(&self) -> bool {
        self.bonds.is_some() && self.families.is_empty()
    }

    fn survey(&self, u: &[f64]) -> Survey<2> {
        self.parts().map(|part| part.survey(u)).fold(Survey::EMPTY, Survey::join)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<2>) {
        self.parts().for_each(|part| part.add_tangent(tangent));
    }

    fn add_diagonal(&self, blocks: &mut [Mat<2, 2>]) {
        self.parts().for_each(|part| part.add_diagonal(blocks));
    }

    fn elements(&self) -> usize {
        self.parts().map(Term::elements).sum()
    }

    fn stored_factors(&self) -> usize {
        self.parts().map(Term::stored_factors).sum()
    }
}
