//! Where the energy goes.
//!
//! Between two breaks the body is elastic: from the load factor λ₀ to λ the loads and prescribed motions do the work
//! `(λ² − λ₀²) W`, W that from zero to the unit load. When bonds break at a load factor λ, the loads do the work
//! `λ² f·(u₁ − u₀)` of the unit displacements before and after. By reciprocity what this and the strain energy give is
//! `½ λ² Σ k e₀ e₁` over the measures e of the broken bonds, each mode of them: the energy that is released. A bond had
//! `½ λ² k e₀²` when it failed; the rest is released by the body at a load that does not follow: it would go into motion.
//! With strains that need no stress, which grow with the load factor, e is what is beyond these, and the work that of heat, too.

use super::FreeLoad;
use peristat_assembly::stiffness::Term;

/// Sums since the start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Ledger {
    pub(super) work: f64,
    pub(super) released: f64,
    pub(super) bond_energy: f64,
    load_factor: f64,
}

/// Part of the work at the unit load that is not stored, above which the body moves without strain.
const MISSED: f64 = 1e-2;

/// Energies of an equilibrium at the unit load.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct UnitEnergy {
    /// Work of loads, prescribed motions and heat from zero to the unit load.
    pub(super) work: f64,
    /// Strain energy.
    pub(super) stored: f64,
}

impl UnitEnergy {
    /// Whether what works is stored, of a body that takes more than the `most` that was stored so far. Less of it may be rounding, beside a
    /// sudden jump of what is moved.
    pub(super) fn balances(&self, most: f64) -> bool {
        let size = self.work.abs().max(self.stored.abs());
        size <= most || (self.work - self.stored).abs() <= MISSED * size
    }
}

impl Ledger {
    /// Goes on from sums and a load factor.
    pub(super) fn resume(work: f64, released: f64, bond_energy: f64, load_factor: f64) -> Self {
        Self { work, released, bond_energy, load_factor }
    }

    /// The load factor changes with the same bonds.
    pub(super) fn load(&mut self, load_factor: f64, unit: UnitEnergy) {
        self.work += (load_factor - self.load_factor) * (load_factor + self.load_factor) * unit.work;
        self.load_factor = load_factor;
    }

    /// What is `gone` was part of the body with the unit displacements `before`, and is not with those `after`, under the
    /// loads. Where strains need no stress, `free` is what these did to the broken bonds, and to all that is gone.
    pub(super) fn lose<const D: usize>(
        &mut self,
        gone: &[Box<dyn Term<D>>],
        loads: &[f64],
        [before, after]: [&[f64]; 2],
        free: Option<&[FreeLoad; 2]>,
    ) {
        let squared = self.load_factor * self.load_factor;
        let energy = |u: &[f64]| gone.iter().map(|term| term.survey(u).energy).sum::<f64>();
        // A product of two states by the energies of their sum and difference: element by element, so that no rigid
        // motion costs a digit.
        let sum: Vec<f64> = before.iter().zip(after).map(|(a, b)| a + b).collect();
        let difference: Vec<f64> = before.iter().zip(after).map(|(a, b)| a - b).collect();
        let [of_bonds, of_all] =
            free.map_or([0.0; 2], |[bonds, all]| [bonds.stored(before), all.product([before, after])]);
        self.released += squared * (0.25 * (energy(&sum) - energy(&difference)) + of_all);
        self.bond_energy += squared * (energy(before) + of_bonds);
        let moved: f64 = loads.iter().zip(before.iter().zip(after)).map(|(f, (a, b))| f * (b - a)).sum();
        self.work += squared * moved;
    }

    /// A part comes off: forces of loads and holds on its unknowns, and these, at the unit load. What these forces have done
    /// from zero on goes with it.
    pub(super) fn come_off(&mut self, off: impl Iterator<Item = (f64, f64)>) {
        let work: f64 = off.map(|(force, u)| 0.5 * force * u).sum();
        self.released += self.load_factor * self.load_factor * work;
    }

    /// What the balance lacks, relative to the work.
    pub(super) fn imbalance(&self, stored: f64) -> f64 {
        let scale = self.work.abs().max(stored + self.released.abs());
        let lack = self.work - stored - self.released;
        if lack == 0.0 { 0.0 } else { lack / scale }
    }
}
