//! A factored system and its solutions.

use super::coarser::Coarser;
use super::load::Load;
use super::measures::worst;
use super::method::{self, Finish, Method};
use super::refine::{DOUBTFUL, DOUBTFUL_FORCES};
use super::shared_solver::SharedSolver;
use super::solve_failure::SolveFailure;
use super::solver_report::SolverReport;
use super::workspace::{StateSolution, Workspace};
use super::{Counters, Problem, Timing};
use peristat_assembly::system::System;
use peristat_solve::{PcgStatus, Preconditioner};

/// The method of a system: one factorisation or hierarchy of levels, any number of right-hand sides.
pub struct LinearSolver<'a, const D: usize> {
    way: Way<'a>,
    finish: Finish,
    work: Workspace<D>,
    report: SolverReport,
    counters: Counters,
    /// What its cycle of 32 bits is of, if it is one.
    rounded: Option<(&'a System<D>, &'a Coarser<D>)>,
}

/// Who iterates.
enum Way<'a> {
    /// This process, with a preconditioner.
    Alone(Box<dyn Preconditioner + 'a>),
    /// Several.
    Shared(Box<dyn SharedSolver + 'a>),
}

impl Way<'_> {
    fn preconditioner(&mut self) -> &mut dyn Preconditioner {
        match self {
            Self::Alone(preconditioner) => &mut **preconditioner,
            Self::Shared(solver) => &mut **solver,
        }
    }
}

/// Passes of conjugate gradients on the true residual.
const PASSES: usize = 4;

impl<'a, const D: usize> LinearSolver<'a, D> {
    /// Chooses the method of a problem and sets it up; `coarser` are its coarser levels, where it takes any.
    ///
    /// # Errors
    /// [`SolveFailure`] if the stiffness has no factor.
    pub(super) fn new(
        problem: &dyn Problem<D>,
        system: &'a System<D>,
        coarser: Option<&'a Coarser<D>>,
        timing: &mut Timing,
    ) -> Result<Self, SolveFailure> {
        let mut counters = Counters::default();
        let method = method::method(problem, system, coarser, timing, &mut counters)?;
        let Method { preconditioner, report, finish, rounded } = method;
        let way = Way::Alone(preconditioner);
        Ok(Self { way, finish, work: Workspace::new(problem, system), report, counters, rounded })
    }

    /// Iterations whose work several processes share.
    pub(super) fn shared(
        problem: &dyn Problem<D>,
        system: &System<D>,
        solver: Box<dyn SharedSolver + 'a>,
    ) -> Self {
        let (report, work) = (solver.report(), Workspace::new(problem, system));
        let (way, finish) = (Way::Shared(solver), Finish::of_cycle());
        Self { way, finish, work, report, counters: Counters::default(), rounded: None }
    }

    /// Whether something else is worth a try where it left too few digits.
    pub(super) fn can_fall_back(&self, problem: &dyn Problem<D>) -> bool {
        self.rounded.is_some() || !self.finish.is_exact && method::can_fall_back(problem)
    }

    /// Takes a cycle of 64 bits instead of one of 32, or a factor instead of a cycle.
    ///
    /// # Errors
    /// [`SolveFailure`] if the stiffness has none.
    pub(super) fn fall_back(
        &mut self,
        problem: &dyn Problem<D>,
        system: &System<D>,
        timing: &mut Timing,
    ) -> Result<(), SolveFailure> {
        let Method { preconditioner, report, finish, .. } = match self.rounded.take() {
            Some(of) => {
                let reason = "in numbers of 64 bits".into();
                method::of_cycle(of, false, reason, timing, &mut self.counters)?
            }
            None => method::of_factor(problem, system, timing, &mut self.counters)?,
        };
        let reason = format!("{} left too few digits; {}", self.report.method, report.reason);
        let mut iterations = std::mem::take(&mut self.report.iterations);
        // The state is solved again.
        iterations.pop();
        self.report = SolverReport { reason, iterations, ..report };
        (self.way, self.finish) = (Way::Alone(preconditioner), finish);
        Ok(())
    }

    /// Forgets the iterations of states from the given number on.
    pub(super) fn keep(&mut self, states: usize) {
        self.report.iterations.truncate(states);
    }

    /// Displacements of each component that count as equally large.
    pub(super) fn scales(&self) -> &[f64; D] {
        &self.work.scales
    }

    /// Method, reason, iterations and counters of all that it solved.
    pub(super) fn into_reports(self) -> (SolverReport, Counters) {
        (self.report, self.counters)
    }

    /// The displacement of a load (`D` planes) without prescribed motions, to the digits that a correction needs.
    pub(super) fn correction(&mut self, system: &System<D>, load: &[f64]) -> Vec<f64> {
        let mut u = vec![0.0; system.size()];
        self.work.start(system, load, 0.0, &mut u);
        let options = self.finish.of_correction();
        let report = self.work.pass(system, self.way.preconditioner(), &options, &mut u);
        system.constraints().expand(0.0, &mut u);
        self.counters.right_hand_sides += 1;
        self.counters.pcg_iterations += report.iterations;
        u
    }

    /// Unknowns under a load (`D` planes) and `motion_factor` times the prescribed motions.
    ///
    /// Every pass solves for the correction of the true, element-wise residual. Without prescribed motions the first
    /// pass is nearly always the last; with them the first residual is that of a sudden jump and carries its rounding,
    /// so a second pass starts from the smooth solution.
    pub(super) fn solve(&mut self, system: &System<D>, load: &Load<D>, motion_factor: f64) -> StateSolution {
        let mut solution = StateSolution::of(vec![0.0; system.size()]);
        solution.by_factor = self.finish.is_exact;
        let moves = system.constraints().moves();
        solution.jump_energy = self.work.start(system, load.forces, motion_factor, &mut solution.u);
        for pass in 0..PASSES {
            let options = &self.finish.options;
            let report = match &mut self.way {
                Way::Alone(own) => self.work.pass(system, &mut **own, options, &mut solution.u),
                Way::Shared(solver) => solver.solve(&self.work.residual, &mut solution.u, options),
            };
            if pass == 0 {
                solution.first_correction = report.first_correction;
            }
            solution.iterations += report.iterations;
            solution.least_eigenvalue = solution.least_eigenvalue.min(report.least_eigenvalue);
            // A later pass that has nothing left to do may see only rounding.
            if pass == 0 || report.status == PcgStatus::Converged {
                solution.status = report.status;
            }
            let before = solution.next_correction;
            self.work.weigh(system, self.way.preconditioner(), (load.forces, motion_factor), &mut solution);
            let next = solution.next_correction;
            let settled = next <= self.finish.settled && !(pass == 0 && moves);
            if settled || next >= 0.1 * before || !next.is_finite() {
                break;
            }
        }
        self.work.doubt(system, self.way.preconditioner(), load, &mut solution);
        let next = solution.next_correction;
        let unknowns = next > DOUBTFUL;
        // Without a strain there is no measure of forces.
        let has_strain = solution.action > 0.0 && !solution.cancels;
        let forces = has_strain && solution.held_error > DOUBTFUL_FORCES * solution.action;
        if self.finish.is_exact
            && (unknowns || forces)
            && self.work.refine(system, self.way.preconditioner(), (load, motion_factor), &mut solution)
        {
            self.report.refined += 1;
            if !unknowns {
                // They had their digits; more would be those of bonds whose numbers are rounded, too.
                solution.next_correction = worst([next, solution.next_correction]);
            }
        }
        self.counters.right_hand_sides += 1;
        self.counters.pcg_iterations += solution.iterations;
        self.report.iterations.push(solution.iterations);
        solution
    }
}
