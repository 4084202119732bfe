//! When the iteration ends, and what is said about it.

use super::lanczos::Lanczos;

/// `r . z` relative to the energy of the solution below which the iteration has reached
/// rounding: the energy error is then 1e-12 of the solution's or less, and what
/// looks like stagnation is the floor.
pub(super) const SETTLED: f64 = 1.0e-24;
/// Curvature of a direction over its square in the norm of the preconditioner below which no rounding makes it: that of one that is
/// settled is nothing but rounding.
const NEGATIVE: f64 = -1.0e-2;
/// Iterations without a new smallest `r . z` after which a settled iteration ends.
const SETTLED_WINDOW: usize = 5;
/// A fall of `r . z` in one step that only a factor makes, and the next one will be as steep. Falls with other
/// preconditioners go up and down by several times.
const STEEP: f64 = 1.0e-3;

/// When to stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PcgOptions {
    /// Products with the operator before the iteration is given up.
    pub max_iterations: usize,
    /// Stop when `r . z` has fallen to this fraction of the energy of all steps so far (or of its first value, if that is
    /// larger). It estimates the square of the relative error in the energy norm. A preconditioner that is much too
    /// stiff starts with an `r . z` far below the energy of the solution, so the first value alone would ask too much.
    pub energy_drop: f64,
    /// Iterations without a new smallest `r . z` that count as stagnation.
    ///
    /// `r . z` need not fall in every step (only the energy of the error does).
    /// With a preconditioner that has no correct digit it may stay above its
    /// first value for dozens of steps before it falls to rounding level, so the
    /// window must not be short.
    pub stagnation_window: usize,
    /// Stop, too, when the 2-norm of the residual has fallen to this fraction of its first value. 0 does not look at it,
    /// and spares one pass over the residual per step. A preconditioner that is no factor need not be applied to the
    /// last residual then.
    pub residual_drop: f64,
}

impl PcgOptions {
    /// To the last digit, with a factor as preconditioner.
    pub const STANDARD: Self =
        Self { max_iterations: 200, energy_drop: 1.0e-32, stagnation_window: 60, residual_drop: 0.0 };
}

impl Default for PcgOptions {
    fn default() -> Self {
        Self::STANDARD
    }
}

/// Why the iteration ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PcgStatus {
    /// `r . z` fell far enough, or reached its rounding floor below 1e-24.
    Converged,
    /// `r . z` found no new minimum for a whole window, above 1e-24.
    Stagnated,
    /// The iterations ran out.
    IterationLimit,
    /// A direction with `p . A p <= 0`, or `r . M^-1 r <= 0` for the right-hand
    /// side: the operator or the preconditioner is not positive definite.
    IndefiniteOperator,
    /// A scalar product is infinite or not a number.
    NotFinite,
}

/// How the iteration went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PcgReport {
    /// Why it ended.
    pub status: PcgStatus,
    /// Steps taken; each is one product and one application of `M^-1`.
    pub iterations: usize,
    /// The last `r . z` over the first, foretold for the last step where that ended the iteration; 0 for a zero
    /// right-hand side.
    pub energy_ratio: f64,
    /// The 2-norm of the last residual over that of the first, if `residual_drop` asks for it; 0 for a zero right-hand
    /// side.
    pub residual_ratio: Option<f64>,
    /// Energy norm of all steps after the first relative to that of the solution:
    /// how wrong the answer of the preconditioner alone was, up to its length.
    pub first_correction: f64,
    /// Least eigenvalue of the preconditioned operator that the steps have seen, the smallest Ritz value; 1 if there were
    /// none. `r . z` over it bounds the squared energy norm of the error.
    pub least_eigenvalue: f64,
}

/// Follows `r . z` and the energy of the steps.
pub(super) struct Watch<'a> {
    options: &'a PcgOptions,
    iterations: usize,
    first: f64,
    previous: f64,
    last: f64,
    smallest: f64,
    since_smallest: usize,
    first_energy: f64,
    later_energy: f64,
    /// Squared 2-norms of the residual, if asked for.
    first_square: f64,
    last_square: f64,
    /// Square of the direction in the norm of the preconditioner: `p = z + beta p`, and `z` is across the last one.
    direction: f64,
    lanczos: Lanczos,
}

impl<'a> Watch<'a> {
    pub(super) fn new(options: &'a PcgOptions) -> Self {
        Self {
            options,
            iterations: 0,
            first: 0.0,
            previous: 0.0,
            last: 0.0,
            smallest: f64::INFINITY,
            since_smallest: 0,
            first_energy: 0.0,
            later_energy: 0.0,
            first_square: 0.0,
            last_square: 0.0,
            direction: 0.0,
            lanczos: Lanczos::default(),
        }
    }

