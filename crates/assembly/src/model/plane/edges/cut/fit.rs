//! Polynomials that are nearest to values at points of a lattice.

use crate::body::Cell;
use nalgebra::DMatrix;

/// How much of a term may be missed before what rounding leaves is mended: more is not reported by the points.
const TOLD: f64 = 1e-6;

/// What values at points, by squared distance and position in spacings, have in the value at zero and in its derivatives of
/// the polynomial of some terms, 3 or 6, that is nearest to them. Weights fall with the squares of distances by `decay`. None if
/// the points do not tell it.
pub(super) fn fit(near: &[(i32, Cell)], terms: usize, decay: f64) -> Option<Vec<[f64; 3]>> {
    let first = near.first()?.0;
    let weight: Vec<f64> = near.iter().map(|n| (decay * f64::from(first - n.0)).exp()).collect();
    let term = |k: usize, q: usize| {
        let [x, y, _] = near[k].1.map(f64::from);
        [1.0, x, y, x * x, x * y, y * y][q]
    };
    let all = DMatrix::from_fn(near.len(), terms, |k, q| weight[k] * term(k, q));
    let inverse = all.pseudo_inverse(1e-8).ok()?;
    let tells = |k: usize, q: usize| weight[k] * inverse[(q, k)];
    let mut rows: Vec<[f64; 3]> = (0..near.len()).map(|k| [0, 1, 2].map(|q| tells(k, q))).collect();
    for row in 0..3 {
        // What is left of the terms is rounding, or the fit cannot distinguish them.
        let left = |q: usize| {
            let found: f64 = rows.iter().enumerate().map(|(k, r)| r[row] * term(k, q)).sum();
            f64::from(u8::from(q == row)) - found
        };
        let rest: Vec<f64> = (0..terms).map(left).collect();
        if rest.iter().any(|r| r.abs() > TOLD) {
            return None;
        }
        for (k, found) in rows.iter_mut().enumerate() {
            found[row] += (0..terms).map(|q| tells(k, q) * rest[q]).sum::<f64>();
        }
    }
    Some(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(of: &dyn Fn(Cell) -> bool) -> Vec<(i32, Cell)> {
        let all = (-4..=4).flat_map(|j| (-4..=4).map(move |i| [i, j, 0])).filter(|c| of(*c));
        let mut near: Vec<(i32, Cell)> = all.map(|c| (c[0] * c[0] + c[1] * c[1], c)).collect();
        near.sort_unstable();
        near
    }

    #[test]
    fn a_fit_is_exact_for_its_terms() {
        let near = cells(&|[i, j, _]| 2 * j + i > 2 && i.abs() < 4);
        for decay in [0.5, 0.2] {
            let rows = fit(&near, 6, decay).expect("a quadratic");
            for (k, expected) in
                [[0.25, 0.0, 0.0], [0.0, 1.0, -3.0], [0.0, -3.0, 1.0], [0.0, 0.0, 0.0]].iter().enumerate()
            {
                let value =
                    |[x, y, _]: [f64; 3]| [0.25, x - 3.0 * y, y - 3.0 * x, x * x + x * y - 2.0 * y * y][k];
                for (row, expected) in expected.iter().enumerate() {
                    let all = near.iter().zip(&rows);
                    let found: f64 = all.map(|(n, r)| r[row] * value(n.1.map(f64::from))).sum();
                    assert!((found - expected).abs() < 1e-12, "{k} {row} {found}");
                }
            }
        }
    }

    #[test]
    fn what_points_do_not_tell_is_refused() {
        let two_rows = cells(&|[_, j, _]| j == 1 || j == 2);
        assert!(fit(&two_rows, 6, 0.5).is_none() && fit(&two_rows, 3, 0.5).is_some());
        assert!(fit(&cells(&|[_, j, _]| j == 1), 3, 0.5).is_none());
    }
}
