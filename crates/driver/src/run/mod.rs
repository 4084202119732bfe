//! Running a scene: assemble, factor, solve every state, certify, recover.

pub mod beam;
pub mod body;
mod border_block;
mod certificate;
mod drift;
mod extent;
mod factor;
pub mod fracture;
mod kept_factor;
mod linear;
mod load;
mod memory;
mod method;
mod multigrid;
pub mod path;
mod problem;
mod range;
mod refine;
mod resultants;
pub(crate) mod scan;
mod sink;
mod verdict;
mod weigh;
mod workspace;

pub use beam::BeamResult;
pub use body::BodyResult;
pub(crate) use certificate::{ASKED, FEW_DIGITS};
pub use certificate::{Balance, Certificate};
pub use factor::{SolveFailure, SolverReport};
pub use linear::LinearSolver;
pub(crate) use method::TOO_MANY_POINTS;
pub use multigrid::Coarser;
pub use problem::{Problem, Sizes, Spread, prepare};
pub(crate) use range::Range;
pub use resultants::{Resultants, Total};
pub use sink::{Advance, Sink, taking};
pub use verdict::{CheckResult, ProbeResult};

use crate::diagnostic::Faults;
use crate::memory::words;
use crate::scene::Scene;
use fracture::Restart;
use load::Load;
use peristat_assembly::system::System;
use std::time::Instant;
use thiserror::Error;
use workspace::StateSolution;

/// What a run is asked for beyond the unknowns.
#[derive(Clone, Copy, Debug, Default)]
pub struct RunOptions {
    /// Recover section forces, stresses and energy densities of every state even if no check reads them.
    pub recover: bool,
    /// Memory that must not be exceeded, bytes.
    pub max_memory: Option<u64>,
    /// Solve a beam that is not exact on any grid once more as one that is, and say how far the two are apart.
    pub compare: bool,
}

/// How often expensive things were done.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
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

/// Wall time per stage, s.
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
#[derive(Clone, Debug)]
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
    /// How the body broke.
    pub fracture: Option<fracture::FractureReport>,
    /// How the body went along its path.
    pub path: Option<path::PathReport>,
    /// What the states of the exact beam are, where a beam was compared with it.
    pub exact: Option<Vec<beam::ExactState>>,
}

impl RunReport {
    /// Why a body that breaks or softens did not come to the end of what was asked for, if it did not.
    pub(crate) fn missed_goal(&self) -> Option<&'static str> {
        let broken = self.fracture.as_ref().map(|r| (r.reached_goal, r.ending));
        let (reached, ending) = broken.or_else(|| self.path.as_ref().map(|r| (r.reached_goal, r.ending)))?;
        (!reached).then_some(ending)
    }
}

