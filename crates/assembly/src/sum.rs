//! Sums that keep their digits.

/// Compensated sum (Neumaier): the imbalance of a million terms is far below their rounding otherwise.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    /// Adds a term.
    pub fn add(&mut self, x: f64) {
        let sum = self.high + x;
        self.low += if self.high.abs() >= x.abs() { (self.high - sum) + x } else { (x - sum) + self.high };
        self.high = sum;
    }

    /// The sum so far.
    pub fn total(self) -> f64 {
        self.high + self.low
    }
}
