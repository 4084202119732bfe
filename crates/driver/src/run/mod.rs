//! Running a scene: assemble, factor, solve every state, certify, recover.

mod certificate;
mod fields;
mod linear;
mod verdict;

pub use certificate::{Balance, Certificate};
pub use fields::{LineFields, Reaction, StateResult};
pub use linear::{LinearSolver, SolveFailure, SolverReport};
pub use verdict::{CheckResult, ProbeResult};
pub(crate) use verdict::{checks, probes};

use crate::diagnostic::{Faults, JsonPath};
use crate::scene::Scene;
use peristat_assembly::model::Model;
use peristat_assembly::stiffness::{Springs, Term};
use peristat_assembly::system::{FreeMotion, System, free_motions};
use std::str::FromStr;
use std::time::Instant;
use thiserror::Error;

/// What a run is asked for beyond the unknowns.
#[derive(Clone, Copy, Debug, Default)]
pub struct RunOptions {
    /// Recover section forces, stresses and energy densities of every state even if no check reads them.
    pub recover: bool,
    /// Memory that must not be exceeded, bytes.
    pub max_memory: Option<u64>,
}

/// Sizes of a scene, known before it is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Sizes {
    /// Points, ghosts included.
    pub points: usize,
    /// Bonds and springs.
    pub bonds: usize,
    /// Independent unknowns.
    pub unknowns: usize,
    /// Memory that solving will take, estimated, bytes.
    pub estimated_bytes: u64,
}

/// How often expensive things were done.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Counters {
    /// Numeric factorisations.
    pub factorisations: usize,
    /// Symbolic analyses.
    pub analyses: usize,
    /// Newton iterations.
    pub newton_iterations: usize,
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
    /// Assembly of the stiffness.
    pub assemble: f64,
    /// Factorisation.
    pub factor: f64,
    /// Conjugate gradients and refinement of all states.
    pub solve: f64,
    /// Certificates of all states.
    pub certify: f64,
    /// Recovery of fields.
    pub recover: f64,
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
    /// Whether every state converged.
    pub converged: bool,
}

