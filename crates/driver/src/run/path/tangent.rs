//! Solutions with the stiffness of bonds of either sign.
//!
//! From event to event few bonds change: the factor stays, and what changed is added to it as a matrix of low rank. Where
//! the stiffness is indefinite, on branches that are not stable, so is its factor.

use super::super::RunError;
use super::super::solve_failure::SolveFailure;
use super::body::{Body, State, norm};
use super::course::Course;
use peristat_solve::{FactorError, LowRank, Preconditioner, SparseIndefinite};
use std::collections::HashMap;
use std::time::Instant;

/// Bonds that may have changed before the factor is made anew.
const MOST_CHANGES: usize = 40;

/// Force that a direction may lack over what drives it.
const ACCURACY: f64 = 1e-11;
/// Solves for a direction, at most.
const MOST_PASSES: usize = 6;

/// Solves with a stiffness of either sign.
pub(super) struct Tangent<const D: usize> {
    /// Stiffness of every bond in the factor; empty if there is none.
    factored: Vec<f64>,
    /// When that was factored: others factor with the same body.
    generation: u64,
    /// The indefinite factor, once one was needed.
    indefinite: Option<SparseIndefinite>,
    is_definite: bool,
    changes: LowRank,
    /// Columns of the bonds that have changed.
    columns: HashMap<u32, usize>,
}

impl<const D: usize> Tangent<D> {
    pub(super) fn new(size: usize) -> Self {
        Self {
            factored: Vec::new(),
            generation: 0,
            indefinite: None,
            is_definite: true,
            changes: LowRank::new(size),
            columns: HashMap::new(),
        }
    }

    /// Rates of all unknowns while the load factor changes at the rate `sign`, all bonds having some stiffness, N/m; none
    /// where the stiffness is singular.
    pub(super) fn direction(
        &mut self,
        course: &mut Course<D>,
        stiffness: &[f64],
        sign: f64,
    ) -> Result<Option<Vec<f64>>, RunError> {
        let (body, state) = (&mut course.body, &course.state);
        let mut drive = body.drive(state, |k| stiffness[k]);
        drive.iter_mut().for_each(|f| *f *= -sign);
        for anew in [false, true] {
            if anew {
                self.forget();
            }
            if !self.adapt(body, state, stiffness)? {
                return Ok(None);
            }
            if let Some(mut direction) = self.solve(body, state, stiffness, &drive) {
                body.system.constraints().expand(sign, &mut direction);
                return Ok(Some(direction));
            }
        }
        Ok(None)
    }

    /// Unknowns that forces give rise to, refined until only rounding is left; none if that is not reached.
    fn solve(
        &mut self,
        body: &mut Body<D>,
        state: &State<D>,
        stiffness: &[f64],
        forces: &[f64],
    ) -> Option<Vec<f64>> {
        let (mut unknowns, mut correction) = (vec![0.0; forces.len()], vec![0.0; forces.len()]);
        let mut lack = forces.to_vec();
        let whole = norm(forces);
        for _ in 0..MOST_PASSES {
            if !self.apply(body, &lack, &mut correction) {
                return None;
            }
            unknowns.iter_mut().zip(&correction).for_each(|(u, c)| *u += c);
            lack = body.product(state, stiffness, &unknowns);
            lack.iter_mut().zip(forces).for_each(|(l, f)| *l = f - *l);
            if norm(&lack) <= ACCURACY * whole {
                return Some(unknowns);
            }
        }
        None
    }

    /// Factors the tangent stiffness of a state; whether it has a factor.
    pub(super) fn factor(&mut self, body: &mut Body<D>, state: &State<D>) -> Result<bool, SolveFailure> {
        self.forget();
        self.is_definite = body.factor(state, 0.0)?;
        if self.is_definite { Ok(true) } else { self.factor_indefinite(body) }
    }

    /// Solves with what was factored last; whether there is a solution.
    pub(super) fn apply(&mut self, body: &mut Body<D>, forces: &[f64], unknowns: &mut [f64]) -> bool {
        let begin = Instant::now();
        body.counters.right_hand_sides += 1;
        let factor: &mut dyn Preconditioner = match (&mut self.indefinite, self.is_definite) {
            (Some(factor), false) => factor,
            _ => body.cholesky(),
        };
        let done = match self.columns.is_empty() {
            true => {
                factor.apply(forces, unknowns);
                true
            }
            false => self.changes.apply(factor, forces, unknowns).is_ok(),
        };
        body.timing.solve += begin.elapsed().as_secs_f64();
        done
    }

