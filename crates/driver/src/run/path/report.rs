//! What is reported of a path.

use super::super::solver_report::SolverReport;
use super::super::{RunReport, Sizes, Timing};
use super::auto::Chosen;
use super::course::Course;
use super::ending::Ending;
use super::facts::facts;
use crate::case::PathControl;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::path::PathScene;
use peristat_assembly::stiffness::Kinematics;

/// Part of the work that may be lost in jumps without a word.
const JUMPED: f64 = 0.01;

/// Stretch that linear kinematics sees in a turn, over the yield stretch, that may be without a word.
const TURNED: f64 = 0.1;

/// How a body went along its path.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct PathReport {
    /// Why the run ended.
    pub ending: &'static str,
    /// Whether it came to the end of what was asked for: limits are kept there, or not at all.
    pub reached_goal: bool,
    /// What drove the body in the end.
    pub control: PathControl,
    /// Why.
    pub control_reason: String,
    /// Yield stretch of the bonds.
    pub yield_stretch: f64,
    /// Failure stretch of the bonds.
    pub failure_stretch: f64,
    /// The one over the other: below 2.5 bodies snap back.
    pub brittleness: f64,
    /// Steps.
    pub steps: usize,
    /// Steps that were tried and refused.
    pub refused_steps: usize,
    /// Iterations, or solves for directions, per step, on the mean.
    pub mean_iterations: f64,
    /// Factorisations per step, on the mean.
    pub mean_factorisations: f64,
    /// Points of parts that came off; their unknowns are masked.
    pub island_points: usize,
    /// What is added to the diagonal of the matrix that is factored, over the median of the elastic one; residuals never
    /// see it.
    pub preconditioner_lift: f64,
    /// What checks can ask for, by name.
    pub facts: serde_json::Map<String, serde_json::Value>,
}

/// Doubts about what was found.
fn warnings<const D: usize>(course: &Course<D>, scene: &PathScene) -> Faults {
    let (mut faults, path) = (Faults::default(), JsonPath::default().key("path"));
    let last = course.points.last().cloned().unwrap_or_default();
    if last.balance > JUMPED {
        faults
            .warning(
                path.clone(),
                format!("{:.1} % of the work was lost where steps jumped or straddled the kinks of bonds", 100.0 * last.balance),
            )
            .hint("\"control\": \"event\" follows the path exactly, snap-backs too; or take a smaller `increment`");
    }
    if let Some(pair) = course.points.windows(2).find(|pair| pair[1].is_branched()) {
        let (at, beyond) = (&pair[0], &pair[1]);
        let more = beyond.negative_eigenvalues.unwrap_or(0);
        faults
            .warning(
                path.clone(),
                format!("the path branches at the load factor {:.4}: beyond, the stiffness has {more} negative {}, and a turn of the load explains {}", at.load_factor, if more == 1 { "eigenvalue" } else { "eigenvalues" }, usize::from(beyond.is_back)),
            )
            .hint("what follows is in equilibrium, but a test may take another branch; a crack or a hole that breaks the symmetry chooses one");
    }
    let turn = course.body.bonds.largest_turn(&course.state.u);
    let seen = 0.5 * turn * turn / scene.law.yield_stretch();
    if scene.kinematics == Kinematics::Linear && seen > TURNED {
        faults
            .warning(
                path.clone(),
                format!("bonds turned by up to {turn:.3} rad, which linear kinematics takes for {:.0} % of the yield stretch", 100.0 * seen),
            )
            .hint("\"kinematics\": \"finite\" in the bond law knows rotations; loads before are as they should be");
    }
    if last.island_points > 1 {
        faults
            .warning(path, format!("{} points have come off: they stay where they are", last.island_points))
            .hint("fields of parts that have come off mean nothing");
    }
    faults
}

pub(super) fn report<const D: usize>(
    course: Course<D>,
    scene: &PathScene,
    chosen: &Chosen<D>,
    (sizes, ending): (Sizes, Ending),
    record: f64,
) -> RunReport {
    let warnings = warnings(&course, scene);
    let counters = course.body.counters.clone();
    let timing = Timing { record, ..course.body.timing.clone() };
    let solver = SolverReport {
        method: "sparse_cholesky".into(),
        reason: "the stiffness of a body that softens is factored anew in every iteration, with one analysis"
            .into(),
        factor_entries: counters.factor_bytes / size_of::<f64>(),
        ..SolverReport::default()
    };
    let steps = course.points.len().saturating_sub(1);
    let per_step = |count: usize| count as f64 / steps.max(1) as f64;
    let iterations = course.points.iter().map(|p| p.iterations).sum();
    RunReport {
        sizes,
        solver,
        timing,
        warnings,
        converged: ending != Ending::Stuck,
        is_interrupted: ending == Ending::Interrupted,
        path: Some(PathReport {
            ending: ending.words(),
            reached_goal: ending.is_goal(),
            control: chosen.name,
            control_reason: chosen.reason.clone(),
            yield_stretch: scene.law.yield_stretch(),
            failure_stretch: scene.law.failure_stretch(),
            brittleness: scene.law.brittleness(),
            steps,
            refused_steps: course.points.iter().map(|p| p.refused).sum(),
            mean_iterations: per_step(iterations),
            mean_factorisations: per_step(counters.factorisations),
            island_points: course.island_points,
            preconditioner_lift: super::body::LIFT,
            facts: facts(&course.points).0.into_iter().map(|(name, value)| (name, value.into())).collect(),
        }),
        counters,
        ..RunReport::default()
    }
}
