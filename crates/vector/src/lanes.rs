//! Numbers side by side in a vector register.

use crate::real::Real;
use pulp::Simd;
use pulp::bytemuck::{self, Pod};

/// A number of which a register holds several.
pub trait Lanes: Real + Pod {
    /// As many as a register of an instruction set holds.
    type Of<S: Simd>: Copy + Pod;

    /// The same number in all lanes.
    fn splat<S: Simd>(simd: S, number: Self) -> Self::Of<S>;

    /// `a + b`
    fn sum<S: Simd>(simd: S, a: Self::Of<S>, b: Self::Of<S>) -> Self::Of<S>;

    /// `a − b`
    fn difference<S: Simd>(simd: S, a: Self::Of<S>, b: Self::Of<S>) -> Self::Of<S>;

    /// `a b`
    fn product<S: Simd>(simd: S, a: Self::Of<S>, b: Self::Of<S>) -> Self::Of<S>;

    /// How many lanes there are.
    #[inline(always)]
    fn count<S: Simd>() -> usize {
        size_of::<Self::Of<S>>() / size_of::<Self>()
    }

    /// Neighbouring entries from a place on.
    #[inline(always)]
    fn load<S: Simd>(_: S, entries: &[Self], at: usize) -> Self::Of<S> {
        bytemuck::pod_read_unaligned(bytemuck::cast_slice(&entries[at..at + Self::count::<S>()]))
    }

    /// The lanes of neighbouring registers.
    #[inline(always)]
    fn lanes<S: Simd>(registers: &[Self::Of<S>]) -> &[Self] {
        bytemuck::cast_slice(registers)
    }
}

macro_rules! lanes {
    ($number:ident, $of:ident, $splat:ident, $add:ident, $sub:ident, $mul:ident) => {
        impl Lanes for $number {
            type Of<S: Simd> = S::$of;

            #[inline(always)]
            fn splat<S: Simd>(simd: S, number: Self) -> S::$of {
                simd.$splat(number)
            }

            #[inline(always)]
            fn sum<S: Simd>(simd: S, a: S::$of, b: S::$of) -> S::$of {
                simd.$add(a, b)
            }

            #[inline(always)]
            fn difference<S: Simd>(simd: S, a: S::$of, b: S::$of) -> S::$of {
                simd.$sub(a, b)
            }

            #[inline(always)]
            fn product<S: Simd>(simd: S, a: S::$of, b: S::$of) -> S::$of {
                simd.$mul(a, b)
            }
        }
    };
}

lanes!(f64, f64s, splat_f64s, add_f64s, sub_f64s, mul_f64s);
lanes!(f32, f32s, splat_f32s, add_f32s, sub_f32s, mul_f32s);