    /// Makes the factor, or what is added to it, that of bonds of some stiffness; whether there is one.
    fn adapt(
        &mut self,
        body: &mut Body<D>,
        state: &State<D>,
        stiffness: &[f64],
    ) -> Result<bool, SolveFailure> {
        if self.factored.len() == stiffness.len() && self.generation == body.generation {
            let differs = |k: &usize| stiffness[*k] != self.factored[*k];
            let fresh: Vec<usize> = (0..stiffness.len())
                .filter(|k| differs(k) && !self.columns.contains_key(&(*k as u32)))
                .collect();
            if self.columns.len() + fresh.len() <= MOST_CHANGES {
                self.change(body, state, stiffness, &fresh);
                return Ok(true);
            }
        }
        self.forget();
        self.is_definite = body.factor_with(state, stiffness)?;
        if !self.is_definite && !self.factor_indefinite(body)? {
            return Ok(false);
        }
        (self.factored, self.generation) = (stiffness.to_vec(), body.generation);
        Ok(true)
    }

    /// Adds columns of bonds and sets all changes.
    fn change(&mut self, body: &mut Body<D>, state: &State<D>, stiffness: &[f64], fresh: &[usize]) {
        let begin = Instant::now();
        for &bond in fresh {
            let column = body.pattern.column(bond, &state.answers.bonds[bond].direction);
            let factor: &mut dyn Preconditioner = match (&mut self.indefinite, self.is_definite) {
                (Some(factor), false) => factor,
                _ => body.cholesky(),
            };
            let index = self.changes.push(factor, &column);
            self.columns.insert(bond as u32, index);
        }
        body.counters.right_hand_sides += fresh.len();
        for (&bond, &index) in &self.columns {
            self.changes.set(index, stiffness[bond as usize] - self.factored[bond as usize]);
        }
        body.timing.solve += begin.elapsed().as_secs_f64();
    }

    /// Negative eigenvalues of the stiffness at hand; none where it has no factor.
    pub(super) fn negative_eigenvalues(&mut self) -> Option<usize> {
        let of_factor = match (&self.indefinite, self.is_definite) {
            (_, true) => 0,
            (Some(factor), false) => factor.negative_pivots(),
            (None, false) => return None,
        };
        Some(self.changes.negative_eigenvalues(of_factor))
    }

    /// Stiffness of the bonds in the factor, if it is still there, and the bonds that have columns, in their order.
    pub(super) fn factored(&self, body: &Body<D>) -> (Vec<f64>, Vec<u32>) {
        if self.generation != body.generation {
            return (Vec::new(), Vec::new());
        }
        let mut changed: Vec<(usize, u32)> =
            self.columns.iter().map(|(&bond, &index)| (index, bond)).collect();
        changed.sort_unstable();
        (self.factored.clone(), changed.into_iter().map(|c| c.1).collect())
    }

    /// Factors what another run has, and adds columns in the order in which that one did.
    ///
    /// # Errors
    /// There is no such factor.
    pub(super) fn factor_again(
        &mut self,
        course: &mut Course<D>,
        (factored, changed): (Vec<f64>, &[u32]),
    ) -> Result<(), RunError> {
        if factored.is_empty() {
            return Ok(());
        }
        let (body, state) = (&mut course.body, &course.state);
        if !self.adapt(body, state, &factored)? {
            return Err(RunError::Misfit);
        }
        let changed: Vec<usize> = changed.iter().map(|&bond| bond as usize).collect();
        self.change(body, state, &factored, &changed);
        Ok(())
    }

    fn forget(&mut self) {
        self.factored.clear();
        self.columns.clear();
        self.changes.clear();
    }

    fn factor_indefinite(&mut self, body: &mut Body<D>) -> Result<bool, SolveFailure> {
        if self.indefinite.is_none() {
            self.indefinite = Some(body.indefinite()?);
        }
        let Some(factor) = &mut self.indefinite else { return Ok(false) };
        match body.refactor(factor) {
            Ok(()) => Ok(true),
            Err(FactorError::Singular { .. } | FactorError::NonPositivePivot { .. }) => Ok(false),
            Err(error) => Err(SolveFailure::Factor(error)),
        }
    }
}
