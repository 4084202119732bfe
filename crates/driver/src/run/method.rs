//! Which method solves a problem, why, and when its answer is good enough.

use super::coarser::Coarser;
use super::cubic_cycle;
use super::factor;
use super::multigrid;
use super::problem::{Spread, TOO_MANY_POINTS};
use super::semicoarsened;
use super::single_cycle;
use super::solve_failure::SolveFailure;
use super::solver_report::SolverReport;
use super::workspace::Elementwise;
use super::{Counters, Problem, Timing};
use crate::case::Solver;
use crate::diagnostic::tidy;
use peristat_assembly::system::{Level, System};
use peristat_solve::{Deflated, PcgOptions, Preconditioner};
use std::time::Instant;

/// Right-hand sides that share a factor from which it is faster than as many multigrid solves, measured at 1e5 points.
const MANY_SIDES: usize = 30;
/// Root of the ratio of the moduli of points up to which coarser lattices are good preconditioners: with an inclusion or a layer a
/// hundred times as stiff, or as soft, a cycle takes 28 iterations at most, in solids 49, at 1e4 times 53 to 800, growing with the lattice.
const MOST_CONTRAST: f64 = 10.0;

/// What a right-hand side is solved with.
pub(super) struct Method<'a, const D: usize> {
    pub(super) preconditioner: Box<dyn Preconditioner + 'a>,
    pub(super) report: SolverReport,
    pub(super) finish: Finish,
    /// What a cycle of 32 bits is of: one of 64 bits is next where it leaves too few digits.
    pub(super) rounded: Option<(&'a System<D>, &'a Coarser<D>)>,
}

/// When conjugate gradients have done enough.
pub(super) struct Finish {
    pub(super) options: PcgOptions,
    /// A next correction below this ends the passes.
    pub(super) settled: f64,
    /// Whether rounding alone ends them.
    pub(super) is_exact: bool,
}

impl Finish {
    /// With a factor: until nothing is left but the rounding of the unknowns themselves.
    fn of_factor() -> Self {
        Self { options: PcgOptions::default(), settled: 1e-13, is_exact: true }
    }

    /// With a multigrid cycle.
    pub(super) fn of_cycle() -> Self {
        Self::of_iteration(200)
    }

    /// For a correction, whose error the next one corrects. With a hundredth of it in doubt the error after all is no larger; with a
    /// millionth the result is the same to eight digits, whatever solves.
    pub(super) fn of_correction(&self) -> PcgOptions {
        const ENOUGH: f64 = 1e-6;
        match self.is_exact {
            true => self.options,
            false => PcgOptions { residual_drop: ENOUGH, energy_drop: 0.0, ..self.options },
        }
    }

    /// With a poor inverse, whose last residual tells little of the error: until rounding.
    fn of_blocks(max_iterations: usize) -> Self {
        let of = Self::of_iteration(max_iterations);
        Self { options: PcgOptions { residual_drop: 1e-13, ..of.options }, ..of }
    }

    /// With an approximate inverse: every digit costs iterations, and ten are more than a discretisation has.
    fn of_iteration(max_iterations: usize) -> Self {
        let options = PcgOptions {
            max_iterations,
            residual_drop: 1e-10,
            stagnation_window: max_iterations,
            ..PcgOptions::default()
        };
        Self { options, settled: 2e-10, is_exact: false }
    }
}

/// What a problem is going to be solved with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Plan {
    /// A multigrid cycle.
    Cycle,
    /// The blocks of the points.
    Blocks,
    /// A factor.
    Factor,
}

