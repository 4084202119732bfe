//! Scalar products whose rounding error does not grow with the length.
//!
//! A plain loop over a million terms loses three digits in the worst case. Here
//! blocks of [`BLOCK`] terms are summed in eight interleaved lanes and the block
//! sums are added pairwise, so that the error grows with the logarithm of the
//! length. The order is fixed: the same input gives the same bits everywhere, on any number of threads, because
//! threads take whole branches of the same tree.

use crate::loops::{SEGMENT, worth_threads};
use crate::vectorised::vectorised;

/// Terms per block; long enough to hide the recursion, short enough for the bound.
const BLOCK: usize = 256;
const LANES: usize = 8;

/// `x . y` for two vectors of one length.
///
/// # Panics
/// They differ in length.
pub fn dot(x: &[f64], y: &[f64]) -> f64 {
    assert_eq!(x.len(), y.len(), "vectors of one length");
    if worth_threads(x.len()) { branches(x, y) } else { serial(x, y) }
}

/// The branches of the tree down to the length of a segment, side by side.
fn branches(x: &[f64], y: &[f64]) -> f64 {
    if x.len() <= SEGMENT {
        return serial(x, y);
    }
    let cut = middle(0, x.len());
    let (left, right) = rayon::join(|| branches(&x[..cut], &y[..cut]), || branches(&x[cut..], &y[cut..]));
    left + right
}

fn serial(x: &[f64], y: &[f64]) -> f64 {
    vectorised(
        #[inline(always)]
        || pairwise(x.len(), &|from, to| block(&x[from..to], &y[from..to])),
    )
}

/// Where to cut a range of more than one block: in the middle, at a block border.
fn middle(from: usize, to: usize) -> usize {
    from + ((to - from) / BLOCK).div_ceil(2) * BLOCK
}

fn pairwise(length: usize, sum: &impl Fn(usize, usize) -> f64) -> f64 {
    fn range(from: usize, to: usize, sum: &impl Fn(usize, usize) -> f64) -> f64 {
        if to - from <= BLOCK {
            return sum(from, to);
        }
        let cut = middle(from, to);
        range(from, cut, sum) + range(cut, to, sum)
    }
    range(0, length, sum)
}

/// One block in eight lanes; the terms past the last full group are added last.
#[inline(always)]
fn block(x: &[f64], y: &[f64]) -> f64 {
    let mut lanes = [0.0; LANES];
    let (x, x_rest) = x.as_chunks::<LANES>();
    let (y, y_rest) = y.as_chunks::<LANES>();
    for (x, y) in x.iter().zip(y) {
        for lane in 0..LANES {
            lanes[lane] += x[lane] * y[lane];
        }
    }
    let four = [lanes[0] + lanes[4], lanes[1] + lanes[5], lanes[2] + lanes[6], lanes[3] + lanes[7]];
    let mut sum = (four[0] + four[2]) + (four[1] + four[3]);
    for (x, y) in x_rest.iter().zip(y_rest) {
        sum += x * y;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_length_sums_every_term() {
        for length in [0, 1, 7, 8, 9, 255, 256, 257, 512, 513, 5000] {
            let x: Vec<f64> = (0..length).map(|i| i as f64).collect();
            let ones = vec![1.0; length];
            let expected = (length * length.saturating_sub(1) / 2) as f64; // Gauss
            assert_eq!(dot(&x, &ones), expected);
        }
    }

    #[test]
    fn threads_take_branches_of_the_same_tree() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
        for length in [2 * SEGMENT + 1, 100_000, 1_000_000, 1_234_567] {
            let x: Vec<f64> = (0..length).map(|i| (i as f64).sin()).collect();
            let y: Vec<f64> = (0..length).map(|i| (i as f64 * 0.7).cos()).collect();
            assert_eq!(pool.install(|| dot(&x, &y)).to_bits(), serial(&x, &y).to_bits());
        }
    }

    #[test]
    fn a_million_terms_keep_fourteen_digits() {
        // 0.1 is not a binary fraction: the plain loop is off by 1.3e-11 here.
        let x = vec![0.1; 1_000_000];
        let ones = vec![1.0; 1_000_000];
        assert!((dot(&x, &ones) / 1.0e5 - 1.0).abs() < 2.0e-15);
    }
}
