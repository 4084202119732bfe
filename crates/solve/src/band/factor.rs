//! The factorisation, by the kernel that suits the width.

use super::pivots::Pivots;
use super::{general, window};
use pulp::Arch;

/// Factors the band in place; `values` has whole columns of `half_bandwidth + 1`.
pub(super) fn factor(values: &mut [f64], half_bandwidth: usize) -> Pivots {
    // Of wider triangles of sums so little stays in registers that the general
    // kernel is faster.
    macro_rules! narrow {
        ($($b:literal)*) => {
            match half_bandwidth {
                $($b => Arch::new().dispatch(
                    #[inline(always)]
                    || window::sweep::<$b, { $b + 1 }>(values),
                ),)*
                _ => general::factor(values, half_bandwidth),
            }
        };
    }
    narrow!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15)
}