/// The plan for a problem, from its size and from what the case asks for. For one right-hand side a multigrid cycle is
/// faster than a factor on squares of 1600 points already, about the smallest that have a coarser lattice.
pub(super) fn plan<const D: usize>(problem: &dyn Problem<D>) -> Plan {
    let points = problem.model().points();
    let is_solid = problem.solid_bytes(false).is_some();
    // Cycles that follow breaking bonds know cubes of one material alone.
    let breaks_by_cycles = is_solid && problem.model().contrast_of_points() == 1.0;
    let few_sides = problem.states() < MANY_SIDES || points > TOO_MANY_POINTS;
    match (problem.solver(), problem.spread()) {
        (_, Spread::Chain) => Plan::Factor,
        (Solver::Multigrid, Spread::Lattice) if problem.breaks() && breaks_by_cycles => Plan::Cycle,
        // A bar of 4096 points takes as long either way, one of 1728 three times as long with cycles.
        (Solver::Auto, Spread::Lattice)
            if problem.breaks() && breaks_by_cycles && points > problem.most_factored() =>
        {
            Plan::Cycle
        }
        _ if problem.breaks() => Plan::Factor,
        (Solver::Pcg, _) => Plan::Blocks,
        (Solver::Multigrid, Spread::Lattice) => Plan::Cycle,
        (Solver::Auto, Spread::Lattice) if has_contrast(problem) && points <= worth_a_factor(problem) => {
            Plan::Factor
        }
        (Solver::Auto, Spread::Lattice) if few_sides => Plan::Cycle,
        (Solver::Auto, Spread::Plane) if points > TOO_MANY_POINTS => Plan::Blocks,
        (Solver::Auto, Spread::Solid) if points > problem.most_factored() => Plan::Blocks,
        _ => Plan::Factor,
    }
}

/// Points up to which a lattice is worth a factor where nothing else converges.
pub(super) fn worth_a_factor<const D: usize>(problem: &dyn Problem<D>) -> usize {
    let is_solid = problem.most_factored() < TOO_MANY_POINTS;
    if is_solid { FALL_BACK_OF_SOLID } else { TOO_MANY_POINTS }
}

/// Whether the moduli of points differ by more than coarser lattices can follow.
fn has_contrast<const D: usize>(problem: &dyn Problem<D>) -> bool {
    problem.model().contrast_of_points() > MOST_CONTRAST * (1.0 + 1e-9)
}

/// The method of a problem.
///
/// # Errors
/// [`SolveFailure`] if a point is not held by its bonds, or a matrix has no factor.
pub(super) fn method<'a, const D: usize>(
    problem: &dyn Problem<D>,
    system: &'a System<D>,
    coarser: Option<&'a Coarser<D>>,
    timing: &mut Timing,
    counters: &mut Counters,
) -> Result<Method<'a, D>, SolveFailure> {
    let (asked, points) = (problem.solver(), system.points());
    let because = |reason: String| if asked == Solver::Auto { reason } else { "the case asks for it".into() };
    match (plan(problem), coarser) {
        (Plan::Cycle, Some(coarser)) => {
            let reason = format!(
                "{points} points of a lattice: coarser lattices are a better preconditioner than a factor"
            );
            of_cycle((system, coarser), may_round(system, coarser), because(reason), timing, counters)
                .or_else(|_| of_factor(problem, system, timing, counters))
        }
        (Plan::Blocks, _) => {
            let why = match problem.spread() {
                Spread::Solid => "of a solid that is too thin for coarser lattices",
                _ => "not of a lattice",
            };
            let reason = format!("{points} points, {why}: a factor would take too much memory");
            of_blocks(system, because(reason), timing)
        }
        _ => {
            let method = of_factor(problem, system, timing, counters)?;
            Ok(with_soft_motions(method, problem, system, timing))
        }
    }
}

/// A factor of the stiffness.
///
/// # Errors
/// [`SolveFailure`] if it has none.
pub(super) fn of_factor<'a, const D: usize>(
    problem: &dyn Problem<D>,
    system: &System<D>,
    timing: &mut Timing,
    counters: &mut Counters,
) -> Result<Method<'a, D>, SolveFailure> {
    let positions = problem.positions();
    let (preconditioner, mut report) =
        factor::factor(system, problem.solver(), positions.as_deref(), timing, counters)?;
    if problem.solver() == Solver::Auto && problem.spread() == Spread::Lattice && has_contrast(problem) {
        let ratio = tidy(problem.model().contrast_of_points().powi(2));
        report.reason = format!(
            "moduli of points differ by a factor of {ratio}: coarser lattices are a poor preconditioner"
        );
    }
    if problem.solver() == Solver::Multigrid {
        let points = system.points();
        report.reason = match problem.spread() {
            Spread::Lattice => "multigrid is asked for, but its coarser levels could not be set up".into(),
            _ => format!(
                "multigrid is asked for, but a lattice of {points} points has no coarser one that helps"
            ),
        };
    }
    Ok(Method { preconditioner, report, finish: Finish::of_factor(), rounded: None })
}

