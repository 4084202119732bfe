//! The factorisation, by the kernel that suits the width.

use super::pivots::Pivots;
use super::{blocked, window};
use peristat_vector::vectorised;

/// Factors the band in place; `values` has whole columns of `half_bandwidth + 1`.
pub(super) fn factor(values: &mut [f64], half_bandwidth: usize) -> Pivots {
    // Of wider triangles of sums so little stays in registers that the general
    // kernel is faster.
    macro_rules! narrow {
        ($($b:literal)*) => {
            match half_bandwidth {
                $($b => vectorised(
                    #[inline(always)]
                    || window::sweep::<$b, { $b + 1 }>(values),
                ),)*
                _ => blocked::factor(values, half_bandwidth),
            }
        };
    }
    narrow!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15)
}
