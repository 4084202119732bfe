//! Sums that keep their digits.

use serde::{Deserialize, Serialize};
use std::ops::Neg;

/// Compensated sum (Knuth): what rounding takes from it is kept beside it, so that the rounding of a million terms is far
/// below that of their sum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    /// A sum of one term.
    #[inline(always)]
    pub fn of(x: f64) -> Self {
        Self { high: x, low: 0.0 }
    }

    /// A sum of a double and what rounding took from it, as [`Sum::unrounded`] gives them.
    #[inline(always)]
    pub(crate) fn of_parts(high: f64, low: f64) -> Self {
        Self { high, low }
    }

    /// Both parts as they are.
    #[inline(always)]
    pub(crate) fn unrounded(self) -> [f64; 2] {
        [self.high, self.low]
    }

    /// Adds a term.
    #[inline(always)]
    pub fn add(&mut self, x: f64) {
        let sum = self.high + x;
        let taken = sum - self.high;
        self.low += (self.high - (sum - taken)) + (x - taken);
        self.high = sum;
    }

    /// Adds a product, exactly.
    #[inline(always)]
    pub fn add_product(&mut self, a: f64, b: f64) {
        let product = a * b;
        self.add(product);
        self.low += a.mul_add(b, -product);
    }

    /// Adds a multiple of another sum.
    #[inline(always)]
    pub fn add_multiple(&mut self, factor: f64, other: Self) {
        self.add_product(factor, other.high);
        self.low += factor * other.low;
    }

    /// The sum as a double and what rounding takes from it.
    #[inline(always)]
    pub fn parts(self) -> [f64; 2] {
        let high = self.high + self.low;
        [high, self.low - (high - self.high)]
    }

    /// Adds another sum.
    #[inline(always)]
    pub fn join(&mut self, other: Self) {
        self.add(other.high);
        self.add(other.low);
    }

    /// The sum and a small term more, rounded once.
    #[inline(always)]
    pub fn with(self, x: f64) -> f64 {
        self.high + (self.low + x)
    }

    /// The sum so far, rounded.
    #[inline(always)]
    pub fn total(self) -> f64 {
        self.high + self.low
    }
}

impl Neg for Sum {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_terms_are_not_lost_beside_large_ones() {
        let mut sum = Sum::of(1e16);
        (0..1000).for_each(|_| sum.add(1.0));
        sum.add(-1e16);
        assert_eq!(sum.total(), 1000.0);
        let mut twice = sum;
        twice.join(-sum);
        assert_eq!(twice.total(), 0.0);
    }
}
