//! A body of bonds with memory: what it answers to displacements, and the factor of its stiffness.

use super::super::factor::SparseFactor;
use super::super::solve_failure::SolveFailure;
use super::super::{Counters, Timing};
use peristat_assembly::law::Bilinear;
use peristat_assembly::stiffness::{BondAnswers, HistoryBonds};
use peristat_assembly::system::{DifferencePattern, System};
use peristat_solve::{FactorError, Preconditioner, SparseIndefinite};
use sprs::CsMat;
use std::time::Instant;

/// What is added to the diagonal of the matrix that is factored, over the median of the elastic one: a preconditioner has a
/// factor then where a part of the body has nearly come off. Residuals never see it.
pub(super) const LIFT: f64 = 1e-10;

/// The bonds of a body that softens.
pub(in super::super) type SofteningBonds<const D: usize> = HistoryBonds<D, Bilinear>;

/// A body of bonds with memory under loads and motions in proportion to a load factor λ.
pub(super) struct Body<const D: usize> {
    pub(super) system: System<D>,
    pub(super) bonds: SofteningBonds<D>,
    /// Loads at a load factor of one.
    pub(super) loads: Vec<f64>,
    /// Unknowns that the prescribed motions at a load factor of one give by themselves.
    pub(super) motion: Vec<f64>,
    /// Unknowns of what has come off: nothing acts on them any more.
    pub(super) masked: Vec<usize>,
    pub(super) pattern: DifferencePattern<D>,
    matrix: CsMat<f64>,
    factor: SparseFactor,
    positions: Option<Vec<[f64; 2]>>,
    /// Median of the diagonal of the elastic stiffness, N/m.
    pub(super) stiffness_scale: f64,
    /// Which matrix is factored: every factorisation counts it up.
    pub(super) generation: u64,
    pub(super) counters: Counters,
    pub(super) timing: Timing,
}

/// A state of a body, in equilibrium or on the way to it.
#[derive(Clone, Debug)]
pub(super) struct State<const D: usize> {
    /// Unknowns, those that are constrained with their values.
    pub(super) u: Vec<f64>,
    pub(super) load_factor: f64,
    pub(super) answers: BondAnswers<D>,
    /// Internal forces less loads, whole: forces of constraints on what they hold.
    pub(super) forces: Vec<f64>,
    /// The same on the independent unknowns: the residual.
    pub(super) residual: Vec<f64>,
    /// Incremental potential: energy less what the loads have done.
    pub(super) potential: f64,
}

impl<const D: usize> State<D> {
    /// 2-norm of the residual.
    pub(super) fn norm(&self) -> f64 {
        norm(&self.residual)
    }
}

impl<const D: usize> Body<D> {
    /// A virgin body; `positions` are those of points that spread in a plane.
    ///
    /// # Errors
    /// The elastic stiffness has no factor.
    pub(super) fn new(
        system: System<D>,
        bonds: SofteningBonds<D>,
        loads: Vec<f64>,
        positions: Option<Vec<[f64; 2]>>,
    ) -> Result<Self, SolveFailure> {
        let mut timing = Timing::default();
        let begin = Instant::now();
        let ends = (0..bonds.list().len()).map(|bond| bonds.shares(bond));
        let pattern = DifferencePattern::new(system.points(), system.constraints(), ends);
        let matrix = pattern.matrix();
        timing.assemble += begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        let factor =
            SparseFactor::analyse::<D>(&matrix, positions.as_deref()).map_err(SolveFailure::Factor)?;
        timing.factor += begin.elapsed().as_secs_f64();
        let counters = Counters { analyses: 1, ..Counters::default() };
        let mut motion = vec![0.0; system.size()];
        system.constraints().expand(1.0, &mut motion);
        let masked = Vec::new();
        let stiffness_scale = 1.0;
        let mut body = Self {
            system,
            bonds,
            loads,
            motion,
            masked,
            pattern,
            matrix,
            factor,
            positions,
            stiffness_scale,
            generation: 0,
            counters,
            timing,
        };
        let rest = body.state(vec![0.0; body.system.size()], 0.0);
        body.fill(&rest, 0.0);
        let mut diagonal: Vec<f64> = body.free_diagonal().collect();
        if !diagonal.is_empty() {
            let middle = diagonal.len() / 2;
            body.stiffness_scale = *diagonal.select_nth_unstable_by(middle, f64::total_cmp).1;
        }
        Ok(body)
    }

