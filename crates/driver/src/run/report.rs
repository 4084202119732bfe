//! Everything about a run but the fields.

use super::beam::ExactState;
use super::fracture::FractureReport;
use super::path::PathReport;
use super::scene_sizes::Sizes;
use super::solver_report::SolverReport;
use crate::diagnostic::Faults;

/// How often expensive things were done.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Counters {
    /// Numeric factorisations.
    pub factorisations: usize,
    /// Symbolic analyses.
    pub analyses: usize,
    /// Conjugate-gradient iterations of all states.
    pub pcg_iterations: usize,
    /// Right-hand sides solved.
    pub right_hand_sides: usize,
    /// Elements (bonds, springs) evaluated, all sweeps together.
    pub bond_evaluations: u64,
    /// Numbers stored per bond.
    pub stored_bond_factors: usize,
    /// Bytes of the factor.
    pub factor_bytes: usize,
}

/// Wall time per stage, s. Load cases that are recorded while others are solved share the processor with these, and stages may add up to
/// more than a run takes.
#[derive(Clone, Debug, Default, serde::Serialize)]
pub struct Timing {
    /// Assembly of the stiffness, or of the coarser levels.
    pub assemble: f64,
    /// Factorisation, or set-up of the levels.
    pub factor: f64,
    /// Conjugate gradients and refinement of all states.
    pub solve: f64,
    /// Certificates of all states.
    pub certify: f64,
    /// Recovery of fields, checks, and writing.
    pub record: f64,
    /// Solving the exact beam, where a beam has another law, other ends or another grid: what these are off by.
    pub compare: f64,
    /// Other grids, for the estimate of the error of this one.
    pub estimate: f64,
}

/// Everything about a run but the fields.
#[derive(Clone, Debug, Default)]
pub struct RunReport {
    /// Sizes.
    pub sizes: Sizes,
    /// Method and why it was chosen.
    pub solver: SolverReport,
    /// Counters.
    pub counters: Counters,
    /// Wall times.
    pub timing: Timing,
    /// What this scene was spared, and why.
    pub skipped: Vec<String>,
    /// Doubts about results that are known only with them.
    pub warnings: Faults,
    /// Whether every state converged.
    pub converged: bool,
    /// Whether the run was asked to end before it was done.
    pub is_interrupted: bool,
    /// How the body broke.
    pub fracture: Option<FractureReport>,
    /// How the body went along its path.
    pub path: Option<PathReport>,
    /// What the states of the exact beam are, where a beam was compared with it.
    pub exact: Option<Vec<ExactState>>,
}

impl RunReport {
    /// Why a body that breaks or softens did not come to the end of what was asked for, if it did not.
    pub(crate) fn missed_goal(&self) -> Option<&'static str> {
        let broken = self.fracture.as_ref().map(|r| (r.reached_goal, r.ending));
        let (reached, ending) = broken.or_else(|| self.path.as_ref().map(|r| (r.reached_goal, r.ending)))?;
        (!reached).then_some(ending)
    }
}
