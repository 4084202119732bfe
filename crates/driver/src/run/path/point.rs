//! What is reported of every state of a body on its path.

use super::newton::Effort;
use serde::{Deserialize, Serialize};

/// A state in equilibrium: a row of `curve.csv`. Energies are sums since the start.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PathPoint {
    /// Number, from 0.
    pub step: usize,
    /// Load factor.
    pub load_factor: f64,
    /// Value of the probe that stands for the load.
    pub load: f64,
    /// Values of all probes that are displacements, openings or reactions, in their order.
    pub probes: Vec<f64>,
    /// Work of loads and prescribed motions, by the trapezoidal rule from state to state.
    pub work: f64,
    /// Energy that the bonds give back.
    pub stored: f64,
    /// Energy that they do not.
    pub dissipated: f64,
    /// What the work lacks of stored and dissipated energy, over the largest work so far: steps straddle the kinks of bonds and jump where
    /// the body would snap. Exact along a traced path.
    pub balance: f64,
    /// What the work differs from that of the forces of the bonds by the same rule, likewise: equilibrium, and nothing
    /// else.
    pub identity: f64,
    /// Bonds that have changed for good in this step.
    pub changed: usize,
    /// Bonds that have softened and still bear something.
    pub softened: usize,
    /// Bonds that have failed.
    pub broken: usize,
    /// Points of parts that have come off.
    pub island_points: usize,
    /// Iterations of this step, or solves for its direction.
    pub iterations: usize,
    /// Iterations that took a part of the secant stiffness.
    pub blended: usize,
    /// Steps that were tried and refused before this one.
    pub refused: usize,
    /// Factorisations so far.
    pub factorisations: usize,
    /// Residual over the reference force.
    pub residual: f64,
    /// Negative eigenvalues of the stiffness along the step, where the control knows them: a turn of the load factor
    /// explains one, and the path branches where there are more.
    pub negative_eigenvalues: Option<usize>,
    /// Whether the step went away from where the path is to turn: a snap-back.
    pub is_back: bool,
    /// How far the crack has grown, m, from the damage of the bonds that cross the line ahead of its tip.
    pub crack_growth: Option<f64>,
    /// Stress intensity at the load, from the compliance of the body as it was.
    pub stress_intensity: Option<f64>,
    /// Energy per area of a crack, from the work so far.
    pub j_integral: Option<f64>,
}

impl PathPoint {
    /// Whether the path has gone by a branch: it is not stable in more directions than its turns explain.
    pub fn is_branched(&self) -> bool {
        self.negative_eigenvalues.is_some_and(|negative| negative > usize::from(self.is_back))
    }
}

/// What a step has cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Cost {
    pub(super) effort: Effort,
    /// Steps that were tried and refused.
    pub(super) refused: usize,
    /// Negative eigenvalues of the stiffness along the step, where known.
    pub(super) negative: Option<usize>,
}
