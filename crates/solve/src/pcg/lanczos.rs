//! The tridiagonal matrix that the coefficients of conjugate gradients make: its eigenvalues, the Ritz values, are close to
//! the outer ones of the preconditioned operator.

/// Bisections of an interval that leave all digits that matter.
const BISECTIONS: usize = 60;

/// Coefficients of the steps so far.
#[derive(Debug, Clone, Default)]
pub(super) struct Lanczos {
    diagonal: Vec<f64>,
    /// Squares of the entries beside the diagonal.
    squares: Vec<f64>,
    /// What the last step adds to the next entry of the diagonal.
    carry: f64,
}

impl Lanczos {
    /// Takes the length of a step and the ratio of `r . z` after it to that before.
    pub(super) fn step(&mut self, step: f64, ratio: f64) {
        let inverse = 1.0 / step;
        // Where the iteration wanders about its floor the coefficients tell nothing.
        if !(inverse > 0.0 && inverse.is_finite() && ratio.is_finite()) {
            return;
        }
        self.diagonal.push(inverse + self.carry);
        let ratio = ratio.max(0.0);
        self.squares.push(ratio * inverse * inverse);
        self.carry = ratio * inverse;
    }

    /// Least eigenvalue; 1 without steps.
    pub(super) fn least_eigenvalue(&self) -> f64 {
        if self.diagonal.is_empty() {
            return 1.0;
        }
        // It is positive, and below every entry of the diagonal.
        let (mut low, mut high) = (0.0, self.diagonal.iter().copied().fold(f64::INFINITY, f64::min));
        for _ in 0..BISECTIONS {
            // By ratios first: eigenvalues of 1e-12 are to have digits, too.
            let middle = if low > 0.0 { 0.5 * (low + high) } else { 0.1 * high };
            if self.is_definite(middle) { low = middle } else { high = middle }
        }
        high
    }

    /// Whether all eigenvalues are greater than `shift`: the pivots of the shifted matrix are positive.
    fn is_definite(&self, shift: f64) -> bool {
        let mut subtracted = 0.0;
        self.diagonal.iter().zip(&self.squares).all(|(entry, square)| {
            let pivot = entry - shift - subtracted;
            subtracted = square / pivot;
            pivot > 0.0
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coefficients of conjugate gradients for diag(eigenvalues) and a right-hand side of ones, in plain loops.
    fn lanczos(eigenvalues: &[f64], steps: usize) -> Lanczos {
        let mut lanczos = Lanczos::default();
        let (mut r, mut p) = (vec![1.0; eigenvalues.len()], vec![1.0; eigenvalues.len()]);
        let square = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>();
        for _ in 0..steps {
            let before = square(&r);
            let curvature: f64 = p.iter().zip(eigenvalues).map(|(p, l)| p * l * p).sum();
            let step = before / curvature;
            r.iter_mut().zip(p.iter().zip(eigenvalues)).for_each(|(r, (p, l))| *r -= step * l * p);
            let ratio = square(&r) / before;
            lanczos.step(step, ratio);
            p.iter_mut().zip(&r).for_each(|(p, r)| *p = r + ratio * *p);
        }
        lanczos
    }

    #[test]
    fn as_many_steps_as_eigenvalues_find_the_least_one() {
        let eigenvalues = [1.0, 0.25, 3.0, 1e-3];
        let found = lanczos(&eigenvalues, 4).least_eigenvalue();
        // Measured 1e-13.
        assert!((found / 1e-3 - 1.0).abs() < 1e-10, "{found}");
        // A part of the steps sees it from above.
        let early = lanczos(&eigenvalues, 2).least_eigenvalue();
        assert!(early > 1e-3 && early < 1.0, "{early}");
    }

    #[test]
    fn an_exact_preconditioner_has_one_eigenvalue_and_no_step_none() {
        assert_eq!(lanczos(&[1.0, 1.0], 1).least_eigenvalue(), 1.0);
        assert_eq!(Lanczos::default().least_eigenvalue(), 1.0);
        let mut wandering = Lanczos::default();
        wandering.step(-1.0, 0.5);
        wandering.step(f64::NAN, 0.5);
        assert_eq!(wandering.least_eigenvalue(), 1.0);
    }

    #[test]
    fn a_soft_direction_of_a_stiff_preconditioner_has_digits() {
        let found = lanczos(&[1.0, 1e-12], 2).least_eigenvalue();
        assert!((found / 1e-12 - 1.0).abs() < 1e-3, "{found}");
    }
}
