//! Updates of vectors, long ones dealt out to threads.
//!
//! Entries do not depend on each other here, so that neither the segments nor the number of threads changes a bit.

use crate::real::Real;
use crate::vectorised::vectorised;
use rayon::prelude::*;

/// Entries that a thread takes at a time: a quarter of a megabyte of each vector.
pub(crate) const SEGMENT: usize = 1 << 15;

/// Whether vectors of this length are worth more than one thread.
pub(crate) fn worth_threads(length: usize) -> bool {
    length > 2 * SEGMENT && rayon::current_num_threads() > 1
}

/// Calls `f` with the segments of `y` and `x`, side by side where that is worth it.
fn segments<R: Real>(y: &mut [R], x: &[R], f: impl Fn(&mut [R], &[R]) + Sync) {
    debug_assert_eq!(y.len(), x.len());
    if worth_threads(y.len()) {
        y.par_chunks_mut(SEGMENT).zip(x.par_chunks(SEGMENT)).for_each(|(y, x)| f(y, x));
    } else {
        f(y, x);
    }
}

/// `y += a x`
pub fn add<R: Real>(y: &mut [R], a: f64, x: &[R]) {
    let a = R::of(a);
    segments(y, x, |y, x| {
        vectorised(
            #[inline(always)]
            || {
                for (y, x) in y.iter_mut().zip(x) {
                    *y += a * *x;
                }
            },
        );
    });
}

/// `y -= a x`
pub fn subtract<R: Real>(y: &mut [R], a: f64, x: &[R]) {
    add(y, -a, x);
}

/// `y = x - y`
pub fn subtract_from<R: Real>(x: &[R], y: &mut [R]) {
    segments(y, x, |y, x| {
        vectorised(
            #[inline(always)]
            || {
                for (y, x) in y.iter_mut().zip(x) {
                    *y = *x - *y;
                }
            },
        );
    });
}

/// `y = x + keep (x - y)`
pub fn extrapolate<R: Real>(y: &mut [R], keep: f64, x: &[R]) {
    let keep = R::of(keep);
    segments(y, x, |y, x| {
        vectorised(
            #[inline(always)]
            || {
                for (y, x) in y.iter_mut().zip(x) {
                    *y = *x + keep * (*x - *y);
                }
            },
        );
    });
}

/// `x += step p` and `p = z + beta p`, in one pass over `p`.
pub fn advance(x: &mut [f64], step: f64, p: &mut [f64], beta: f64, z: &[f64]) {
    let pass = |x: &mut [f64], p: &mut [f64], z: &[f64]| {
        vectorised(
            #[inline(always)]
            || {
                for ((x, p), z) in x.iter_mut().zip(p.iter_mut()).zip(z) {
                    *x += step * *p;
                    *p = z + beta * *p;
                }
            },
        );
    };
    if worth_threads(x.len()) {
        let (x, p) = (x.par_chunks_mut(SEGMENT), p.par_chunks_mut(SEGMENT));
        x.zip(p).zip(z.par_chunks(SEGMENT)).for_each(|((x, p), z)| pass(x, p, z));
    } else {
        pass(x, p, z);
    }
}