    /// Diagonal of the matrix at independent unknowns.
    fn free_diagonal(&self) -> impl Iterator<Item = f64> + '_ {
        let mut held = vec![false; self.system.size()];
        self.system.constraints().rows().iter().for_each(|row| held[row.unknown] = true);
        let diagonal = self.pattern.diagonal().iter().enumerate().filter(move |(k, _)| !held[*k]);
        diagonal.map(|(_, &place)| self.matrix.data()[place as usize])
    }

    /// The state of some independent unknowns at a load factor.
    pub(super) fn state(&mut self, u: Vec<f64>, load_factor: f64) -> State<D> {
        let size = u.len();
        let mut state = State {
            u,
            load_factor,
            answers: self.bonds.at_rest(),
            forces: vec![0.0; size],
            residual: vec![0.0; size],
            potential: 0.0,
        };
        self.evaluate(&mut state);
        state
    }

    /// Finds what the body answers to the independent unknowns and the load factor of a state.
    pub(super) fn evaluate(&mut self, state: &mut State<D>) {
        self.system.constraints().expand(state.load_factor, &mut state.u);
        self.bonds.evaluate(&state.u, &mut state.answers);
        self.counters.bond_evaluations += self.bonds.list().len() as u64;
        state.forces.fill(0.0);
        let answers = &state.answers.bonds;
        self.bonds.add_force(answers, |k| answers[k].force, &mut state.forces);
        let mut work = 0.0;
        for ((force, load), u) in state.forces.iter_mut().zip(&self.loads).zip(&state.u) {
            *force -= state.load_factor * load;
            work += state.load_factor * load * u;
        }
        state.potential = state.answers.energy - work;
        state.residual.clone_from(&state.forces);
        self.restrict(&mut state.residual);
    }

    /// Turns forces on all unknowns into those on the independent ones that are part of the body.
    pub(super) fn restrict(&self, forces: &mut [f64]) {
        self.system.constraints().restrict(forces);
        self.masked.iter().for_each(|&unknown| forces[unknown] = 0.0);
    }

    /// Makes the matrix of a state, `(1 − θ)` of the tangent and `θ` of the secant stiffness.
    fn fill(&mut self, state: &State<D>, secant_part: f64) {
        let begin = Instant::now();
        let answers = &state.answers.bonds;
        self.pattern.fill(|k| answers[k].block(secant_part), &mut self.matrix);
        self.timing.assemble += begin.elapsed().as_secs_f64();
    }

    /// Factors the stiffness of a state; whether it has a factor, that is, whether it is positive definite.
    ///
    /// # Errors
    /// It is not finite, or there is no memory.
    pub(super) fn factor(&mut self, state: &State<D>, secant_part: f64) -> Result<bool, SolveFailure> {
        self.fill(state, secant_part);
        self.factor_filled()
    }

    /// What would correct the unknowns of a state whose residual is not zero: by its tangent, or by its secant stiffness
    /// where that is not positive definite; infinite where neither has a factor. It tells of the state and is no part of the
    /// path: nothing of it is counted.
    ///
    /// # Errors
    /// As [`Self::factor`].
    pub(super) fn correction(&mut self, state: &State<D>) -> Result<Vec<f64>, SolveFailure> {
        let (counters, timing) = (self.counters.clone(), self.timing.clone());
        let mut correction = vec![f64::INFINITY; state.u.len()];
        for secant_part in [0.0, 1.0] {
            if self.factor(state, secant_part)? {
                correction.fill(0.0);
                self.solve(&state.residual, &mut correction);
                break;
            }
        }
        (self.counters, self.timing) = (counters, timing);
        Ok(correction)
    }

    /// The same with the stiffness of every bond, N/m, along it.
    ///
    /// # Errors
    /// As [`Self::factor`].
    pub(super) fn factor_with(&mut self, state: &State<D>, stiffness: &[f64]) -> Result<bool, SolveFailure> {
        let begin = Instant::now();
        let answers = &state.answers.bonds;
        let block = |k: usize| {
            let n = &answers[k].direction;
            n.map(|a| n.map(|b| stiffness[k] * (a * b)))
        };
        self.pattern.fill(block, &mut self.matrix);
        self.timing.assemble += begin.elapsed().as_secs_f64();
        self.factor_filled()
    }

    fn factor_filled(&mut self) -> Result<bool, SolveFailure> {
        let begin = Instant::now();
        let lift = LIFT * self.stiffness_scale;
        let values = self.matrix.data_mut();
        for &place in self.pattern.diagonal() {
            let value = &mut values[place as usize];
            *value = if *value == 0.0 { self.stiffness_scale } else { *value + lift };
        }
        self.generation += 1;
        self.counters.factorisations += 1;
        let done = self.factor.refactor(&self.matrix);
        self.counters.factor_bytes = self.factor.bytes();
        self.timing.factor += begin.elapsed().as_secs_f64();
        match done {
            Ok(()) => Ok(true),
            Err(FactorError::NonPositivePivot { .. }) => Ok(false),
            Err(error) => Err(SolveFailure::Factor(error)),
        }
    }

    /// What was factored last as positive definite.
    pub(super) fn cholesky(&mut self) -> &mut SparseFactor {
        &mut self.factor
    }

    /// A factor for what is not.
    ///
    /// # Errors
    /// There is no memory.
    pub(super) fn indefinite(&mut self) -> Result<SparseIndefinite, SolveFailure> {
        let made = self.factor.indefinite::<D>(&self.matrix, self.positions.as_deref());
        made.map_err(SolveFailure::Factor)
    }

    /// Factors the last matrix by another method.
    ///
    /// # Errors
    /// The matrix has no such factor.
    pub(super) fn refactor(&mut self, factor: &mut SparseIndefinite) -> Result<(), FactorError> {
        let begin = Instant::now();
        self.counters.factorisations += 1;
        let done = factor.refactor(&self.matrix);
        self.timing.factor += begin.elapsed().as_secs_f64();
        done
    }

    /// Forces on the independent unknowns of some displacements while bonds have some stiffness, N/m.
    pub(super) fn product(&self, state: &State<D>, stiffness: &[f64], unknowns: &[f64]) -> Vec<f64> {
        let mut u = unknowns.to_vec();
        self.system.constraints().expand(0.0, &mut u);
        let answers = &state.answers.bonds;
        let rates = self.bonds.elongation_rates(answers, &u);
        let mut forces = vec![0.0; u.len()];
        self.bonds.add_force(answers, |k| stiffness[k] * rates[k], &mut forces);
        self.restrict(&mut forces);
        forces
    }

    /// Applies the inverse of what was factored last to forces on the independent unknowns.
    pub(super) fn solve(&mut self, forces: &[f64], unknowns: &mut [f64]) {
        let begin = Instant::now();
        self.factor.apply(forces, unknowns);
        self.counters.right_hand_sides += 1;
        self.timing.solve += begin.elapsed().as_secs_f64();
    }

    /// Forces on the independent unknowns per load factor while these stay, bonds having some stiffness, N/m: `∂r/∂λ`.
    pub(super) fn drive(&self, state: &State<D>, stiffness: impl Fn(usize) -> f64) -> Vec<f64> {
        let rates = self.bonds.elongation_rates(&state.answers.bonds, &self.motion);
        let mut forces: Vec<f64> = self.loads.iter().map(|f| -f).collect();
        self.bonds.add_force(&state.answers.bonds, |k| stiffness(k) * rates[k], &mut forces);
        self.restrict(&mut forces);
        forces
    }

    /// The state with some unknowns at a load factor of one if all bonds had the stiffness of a state, given the rates of
    /// their elongations, and its work.
    pub(super) fn elastic_state(&self, from: &State<D>, u: &[f64], rates: &[f64]) -> (State<D>, f64) {
        let mut state = State { u: u.to_vec(), load_factor: 1.0, ..from.clone() };
        let mut work = 0.0;
        for (answer, rate) in state.answers.bonds.iter_mut().zip(rates) {
            (answer.elongation, answer.force) = (*rate, answer.tangent * rate);
            work += 0.5 * answer.force * rate;
        }
        state.forces = self.loads.iter().map(|f| -f).collect();
        let answers = &state.answers.bonds;
        self.bonds.add_force(answers, |k| answers[k].force, &mut state.forces);
        (state, work)
    }

    /// Force that does the work of the prescribed motions with the load factor.
    pub(super) fn motion_force(&self, state: &State<D>) -> f64 {
        self.system.constraints().rows().iter().map(|row| row.value * state.forces[row.unknown]).sum()
    }

    /// Forces that hold the equations.
    pub(super) fn multipliers(&self, state: &State<D>) -> Vec<f64> {
        self.system.constraints().multipliers(|unknown| state.forces[unknown])
    }
}

/// 2-norm.
pub(super) fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
