//! Weights of the bonds of one point.

use nalgebra::{SMatrix, SVector};

/// A bond of a family: its start weight, 1/m², its length, m, and its direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Member {
    pub(super) weight: f64,
    pub(super) length: f64,
    pub(super) direction: [f64; 2],
}

/// Smallest singular value that counts, per the largest.
const ROUNDING: f64 = 1e-10;

/// Changes weights so that `Σ w h_k = target`, each by the factor `1 + c·g` with one vector c.
///
/// Where no such weights exist the equations are met in the sense of least squares.
pub(super) fn corrected<const Q: usize>(
    begin: &[f64],
    g: &[[f64; Q]],
    h: &[[f64; Q]],
    target: [f64; Q],
) -> Vec<f64> {
    let (mut matrix, mut rest) = (SMatrix::<f64, Q, Q>::zeros(), SVector::<f64, Q>::from(target));
    for ((w, g), h) in begin.iter().zip(g).zip(h) {
        let (g, h) = (SVector::from(*g), SVector::from(*h));
        matrix += *w * h * g.transpose();
        rest -= *w * h;
    }
    // The search for singular values of what is no number would not end.
    if matrix.iter().any(|value| !value.is_finite()) {
        return begin.to_vec();
    }
    let decomposed = nalgebra::DMatrix::from_iterator(Q, Q, matrix.iter().copied()).svd(true, true);
    let least = ROUNDING * decomposed.singular_values.max();
    let rest = nalgebra::DVector::from_iterator(Q, rest.iter().copied());
    let c = decomposed.solve(&rest, least).unwrap_or_else(|_| nalgebra::DVector::zeros(Q));
    begin.iter().zip(g).map(|(w, g)| w * (1.0 + (0..Q).map(|k| c[k] * g[k]).sum::<f64>())).collect()
}

/// Weights r with which a uniform strain has the right energy, `Σ r L² (1, cos 2φ, sin 2φ, cos 4φ, sin 4φ) = (1, 0, 0, 0, 0)`,
/// and whether that succeeded.
///
/// Where some of them would be negative, as at corners, they go only so far from those with `Σ r L² = 1` that none is.
pub(super) fn matched(family: &[Member]) -> (Vec<f64>, bool) {
    let whole: f64 = family.iter().map(|m| m.weight * m.length * m.length).sum();
    let begin: Vec<f64> = family.iter().map(|m| m.weight / whole).collect();
    let waves = |m: &Member| {
        let [x, y] = m.direction;
        let (cos, sin) = (x * x - y * y, 2.0 * x * y);
        [1.0, cos, sin, cos * cos - sin * sin, 2.0 * cos * sin]
    };
    let g: Vec<[f64; 5]> = family.iter().map(waves).collect();
    let h: Vec<[f64; 5]> = g.iter().zip(family).map(|(g, m)| g.map(|g| g * m.length * m.length)).collect();
    let target = [1.0, 0.0, 0.0, 0.0, 0.0];
    let full = corrected(&begin, &g, &h, target);
    let met = (0..5).all(|k| {
        let sum: f64 = full.iter().zip(&h).map(|(w, h)| w * h[k]).sum();
        (sum - target[k]).abs() <= 1e-11
    });
    let share = |(begin, full): (&f64, &f64)| if *full < 0.0 { begin / (begin - full) } else { 1.0 };
    let step = begin.iter().zip(&full).map(share).fold(1.0, f64::min);
    if met && step == 1.0 {
        return (full, true);
    }
    let step = if met { step } else { 0.0 };
    (begin.iter().zip(&full).map(|(b, f)| (b + step * (f - b)).max(0.0)).collect(), false)
}
