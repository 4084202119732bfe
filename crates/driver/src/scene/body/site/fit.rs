//! Values at a position by a linear field that is fitted to those of points around it.

use nalgebra::{Matrix4, Vector4};

/// Least root of a pivot over the largest of what a fit solves: with less, the points are on one line or plane.
const SPREAD: f64 = 1e-3;

/// Weights of points, by their numbers and steps from the position in spacings, that give linear fields exactly: a fit to all of
/// them in which near ones count most. `None` if they do not spread in all directions of the plane or of space.
pub(super) fn linear(points: &[(u32, [f64; 3])]) -> Option<Vec<(u32, f64)>> {
    let terms = |[x, y, z]: [f64; 3]| Vector4::new(1.0, x, y, z);
    let weight = |step: [f64; 3]| (0.25 + step.iter().map(|s| s * s).sum::<f64>()).powi(-2);
    let mut normal = Matrix4::zeros();
    for &(_, step) in points {
        normal += weight(step) * terms(step) * terms(step).transpose();
    }
    // In the plane.
    if points.iter().all(|(_, step)| step[2] == 0.0) {
        normal[(3, 3)] = normal[(0, 0)];
    }
    let factor = normal.cholesky()?;
    let pivots = factor.l_dirty().diagonal();
    if pivots.min() < SPREAD * pivots.max() {
        return None;
    }
    let value = factor.solve(&Vector4::x());
    Some(points.iter().map(|&(point, step)| (point, weight(step) * value.dot(&terms(step)))).collect())
}

#[cfg(test)]
mod tests {
    use super::linear;

    fn field([x, y, z]: [f64; 3]) -> f64 {
        3.0 + x - 2.0 * y + 0.5 * z
    }

    #[test]
    fn linear_fields_are_exact_from_one_side() {
        let space = (0..27).map(|k| [k % 3, k / 3 % 3, k / 9].map(|c| 0.3 + f64::from(c)));
        let plane = (0..9).map(|k| [0.3 + f64::from(k % 3), -1.2 - f64::from(k / 3), 0.0]);
        for steps in [space.collect::<Vec<_>>(), plane.collect()] {
            let points: Vec<(u32, [f64; 3])> = (0..).zip(steps).collect();
            let weights = linear(&points).expect("a fit");
            let found: f64 = weights.iter().map(|(k, w)| w * field(points[*k as usize].1)).sum();
            // Measured: 8e-15.
            assert!((found - 3.0).abs() < 1e-13, "{found}");
        }
    }

    #[test]
    fn points_in_a_row_tell_nothing_across_it() {
        let points: Vec<(u32, [f64; 3])> = (0..5).map(|k| (k, [f64::from(k) - 2.0, 0.3, 0.0])).collect();
        assert!(linear(&points).is_none() && linear(&[]).is_none());
    }
}
