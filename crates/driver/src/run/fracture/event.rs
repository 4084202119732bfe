//! What is told of every equilibrium of a body that breaks, and what it takes to go on from one.

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
    /// Bonds that broke here.
    pub broken_now: usize,
    /// Bonds that are broken.
    pub broken: usize,
    /// Points in parts that have come off.
    pub islands: usize,
    /// Work of the loads and of prescribed motions.
    pub work: f64,
    /// Strain energy.
    pub stored: f64,
    /// Energy that is gone: work less strain energy.
    pub released: f64,
    /// Energy of the broken bonds at their failure.
    pub bond_energy: f64,
    /// Part of the released energy that the breaking of bonds did not take up at a constant load.
    pub unstable_release: f64,
    /// What the balance of energies lacks.
    pub balance: f64,
    /// Iterations of this solve.
    pub iterations: usize,
    /// Factorisations so far.
    pub factorisations: usize,
    /// Relative residual of this solve.
    pub residual: f64,
}

/// What it takes to go on from an equilibrium of a body that breaks.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Restart {
    /// The case, [`crate::scene::Scene::fingerprint`]; a run leaves it empty, [`crate::Loaded::run`] fills it in.
    pub case: String,
    /// The equilibria so far.
    pub events: Vec<Event>,
    /// The bonds that are broken, in the order in which they broke.
    pub broken: Vec<u64>,
    /// How many of them were broken when the factor was made.
    pub factored: usize,
    /// Displacements at the unit load, one plane per component.
    pub unit: Vec<f64>,
    /// Unknowns of parts that have come off, with their values.
    pub islands: Vec<(u64, f64)>,
    /// Number of states that were recorded.
    pub recorded: usize,
    /// Load step.
    pub step: usize,
    /// Load factor.
    pub load_factor: f64,
    /// What the summary says of the recorded states; filled in likewise.
    pub summaries: String,
}
