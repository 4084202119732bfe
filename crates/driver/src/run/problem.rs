//! What a run needs of a scene, whatever its model, and the system it becomes.

use super::method::TOO_MANY_POINTS;
use super::multigrid::Coarser;
use super::{RunError, RunOptions, memory};
use crate::case::Solver;
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::stiffness::{Spring, Springs, Term};
use peristat_assembly::system::{FreeMotion, System, free_motions};
use std::str::FromStr;

/// Free motions that are told one by one, at most.
const MOST_MOTIONS: usize = 6;

/// A model with its conditions and right-hand sides.
pub trait Problem<const D: usize> {
    /// The model with its body.
    fn model(&self) -> &dyn Model<D>;

    /// Springs to the ground.
    fn springs(&self) -> &[Spring];

    /// Equations of supports and links; their origins are paths into the case.
    fn equations(&self) -> &[Equation];

    /// The solver that is asked for.
    fn solver(&self) -> Solver;

    /// Number of right-hand sides.
    fn states(&self) -> usize;

    /// Whether bonds break: a factor is kept to the end.
    fn breaks(&self) -> bool {
        false
    }

    /// Adds the loads of a state to `force`, `D` planes, and returns the factor on prescribed motions.
    fn add_load(&self, state: usize, force: &mut [f64]) -> f64;

    /// How its points lie.
    fn spread(&self) -> Spread {
        Spread::Chain
    }

    /// Points beyond which a factor takes more than it gives.
    fn most_factored(&self) -> usize {
        TOO_MANY_POINTS
    }

    /// Memory that a solid takes which is solved by iterations, bytes; none of other bodies.
    fn solid_bytes(&self) -> Option<usize> {
        None
    }

    /// Positions of the points, where they spread in a plane: their factor is ordered by them.
    fn positions(&self) -> Option<Vec<[f64; 2]>> {
        None
    }

    /// The coarser levels of a multigrid cycle, where the points are those of a lattice.
    fn coarser(&self) -> Option<Coarser<D>> {
        None
    }

    /// A free motion in words, such as `the beam from x = 0 to 1 is free to move along w: no support or link prevents it`.
    fn describe(&self, motion: &FreeMotion) -> String;

    /// What would hold a free motion, for a hint.
    fn remedy(&self) -> &'static str;
}

/// How the points of a problem lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spread {
    /// Along lines.
    Chain,
    /// In a plane.
    Plane,
    /// In space.
    Solid,
    /// In a plane or in space, on a lattice that has coarser ones.
    Lattice,
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
/// [`RunError::Memory`] if solving would take more than is allowed, or than the machine has; [`RunError::Case`] names
/// contradicting supports or every motion that nothing holds.
pub fn prepare<const D: usize>(
    problem: &dyn Problem<D>,
    options: &RunOptions,
) -> Result<(System<D>, Sizes), RunError> {
    prepare_within(problem, memory::estimate(problem, options.recover), options)
}

/// The same where solving will take `needed` bytes of memory.
pub(super) fn prepare_within<const D: usize>(
    problem: &dyn Problem<D>,
    needed: u64,
    options: &RunOptions,
) -> Result<(System<D>, Sizes), RunError> {
    let allowed = crate::memory::allowed(options.max_memory);
    if let Some(allowed) = allowed.filter(|&allowed| needed > allowed) {
        return Err(RunError::Memory { needed, allowed });
    }
    let mut faults = Faults::default();
    let (points, mut springs): (usize, Vec<Box<dyn Term<D>>>) = (problem.model().points(), Vec::new());
    if !problem.springs().is_empty() {
        springs.push(Box::new(Springs::new(points, problem.springs().to_vec())));
    }
    let system = match System::new(problem.model(), springs, problem.equations().to_vec()) {
        Ok(system) => system,
        Err(contradiction) => {
            let path = JsonPath::from_str(&contradiction.origin).unwrap_or_default();
            let mut others: Vec<String> = contradiction
                .others
                .iter()
                .filter(|o| **o != contradiction.origin)
                .map(|o| format!("`{o}`"))
                .collect();
            others.sort_unstable();
            others.dedup();
            let message = match others.is_empty() {
                true => format!("`{}` contradicts itself", contradiction.origin),
                false => format!("`{}` contradicts {}", contradiction.origin, others.join(", ")),
            };
            faults.error(path, message).hint(match problem.spread() {
                Spread::Chain => "prescribe each motion once; points that a link or a joint joins move together",
                _ => "prescribe each motion once: edges share the points of their corner, and those of a rigid region move together",
            });
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
    let sizes = Sizes {
        points: system.points(),
        bonds: system.elements(),
        unknowns: system.independent() - problem.model().idle(),
        estimated_bytes: needed,
    };
    Ok((system, sizes))
}
