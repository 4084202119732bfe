//! Beam clamped at x = 0 and simply supported at x = L under a uniform load q.
//!
//! The cantilever under q plus the cantilever under the support's force R at the tip, with O = B / (S L²) and
//! R = -(3 q L / 8) (1 + 4 O) / (1 + 3 O). The two nearly cancel near the support, so they are summed by
//! hand: with d = 1 + 3 O
//!
//! ```text
//! w = q x (L - x) [ 3 O (5 + 12 O) L² / d + x (3 (1 + 2 O) L / 2d - x) ] / 24B
//! phi = q x [ (L - x)² - L (2L - x) (1 + 12 O) / 8d ] / 6B
//! M = q (L - x) (L / 4d - x) / 2      V = q (L (5 + 12 O) / 8d - x)
//! ```

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "clamped_simply_supported_uniform",
    about: "beam clamped at x = 0 and simply supported at x = L, uniform load",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Clamped, End::Simple)?;
    let (l, b, s) = facts.symbols();
    let propped = Propped::new(facts.only_uniform()?, l, b, s);
    Ok(Solution::local(propped.energy(), move |x| propped.at(x)))
}

/// This beam, ready for evaluation; half of a beam over two spans is one too.
#[derive(Clone, Copy)]
pub(super) struct Propped {
    q: f64,
    l: f64,
    b: f64,
    /// O = B / (S L²).
    softness: f64,
}

impl Propped {
    pub(super) fn new(q: f64, l: f64, b: f64, s: f64) -> Self {
        Self { q, l, b, softness: b / (s * l * l) }
    }

    /// Coefficients of L² and of L x in the bracket of w.
    fn bracket(&self) -> (f64, f64) {
        let (o, d) = (self.softness, 1.0 + 3.0 * self.softness);
        (3.0 * o * (5.0 + 12.0 * o) / d, 1.5 * (1.0 + 2.0 * o) / d)
    }

    /// State at x from the clamped end.
    pub(super) fn at(&self, x: f64) -> State {
        let Self { q, l, b, softness: o } = *self;
        let d = 1.0 + 3.0 * o;
        let (constant, linear) = self.bracket();
        let rest = l - x;
        State {
            w: q * x * rest * (constant * l * l + x * (linear * l - x)) / (24.0 * b),
            phi: q * x * (rest * rest - l * (2.0 * l - x) * (1.0 + 12.0 * o) / (8.0 * d)) / (6.0 * b),
            moment: q * rest * (l / (4.0 * d) - x) / 2.0,
            shear: q * (l * (5.0 + 12.0 * o) / (8.0 * d) - x),
        }
    }

    /// Half the integral of q w.
    pub(super) fn energy(&self) -> f64 {
        let (constant, linear) = self.bracket();
        self.q * self.q * self.l.powi(5) * (constant / 6.0 + linear / 12.0 - 0.05) / (48.0 * self.b)
    }
}
