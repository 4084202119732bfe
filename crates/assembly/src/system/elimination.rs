//! Homogeneous equations among many unknowns, eliminated one by one.
//!
//! Rows stay in triangular form: a pivot is expressed by unknowns that had no row when it got its own, and rows are not
//! substituted into each other. So equations that only neighbours share stay short, however many there are.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Sums below this part of what went into them are rounding.
const ROUNDING: f64 = 1e-12;

/// Equations `Σ c u = 0` in triangular form.
pub(super) struct Elimination {
    /// Pivot and its expression by other unknowns.
    rows: Vec<(usize, Vec<(usize, f64)>)>,
    /// Per unknown: number of its row plus one, zero if it has none.
    row_of: Vec<usize>,
    /// Room for an equation under reduction: sum and size of every unknown's coefficient.
    sums: Vec<[f64; 2]>,
}

impl Elimination {
    /// No equations yet.
    pub(super) fn new(unknowns: usize) -> Self {
        Self { rows: Vec::new(), row_of: vec![0; unknowns], sums: vec![[0.0; 2]; unknowns] }
    }

    /// Takes an equation; one that follows from the others changes nothing. Its first unknown becomes the pivot where it
    /// has no row yet, else the one with the largest coefficient.
    pub(super) fn add(&mut self, terms: &[(usize, f64)]) {
        let Self { rows, row_of, sums } = self;
        let (mut touched, mut due) = (Vec::new(), BinaryHeap::new());
        let mut put =
            |unknown: usize, c: f64, sums: &mut [[f64; 2]], due: &mut BinaryHeap<Reverse<usize>>| {
                if c == 0.0 {
                    return;
                }
                let sum = &mut sums[unknown];
                if sum[1] == 0.0 {
                    touched.push(unknown);
                    if row_of[unknown] > 0 {
                        due.push(Reverse(row_of[unknown] - 1));
                    }
                }
                *sum = [sum[0] + c, sum[1] + c.abs()];
            };
        terms.iter().for_each(|&(unknown, c)| put(unknown, c, sums, &mut due));
        // A row brings in only pivots of later rows, so in this order every one is due once.
        while let Some(Reverse(row)) = due.pop() {
            let (pivot, expression) = &rows[row];
            let [sum, size] = sums[*pivot];
            if !is_rounding(sum, size) {
                expression.iter().for_each(|&(unknown, c)| put(unknown, sum * c, sums, &mut due));
            }
        }
        let mut left: Vec<(usize, f64)> = Vec::new();
        for unknown in touched {
            let [sum, size] = std::mem::take(&mut sums[unknown]);
            if row_of[unknown] == 0 && !is_rounding(sum, size) {
                left.push((unknown, sum));
            }
        }
        let declared = terms.first().and_then(|t| left.iter().find(|l| l.0 == t.0));
        let pivot = declared.or(left.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())));
        if let Some(&(pivot, coefficient)) = pivot {
            left.retain(|l| l.0 != pivot);
            left.iter_mut().for_each(|l| l.1 /= -coefficient);
            rows.push((pivot, left));
            row_of[pivot] = rows.len();
        }
    }

    /// Unknowns that no equation determines, in order.
    pub(super) fn free(&self) -> Vec<usize> {
        (0..self.row_of.len()).filter(|&unknown| self.row_of[unknown] == 0).collect()
    }

    /// The solution in which one free unknown is one and all others are zero.
    pub(super) fn solution(&self, free: usize) -> Vec<f64> {
        let mut values = vec![0.0; self.row_of.len()];
        values[free] = 1.0;
        for (pivot, expression) in self.rows.iter().rev() {
            let (sum, size) = expression.iter().fold((0.0, 0.0), |(sum, size), &(unknown, c)| {
                let part = c * values[unknown];
                (sum + part, size + f64::abs(part))
            });
            values[*pivot] = if is_rounding(sum, size) { 0.0 } else { sum };
        }
        values
    }
}

/// Whether a sum is what rounding left of terms of some size.
fn is_rounding(sum: f64, size: f64) -> bool {
    sum.abs() <= ROUNDING * size
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_equations_leave_free_is_found_and_solves_them() {
        // a = b, b = 2 c, a = 2 c (follows), d + e = 0.
        let equations: [&[(usize, f64)]; 4] =
            [&[(0, 1.0), (1, -1.0)], &[(1, 1.0), (2, -2.0)], &[(0, 1.0), (2, -2.0)], &[(3, 1.0), (4, 1.0)]];
        let mut elimination = Elimination::new(5);
        equations.iter().for_each(|e| elimination.add(e));
        assert_eq!(elimination.free(), [2, 4]);
        assert_eq!(elimination.solution(2), [2.0, 2.0, 1.0, 0.0, 0.0]);
        assert_eq!(elimination.solution(4), [0.0, 0.0, 0.0, -1.0, 1.0]);
    }

    #[test]
    fn a_long_chain_of_neighbours_stays_short() {
        let count = 20_000;
        let mut elimination = Elimination::new(count);
        (1..count).for_each(|k| elimination.add(&[(k - 1, 1.0), (k, -1.0)]));
        assert_eq!(elimination.free(), [count - 1]);
        assert!(elimination.rows.iter().all(|r| r.1.len() == 1));
        assert!(elimination.solution(count - 1).iter().all(|v| *v == 1.0));
    }
}
