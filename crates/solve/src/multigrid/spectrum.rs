//! The largest eigenvalue of `M^-1 A` on every level.

use super::MultigridOptions;
use crate::hierarchy::Hierarchy;
use peristat_vector::Real;
use peristat_vector::subtract;

/// Bounds for all levels but the coarsest, finest first, the margin included.
pub(super) fn largest_eigenvalues<H: Hierarchy>(hierarchy: &H, options: &MultigridOptions) -> Vec<f64> {
    let mut bounds = Vec::new();
    let mut known = 0.0_f64;
    for level in (0..hierarchy.depth() - 1).rev() {
        let bound = if known > 0.0 && hierarchy.size(level) > options.measured_size {
            known
        } else {
            options.margin * largest_eigenvalue(hierarchy, level, options.lanczos_steps)
        };
        known = known.max(bound);
        bounds.push(bound);
    }
    bounds.reverse();
    bounds
}

/// From below, by conjugate gradients on an arbitrary right-hand side: their coefficients are the tridiagonal matrix of
/// the Lanczos process (Saad, Iterative methods for sparse linear systems, 2nd ed., section 6.7.3). 1 without unknowns.
fn largest_eigenvalue<H: Hierarchy>(hierarchy: &H, level: usize, steps: usize) -> f64 {
    let size = hierarchy.size(level);
    let arbitrary: Vec<H::Real> = (0..size).map(|i| H::Real::of(arbitrary(i))).collect();
    // Residuals are what the operator makes of something: zero where unknowns depend on others.
    let mut r = vec![H::Real::default(); size];
    hierarchy.apply(level, &arbitrary, &mut r);
    let mut p = vec![H::Real::default(); size];
    hierarchy.smooth(level, 1.0, &r, &mut p);
    let mut rz = hierarchy.dot(level, &r, &p);
    let first = rz;
    let (mut diagonal, mut off_diagonal) = (Vec::new(), Vec::new());
    let mut carried = 0.0;
    // The product, then the preconditioned residual.
    let mut image = vec![H::Real::default(); size];
    // A residual at rounding level has no more to tell.
    while diagonal.len() + 1 < steps && rz > 1.0e-24 * first {
        hierarchy.apply(level, &p, &mut image);
        let length = rz / hierarchy.dot(level, &p, &image);
        subtract(&mut r, length, &image);
        image.fill(H::Real::default());
        hierarchy.smooth(level, 1.0, &r, &mut image);
        let next = hierarchy.dot(level, &r, &image);
        let beta = next / rz;
        let carry = H::Real::of(beta);
        p.iter_mut().zip(&image).for_each(|(p, z)| *p = *z + carry * *p);
        diagonal.push(1.0 / length + carried);
        carried = beta / length;
        off_diagonal.push(beta.max(0.0).sqrt() / length);
        rz = next;
    }
    if diagonal.is_empty() { 1.0 } else { largest_of_tridiagonal(&diagonal, &off_diagonal) }
}

/// Between -1/2 and 1/2: fractions of multiples of the golden section, far from every smooth vector.
fn arbitrary(i: usize) -> f64 {
    let turns = (i as f64 + 1.0) * 0.618_033_988_749_894_9;
    let hashed = (turns.fract() * 7919.0 + turns.fract() * turns.fract() * 104_729.0).fract();
    hashed - 0.5
}

/// By bisection: all pivots of `T - x` are negative if `x` is beyond the largest eigenvalue.
fn largest_of_tridiagonal(diagonal: &[f64], off_diagonal: &[f64]) -> f64 {
    let beyond = |x: f64| {
        let mut pivot = diagonal[0] - x;
        for (d, e) in diagonal[1..].iter().zip(off_diagonal) {
            if pivot >= 0.0 {
                return false;
            }
            pivot = d - x - e * e / pivot;
        }
        pivot < 0.0
    };
    let mut low = diagonal.iter().fold(0.0_f64, |a, b| a.max(*b));
    let mut high = low + 2.0 * off_diagonal.iter().fold(0.0_f64, |a, b| a.max(*b));
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if beyond(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bisection_finds_the_largest_eigenvalue_of_a_chain() {
        // 2 - 2 cos(k pi / 11), largest for k = 10
        let found = largest_of_tridiagonal(&[2.0; 10], &[-1.0; 9].map(f64::abs));
        let expected = 2.0 + 2.0 * (std::f64::consts::PI / 11.0).cos();
        assert!((found - expected).abs() < 1.0e-10);
    }
}
