//! Weights with which a family measures every uniform strain exactly.

use crate::body::Cell;
use nalgebra::{SMatrix, SVector};

/// Singular values below this part of the largest one count as zero.
const RANK: f64 = 1e-10;

/// `(1, cos 2φ, sin 2φ, cos 4φ, sin 4φ)` of a direction.
fn harmonics([a, b, _]: Cell) -> SVector<f64, 5> {
    let (x, y) = (f64::from(a), f64::from(b));
    let square = x * x + y * y;
    let (cos, sin) = ((x * x - y * y) / square, 2.0 * x * y / square);
    SVector::from([1.0, cos, sin, cos * cos - sin * sin, 2.0 * sin * cos])
}

/// Square of the length of an offset, spacings².
fn squared([a, b, _]: Cell) -> f64 {
    f64::from(a * a + b * b)
}

/// `Σ w ξ²`, the weighted volume of a family with these weights per offset.
pub(super) fn weighted_volume(offsets: &[Cell], weights: &[f64]) -> f64 {
    offsets.iter().zip(weights).map(|(&o, w)| w * squared(o)).sum()
}

/// Multiplies the weights of a family by `c·ψ(φ)` with the harmonics ψ so that `Σ w ξ² ψ = (q, 0, 0, 0, 0)`: then
/// `⟨cos⁴⟩ = ⟨sin⁴⟩ = 3/8`, `⟨cos² sin²⟩ = 1/8`, and dilatation, strains and energy of any uniform strain are exact. In a
/// family with fewer directions than harmonics the smallest such change is made.
pub(super) fn correct(offsets: &[Cell], weights: &mut [f64], q: f64) {
    let mut gram = SMatrix::<f64, 5, 5>::zeros();
    for (&offset, w) in offsets.iter().zip(weights.iter()).filter(|(_, w)| **w != 0.0) {
        let psi = harmonics(offset);
        gram += w * squared(offset) * psi * psi.transpose();
    }
    let svd = gram.svd(true, true);
    let most = svd.singular_values.max();
    let wanted = SVector::from([q, 0.0, 0.0, 0.0, 0.0]);
    let Ok(c) = svd.solve(&wanted, RANK * most) else { return };
    for (&offset, w) in offsets.iter().zip(weights) {
        *w *= c.dot(&harmonics(offset));
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::bond_plane::Influence;
    use super::super::super::plane::{half_offsets, is_within, length};
    use super::*;

    /// Full families in lattice units: q and the factors at φ = 0 and 45°, from c0 + c1 and c0 − c1 of an independent
    /// Python implementation.
    #[test]
    fn full_families_have_two_constants() {
        let table = [
            (Influence::Constant, 2.0, 28.0, 1.2250000000, -0.5250000000),
            (Influence::Constant, 3.0, 136.0, 1.0017118077, -0.0485012173),
            (Influence::Inverse, 2.0, 35.3137084990, 1.1481812161, -0.4124789557),
            (Influence::Inverse, 3.0, 176.5773197054, 1.0016397909, -0.0477652572),
            (Influence::Inverse, 4.0, 516.0069522141, 1.0023915913, -0.0643608866),
            (Influence::Linear, 3.0, 24.2446348030, 1.0023087202, 0.0614500538),
            (Influence::Linear, 4.0, 79.1935897369, 1.0012108169, 0.0476261763),
        ];
        for (influence, m, q, c0, c1) in table {
            let half: Vec<Cell> = half_offsets(m, 1).into_iter().filter(|&o| is_within(o, m)).collect();
            let offsets: Vec<Cell> = half.iter().copied().chain(half.iter().map(|o| o.map(|k| -k))).collect();
            let plain: Vec<f64> = offsets.iter().map(|&o| influence.at(length(o) / m)).collect();
            assert!((weighted_volume(&offsets, &plain) / q - 1.0).abs() < 1e-9, "{influence:?} {m}");
            let mut weights = plain.clone();
            correct(&offsets, &mut weights, weighted_volume(&offsets, &plain));
            for (offset, factor) in [([1, 0, 0], c0 + c1), ([1, 1, 0], c0 - c1)] {
                let k = offsets.iter().position(|o| *o == offset).unwrap();
                assert!((weights[k] / plain[k] - factor).abs() < 1e-9, "{influence:?} {m} {offset:?}");
            }
        }
    }
}
