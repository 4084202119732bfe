//! Elimination in double-double arithmetic.

use twofloat::TwoFloat;

/// A quotient in double-double arithmetic: that of the library has the digits of a double.
pub(super) fn over(a: TwoFloat, b: TwoFloat) -> TwoFloat {
    let mut quotient = TwoFloat::from(0.0);
    let mut rest = a;
    for _ in 0..3 {
        let digits = f64::from(rest) / f64::from(b);
        quotient += digits;
        rest -= b * digits;
    }
    quotient
}

/// Gaussian elimination of a positive definite matrix in double-double arithmetic; none if a pivot vanishes but for rounding.
pub(super) fn solved(mut matrix: Vec<Vec<TwoFloat>>, mut rhs: Vec<TwoFloat>) -> Option<Vec<TwoFloat>> {
    let n = rhs.len();
    let size: Vec<f64> = (0..n).map(|k| f64::from(matrix[k][k])).collect();
    for k in 0..n {
        let pivot = matrix[k][k];
        if f64::from(pivot) <= 1e-24 * size[k] {
            return None;
        }
        let line = matrix[k].clone();
        for i in k + 1..n {
            let factor = over(matrix[i][k], pivot);
            if f64::from(factor) != 0.0 {
                for j in k..n {
                    let taken = factor * line[j];
                    matrix[i][j] -= taken;
                }
                let taken = factor * rhs[k];
                rhs[i] -= taken;
            }
        }
    }
    for k in (0..n).rev() {
        let known = (k + 1..n).fold(TwoFloat::from(0.0), |sum, j| sum + matrix[k][j] * rhs[j]);
        rhs[k] = over(rhs[k] - known, matrix[k][k]);
    }
    Some(rhs)
}
