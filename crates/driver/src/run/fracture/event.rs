//! What is reported of every equilibrium of a body that breaks, and what it takes to go on from one.

use super::super::RunError;
use serde::{Deserialize, Serialize};

/// An equilibrium of a body that breaks: a row of `curve.csv`. Energies are sums since the start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Load step, from 0.
    pub step: usize,
    /// Number of the equilibrium, from 0.
    pub solve: usize,
    /// Load factor.
    pub load_factor: f64,
    /// Value of the probe that stands for the load.
    pub load: f64,
    /// Bonds that break at this equilibrium.
    pub broken_now: usize,
    /// Bonds that were broken before.
    pub broken: usize,
    /// Points in parts that have come off.
    pub island_points: usize,
    /// Work of the loads and of prescribed motions.
    pub work: f64,
    /// Strain energy.
    pub stored: f64,
    /// Energy that breaking bonds released, from the strains of the bonds before and after; the work is this and the strain
    /// energy.
    pub released: f64,
    /// Energy of the broken bonds at their failure.
    pub bond_energy: f64,
    /// The rest of the released energy: what the body gives at a load that does not follow, and would go into motion.
    pub unstable_release: f64,
    /// What work, strain energy and released energy lack of a balance, over the work.
    pub balance: f64,
    /// Iterations of this solve; none where no bond broke before.
    pub iterations: usize,
    /// Factorisations so far.
    pub factorisations: usize,
    /// Residual of this solve at the unit load, 2-norm.
    pub residual: f64,
}

/// What it takes to go on from an equilibrium of a body that breaks.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BreakRestart {
    /// The equilibria so far.
    pub events: Vec<Event>,
    /// The bonds that are broken, in the order in which they broke.
    pub broken: Vec<u64>,
    /// How many of them were broken when the factor was made.
    pub factored: usize,
    /// Displacements at the unit load, one plane per component.
    pub unit: Vec<f64>,
    /// Unknowns of parts that have come off, with their values.
    pub frozen: Vec<(u64, f64)>,
    /// Load step.
    pub step: usize,
    /// Load factor.
    pub load_factor: f64,
    /// Solves so far.
    pub right_hand_sides: usize,
    /// Iterations so far, those of recorded states among them.
    pub pcg_iterations: usize,
    /// The residual that is asked for, 2-norm.
    pub target: f64,
}

impl BreakRestart {
    /// Whether this can be of a body with so many unknowns and bond numbers.
    ///
    /// # Errors
    /// [`RunError::Misfit`] if something in it is none of this body.
    pub(super) fn fits(&self, unknowns: usize, bond_numbers: u64) -> Result<(), RunError> {
        let fits = self.unit.len() == unknowns
            && self.factored <= self.broken.len()
            && self.broken.iter().all(|&bond| bond < bond_numbers)
            && self.frozen.iter().all(|&(unknown, _)| unknown < unknowns as u64);
        if fits { Ok(()) } else { Err(RunError::Misfit) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_restart_of_another_body_does_not_fit() {
        let fitting = BreakRestart {
            broken: vec![7, 0],
            factored: 2,
            unit: vec![0.0; 6],
            frozen: vec![(5, 0.1)],
            ..BreakRestart::default()
        };
        fitting.fits(6, 8).unwrap();
        let misfits = [
            fitting.fits(7, 8),
            fitting.fits(6, 7),
            BreakRestart { factored: 3, ..fitting.clone() }.fits(6, 8),
            BreakRestart { frozen: vec![(6, 0.1)], ..fitting.clone() }.fits(6, 8),
        ];
        for misfit in misfits {
            assert!(matches!(misfit, Err(RunError::Misfit)));
        }
    }
}
