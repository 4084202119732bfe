//! Factorisation and sweeps for a band of any width.

use super::pivots::Pivots;

/// Earlier columns subtracted per pass over the current one.
const GROUP: usize = 4;

/// Factors the band in place, column by column from the columns before.
pub(super) fn factor(values: &mut [f64], half_bandwidth: usize) -> Pivots {
    let width = half_bandwidth + 1;
    let mut pivots = Pivots::default();
    // Pivots of the last columns; what is stored is their reciprocals.
    let mut recent = vec![0.0; width];
    for j in 0..values.len() / width {
        let (done, rest) = values.split_at_mut(j * width);
        let current = &mut rest[..width];
        pulp::Arch::new().dispatch(
            #[inline(always)]
            || update(current, done, &recent, j),
        );
        let mut pivot = current[0];
        if !(pivot > 0.0 && pivot < f64::INFINITY) {
            match pivots.note(j, pivot, current) {
                Some(usable) => pivot = usable,
                None => return pivots,
            }
        }
        recent[j % width] = pivot;
        let reciprocal = 1.0 / pivot;
        for value in current.iter_mut() {
            *value *= reciprocal;
        }
        current[0] = reciprocal;
    }
    pivots
}

/// `current -= sum of d_i l_i[j - i] l_i` over the columns before, oldest first.
#[inline(always)]
fn update(current: &mut [f64], done: &[f64], recent: &[f64], j: usize) {
    let width = current.len();
    let mut age = (width - 1).min(j);
    let column = |age: usize| {
        let from = (j - age) * width;
        let part = &done[from + age..from + width];
        (part[0] * recent[(j - age) % width], part)
    };
    while age >= GROUP {
        let (f0, c0) = column(age);
        let (f1, c1) = column(age - 1);
        let (f2, c2) = column(age - 2);
        let (f3, c3) = column(age - 3);
        // All four reach as far as the oldest; the others go a little further.
        let shared = c0.len();
        let targets = current[..shared].iter_mut();
        let parts = c0.iter().zip(&c1[..shared]).zip(&c2[..shared]).zip(&c3[..shared]);
        for (target, (((v0, v1), v2), v3)) in targets.zip(parts) {
            *target = (((*target - f0 * v0) - f1 * v1) - f2 * v2) - f3 * v3;
        }
        for (factor, part) in [(f1, c1), (f2, c2), (f3, c3)] {
            for (target, value) in current[shared..].iter_mut().zip(&part[shared..]) {
                *target -= factor * value;
            }
        }
        age -= GROUP;
    }
    while age > 0 {
        let (factor, part) = column(age);
        for (target, value) in current.iter_mut().zip(part) {
            *target -= factor * value;
        }
        age -= 1;
    }
}

/// Solves `L D L^T x = y` in place; columns of `width`, the reciprocal pivot first.
pub(super) fn solve(values: &[f64], width: usize, y: &mut [f64]) {
    let order = y.len();
    pulp::Arch::new().dispatch(
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
        let taken = crate::sums::dot(&column[1..end - j], &y[j + 1..end]);
        y[j] = y[j] * column[0] - taken;
    }
}
