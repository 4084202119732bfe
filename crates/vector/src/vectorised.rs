//! Closures compiled for the widest vectors that the processor has.

use pulp::{Arch, Simd, WithSimd};

struct Kernel<F>(F);

impl<R, F: FnMut() -> R> WithSimd for Kernel<F> {
    type Output = R;

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, _: S) -> R {
        (self.0)()
    }
}

/// Runs a closure, marked `#[inline(always)]`, with those vectors.
///
/// `Arch::dispatch` takes closures, too, but calls them by value. For a closure that
/// could be called again that goes through a shim without the attribute, and if the
/// shim is not inlined the closure is compiled for the oldest processor.
#[inline(always)]
pub fn vectorised<R>(kernel: impl FnMut() -> R) -> R {
    Arch::new().dispatch(Kernel(kernel))
}
