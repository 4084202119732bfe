//! Control of the energy that a step dissipates: the load factor is an unknown, and may fall.
//!
//! The bonds that softened in the last step are to dissipate a given energy τ more, in linear approximation:
//! `w·(e − e_n) = τ` with `w = k ξ dD/ds`. The bordered system is solved by two solutions with the stiffness of the bonds.
//!
//! As long as few bonds soften, steps of the load factor lead on. One that would dissipate more than it may is made
//! shorter, and where none is short enough the body snaps back: then the bonds that are about to soften drive it, `e_n`
//! being no less than where they begin.

mod approach;

use super::super::RunError;
use super::body::{Body, State};
use super::control::{Control, Goal, Load, Step};
use super::course::Course;
use super::displacement::Displacement;
use super::kept::{Dissipated, Memory};
use super::newton::{Effort, TOLERANCE};
use super::point::Cost;
use super::tangent::Tangent;
use approach::{dissipates, softens_at};
use peristat_assembly::law::Law;
use peristat_assembly::stiffness::Answer;

/// Bonds that have to soften in a step before their energy drives the next one.
const ENOUGH: usize = 8;
/// Iterations of a step, at most; after no more than the second number the next one is larger.
const ITERATIONS: [usize; 2] = [25, 6];
/// Growth of the steps.
const GROWTH: f64 = 1.5;
/// The smallest step over the largest one.
const LEAST: f64 = 1.0 / 256.0;
/// Energy that a step of the load factor may dissipate over that of a step of energy.
const JUMPS: f64 = 2.0;
/// Parts of a correction that are tried.
const PARTS: [f64; 4] = [1.0, 0.5, 0.25, 0.1];
/// How much of the last step a predictor may be.
const FARTHEST: f64 = 4.0;
/// Error of the constraint over τ, below which it is met.
const MET: f64 = 1e-8;

/// Steps of dissipated energy, beginning with steps of the load factor.
pub(super) struct Dissipation<const D: usize> {
    start: Displacement<D>,
    tangent: Tangent<D>,
    /// Largest energy of a step, J, and that of the next one.
    largest: f64,
    energy: f64,
    /// How many bonds have to soften in a step to drive the next one.
    fewest: usize,
    /// Force that dissipates the energy, per bond; none as long as too few soften.
    weights: Option<Vec<f64>>,
    /// Unknowns, load factor and damage of the bonds in the state before.
    before: Option<(Vec<f64>, f64, Vec<f64>)>,
    /// The last step: unknowns and load factor.
    last: Option<(Vec<f64>, f64)>,
}

impl<const D: usize> Dissipation<D> {
    /// `energy` is the largest one of a step, J.
    pub(super) fn new(course: &Course<D>, increment: f64, energy: f64) -> Self {
        Self {
            start: Displacement::new(increment),
            tangent: Tangent::new(course.body.system.size()),
            largest: energy,
            energy,
            fewest: ENOUGH,
            weights: None,
            before: None,
            last: None,
        }
    }

    /// A state that dissipates the energy, if one is found.
    fn solve(
        &mut self,
        course: &mut Course<D>,
        weights: &[f64],
        effort: &mut Effort,
    ) -> Result<Option<State<D>>, RunError> {
        let Some((unknowns, grown)) = &self.last else { return Ok(None) };
        let start = Self::starts(course, weights);
        let mut state = course.state.clone();
        let rates = course.body.bonds.elongation_rates(&state.answers.bonds, unknowns);
        let would: f64 = weights.iter().zip(&rates).map(|(w, r)| w * r).sum();
        let share = if would > 0.0 { (self.energy / would).min(FARTHEST) } else { 1.0 };
        state.u.iter_mut().zip(unknowns).for_each(|(u, d)| *u += share * d);
        course.hold_islands(&mut state.u);
        state.load_factor += share * grown;
        course.body.evaluate(&mut state);
        let reference = course.reference;
        for _ in 0..ITERATIONS[0] {
            let lack = self.lack(weights, &state, &start);
            let norm = state.norm();
            if norm <= TOLERANCE * reference && lack.abs() <= MET * self.energy {
                // Others may have softened much more than those that were asked.
                return Ok((dissipates(course, &state) <= JUMPS * self.largest).then_some(state));
            }
            if norm.is_nan() || norm > 1e6 * reference {
                return Ok(None);
            }
            effort.iterations += 1;
            let Some((correction, factor)) = self.correction(course, &state, weights, lack)? else {
                return Ok(None);
            };
            let merit = |state: &State<D>, lack: f64| state.norm() / reference + lack.abs() / self.energy;
            let (now, mut best): (f64, Option<(f64, State<D>)>) = (merit(&state, lack), None);
            for part in PARTS {
                let mut next = state.clone();
                next.u.iter_mut().zip(&correction).for_each(|(u, d)| *u += part * d);
                next.load_factor += part * factor;
                course.body.evaluate(&mut next);
                let found = merit(&next, self.lack(weights, &next, &start));
                if best.as_ref().is_none_or(|b| found < b.0) {
                    best = Some((found, next));
                }
                if found < 0.9 * now {
                    break;
                }
            }
            let Some((_, next)) = best else { return Ok(None) };
            state = next;
        }
        Ok(None)
    }

    /// Elongations from which weighted ones dissipate: the committed ones, or where bonds begin to soften.
    fn starts(course: &Course<D>, weights: &[f64]) -> Vec<f64> {
        let bonds = &course.body.bonds;
        let of = |(k, answer): (usize, &Answer<D>)| match weights[k] {
            0.0 => answer.elongation,
            _ => answer.elongation.max(softens_at(bonds, k)),
        };
        course.state.answers.bonds.iter().enumerate().map(of).collect()
    }