/// Why a run has no result.
#[derive(Debug, Error)]
pub enum RunError {
    /// The case cannot be solved as it is.
    #[error("the case cannot be solved")]
    Case(Faults),
    /// More memory would be needed than is allowed.
    #[error("about {} MB of memory would be needed, {} MB are allowed", needed / 1_000_000, allowed / 1_000_000)]
    Memory {
        /// Estimated need, bytes.
        needed: u64,
        /// Limit, bytes.
        allowed: u64,
    },
    /// The stiffness has no factor.
    #[error(transparent)]
    Solve(#[from] SolveFailure),
    /// A result could not be taken, for instance written.
    #[error(transparent)]
    Sink(#[from] std::io::Error),
}

/// The system of a scene, checked for contradictions and free motions.
///
/// # Errors
/// [`RunError::Case`] names contradicting supports or every motion that nothing holds.
pub fn system(scene: &Scene) -> Result<System<2>, RunError> {
    let mut faults = Faults::default();
    let points = scene.beam.points();
    let springs: Vec<Box<dyn Term<2>>> = match scene.springs.is_empty() {
        true => Vec::new(),
        false => vec![Box::new(Springs::new(points, scene.springs.clone()))],
    };
    let system = match System::new(&scene.beam, springs, scene.equations.clone()) {
        Ok(system) => system,
        Err(contradiction) => {
            // Origins of equations from the case are paths into it.
            let path = JsonPath::from_str(&contradiction.origin).unwrap_or_default();
            let others: Vec<String> = contradiction.others.iter().map(|o| format!("`{o}`")).collect();
            faults
                .error(
                    path,
                    format!("`{}` contradicts {}", contradiction.origin, others.join(", ")),
                )
                .hint("prescribe each motion of a point once");
            return Err(RunError::Case(faults));
        }
    };
    for motion in free_motions(&scene.beam, &system) {
        faults
            .error(JsonPath::default().key("supports"), mechanism(scene, &motion))
            .hint("a beam needs at least a deflection and a rotation, or two deflections, held by supports or links");
    }
    if faults.has_errors() {
        Err(RunError::Case(faults))
    } else {
        Ok(system)
    }
}

/// A free motion in words.
fn mechanism(scene: &Scene, motion: &FreeMotion) -> String {
    let position = |point: usize| scene.beam.position(point)[0];
    let parts: Vec<String> = motion
        .parts
        .iter()
        .map(|&[a, b]| format!("x = {} to {}", position(a), position(b)))
        .collect();
    let amount = |name: &str| motion.motions.iter().find(|m| m.0 == name).map_or(0.0, |m| m.1);
    let (shift, turn) = (amount("translation along w"), amount("rotation"));
    let how = if turn == 0.0 {
        "move along w".into()
    } else {
        format!("rotate about x = {:.6}", motion.centre[0] - shift / turn)
            .trim_end_matches('0')
            .trim_end_matches('.')
            .into()
    };
    let how: String = how;
    format!(
        "the beam from {} is free to {how}: no support or link prevents it",
        parts.join(" and from ")
    )
}

/// Sizes and the memory that solving will take.
pub fn sizes(system: &System<2>) -> Sizes {
    let unknowns = system.size() as u64;
    // Factor, seven vectors of the solve, recovered fields.
    let width = 2 * (system.reach() as u64 + 1);
    let factor = if system.constraints().has_slaves() {
        40 * unknowns * width
    } else {
        8 * unknowns * width
    };
    let estimated_bytes = factor + 8 * 7 * unknowns + 40 * system.points() as u64;
    Sizes {
        points: system.points(),
        bonds: system.elements(),
        unknowns: system.independent(),
        estimated_bytes,
    }
}

/// Solves every state and hands its result to `sink` as it comes.
///
/// # Errors
/// [`RunError`]; a state that did not converge is no error but an outcome in the report.
pub fn run(
    scene: &Scene,
    options: &RunOptions,
    sink: &mut dyn FnMut(StateResult) -> std::io::Result<()>,
) -> Result<RunReport, RunError> {
    let system = system(scene)?;
    let sizes = sizes(&system);
    if let Some(allowed) = options.max_memory
        && sizes.estimated_bytes > allowed
    {
        return Err(RunError::Memory {
            needed: sizes.estimated_bytes,
            allowed,
        });
    }
    let mut timing = Timing::default();
    let mut solver = LinearSolver::new(&system, scene.solver, &mut timing)?;
    let recover = options.recover
        || scene.probes.iter().any(|p| p.field.is_recovered())
        || scene.expectations.iter().any(|e| e.is_recovered(&scene.probes));
    let mut load = vec![0.0; system.size()];
    let mut converged = true;
    for (index, state) in scene.states.iter().enumerate() {
        load.fill(0.0);
        state.loads.add_to(&scene.beam, &mut load);
        let begin = Instant::now();
        let solution = solver.solve(&load, state.motion_factor);
        timing.solve += begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        let certificate = certificate::certify(&scene.beam, &system, &load, &solution);
        timing.certify += begin.elapsed().as_secs_f64();
        converged &= certificate.converged;
        let begin = Instant::now();
        let result = fields::result(scene, index, solution, certificate, recover);
        timing.recover += begin.elapsed().as_secs_f64();
        sink(result)?;
    }
    let mut counters = solver.counters().clone();
    counters.bond_evaluations = system.evaluations();
    counters.stored_bond_factors = system.terms().iter().map(|t| t.stored_factors()).sum();
    let skipped = skipped(scene, &counters, recover);
    Ok(RunReport {
        sizes,
        solver: solver.report().clone(),
        counters,
        timing,
        skipped,
        converged,
    })
}

/// What the scene was spared.
fn skipped(scene: &Scene, counters: &Counters, recover: bool) -> Vec<String> {
    let mut skipped = vec![
        "axial unknowns: no measure of a straight beam reads them".to_string(),
        "Newton iterations: every term is linear".to_string(),
        "bond geometry: bonds of one offset share it".to_string(),
    ];
    if counters.stored_bond_factors <= 64 * 64 * scene.beam.chains().len() {
        skipped.push("factors of interior bonds: the lattice is uniform".into());
    }
    if counters.right_hand_sides > counters.factorisations {
        skipped.push(format!(
            "{} factorisations: the stiffness does not depend on the load",
            counters.right_hand_sides - counters.factorisations
        ));
    }
    if counters.analyses == 0 {
        skipped.push("symbolic analysis: the stiffness is a band".into());
    }
    if !recover {
        skipped.push("section forces, stresses, energy densities: no output or check asks for them".into());
    } else if scene.section.height.is_none() {
        skipped.push("bending stresses: the section has no height".into());
    }
    skipped
}
