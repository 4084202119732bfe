//! Running bodies in the plane: the common run and that of bodies that break, the stress intensities of cracks, and the
//! fields recovered.

mod crack_front;
mod cubes;
mod eigenstrain;
mod failure;
mod fields;
mod fracture;
mod gradient;
mod grips;
mod hole_fits;
mod intensity;
mod layers;
mod levels;
mod lines;
mod local;
mod modes;
mod of_stress;
mod path;
mod probed;
mod problem;
mod ranks;
mod reaction;
mod reduced;
mod skipped;
mod softness;
mod solid_memory;
mod tips;
mod verdict;

pub use fields::{BodyResult, Recovered};
pub(crate) use gradient::{Steepest, steepest};
pub use reaction::{BodyReaction, MirrorReaction};
pub(crate) use verdict::{checks, probes};

use super::restart::Restart;
use super::{Counters, RunError, RunOptions, RunReport, Sink, Sizes, SolvedState, prepare, solve_states_by};
use crate::diagnostic::Faults;
use crate::model::{AnyBody, with_body};
use crate::scene::Scene;
use crate::scene::body::{BodyScene, HoleRing};
use fracture::BreakingPlane;
use local::Local;
use path::SofteningPlane;
use peristat_assembly::model::plane::{BreakingModel, Solvable};
use peristat_solve::Ranks;
pub use problem::BodyProblem;
use ranks::Crew;
pub use ranks::{follow, lead};

/// Solves every state of a body in the plane and hands its result to `sink` as it comes.
///
/// # Errors
/// As [`super::run`].
pub fn run(
    scene: &BodyScene,
    options: &RunOptions,
    sink: &mut (dyn FnMut(BodyResult) -> std::io::Result<()> + Send),
) -> Result<RunReport, RunError> {
    let recover = options.recover || asks_for_stresses(scene);
    let options = &RunOptions { recover, ..*options };
    let local = Local::of(scene, recover)?;
    with_body!(&scene.model, body => {
        let mut problem = BodyProblem::new(scene, body.clone());
        problem.local = local;
        run_body(&problem, options, None, sink)
    })
}

/// The same by several processes, of which this is the first; the others [`follow`] it.
///
/// # Errors
/// As [`super::run`], and [`RunError::NotShared`] for cases that cannot be solved so.
pub fn run_on(
    ranks: &dyn Ranks,
    scene: &Scene,
    options: &RunOptions,
    sink: &mut (dyn FnMut(BodyResult) -> std::io::Result<()> + Send),
) -> Result<RunReport, RunError> {
    let scene = ranks::begin(ranks, scene)?;
    let recover = options.recover || asks_for_stresses(scene);
    let options = &RunOptions { recover, ..*options };
    with_body!(&scene.model, body => {
        run_body(&BodyProblem::new(scene, body.clone()), options, Some(ranks), sink)
    })
}

fn run_body<const D: usize>(
    problem: &BodyProblem<dyn Solvable<D>>,
    options: &RunOptions,
    ranks: Option<&dyn Ranks>,
    sink: &mut (dyn FnMut(BodyResult) -> std::io::Result<()> + Send),
) -> Result<RunReport, RunError> {
    let (scene, recover) = (problem.scene, options.recover);
    let prepared = prepare(problem, options);
    let (system, sizes) = match ranks {
        Some(ranks) => ranks::agree(ranks, prepared)?,
        None => prepared?,
    };
    let crew = ranks.map(|ranks| Crew::new(problem, &system, ranks)).transpose()?;
    let found = intensity::of_states(scene, options)?;
    let tips = tips::Tips::of(scene);
    let rings = HoleRing::of(scene);
    let mut layers = layers::Layers::of(scene, &rings);
    let mut warnings = Faults::default();
    hole_fits::check_sharp(scene, &rings, &mut warnings);
    let mut doubts = probed::Doubts::of(scene);
    let mut take = |solved: SolvedState| {
        tips.check(scene, solved.state, &solved.solution.u, &mut warnings);
        layers.check(scene, &solved.solution.u, &mut warnings);
        let mut result = fields::collect(scene, solved, (&found.values, &rings), recover);
        if let Some(local) = &problem.local {
            local.complete(&mut result);
            doubts.see(&result);
        }
        hole_fits::check(&result, &mut warnings);
        sink(result)
    };
    let shared = crew.as_ref().map(Crew::leader).transpose()?;
    let mut report = solve_states_by(shared, problem, (&system, sizes), &mut take)?;
    // What is stored per bond: triangles and springs are no bonds.
    report.counters.stored_bond_factors = system.terms()[0].stored_factors();
    doubts.warn(scene, &mut warnings);
    report.skipped = skipped::skipped(scene, &report, recover);
    report.converged &= found.converged;
    report.warnings = warnings;
    add(&mut report.counters, &found.counters);
    report.timing.solve += found.seconds;
    Ok(report)
}

