//! The energy of a plate: its bonds, what completes them, and dilatations.
//!
//! One term, not several: dilatations alone have a negative energy where `λ < μ`.

use super::families::Dilatations;
use super::rings::terms;
use super::sources::Bonded;
use crate::bonds::Mat;
use crate::stiffness::{BlockMatrix, ConnectedParts, Survey, Term};
use std::fmt::{Debug, Formatter, Result};
use std::sync::Arc;

/// Terms whose sum is an energy.
#[derive(Clone)]
pub(super) struct JointTerm {
    /// Bonds, and what completes them.
    bonds: Arc<Vec<Box<dyn Term<2>>>>,
    families: Arc<Vec<Box<dyn Term<2>>>>,
}

impl Debug for JointTerm {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.debug_struct("JointTerm").field("elements", &self.elements()).finish()
    }
}

impl JointTerm {
    pub(super) fn new(plate: &Bonded, dilatations: Option<&Dilatations>) -> Self {
        let families = dilatations.map_or(Vec::new(), |of| {
            let mut terms: Vec<Box<dyn Term<2>>> = vec![Box::new(of.grid.clone()), Box::new(of.own.clone())];
            terms.extend(of.means.clone().map(|means| Box::new(means) as Box<dyn Term<2>>));
            terms
        });
        Self { bonds: Arc::new(terms(plate)), families: Arc::new(families) }
    }

    fn parts(&self) -> impl Iterator<Item = &dyn Term<2>> {
        self.bonds.iter().chain(self.families.iter()).map(|term| &**term)
    }
}

impl Term<2> for JointTerm {
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
