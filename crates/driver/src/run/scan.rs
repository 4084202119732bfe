//! Sweeps over many values that stay quick because they look closely only where something new is.

/// Values that are looked at together.
const CHUNK: usize = 256;
const LANES: usize = 8;

/// Index of the first of the smallest and of the largest values; `None` if there are none. What is not a number is passed
/// over behind the first value.
pub(crate) fn extremes(values: &[f64]) -> Option<[usize; 2]> {
    let (mut low, mut high) = (0, 0);
    let (mut smallest, mut largest) = (*values.first()?, *values.first()?);
    for (number, chunk) in values.chunks(CHUNK).enumerate() {
        let [least, most] = bounds(chunk);
        let find = |wanted: f64| chunk.iter().position(|v| *v == wanted).map_or(0, |k| number * CHUNK + k);
        if least < smallest {
            (smallest, low) = (least, find(least));
        }
        if most > largest {
            (largest, high) = (most, find(most));
        }
    }
    Some([low, high])
}

/// Smallest and largest value.
fn bounds(values: &[f64]) -> [f64; 2] {
    let (mut least, mut most) = ([f64::INFINITY; LANES], [f64::NEG_INFINITY; LANES]);
    let mut take = |chunk: &[f64]| {
        for ((least, most), v) in least.iter_mut().zip(&mut most).zip(chunk) {
            *least = if *v < *least { *v } else { *least };
            *most = if *v > *most { *v } else { *most };
        }
    };
    let (chunks, rest) = values.as_chunks::<LANES>();
    chunks.iter().for_each(|chunk| take(chunk));
    take(rest);
    [least.into_iter().fold(f64::INFINITY, f64::min), most.into_iter().fold(f64::NEG_INFINITY, f64::max)]
}

/// Largest magnitude, infinite if a value is not a number.
pub(super) fn largest(values: &[f64]) -> f64 {
    let (mut most, mut odd) = ([0.0_f64; LANES], [0.0_f64; LANES]);
    // Comparisons pass over what is not a number; the sum of products with zero does not.
    let mut take = |chunk: &[f64]| {
        for ((most, odd), x) in most.iter_mut().zip(&mut odd).zip(chunk) {
            *most = if x.abs() > *most { x.abs() } else { *most };
            *odd += 0.0 * x;
        }
    };
    let (chunks, rest) = values.as_chunks::<LANES>();
    chunks.iter().for_each(|chunk| take(chunk));
    take(rest);
    if odd.iter().sum::<f64>() == 0.0 { most.into_iter().fold(0.0, f64::max) } else { f64::INFINITY }
}

/// Sum of the squares.
pub(super) fn squares(values: &[f64]) -> f64 {
    let mut sums = [0.0_f64; LANES];
    let mut take = |chunk: &[f64]| sums.iter_mut().zip(chunk).for_each(|(sum, v)| *sum += v * v);
    let (chunks, rest) = values.as_chunks::<LANES>();
    chunks.iter().for_each(|chunk| take(chunk));
    take(rest);
    sums.iter().sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_of_equal_extremes_is_found() {
        let mut values: Vec<f64> = (0..1000).map(|k| f64::from(k % 7)).collect();
        assert_eq!(extremes(&values), Some([0, 6]));
        values[700] = -1.0;
        values[999] = 9.0;
        assert_eq!(extremes(&values), Some([700, 999]));
        assert_eq!(extremes(&[]), None);
    }

    #[test]
    fn a_value_that_is_no_number_is_the_largest() {
        let mut values = vec![1.0; 300];
        values[20] = -3.0;
        assert_eq!(largest(&values), 3.0);
        values[299] = f64::NAN;
        assert_eq!(largest(&values), f64::INFINITY);
    }
}
