//! Equilibrium at a given load factor: Newton's method that cannot diverge.
//!
//! The tangent of softening bonds may be indefinite, so Newton's direction need not go downhill. The tangent is then
//! blended with the secant stiffness, `(1 − θ) K_t + θ K_s`, by as little as makes it positive definite: its direction goes
//! down the incremental potential for sure, and the step with `θ = 1` is one down a quadratic majoriser of it. A line
//! search on the slope of the potential decides how far to go.

use super::super::solve_failure::SolveFailure;
use super::body::{Body, State};

/// Parts of the secant stiffness, tried in this order.
const SECANT_PARTS: [f64; 5] = [0.0, 0.03, 0.1, 0.3, 1.0];
/// Residual over the reference force, below which a state is in equilibrium.
pub(super) const TOLERANCE: f64 = 1e-10;
/// Iterations of a step, at most.
const MOST_ITERATIONS: usize = 60;
/// Slope left over that at the start, below which a line search has gone far enough.
const FLAT: f64 = 0.2;
/// Evaluations of a line search, at most.
const MOST_EVALUATIONS: usize = 12;
/// Part of a direction below which the next blend is tried.
const SHORT: f64 = 0.01;
/// Largest part of a direction of a blend.
const FARTHEST: f64 = 8.0;

/// How a step was solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Effort {
    /// Iterations.
    pub(super) iterations: usize,
    /// Those among them that took a part of the secant stiffness.
    pub(super) blended: usize,
}

impl<const D: usize> Body<D> {
    /// Brings a state to equilibrium at its load factor; nothing is committed. Whether it got there.
    ///
    /// # Errors
    /// A matrix is not finite, or there is no memory.
    pub(super) fn equilibrate(
        &mut self,
        state: &mut State<D>,
        reference: f64,
        effort: &mut Effort,
    ) -> Result<bool, SolveFailure> {
        self.evaluate(state);
        let mut direction = vec![0.0; state.u.len()];
        let mut least = 0;
        for _ in 0..MOST_ITERATIONS {
            let norm = state.norm();
            if norm <= TOLERANCE * reference {
                return Ok(true);
            }
            if !norm.is_finite() {
                return Ok(false);
            }
            effort.iterations += 1;
            let mut taken = None;
            for (k, &part) in SECANT_PARTS.iter().enumerate().skip(least) {
                if !self.factor(state, part)? {
                    continue;
                }
                self.solve(&state.residual, &mut direction);
                direction.iter_mut().for_each(|d| *d = -*d);
                let farthest = if part == 0.0 { 1.0 } else { FARTHEST };
                let (step, next) = self.line_search(state, &direction, farthest);
                taken = Some((k, next));
                if step >= SHORT {
                    break;
                }
            }
            let Some((k, next)) = taken else { return Ok(false) };
            effort.blended += usize::from(k > 0);
            least = k.saturating_sub(1);
            *state = next;
        }
        Ok(state.norm() <= TOLERANCE * reference)
    }

    /// How far to go in a direction, and the state there.
    fn line_search(&mut self, from: &State<D>, direction: &[f64], farthest: f64) -> (f64, State<D>) {
        let slope = |state: &State<D>| direction.iter().zip(&state.residual).map(|(d, r)| d * r).sum::<f64>();
        let start = slope(from);
        let mut state = from.clone();
        let mut go = |step: f64, state: &mut State<D>| {
            state
                .u
                .iter_mut()
                .zip(from.u.iter().zip(direction))
                .for_each(|(u, (from, d))| *u = from + step * d);
            self.evaluate(state);
        };
        let [mut low, mut low_slope] = [0.0, start];
        let mut high: Option<f64> = None;
        let mut step = 1.0;
        go(step, &mut state);
        for _ in 0..MOST_EVALUATIONS {
            let here = slope(&state);
            let is_down = state.potential <= from.potential + 1e-12 * from.potential.abs();
            if here.abs() <= FLAT * start.abs() && is_down {
                break;
            }
            if here < 0.0 && is_down {
                if high.is_none() && step >= farthest {
                    break;
                }
                [low, low_slope] = [step, here];
                step = high.map_or((2.0 * step).min(farthest), |high| 0.5 * (low + high));
            } else {
                let towards = if here > low_slope && here > 0.0 {
                    (-low_slope / (here - low_slope)).clamp(0.1, 0.9)
                } else {
                    0.5
                };
                high = Some(step);
                step = low + (step - low) * towards;
            }
            go(step, &mut state);
        }
        (step, state)
    }
}
