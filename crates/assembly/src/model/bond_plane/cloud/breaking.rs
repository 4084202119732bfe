//! Breaking bonds of a cloud.

use super::CloudBody;
use crate::model::plane::{CriticalStretch, remove_spanning, spanning};
use crate::stiffness::{Bond, Bonds, Families, Term};
use std::collections::HashSet;
use std::sync::Arc;

impl CloudBody<2, 3> {
    /// Above the number of any bond: a bond has the number `lower point · points + other point`.
    pub(in super::super) fn bond_numbers(&self) -> u64 {
        (self.sites.positions.len() as u64).pow(2)
    }

    pub(in super::super) fn ends(&self, bond: u64) -> [usize; 2] {
        let n = self.sites.positions.len() as u64;
        [(bond / n) as usize, (bond % n) as usize]
    }

    fn number(&self, bond: &Bond<2, 1>) -> u64 {
        let [i, j] = bond.points.map(u64::from);
        i * self.sites.positions.len() as u64 + j
    }

    pub(in super::super) fn for_each_ratio(
        &self,
        u: &[f64],
        critical: &CriticalStretch,
        visit: &mut dyn FnMut(u64, f64),
    ) {
        for bond in self.bonds.list() {
            let ([e], _) = bond.response(self.sites.positions.len(), u);
            let ratio = e / (self.length(bond) * critical.by_offset()[0]);
            if ratio > 0.0 {
                visit(self.number(bond), ratio);
            }
        }
    }

    /// The bonds with these numbers that are there.
    fn listed(&self, bonds: &[u64]) -> Vec<Bond<2, 1>> {
        let wanted: HashSet<u64> = bonds.iter().copied().collect();
        self.bonds.list().iter().filter(|bond| wanted.contains(&self.number(bond))).copied().collect()
    }

    pub(in super::super) fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<2>>> {
        let (n, listed) = (self.sites.positions.len(), self.listed(bonds));
        let spanning = spanning(&self.overlay, &listed);
        vec![Box::new(Bonds::new(n, listed.into_iter())), Box::new(Families::new(n, spanning))]
    }

    pub(in super::super) fn break_bonds(&mut self, bonds: &[u64]) {
        let broken = self.listed(bonds);
        let gone: HashSet<[u32; 2]> = broken.iter().map(|b| b.points).collect();
        for bond in &broken {
            self.lose(bond.points.map(|p| p as usize));
        }
        Arc::make_mut(&mut self.bonds).retain(|bond| !gone.contains(&bond.points));
        remove_spanning(&mut self.overlay, &broken.iter().map(|bond| bond.points).collect());
    }
}
