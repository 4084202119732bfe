//! The factorisation of a very narrow band, with everything in registers.
//!
//! A narrow band is bound by the chain from one pivot to the next: a division,
//! two multiplications and a subtraction. Here nothing else is on that chain and
//! nothing goes through memory: what the columns so far take from the next ones
//! is a small triangle of sums, and the last column, the only one that the
//! division delays, is kept apart from it.

use super::pivots::Pivots;

/// `B` half bandwidth, `W = B + 1`.
#[inline(always)]
pub(super) fn sweep<const B: usize, const W: usize>(values: &mut [f64]) -> Pivots {
    const { assert!(W == B + 1 && B > 0) }
    let mut pivots = Pivots::default();
    // pending[k][r]: taken from entry r of the column k after the current one.
    let mut pending = [[0.0; W]; W];
    let mut last = [0.0; W];
    let mut last_scaled = [0.0; W];
    for (j, column) in values.as_chunks_mut::<W>().0.iter_mut().enumerate() {
        let mut current = *column;
        for r in 0..B {
            current[r] = (current[r] - pending[0][r]) - last_scaled[1] * last[r + 1];
        }
        for k in 1..B {
            for r in 0..B - k {
                pending[k - 1][r] = pending[k][r] + last_scaled[k + 1] * last[k + 1 + r];
            }
        }
        let mut pivot = current[0];
        if !(pivot > 0.0 && pivot < f64::INFINITY) {
            match pivots.note(j, pivot, &current) {
                Some(usable) => pivot = usable,
                None => return pivots,
            }
        }
        let reciprocal = 1.0 / pivot;
        last = current;
        last_scaled = current.map(|v| v * reciprocal);
        *column = last_scaled;
        column[0] = reciprocal;
    }
    pivots
}
