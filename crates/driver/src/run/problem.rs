//! What a run needs of a scene, whatever its model, and the system it becomes.

use super::RunError;
use super::strain::{self, StrainProblem};
use crate::case::Solver;
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::stiffness::{ObliqueSpring, ObliqueSprings, Spring, Springs, Term};
use peristat_assembly::system::{FreeMotion, System, free_motions};
use peristat_solve::{Method, Profile, choose};
use std::str::FromStr;

/// Free motions that are told one by one, at most.
const MOST_MOTIONS: usize = 6;

/// A model with its conditions and right-hand sides.
pub trait Problem<const D: usize> {
    /// The model.
    type Model: Model<D>;

    /// The model with its body.
    fn model(&self) -> &Self::Model;

    /// Springs to the ground.
    fn springs(&self) -> &[Spring];

    /// Springs to the ground in a direction between two unknowns.
    fn oblique_springs(&self) -> &[ObliqueSpring] {
        &[]
    }

    /// Equations of supports and links; their origins are paths into the case.
    fn equations(&self) -> &[Equation];

    /// Number of unknowns that nothing reads.
    fn idle(&self) -> usize {
        0
    }

    /// The solver that is asked for.
    fn solver(&self) -> Solver;

    /// Number of right-hand sides.
    fn states(&self) -> usize;

    /// Adds the loads of a state to `force`, `D` planes, and returns the factor on prescribed motions.
    fn add_load(&self, state: usize, force: &mut [f64]) -> f64;

    /// The problem as the strain form sees it; `None` if it has other unknowns or energies.
    fn strain_problem(&self) -> Option<StrainProblem<'_>> {
        None
    }

    /// A free motion in words, such as `the beam from x = 0 to 1 is free to move along w: no support or link prevents it`.
    fn describe(&self, motion: &FreeMotion) -> String;

    /// What would hold a free motion, for a hint.
    fn remedy(&self) -> &'static str;
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

/// The system of a problem, checked for size, contradictions and free motions, in this order.
///
/// # Errors
/// [`RunError::Memory`] if solving would take more than `max_memory`, or than the machine has; [`RunError::Case`] names
/// contradicting supports or every motion that nothing holds.
pub fn prepare<const D: usize, P: Problem<D>>(
    problem: &P,
    max_memory: Option<u64>,
) -> Result<(System<D>, Sizes), RunError> {
    let needed = estimate::<D, P>(problem);
    if let Some(allowed) = max_memory.or_else(available_memory).filter(|&allowed| needed > allowed) {
        return Err(RunError::Memory { needed, allowed });
    }
    let mut faults = Faults::default();
    let (points, mut springs): (usize, Vec<Box<dyn Term<D>>>) = (problem.model().points(), Vec::new());
    if !problem.springs().is_empty() {
        springs.push(Box::new(Springs::new(points, problem.springs().to_vec())));
    }
    if !problem.oblique_springs().is_empty() {
        springs.push(Box::new(ObliqueSprings::new(points, problem.oblique_springs().to_vec())));
    }
    let system = match System::new(problem.model(), springs, problem.equations().to_vec()) {
        Ok(system) => system,
        Err(contradiction) => {
            let path = JsonPath::from_str(&contradiction.origin).unwrap_or_default();
            let others: Vec<String> = contradiction.others.iter().map(|o| format!("`{o}`")).collect();
            faults
                .error(path, format!("`{}` contradicts {}", contradiction.origin, others.join(", ")))
                .hint("prescribe each motion once; points that a link or a joint joins move together");
            return Err(RunError::Case(faults));
        }
    };
    let (motions, supports) = (free_motions(problem.model(), &system), JsonPath::default().key("supports"));
    for motion in motions.iter().take(MOST_MOTIONS) {
        faults.error(supports.clone(), problem.describe(motion)).hint(problem.remedy());
    }
    if let Some(more @ 1..) = motions.len().checked_sub(MOST_MOTIONS) {
        let s = if more == 1 { "" } else { "s" };
        faults.error(supports, format!("{more} more motion{s} of this kind would be free"));
    }
    if faults.has_errors() {
        return Err(RunError::Case(faults));
    }
    strain::chosen(problem)?;
    let sizes = Sizes {
        points: system.points(),
        bonds: system.elements(),
        unknowns: system.independent() - problem.idle(),
        estimated_bytes: needed,
    };
    Ok((system, sizes))
}

/// Memory of matrix, factor, vectors, fields and their files, bytes.
fn estimate<const D: usize, P: Problem<D>>(problem: &P) -> u64 {
    let model = problem.model();
    let unknowns = (D * model.points()) as u64;
    let terms = model.terms();
    let reach = terms.iter().map(|t| t.reach()).max().unwrap_or(0);
    let relations = model.relations();
    let equations = || problem.equations().iter().chain(&relations);
    let slaves = equations().any(|e| e.terms.len() > 1);
    // Points that an equation joins come as close as neighbours do.
    let span = |e: &Equation| {
        let points = || e.terms.iter().map(|(u, _)| u.point);
        points().max().unwrap_or(0) - points().min().unwrap_or(0)
    };
    let far = equations().map(span).max().unwrap_or(0);
    let band = |reach: usize| 8 * unknowns * (D * (reach + 1)) as u64;
    let elements: usize = terms.iter().map(|t| t.elements()).sum();
    let profile = Profile {
        unknowns: D * model.points(),
        half_bandwidth: D * (reach + 1) - 1,
        entries: model.points() * D * (D + 1) / 2 + elements * D * D,
    };
    // Blocks, triplets, compressed rows, and a factor about as large as all of them.
    let sparse = 80 * profile.entries as u64;
    let matrix = match (slaves, problem.solver()) {
        (_, Solver::Auto | Solver::Strain) if strain::applies(problem).is_ok() => 0,
        (true, Solver::Band) => band(reach + far) + sparse,
        (true, _) | (false, Solver::Sparse) => sparse,
        (false, Solver::Auto | Solver::Strain) if choose(&profile).0 == Method::Sparse => sparse,
        (false, _) => band(reach),
    };
    // Bonds that are each their own are kept here and where they were made.
    let kept: usize = terms.iter().map(|t| t.stored_factors()).sum();
    matrix + 16 * kept as u64 + 8 * 6 * unknowns + 240 * model.points() as u64
}

/// Memory that programs can have without swapping, bytes, on systems that have `/proc`.
fn available_memory() -> Option<u64> {
    let info = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = info.lines().find(|l| l.starts_with("MemAvailable:"))?;
    let kilobytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024 * kilobytes)
}