/// Breaks the bonds of a body in the plane, and hands its equilibria to `sink` as they come.
///
/// # Errors
/// As [`super::run`].
pub fn run_breaking(
    scene: &BodyScene,
    options: &RunOptions,
    resume: Option<Restart>,
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError> {
    let recover = options.recover || asks_for_stresses(scene);
    let options = &RunOptions { recover, ..*options };
    let none = Err(RunError::NotResumable);
    with_body!(&scene.model, body => body.breaking().map_or(none, |body| break_body(scene, body, options, resume, sink)))
}

/// Follows the path of a body in the plane whose bonds soften, and hands its states to `sink` as they come.
///
/// # Errors
/// As [`super::run`].
pub fn run_softening(
    scene: &BodyScene,
    options: &RunOptions,
    resume: Option<Restart>,
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError> {
    let recover = options.recover || asks_for_stresses(scene);
    let options = &RunOptions { recover, ..*options };
    let AnyBody::Two(body) = &scene.model else { return Err(RunError::NotResumable) };
    let (Some(path), Some(body)) = (&scene.path, body.softening()) else {
        return Err(RunError::NotResumable);
    };
    let problem = BodyProblem::new(scene, body);
    let prepared = prepare(&problem, options)?;
    let found = intensity::of_states(scene, options)?;
    let intensity = found.values.first().map(|k| k[0]);
    let (elastic, front, softened) = ([0.0; 2], None, Vec::new());
    let mut body = SofteningPlane { problem, path, recover, intensity, elastic, front, softened };
    body.front = crack_front::Front::new(scene, &super::path::SofteningBody::bonds(&body));
    let mut report = super::path::run(&mut body, prepared, resume, sink)?;
    report.skipped = skipped::skipped(scene, &report, recover);
    add(&mut report.counters, &found.counters);
    report.timing.solve += found.seconds;
    grips::tell(scene, &body.softened, &mut report.warnings);
    if !report.is_interrupted {
        softness::tell(scene, options, &mut report);
    }
    Ok(report)
}

fn break_body<const D: usize>(
    scene: &BodyScene,
    body: Box<dyn BreakingModel<D>>,
    options: &RunOptions,
    resume: Option<Restart>,
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError> {
    let Some(fracture) = &scene.fracture else { return Err(RunError::NotResumable) };
    let problem = BodyProblem::new(scene, body);
    let prepared = prepare(&problem, options)?;
    let mut breaking = BreakingPlane { problem, fracture, recover: options.recover, off: Vec::new() };
    let mut report = super::fracture::run(&mut breaking, prepared, resume, sink)?;
    report.skipped = skipped::skipped(scene, &report, options.recover);
    if !report.is_interrupted {
        softness::tell(scene, options, &mut report);
    }
    Ok(report)
}

/// Whether a probe, a check or a line reads more than displacements and reactions.
fn asks_for_stresses(scene: &BodyScene) -> bool {
    !scene.lines.is_empty()
        || scene.probes.iter().any(|p| p.is_recovered())
        || scene.expectations.iter().any(verdict::is_recovered)
}

/// Sizes of a body that can be solved.
///
/// # Errors
/// As [`prepare`].
pub fn sizes(scene: &BodyScene, options: &RunOptions) -> Result<Sizes, RunError> {
    with_body!(&scene.model, body => prepare(&BodyProblem::new(scene, body.clone()), options).map(|p| p.1))
}

/// Adds what other solves have cost.
fn add(to: &mut Counters, other: &Counters) {
    to.factorisations += other.factorisations;
    to.analyses += other.analyses;
    to.pcg_iterations += other.pcg_iterations;
    to.right_hand_sides += other.right_hand_sides;
    to.bond_evaluations += other.bond_evaluations;
}
