//! The polynomial of the smoother.

use crate::hierarchy::Relaxation;

/// The steps of the Chebyshev iteration whose error polynomial of this degree is smallest on the eigenvalues from
/// `largest / range` to `largest` (Saad, Iterative methods for sparse linear systems, 2nd ed., algorithm 12.1, with the
/// increments written as differences of iterates).
pub(super) fn steps(largest: f64, range: f64, degree: usize) -> Vec<Relaxation> {
    let smallest = largest / range;
    let (centre, radius) = (0.5 * (largest + smallest), 0.5 * (largest - smallest));
    let mut steps = vec![Relaxation { keep: 0.0, scale: 1.0 / centre }];
    let mut rho = radius / centre;
    while steps.len() < degree {
        let next = 1.0 / (2.0 * centre / radius - rho);
        steps.push(Relaxation { keep: next * rho, scale: 2.0 * next / radius });
        rho = next;
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is left of an error of this eigenvalue after the steps.
    fn error(steps: &[Relaxation], eigenvalue: f64) -> f64 {
        let (mut error, mut previous) = (1.0, 1.0);
        for step in steps {
            let next = error + step.keep * (error - previous) - step.scale * eigenvalue * error;
            (previous, error) = (error, next);
        }
        error
    }

    #[test]
    fn the_error_is_the_chebyshev_polynomial_of_the_interval() {
        // T_3(s) / T_3(s_0) with s = (9/16 - x) / (7/16), from 1/8 to 1; s_0 = 9/7 at x = 0
        let cubic = |s: f64| (4.0 * s * s - 3.0) * s;
        let steps = steps(1.0, 8.0, 3);
        for i in 0..=20 {
            let x = i as f64 / 20.0;
            let expected = cubic((9.0 - 16.0 * x) / 7.0) / cubic(9.0 / 7.0);
            assert!((error(&steps, x) - expected).abs() < 1.0e-14);
        }
    }
}
