//! What is reported of a body that broke.

use super::super::solver_report::SolverReport;
use super::super::{Counters, RunReport, Sizes};
use super::breaking::Breaking;
use super::ending::Ending;
use super::problem::{BreakingBody, Facts};
use crate::diagnostic::{Faults, JsonPath};

/// How a body broke.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct FractureReport {
    /// Why the run ended.
    pub ending: &'static str,
    /// Whether it came to the end of what was asked for: limits are kept there, or not at all.
    pub reached_goal: bool,
    /// Equilibria.
    pub solves: usize,
    /// Bonds that broke.
    pub broken_bonds: usize,
    /// Points of parts that came off.
    pub island_points: usize,
    /// Conjugate-gradient iterations per solve, on the mean.
    pub mean_iterations: f64,
    /// What checks can ask for, by name.
    pub facts: serde_json::Map<String, serde_json::Value>,
}

impl<const D: usize, P: BreakingBody<D>> Breaking<'_, D, P> {
    /// Doubts about what was found.
    fn warnings(&self) -> Faults {
        let (mut faults, path) = (Faults::default(), JsonPath::default().key("fracture"));
        if self.is_rounding {
            faults
                .warning(path.key("load"), "the probe that stands for the load is zero but for rounding")
                .hint("take one that the loads or motions work with: its peak and what ends the run mean nothing");
        }
        if self.loads_gone {
            faults
                .warning(path.clone(), "loads acted on parts that came off: they act no more")
                .hint("the load factor is that of the loads that are left");
        }
        for doubt in self.body.doubts(&self.broken) {
            faults.warning(path.key("directions"), doubt).hint("let `from` and `to` hold one straight crack");
        }
        faults
    }

    pub(super) fn report(self, sizes: Sizes, ending: Ending) -> RunReport {
        let facts = Facts::of(&self.events, self.body.facts(&self.broken));
        let mut counters: Counters = self.unit.counters.clone();
        let (method, reason) = self.unit.inverse.method(self.body.problem().solver());
        let solver = SolverReport {
            method: method.into(),
            reason,
            factor_entries: counters.factor_bytes / size_of::<f64>(),
            ..SolverReport::default()
        };
        counters.bond_evaluations = self.system.evaluations();
        counters.stored_bond_factors = self.system.terms().iter().map(|t| t.stored_factors()).sum();
        let warnings = self.warnings();
        let iterations: usize = self.events.iter().map(|e| e.iterations).sum();
        let mean_iterations = iterations as f64 / counters.right_hand_sides.max(1) as f64;
        RunReport {
            sizes,
            solver,
            counters,
            timing: self.timing,
            warnings,
            converged: self.converged,
            is_interrupted: ending == Ending::Interrupted,
            fracture: Some(FractureReport {
                ending: ending.words(),
                reached_goal: ending.is_goal(),
                solves: self.events.len(),
                broken_bonds: self.broken.len(),
                island_points: self.islands.points(),
                mean_iterations,
                facts: facts.0.into_iter().map(|(name, value)| (name, value.into())).collect(),
            }),
            ..RunReport::default()
        }
    }
}