/// A method whose factor also knows the motions that its rounding hides, where there are any and their stiffness has a factor.
fn with_soft_motions<'a, const D: usize>(
    method: Method<'a, D>,
    problem: &dyn Problem<D>,
    system: &'a System<D>,
    timing: &mut Timing,
) -> Method<'a, D> {
    let Some(motions) = problem.soft_motions(system) else { return method };
    let begin = Instant::now();
    let Method { preconditioner: factor, mut report, .. } = method;
    let preconditioner: Box<dyn Preconditioner + 'a> =
        match Deflated::new(Box::new(Elementwise(system)), factor, motions) {
            Ok(deflated) => {
                report.reason += "; the softest waves, which its rounding hides, are solved for apart";
                Box::new(deflated)
            }
            Err((_, factor)) => factor,
        };
    timing.factor += begin.elapsed().as_secs_f64();
    Method { preconditioner, report, ..method }
}

/// Points of a solid whose factor is worth its memory where nothing else converges.
const FALL_BACK_OF_SOLID: usize = 30_000;

/// Whether a problem whose cycle did not converge is worth a factor: the case leaves the choice, and there is room.
pub(super) fn can_fall_back<const D: usize>(problem: &dyn Problem<D>) -> bool {
    let most = match problem.spread() {
        Spread::Solid => FALL_BACK_OF_SOLID,
        _ => TOO_MANY_POINTS,
    };
    plan(problem) != Plan::Factor && problem.solver() == Solver::Auto && problem.model().points() <= most
}

/// Whether a cycle in numbers of 32 bits is the first choice.
fn may_round<const D: usize>(system: &System<D>, coarser: &Coarser<D>) -> bool {
    matches!(coarser, Coarser::Models(models) if single_cycle::suits(system, models))
}

/// A multigrid cycle; of models of coarser bodies in numbers of 32 bits where it is to be `rounded`.
///
/// # Errors
/// [`SolveFailure`] if a point is not held by its bonds, or the coarsest level has no factor.
pub(super) fn of_cycle<'a, const D: usize>(
    (system, coarser): (&'a System<D>, &'a Coarser<D>),
    rounded: bool,
    reason: String,
    timing: &mut Timing,
    counters: &mut Counters,
) -> Result<Method<'a, D>, SolveFailure> {
    let begin = Instant::now();
    let (preconditioner, factor_entries): (Box<dyn Preconditioner + 'a>, usize) = match coarser {
        Coarser::Models(models) if rounded => {
            let (cycle, entries) = single_cycle::cycle(system, models, counters)?;
            (Box::new(cycle), entries)
        }
        Coarser::Models(models) => {
            let (cycle, entries) = multigrid::cycle(system, models, counters)?;
            (Box::new(cycle), entries)
        }
        Coarser::Cubes(levels) => {
            let (cycle, entries) = cubic_cycle::cycle(system, levels, counters)?;
            (Box::new(cycle), entries)
        }
        Coarser::Lines(places) => {
            let (cycle, entries) = semicoarsened::cycle(system, places, counters)?;
            (Box::new(cycle), entries)
        }
    };
    timing.factor += begin.elapsed().as_secs_f64();
    counters.factor_bytes = factor_entries * size_of::<f64>();
    let report =
        SolverReport { method: "multigrid".into(), reason, factor_entries, ..SolverReport::default() };
    let rounded = rounded.then_some((system, coarser));
    Ok(Method { preconditioner, report, finish: Finish::of_cycle(), rounded })
}

fn of_blocks<'a, const D: usize>(
    system: &'a System<D>,
    reason: String,
    timing: &mut Timing,
) -> Result<Method<'a, D>, SolveFailure> {
    let begin = Instant::now();
    let level = Level::new(system).map_err(|point| SolveFailure::Loose { point })?;
    timing.factor = begin.elapsed().as_secs_f64();
    let report =
        SolverReport { method: "block_jacobi".into(), reason, factor_entries: 0, ..SolverReport::default() };
    // About 1300 iterations at 1e5 points in the plane, growing with the number of points along a side.
    let limit = 1000 + 20 * (system.points() as f64).sqrt() as usize;
    let preconditioner = Box::new(Blocks(level));
    Ok(Method { preconditioner, report, finish: Finish::of_blocks(limit), rounded: None })
}

/// The inverse of the diagonal blocks.
struct Blocks<'a, const D: usize>(Level<'a, D>);

impl<const D: usize> Preconditioner for Blocks<'_, D> {
    fn size(&self) -> usize {
        self.0.system().size()
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        z.fill(0.0);
        self.0.smooth(1.0, r, z);
    }
}
