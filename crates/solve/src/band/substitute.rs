//! The two triangular sweeps.
//!
//! Both are a recurrence over the last `B` results, which stay in registers. The
//! oldest terms are subtracted first: the chain from one result to the next is
//! then a single multiplication and subtraction. The vectors are read from and
//! written to component planes on the way, and the result of the forward sweep
//! rests in the output vector, so that no scratch vector is needed. Only wide bands
//! go through one.

use super::general;

/// Largest half bandwidth whose window of results is held in registers.
const NARROW: usize = 21;

/// Whether the sweeps over a band of this width work on interleaved scratch.
pub(super) fn needs_scratch(half_bandwidth: usize) -> bool {
    half_bandwidth > NARROW
}

/// Solves `L D L^T z = r`; `values` holds the factor as columns of
/// `half_bandwidth + 1`. `scratch` has one entry per unknown if [`needs_scratch`].
pub(super) fn solve(
    values: &[f64],
    half_bandwidth: usize,
    planes: usize,
    scratch: &mut [f64],
    r: &[f64],
    z: &mut [f64],
) {
    macro_rules! narrow {
        ($($b:literal)*) => {
            match half_bandwidth {
                $($b => narrow_solve::<$b, { $b + 1 }>(values, planes, r, z),)*
                _ => {
                    let points = r.len() / planes;
                    let entry = |k: usize| (k % planes) * points + k / planes;
                    for (k, value) in scratch.iter_mut().enumerate() {
                        *value = r[entry(k)];
                    }
                    general::solve(values, half_bandwidth + 1, scratch);
                    for (k, value) in scratch.iter().enumerate() {
                        z[entry(k)] = *value;
                    }
                },
            }
        };
    }
    narrow!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21)
}

fn narrow_solve<const B: usize, const W: usize>(values: &[f64], planes: usize, r: &[f64], z: &mut [f64]) {
    let columns = values.as_chunks::<W>().0;
    // Constant strides for the common cases.
    match planes {
        1 => {
            forward::<B, W>(columns, 1, r, z);
            backward::<B, W>(columns, 1, z);
        }
        2 => {
            forward::<B, W>(columns, 2, r, z);
            backward::<B, W>(columns, 2, z);
        }
        _ => {
            forward::<B, W>(columns, planes, r, z);
            backward::<B, W>(columns, planes, z);
        }
    }
}

/// `L y = r`; `y` is left in `z`.
#[inline(always)]
fn forward<const B: usize, const W: usize>(columns: &[[f64; W]], planes: usize, r: &[f64], z: &mut [f64]) {
    let points = columns.len() / planes;
    // What all columns but the last have already taken from the next unknowns;
    // the last one is kept apart so that its term is the only one in the chain.
    let mut pending = [0.0; B];
    let mut last = &[0.0; W];
    let mut last_value = 0.0;
    for (point, group) in columns.chunks_exact(planes).enumerate() {
        for (plane, column) in group.iter().enumerate() {
            let entry = plane * points + point;
            let mut value = r[entry];
            if B > 0 {
                value = (value - pending[0]) - last[1] * last_value;
            }
            for k in 2..=B {
                pending[k - 2] = pending[k - 1] + last[k] * last_value;
            }
            z[entry] = value;
            last = column;
            last_value = value;
        }
    }
}

/// `L^T x = D^-1 y` in place.
#[inline(always)]
fn backward<const B: usize, const W: usize>(columns: &[[f64; W]], planes: usize, z: &mut [f64]) {
    let points = columns.len() / planes;
    // The results after the current unknown, nearest first.
    let mut after = [0.0; B];
    for (point, group) in columns.chunks_exact(planes).enumerate().rev() {
        for (plane, column) in group.iter().enumerate().rev() {
            let entry = plane * points + point;
            let mut value = z[entry] * column[0];
            for k in (1..=B).rev() {
                value -= column[k] * after[k - 1];
            }
            for k in (1..B).rev() {
                after[k] = after[k - 1];
            }
            if B > 0 {
                after[0] = value;
            }
            z[entry] = value;
        }
    }
}
