//! What stands in for the inverse of a stiffness that changes: kept from one equilibrium to the next, and renewed now and then.

use super::cubic_cycle::{self, Cubes};
use super::kept_factor::KeptFactor;
use super::method::{Plan, plan, worth_a_factor};
use super::solve_failure::SolveFailure;
use super::{Coarser, Counters, Problem, Timing};
use crate::case::Solver;
use peristat_assembly::cubic::CubicLevels;
use peristat_assembly::system::System;
use peristat_solve::{DissectedCholesky, Preconditioner};
use std::time::Instant;

/// It is that of the system as it was when it was made.
pub(super) enum KeptInverse {
    /// A sparse factor.
    Factor(KeptFactor),
    /// A multigrid cycle over the cubes of a solid, for so many unknowns.
    Cycle(Box<Cubes<CubicLevels>>, usize),
}

impl KeptInverse {
    /// The one that suits a problem.
    ///
    /// # Errors
    /// [`SolveFailure`] if there is no factor, or it would be too large.
    pub(super) fn new<const D: usize>(
        problem: &dyn Problem<D>,
        system: &System<D>,
        timing: &mut Timing,
        counters: &mut Counters,
    ) -> Result<Self, SolveFailure> {
        match cycle(problem, system, timing, counters) {
            Some(cycle) => Ok(cycle),
            None if plan(problem) == Plan::Cycle && system.points() > worth_a_factor(problem) => {
                Err(SolveFailure::TooLarge { points: system.points() })
            }
            None => Ok(Self::Factor(KeptFactor::new(problem, system, timing, counters)?)),
        }
    }

    /// Makes it that of the system as it is now.
    ///
    /// # Errors
    /// [`SolveFailure`] if there is no factor.
    pub(super) fn renew<const D: usize>(
        &mut self,
        problem: &dyn Problem<D>,
        system: &System<D>,
        timing: &mut Timing,
        counters: &mut Counters,
    ) -> Result<(), SolveFailure> {
        match self {
            Self::Factor(factor) => factor.refill(system, timing, counters)?,
            // Where what has come off leaves no cycle, the old one goes on.
            Self::Cycle(..) => {
                if let Some(cycle) = cycle(problem, system, timing, counters) {
                    *self = cycle;
                }
            }
        }
        Ok(())
    }

    /// Iterations after which a new one is cheaper than going on. Breaking n bonds of m measures costs a factor about n m of them;
    /// a cycle takes some anyway, and costs as much as two or three.
    pub(super) fn patience(&self) -> usize {
        match self {
            Self::Factor(_) => 16,
            Self::Cycle(..) => 24,
        }
    }

    /// Name of the method, and why it was taken.
    pub(super) fn method(&self, asked: Solver) -> (&'static str, String) {
        match (self, asked) {
            (Self::Factor(_), Solver::Multigrid) => (
                "sparse_cholesky",
                "multigrid is asked for, but only solids of one material with coarser lattices break with it".into(),
            ),
            (Self::Factor(_), _) => {
                ("sparse_cholesky", "a body that breaks keeps its factor from equilibrium to equilibrium".into())
            }
            (Self::Cycle(..), Solver::Auto) => (
                "multigrid",
                "a large solid that breaks: coarser lattices, cut where its bonds break, take less than a factor".into(),
            ),
            (Self::Cycle(..), _) => ("multigrid", "the case asks for it".into()),
        }
    }

    /// The factor that solves among a few unknowns, too.
    pub(super) fn dissected(&mut self) -> Option<&mut DissectedCholesky> {
        match self {
            Self::Factor(factor) => factor.dissected(),
            Self::Cycle(..) => None,
        }
    }

    /// Whether it knows soft motions as well as stiff ones.
    pub(super) fn is_factor(&self) -> bool {
        matches!(self, Self::Factor(_))
    }
}

/// A cycle for a problem that is to be solved by one.
fn cycle<const D: usize>(
    problem: &dyn Problem<D>,
    system: &System<D>,
    timing: &mut Timing,
    counters: &mut Counters,
) -> Option<KeptInverse> {
    if plan(problem) != Plan::Cycle {
        return None;
    }
    let begin = Instant::now();
    let Some(Coarser::Cubes(levels)) = problem.coarser(system) else { return None };
    let (cubes, entries) = cubic_cycle::cubes(levels, counters).ok()?;
    counters.factor_bytes = entries * size_of::<f64>();
    timing.factor += begin.elapsed().as_secs_f64();
    Some(KeptInverse::Cycle(Box::new(cubes), system.size()))
}

impl Preconditioner for KeptInverse {
    fn size(&self) -> usize {
        match self {
            Self::Factor(factor) => factor.size(),
            Self::Cycle(_, size) => *size,
        }
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        match self {
            Self::Factor(factor) => factor.apply(r, z),
            Self::Cycle(cubes, _) => cubes.correct(r, z),
        }
    }
}
