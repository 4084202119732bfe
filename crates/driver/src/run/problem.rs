//! What a run needs of a scene, whatever its model, and the system it becomes.

use super::RunError;
use crate::case::Solver;
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::stiffness::{Spring, Springs, Term};
use peristat_assembly::system::{FreeMotion, System, free_motions};
use std::str::FromStr;

/// A model with its conditions and right-hand sides.
pub trait Problem<const D: usize> {
    /// The model.
    type Model: Model<D>;

    /// The model with its body.
    fn model(&self) -> &Self::Model;

    /// Springs to the ground.
    fn springs(&self) -> &[Spring];

    /// Equations of supports and links; their origins are paths into the case.
    fn equations(&self) -> &[Equation];

    /// The solver that is asked for.
    fn solver(&self) -> Solver;

    /// Number of right-hand sides.
    fn states(&self) -> usize;

    /// Adds the loads of a state to `force`, `D` planes, and returns the factor on prescribed motions.
    fn add_load(&self, state: usize, force: &mut [f64]) -> f64;

    /// A free motion in words, such as `the beam from x = 0 to 1 is free to move along w`.
    fn describe(&self, motion: &FreeMotion) -> String;
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
    let springs: Vec<Box<dyn Term<D>>> = match problem.springs() {
        [] => Vec::new(),
        springs => vec![Box::new(Springs::new(problem.model().points(), springs.to_vec()))],
    };
    let system = match System::new(problem.model(), springs, problem.equations().to_vec()) {
        Ok(system) => system,
        Err(contradiction) => {
            let path = JsonPath::from_str(&contradiction.origin).unwrap_or_default();
            let others: Vec<String> = contradiction.others.iter().map(|o| format!("`{o}`")).collect();
            faults
                .error(path, format!("`{}` contradicts {}", contradiction.origin, others.join(", ")))
                .hint("prescribe each motion once; points that a link joins move together");
            return Err(RunError::Case(faults));
        }
    };
    for motion in free_motions(problem.model(), &system) {
        faults
            .error(JsonPath::default().key("supports"), format!("{}: no support or link prevents it", problem.describe(&motion)))
            .hint("a beam needs at least a deflection and a rotation, or two deflections, held by supports or links");
    }
    if faults.has_errors() {
        return Err(RunError::Case(faults));
    }
    let sizes = Sizes {
        points: system.points(),
        bonds: system.elements(),
        unknowns: system.independent(),
        estimated_bytes: needed,
    };
    Ok((system, sizes))
}

/// Memory of matrix, factor, vectors, fields and their files, bytes.
fn estimate<const D: usize, P: Problem<D>>(problem: &P) -> u64 {
    let model = problem.model();
    let unknowns = (D * model.points()) as u64;
    let reach = model.terms().iter().map(|t| t.reach()).max().unwrap_or(0);
    let relations = model.relations();
    let equations = || problem.equations().iter().chain(&relations);
    let slaves = equations().any(|e| e.terms.len() > 1);
    // Points that an equation joins come as close as neighbours do.
    let span = |e: &Equation| {
        let points = || e.terms.iter().map(|(u, _)| u.point);
        points().max().unwrap_or(0) - points().min().unwrap_or(0)
    };
    let far = equations().map(span).max().unwrap_or(0);
    let width = |reach: usize| (D * (reach + 1)) as u64;
    let matrix = match (slaves, problem.solver()) {
        (false, _) => 8 * unknowns * width(reach),
        (true, Solver::Band) => 8 * unknowns * width(reach + far) + 120 * unknowns * width(reach),
        // Multiplied out in compressed rows before it is factored.
        (true, _) => 120 * unknowns * width(reach),
    };
    matrix + 8 * 6 * unknowns + 240 * model.points() as u64
}

/// Memory that programs can have without swapping, bytes, on systems that have `/proc`.
fn available_memory() -> Option<u64> {
    let info = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = info.lines().find(|l| l.starts_with("MemAvailable:"))?;
    let kilobytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024 * kilobytes)
}
