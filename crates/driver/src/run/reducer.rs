//! What is made of many values: extremes with their places, means and integrals.

use crate::case::Reduction;
use peristat_assembly::sum::Sum;

/// Values as they come.
pub(super) struct Reducer<P> {
    of: Reduction,
    /// The extreme so far: what it is compared by, its value and its place.
    best: Option<(f64, f64, P)>,
    /// Values times their measures.
    sum: Sum,
    /// Measures.
    extent: Sum,
}

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reduced<P> {
    /// The value; not a number if one of the values is none.
    pub(super) value: f64,
    /// Where an extreme is.
    pub(super) place: Option<P>,
    /// What a mean or an integral is taken over.
    pub(super) extent: Option<f64>,
}

impl<P: Copy> Reducer<P> {
    pub(super) fn new(of: Reduction) -> Self {
        Self { of, best: None, sum: Sum::default(), extent: Sum::default() }
    }

    /// Takes a value at a place; `measure` is the volume or length that it stands for.
    pub(super) fn take(&mut self, value: f64, place: P, measure: impl FnOnce(P) -> f64) {
        let size = match self.of {
            Reduction::Largest => value,
            Reduction::Smallest => -value,
            Reduction::LargestMagnitude => value.abs(),
            Reduction::Mean | Reduction::Integral => {
                let measure = measure(place);
                self.sum.add(measure * value);
                return self.extent.add(measure);
            }
        };
        // What is not a number is the worst of all and stays.
        let is_worse = |most: f64| size > most || (size.is_nan() && !most.is_nan());
        if self.best.is_none_or(|(most, ..)| is_worse(most)) {
            self.best = Some((size, value, place));
        }
    }

    /// What was made of the values; `None` if there were none.
    pub(super) fn found(self) -> Option<Reduced<P>> {
        if self.of.is_extreme() {
            let (_, value, place) = self.best?;
            let value = if self.of == Reduction::LargestMagnitude { value.abs() } else { value };
            return Some(Reduced { value, place: Some(place), extent: None });
        }
        let (sum, extent) = (self.sum.total(), self.extent.total());
        let value = if self.of == Reduction::Mean { sum / extent } else { sum };
        (extent > 0.0).then_some(Reduced { value, place: None, extent: Some(extent) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(of: Reduction, values: &[f64]) -> Option<Reduced<usize>> {
        let mut reducer = Reducer::new(of);
        values.iter().enumerate().for_each(|(k, v)| reducer.take(*v, k, |k| k as f64 + 1.0));
        reducer.found()
    }

    #[test]
    fn extremes_have_places_and_integrals_extents() {
        use Reduction::{Integral, Largest, LargestMagnitude, Mean, Smallest};
        let values = [2.0, -5.0, 3.0, 3.0];
        let of = |of| found(of, &values).map(|r| (r.value, r.place, r.extent)).unwrap();
        assert_eq!(of(Largest), (3.0, Some(2), None));
        assert_eq!(of(Smallest), (-5.0, Some(1), None));
        assert_eq!(of(LargestMagnitude), (5.0, Some(1), None));
        // 1 · 2 − 2 · 5 + 3 · 3 + 4 · 3 over 1 + 2 + 3 + 4.
        assert_eq!(of(Integral), (13.0, None, Some(10.0)));
        assert_eq!(of(Mean), (1.3, None, Some(10.0)));
        for of in [Largest, Smallest, LargestMagnitude, Mean, Integral] {
            assert_eq!(found(of, &[]), None);
            assert!(found(of, &[1.0, f64::NAN, 2.0]).unwrap().value.is_nan());
        }
    }
}
