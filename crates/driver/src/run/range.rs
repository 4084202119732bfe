//! Smallest and largest values with their places.

/// Smallest and largest value so far, each with its place; the first of equal ones stays.
#[derive(Clone, Debug)]
pub(crate) struct Range<P>(Option<[(f64, P); 2]>);

impl<P> Default for Range<P> {
    fn default() -> Self {
        Self(None)
    }
}

impl<P> Range<P> {
    /// Takes a smallest and a largest value.
    pub(crate) fn take(&mut self, [a, b]: [(f64, P); 2]) {
        let Some([low, high]) = &mut self.0 else {
            self.0 = Some([a, b]);
            return;
        };
        if a.0 < low.0 {
            *low = a;
        }
        if b.0 > high.0 {
            *high = b;
        }
    }

    /// Both; `None` before the first.
    pub(crate) fn ends(self) -> Option<[(f64, P); 2]> {
        self.0
    }
}