/// Why a run has no result.
#[derive(Debug, Error)]
pub enum RunError {
    /// The case cannot be solved as it is.
    #[error("the case cannot be solved")]
    Case(Faults),
    /// More memory would be needed than is allowed.
    #[error("about {} of memory would be needed, {} may be used", words(*needed), words(*allowed))]
    Memory {
        /// Estimated need, bytes.
        needed: u64,
        /// Limit, bytes.
        allowed: u64,
    },
    /// The stiffness has no factor.
    #[error(transparent)]
    Solve(#[from] SolveFailure),
    /// The run was asked to end before it was done.
    #[error("interrupted")]
    Interrupted,
    /// There is a restart to go on from, but the scene is not solved in events.
    #[error("only a run of a body that breaks can be resumed")]
    NotResumable,
    /// There is a restart to go on from, but it is of another body.
    #[error("the restart does not fit the body")]
    Misfit,
    /// A result could not be taken, for instance written.
    #[error(transparent)]
    Sink(#[from] std::io::Error),
}

/// What the result of a state is, whatever the model.
#[derive(Clone, Debug)]
pub struct StateRecord {
    /// Index among the states of the scene.
    pub index: usize,
    /// Name.
    pub name: String,
    /// Load factor.
    pub load_factor: f64,
    /// Unknowns, one plane per component over all points, ghosts included.
    pub u: Vec<f64>,
    /// Certificate.
    pub certificate: Certificate,
    /// What is known of a body that breaks.
    pub facts: Option<fracture::Facts>,
}

/// The result of one state.
#[derive(Clone, Debug)]
pub enum StateResult {
    /// Of a beam or frame.
    Beam(BeamResult),
    /// Of a body in the plane.
    Body(BodyResult),
}

impl StateResult {
    /// What it is, whatever the model.
    pub fn record(&self) -> &StateRecord {
        match self {
            Self::Beam(result) => &result.record,
            Self::Body(result) => &result.record,
        }
    }
}

impl StateResult {
    /// What it is, whatever the model, to be changed.
    fn record_mut(&mut self) -> &mut StateRecord {
        match self {
            Self::Beam(result) => &mut result.record,
            Self::Body(result) => &mut result.record,
        }
    }
}

/// Solves every state of a scene and hands its result to `sink` as it comes; a body that breaks goes on from `resume`.
///
/// # Errors
/// [`RunError`]; a state that did not converge is no error but an outcome in the report.
pub fn run(
    scene: &Scene,
    options: &RunOptions,
    resume: Option<Restart>,
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError> {
    match scene {
        Scene::Beam(scene) if scene.fracture.is_some() => beam::run_breaking(scene, options, resume, sink),
        Scene::Body(scene) if scene.fracture.is_some() => body::run_breaking(scene, options, resume, sink),
        Scene::Body(scene) if scene.path.is_some() && resume.is_none() => {
            body::run_softening(scene, options, sink)
        }
        _ if resume.is_some() => Err(RunError::NotResumable),
        Scene::Beam(scene) => beam::run(scene, options, &mut |result| sink.take(StateResult::Beam(result))),
        Scene::Body(scene) => body::run(scene, options, &mut |result| sink.take(StateResult::Body(result))),
    }
}

/// Sizes of a scene that can be solved.
///
/// # Errors
/// As [`prepare`].
pub fn sizes(scene: &Scene, options: &RunOptions) -> Result<Sizes, RunError> {
    match scene {
        Scene::Beam(scene) => beam::sizes(scene, options),
        Scene::Body(scene) => body::sizes(scene, options),
    }
}

/// One solved right-hand side.
struct SolvedState<'a> {
    state: usize,
    load: &'a [f64],
    solution: StateSolution,
    certificate: Certificate,
}

/// Solution of a load and a factor on prescribed motions, with its certificate.
fn certified<const D: usize>(
    problem: &dyn Problem<D>,
    system: &System<D>,
    solver: &mut LinearSolver<D>,
    (load, motion_factor): (&[f64], f64),
    timing: &mut Timing,
) -> (StateSolution, Certificate) {
    let begin = Instant::now();
    let solution = solver.solve(system, &Load::new(problem.model(), load), motion_factor);
    timing.solve += begin.elapsed().as_secs_f64();
    let begin = Instant::now();
    let certificate = certificate::certify(problem, system, load, &solution, solver.scales());
    timing.certify += begin.elapsed().as_secs_f64();
    (solution, certificate)
}

/// Solves every state of a prepared problem, whatever its model, and hands solution and certificate to `take`.
fn solve_states<const D: usize>(
    problem: &dyn Problem<D>,
    (system, sizes): (&System<D>, Sizes),
    take: &mut dyn FnMut(SolvedState) -> std::io::Result<()>,
) -> Result<RunReport, RunError> {
    let mut timing = Timing::default();
    let begin = Instant::now();
    let coarser = if method::plan(problem) == method::Plan::Cycle { problem.coarser() } else { None };
    timing.assemble = begin.elapsed().as_secs_f64();
    let mut ready = Some(LinearSolver::new(problem, system, coarser.as_ref(), &mut timing)?);
    let (mut report, mut counters) = (SolverReport::default(), Counters::default());
    let mut load = vec![0.0; system.size()];
    let mut converged = true;
    for state in 0..problem.states() {
        let Some(solver) = &mut ready else { break };
        load.fill(0.0);
        let motion_factor = problem.add_load(state, &mut load);
        let (mut solution, mut certificate) =
            certified(problem, system, solver, (&load, motion_factor), &mut timing);
        let is_poor = !certificate.converged || certificate.digits < FEW_DIGITS;
        if is_poor && !solver.has_factor() && method::can_fall_back(problem) {
            solver.fall_back(problem, system, &mut timing)?;
            (solution, certificate) = certified(problem, system, solver, (&load, motion_factor), &mut timing);
        }
        converged &= certificate.converged;
        // The factor is the largest thing in memory: the last state is recorded without it.
        if state + 1 == problem.states() {
            (report, counters) = (solver.report().clone(), solver.counters().clone());
            ready = None;
        }
        let begin = Instant::now();
        take(SolvedState { state, load: &load, solution, certificate })?;
        timing.record += begin.elapsed().as_secs_f64();
    }
    counters.bond_evaluations = system.evaluations();
    counters.stored_bond_factors = system.terms().iter().map(|t| t.stored_factors()).sum();
    Ok(RunReport {
        sizes,
        solver: report,
        counters,
        timing,
        skipped: Vec::new(),
        warnings: Faults::default(),
        converged,
        fracture: None,
        path: None,
        exact: None,
    })
}
