//! A quantity that varies along a member.

use serde::{Deserialize, Serialize};

/// Value along a member, by the distance s from its start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Profile {
    /// The same everywhere.
    Uniform(f64),
    /// `c₀ + c₁ s + c₂ s² + …`.
    Polynomial(Vec<f64>),
    /// Straight between pairs `[s, value]` with growing s; constant before the first and after the last. Two pairs with
    /// the same s are a jump.
    Table(Vec<[f64; 2]>),
}

impl Profile {
    /// Value at a distance from the start; on a jump the one after it.
    pub fn value(&self, s: f64) -> f64 {
        match self {
            Self::Uniform(value) => *value,
            Self::Polynomial(coefficients) => coefficients.iter().rev().fold(0.0, |sum, c| sum * s + c),
            Self::Table(pairs) => on_piece(pairs, s, s),
        }
    }

    /// Value at a distance from the start; on a jump the one on the side of `towards`.
    pub fn beside(&self, s: f64, towards: f64) -> f64 {
        match self {
            // What is nearer to a jump is on it, up to rounding.
            Self::Table(pairs) => on_piece(pairs, s + 1e-9 * (towards - s), s),
            smooth => smooth.value(s),
        }
    }

    /// The value, where it is the same everywhere.
    pub fn uniform(&self) -> Option<f64> {
        match self {
            Self::Uniform(value) => Some(*value),
            Self::Polynomial(coefficients) => match coefficients.as_slice() {
                [] => Some(0.0),
                [first, rest @ ..] => rest.iter().all(|c| *c == 0.0).then_some(*first),
            },
            Self::Table(pairs) => {
                let first = pairs.first().map_or(0.0, |p| p[1]);
                pairs.iter().all(|p| p[1] == first).then_some(first)
            }
        }
    }

    /// Integral from `a` to `b` >= a.
    pub fn integral(&self, a: f64, b: f64) -> f64 {
        match self {
            Self::Uniform(value) => value * (b - a),
            Self::Polynomial(coefficients) => {
                let power = |x: f64| {
                    let terms = coefficients.iter().enumerate().rev();
                    terms.fold(0.0, |sum, (k, c)| sum * x + c / (k + 1) as f64) * x
                };
                power(b) - power(a)
            }
            Self::Table(pairs) => {
                let inside = pairs.iter().map(|p| p[0]).filter(|s| *s > a && *s < b);
                let ends: Vec<f64> = std::iter::once(a).chain(inside).chain([b]).collect();
                // Straight in between: the value in the middle is the mean, and jumps are at ends.
                ends.windows(2).map(|w| self.value(0.5 * (w[0] + w[1])) * (w[1] - w[0])).sum()
            }
        }
    }

    /// Where its slope or its value jumps.
    pub fn breaks(&self) -> &[[f64; 2]] {
        match self {
            Self::Table(pairs) => pairs,
            _ => &[],
        }
    }
}

/// Value at `s` of the piece of a table that `inside` is on.
fn on_piece(pairs: &[[f64; 2]], inside: f64, s: f64) -> f64 {
    let next = pairs.partition_point(|p| p[0] <= inside);
    match (next.checked_sub(1).map(|k| pairs[k]), pairs.get(next)) {
        // A mean, not a slope: near either pair nothing cancels.
        (Some(a), Some(b)) => (a[1] * (b[0] - s) + b[1] * (s - a[0])) / (b[0] - a[0]),
        (Some(a), None) => a[1],
        (None, Some(b)) => b[1],
        (None, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_starts_with_its_constant() {
        let p = Profile::Polynomial(vec![1.0, 4.5, 6.75, 3.375]);
        // (1 + 1.5 s)³ at s = 2.
        assert_eq!(p.value(2.0), 64.0);
        assert_eq!(p.uniform(), None);
        assert_eq!(Profile::Polynomial(vec![3.0, 0.0]).uniform(), Some(3.0));
    }

    #[test]
    fn integrals_see_every_jump() {
        let t = Profile::Table(vec![[1.0, 2.0], [2.0, 4.0], [2.0, 10.0], [4.0, 0.0]]);
        // 2 before, (2 + 4)/2 from 1 to 2, 10·2/2 from 2 to 4, nothing after.
        assert_eq!(t.integral(0.0, 9.0), 2.0 + 3.0 + 10.0);
        let p = Profile::Polynomial(vec![1.0, 2.0, 3.0]);
        assert_eq!((p.integral(1.0, 2.0), Profile::Uniform(3.0).integral(1.0, 2.0)), (11.0, 3.0));
    }

    #[test]
    fn a_table_is_straight_between_its_pairs_and_constant_beyond() {
        let t = Profile::Table(vec![[1.0, 2.0], [2.0, 4.0], [2.0, 10.0], [4.0, 0.0]]);
        let values = [0.0, 1.0, 1.5, 2.0, 3.0, 4.0, 9.0].map(|s| t.value(s));
        assert_eq!(values, [2.0, 2.0, 3.0, 10.0, 5.0, 0.0, 0.0]);
    }

    #[test]
    fn integrals_are_areas() {
        assert_eq!(Profile::Uniform(3.0).integral(1.0, 3.5), 7.5);
        // s³ − s² from 1 to 2, and a trapezium, a jump and a rectangle.
        assert_eq!(Profile::Polynomial(vec![0.0, -2.0, 3.0]).integral(1.0, 2.0), 4.0);
        let table = Profile::Table(vec![[0.0, 1.0], [2.0, 3.0], [2.0, 5.0]]);
        assert_eq!(table.integral(1.0, 4.0), 2.5 + 10.0);
    }
}