    /// The first `r . z`, of a right-hand side that is not zero, and its `r . r`, which is evaluated if it is needed.
    pub(super) fn start(&mut self, rz: f64, square: impl FnOnce() -> f64) -> Option<PcgStatus> {
        if self.options.residual_drop > 0.0 {
            self.first_square = square();
            self.last_square = self.first_square;
        }
        (self.first, self.last, self.smallest) = (rz, rz, rz);
        (self.previous, self.direction) = (0.0, rz);
        if !rz.is_finite() {
            Some(PcgStatus::NotFinite)
        } else if rz <= 0.0 {
            Some(PcgStatus::IndefiniteOperator)
        } else if self.options.max_iterations == 0 {
            Some(PcgStatus::IterationLimit)
        } else {
            None
        }
    }

    /// `p . A p` of a direction.
    pub(super) fn curvature(&self, curvature: f64) -> Option<PcgStatus> {
        if !curvature.is_finite() {
            Some(PcgStatus::NotFinite)
        } else if curvature > 0.0 {
            None
        } else if self.settled() && curvature > NEGATIVE * self.direction {
            Some(PcgStatus::Converged)
        } else {
            Some(PcgStatus::IndefiniteOperator)
        }
    }

    /// The `r . z` after the next step where `M^-1` need not be applied to know that the iteration ends there: the
    /// residual, whose square is evaluated if it is needed, is small enough, or the last fall was that of a factor and
    /// ends the iteration when repeated. Falls get steeper with a factor, so this is no promise that is broken.
    pub(super) fn foretell(&mut self, square: impl FnOnce() -> f64) -> Option<f64> {
        if self.options.residual_drop > 0.0 {
            let before = self.last_square;
            self.last_square = square();
            if self.residual_gone() {
                return Some(self.last * (self.last_square / before));
            }
        }
        let fall = self.last / self.previous;
        let next = self.last * fall;
        (fall < STEEP && next <= self.options.energy_drop * self.scale()).then_some(next)
    }

    /// Whether the residual has fallen as far as asked.
    fn residual_gone(&self) -> bool {
        let drop = self.options.residual_drop;
        drop > 0.0 && self.last_square.is_finite() && self.last_square <= drop * drop * self.first_square
    }

    /// A step of length `step` was taken and `r . z` went from `rz` to `next`.
    pub(super) fn step(&mut self, step: f64, rz: f64, next: f64) -> Option<PcgStatus> {
        let energy = step * rz;
        if self.iterations == 0 {
            self.first_energy = energy;
        } else {
            self.later_energy += energy;
        }
        self.iterations += 1;
        self.lanczos.step(step, next / rz);
        (self.previous, self.last) = (rz, next);
        self.direction = next + (next / rz).powi(2) * self.direction;
        if !next.is_finite() || !energy.is_finite() {
            return Some(PcgStatus::NotFinite);
        }
        if next.abs() <= self.options.energy_drop * self.scale() || self.residual_gone() {
            return Some(PcgStatus::Converged);
        }
        if next < self.smallest {
            self.smallest = next.max(0.0);
            self.since_smallest = 0;
        } else {
            self.since_smallest += 1;
        }
        // A negative value says that r . z is all rounding: nothing more to gain.
        if next <= 0.0 {
            let floor = next.abs() <= SETTLED * self.scale();
            return Some(if floor { PcgStatus::Converged } else { PcgStatus::Stagnated });
        }
        if self.settled() && self.since_smallest >= SETTLED_WINDOW {
            return Some(PcgStatus::Converged);
        }
        if self.since_smallest >= self.options.stagnation_window {
            return Some(PcgStatus::Stagnated);
        }
        if self.iterations >= self.options.max_iterations {
            return Some(if self.settled() { PcgStatus::Converged } else { PcgStatus::IterationLimit });
        }
        None
    }

    fn settled(&self) -> bool {
        self.smallest <= SETTLED * self.scale()
    }

    /// Energy of the steps so far, not less than the first `r . z`.
    fn scale(&self) -> f64 {
        self.first.max(self.first_energy + self.later_energy)
    }

    fn residual_ratio(&self) -> Option<f64> {
        let ratio =
            if self.first_square == 0.0 { 0.0 } else { (self.last_square / self.first_square).sqrt() };
        (self.options.residual_drop > 0.0).then_some(ratio)
    }

    pub(super) fn report(&self, status: PcgStatus) -> PcgReport {
        let all = self.first_energy + self.later_energy;
        let share = if all > 0.0 { self.later_energy.max(0.0) / all } else { 0.0 };
        PcgReport {
            status,
            iterations: self.iterations,
            energy_ratio: if self.first == 0.0 { 0.0 } else { self.last / self.first },
            residual_ratio: self.residual_ratio(),
            first_correction: share.sqrt(),
            least_eigenvalue: self.lanczos.least_eigenvalue(),
        }
    }
}

#[cfg(test)]
mod tests;