    /// What the weighted elongations lack of the energy.
    fn lack(&self, weights: &[f64], state: &State<D>, start: &[f64]) -> f64 {
        let each = weights.iter().zip(&state.answers.bonds).zip(start);
        each.filter(|((w, _), _)| **w != 0.0).map(|((w, a), e)| w * (a.elongation - e)).sum::<f64>()
            - self.energy
    }

    /// Correction of unknowns and load factor.
    fn correction(
        &mut self,
        course: &mut Course<D>,
        state: &State<D>,
        weights: &[f64],
        lack: f64,
    ) -> Result<Option<(Vec<f64>, f64)>, RunError> {
        let body: &mut Body<D> = &mut course.body;
        if !self.tangent.factor(body, state)? {
            return Ok(None);
        }
        let answers = &state.answers.bonds;
        let mut along = vec![0.0; state.u.len()];
        if !self.tangent.apply(body, &state.residual, &mut along) {
            return Ok(None);
        }
        let drive = body.drive(state, |k| answers[k].tangent);
        let mut with_load = vec![0.0; state.u.len()];
        if !self.tangent.apply(body, &drive, &mut with_load) {
            return Ok(None);
        }
        // d = −K⁻¹ r − μ K⁻¹ k_λ, and the constraint decides μ.
        let constraints = body.system.constraints();
        along.iter_mut().for_each(|v| *v = -*v);
        constraints.expand(0.0, &mut along);
        with_load.iter_mut().for_each(|v| *v = -*v);
        constraints.expand(1.0, &mut with_load);
        let dot = |v: &[f64]| -> f64 {
            let rates = body.bonds.elongation_rates(answers, v);
            weights.iter().zip(rates).map(|(w, r)| w * r).sum()
        };
        let per_load = dot(&with_load);
        if per_load == 0.0 {
            return Ok(None);
        }
        let factor = (-lack - dot(&along)) / per_load;
        along.iter_mut().zip(&with_load).for_each(|(v, w)| *v += factor * w);
        Ok(Some((along, factor)))
    }

    /// What bonds that have softened since the last step dissipate per elongation.
    fn weights(course: &Course<D>, before: &[f64], fewest: usize) -> Option<Vec<f64>> {
        let bonds = &course.body.bonds;
        let mut count = 0;
        let weight = |(k, before): (usize, &f64)| {
            let (law, history, bond) = (bonds.law(k), &bonds.history()[k], &bonds.list()[k]);
            if history.broken || law.damage(history) <= *before {
                return 0.0;
            }
            count += 1;
            bond.stiffness * bond.length * law.dissipation_rate()
        };
        let weights: Vec<f64> = before.iter().enumerate().map(weight).collect();
        (count >= fewest).then_some(weights)
    }
}

impl<const D: usize> Control<D> for Dissipation<D> {
    fn step(&mut self, course: &mut Course<D>, goal: Goal, load: Load<D>) -> Result<Step<D>, RunError> {
        let mut cost = Cost::default();
        let Goal::LoadFactor(end) = goal else { return self.start.step(course, goal, load) };
        let Some(weights) = self.weights.clone() else { return self.approach(course, goal, load) };
        loop {
            if let Some(state) = self.solve(course, &weights, &mut cost.effort)? {
                if cost.effort.iterations <= ITERATIONS[1] {
                    self.energy = (self.energy * GROWTH).min(self.largest);
                }
                let forwards = end > course.points.last().map_or(0.0, |p| p.load_factor);
                let is_beyond = if forwards { state.load_factor >= end } else { state.load_factor <= end };
                if is_beyond {
                    // The last step ends where it was asked to.
                    return self.start.step(course, goal, load);
                }
                cost.negative = self.tangent.negative_eigenvalues();
                return Ok(Step::To(state, cost, false));
            }
            cost.refused += 1;
            self.energy *= 0.5;
            if self.energy < LEAST * self.largest {
                self.energy = self.largest;
                self.weights = None;
                return self.approach(course, goal, load);
            }
        }
    }

    fn committed(&mut self, course: &mut Course<D>, turns: bool) {
        self.start.committed(course, turns);
        let bonds = &course.body.bonds;
        let damage: Vec<f64> =
            (0..bonds.list().len()).map(|k| bonds.law(k).damage(&bonds.history()[k])).collect();
        let now = (course.state.u.clone(), course.state.load_factor, damage);
        let before = self.before.replace(now);
        self.weights = None;
        if let Some((u, load_factor, damage)) = before.filter(|_| !turns) {
            self.weights = Self::weights(course, &damage, self.fewest);
            let moved = course.state.u.iter().zip(&u).map(|(now, before)| now - before).collect();
            self.last = Some((moved, course.state.load_factor - load_factor));
        }
    }

    fn memory(&self, _course: &Course<D>) -> Memory {
        Memory::Dissipation(Dissipated {
            energy: self.energy,
            fewest: self.fewest,
            weights: self.weights.clone(),
            before: self.before.clone(),
            last: self.last.clone(),
            start: self.start.steps(),
        })
    }

    fn recall(&mut self, _course: &mut Course<D>, memory: Memory) -> Result<(), RunError> {
        let Memory::Dissipation(kept) = memory else { return Err(RunError::Misfit) };
        self.start.recall_steps(kept.start);
        (self.energy, self.fewest, self.weights) = (kept.energy, kept.fewest, kept.weights);
        (self.before, self.last) = (kept.before, kept.last);
        Ok(())
    }
}
