//! The sweeps over a band of any width.

use peristat_vector::vectorised;

/// Solves `L D L^T x = y` in place; columns of `width`, the reciprocal pivot first.
pub(super) fn solve(values: &[f64], width: usize, y: &mut [f64]) {
    let order = y.len();
    vectorised(
        #[inline(always)]
        || {
            for (j, column) in values.chunks_exact(width).enumerate() {
                let Some((value, below)) = y[j..].split_first_mut() else {
                    return;
                };
                for (target, entry) in below.iter_mut().zip(&column[1..]) {
                    *target -= entry * *value;
                }
            }
        },
    );
    for (j, column) in values.chunks_exact(width).enumerate().rev() {
        let end = (j + width).min(order);
        let taken = peristat_vector::dot(&column[1..end - j], &y[j + 1..end]);
        y[j] = y[j] * column[0] - taken;
    }
}
