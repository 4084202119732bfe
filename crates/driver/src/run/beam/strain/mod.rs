//! Solving in strains: straight beams with few supports, whatever their slenderness.

mod evidence;
mod memory;
mod off;
mod passes;
mod plan;
mod reactions;
mod solver;

pub(super) use memory::estimate as memory;
pub(super) use plan::chosen;

use crate::run::{
    Counters, Problem, RunError, RunReport, Sizes, SolveFailure, SolvedState, SolverReport, Timing, goes_on,
};
use crate::scene::beam::BeamScene;
use peristat_assembly::model::Model;
use peristat_assembly::model::timoshenko_beam::{BeamLoads, StrainForm, TimoshenkoBeam};
use peristat_assembly::system::System;
use solver::StrainSolver;
use std::time::Instant;

/// Its name in reports.
pub(super) const METHOD: &str = "strain_form";

/// What the strain form needs of a beam with the unknowns (w, φ).
#[derive(Clone, Debug)]
pub(super) struct StrainProblem<'a> {
    /// The beam.
    pub(super) beam: &'a TimoshenkoBeam,
    /// Its strain form.
    pub(super) form: StrainForm<'a>,
    /// A lower bound of the eigenvalues of its scaled stiffness.
    pub(super) least_eigenvalue: f64,
    /// Loads and factor on prescribed motions of every state.
    pub(super) states: Vec<(&'a BeamLoads, f64)>,
}

/// Solves every state and hands solution and certificate to `take`. Loads on points are put together only if `recover`
/// asks for them.
///
/// # Errors
/// [`RunError::Solve`] if the stiffness has no factor, [`RunError::Sink`] from `take`.
pub(super) fn solve_states<const D: usize>(
    scene: &BeamScene,
    parts: StrainProblem,
    (system, sizes): (&System<D>, Sizes),
    recover: bool,
    take: &mut dyn FnMut(SolvedState) -> std::io::Result<()>,
) -> Result<RunReport, RunError>
where
    TimoshenkoBeam: Model<D>,
{
    let mut timing = Timing::default();
    let mut solver = StrainSolver::new(&parts, system.constraints(), &scene.springs, &mut timing)?;
    let mut load = vec![0.0; if recover { system.size() } else { 0 }];
    let (mut converged, mut is_interrupted) = (true, false);
    for (state, &(loads, motion_factor)) in parts.states.iter().enumerate() {
        if recover {
            load.fill(0.0);
            scene.add_load(state, &mut load);
        }
        let begin = Instant::now();
        let (solution, evidence) = solver.solve(loads, motion_factor)?;
        timing.solve += begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        let calibration = <TimoshenkoBeam as Model<D>>::calibration_error(parts.beam);
        let certificate = evidence::certify(
            <TimoshenkoBeam as Model<D>>::rigid_motions(parts.beam),
            calibration,
            &evidence,
        );
        timing.certify += begin.elapsed().as_secs_f64();
        converged &= certificate.converged;
        let begin = Instant::now();
        is_interrupted = !goes_on(take(SolvedState { state, load: &load, solution, certificate }))?;
        timing.record += begin.elapsed().as_secs_f64();
        if is_interrupted {
            break;
        }
    }
    let counters = Counters {
        factorisations: 1,
        right_hand_sides: parts.states.len(),
        bond_evaluations: system.evaluations(),
        stored_bond_factors: system.terms().iter().map(|t| t.stored_factors()).sum(),
        factor_bytes: solver.bytes(),
        ..Counters::default()
    };
    let supports = solver.supports();
    let report = SolverReport {
        method: METHOD.into(),
        reason: format!(
            "straight chain with {supports} held displacement{}: the condition number grows with neither cells nor slenderness",
            if supports == 1 { "" } else { "s" }
        ),
        factor_entries: solver.bytes() / size_of::<f64>(),
        ..SolverReport::default()
    };
    Ok(RunReport {
        sizes,
        solver: report,
        counters,
        timing,
        converged,
        is_interrupted,
        ..RunReport::default()
    })
}

impl From<peristat_solve::FactorError> for SolveFailure {
    fn from(error: peristat_solve::FactorError) -> Self {
        Self::Factor(error)
    }
}
