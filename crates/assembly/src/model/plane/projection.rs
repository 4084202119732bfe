//! The non-negative solution of linear equations that is closest to a start.

use nalgebra::{Cholesky, DMatrix, DVector};

/// Weight of the start against the equations, each squared, while the positive weights are searched for.
const SOFTNESS: f64 = 1e-10;

/// Minimises `Σ ((x − start)/scales)²` over `x >= 0` with `matrix·x = rhs`.
///
/// Non-negative least squares (Lawson and Hanson) find which weights are positive, with the equations as a stiff part of
/// the sum; then those are moved onto the equations. The least squares of few equations in many weights are solved in
/// as many unknowns as there are equations, `y = y₀ + Aᵀλ` with `(A Aᵀ + ε) λ = b − A y₀`. Where the equations have no
/// solution a residual remains.
pub(in super::super) fn project(
    matrix: &DMatrix<f64>,
    rhs: &DVector<f64>,
    start: &DVector<f64>,
    scales: &DVector<f64>,
) -> DVector<f64> {
    let mut a = matrix.clone();
    a.column_iter_mut().zip(scales.iter()).for_each(|(mut column, s)| column *= *s);
    let mut b = rhs.clone();
    for (mut row, b) in a.row_iter_mut().zip(b.iter_mut()) {
        let norm = row.norm();
        if norm > 0.0 {
            row /= norm;
            *b /= norm;
        }
    }
    let y0 = start.component_div(scales);
    let (mut y, mut positive) = least_squares(&a, &b, &y0);
    polish(&a, &b, &mut y, &mut positive);
    y.map(|v| v.max(0.0)).component_mul(scales)
}

/// `min |A y − b|²/ε + |y − y₀|²` over `y >= 0`, from the start itself instead of from zero.
fn least_squares(a: &DMatrix<f64>, b: &DVector<f64>, y0: &DVector<f64>) -> (DVector<f64>, Vec<bool>) {
    let n = y0.len();
    let (mut y, mut positive) = start(a, b, y0);
    for _ in 0..20 * (n + 1) {
        let Some((z, multipliers)) = on_subset(a, b, y0, &positive) else { break };
        // As far towards the minimum as no weight becomes negative.
        let negative = (0..n).filter(|&k| positive[k] && z[k] <= 0.0);
        let step = negative.map(|k| y[k] / (y[k] - z[k])).fold(1.0, f64::min);
        if step < 1.0 || (0..n).any(|k| positive[k] && z[k] <= 0.0) {
            for k in 0..n {
                y[k] += step * (z[k] - y[k]);
                if positive[k] && z[k] <= 0.0 && y[k] <= 1e-14 {
                    positive[k] = false;
                    y[k] = 0.0;
                }
            }
            continue;
        }
        y = z;
        // Descent of the sum per weight; where all weights at zero would rise by growing, this is the minimum.
        let gain = a.tr_mul(&multipliers) + y0 - &y;
        let best = (0..n).filter(|&k| !positive[k]).max_by(|&k, &l| gain[k].total_cmp(&gain[l]));
        let noise = 1e-12 * (1.0 + multipliers.amax());
        match best {
            Some(k) if gain[k] > noise => positive[k] = true,
            _ => break,
        }
    }
    (y, positive)
}

/// A point from which single weights decide: all that would be negative are dropped at once until none is. The minimum does not
/// depend on it, but with thousands of weights the time does.
fn start(a: &DMatrix<f64>, b: &DVector<f64>, y0: &DVector<f64>) -> (DVector<f64>, Vec<bool>) {
    let mut positive: Vec<bool> = y0.iter().map(|&v| v > 0.0).collect();
    while let Some((z, _)) = on_subset(a, b, y0, &positive) {
        let negative: Vec<usize> = (0..z.len()).filter(|&k| positive[k] && z[k] <= 0.0).collect();
        if negative.is_empty() {
            return (z, positive);
        }
        negative.into_iter().for_each(|k| positive[k] = false);
    }
    (DVector::zeros(y0.len()), vec![false; y0.len()])
}

/// The minimum over the positive weights and the multipliers of the equations.
fn on_subset(
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    y0: &DVector<f64>,
    positive: &[bool],
) -> Option<(DVector<f64>, DVector<f64>)> {
    let (mut gram, mut rest) = (DMatrix::identity(b.len(), b.len()) * SOFTNESS, b.clone());
    for (k, column) in a.column_iter().enumerate().filter(|(k, _)| positive[*k]) {
        gram.ger(1.0, &column, &column, 1.0);
        rest.axpy(-y0[k], &column, 1.0);
    }
    let multipliers = Cholesky::new(gram)?.solve(&rest);
    let weight = |k: usize| if positive[k] { y0[k] + a.column(k).dot(&multipliers) } else { 0.0 };
    Some((DVector::from_fn(y0.len(), |k, _| weight(k)), multipliers))
}

/// Moves the positive weights onto the equations by the shortest way; weights that would become negative are zero.
fn polish(a: &DMatrix<f64>, b: &DVector<f64>, y: &mut DVector<f64>, positive: &mut [bool]) {
    for _ in 0..10 {
        let mut reduced = a.clone();
        let columns = reduced.column_iter_mut().zip(positive.iter());
        columns.filter(|(_, positive)| !**positive).for_each(|(mut column, _)| column.fill(0.0));
        let residual = b - &reduced * &*y;
        let Ok(correction) = reduced.svd(true, true).solve(&residual, 1e-12) else { return };
        let small = correction.amax() <= 1e-16 * y.amax();
        *y += correction;
        for (v, positive) in y.iter_mut().zip(positive.iter_mut()) {
            *positive &= *v > 0.0;
            *v = if *positive { *v } else { 0.0 };
        }
        if small {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closest_solution_is_found_where_bounds_act() {
        // x + y + z = 1, x − y = 1 from (0.2, 0.7, 0.1): y would be negative; then x = 1 and z = 0 alone remain.
        let matrix = DMatrix::from_row_slice(2, 3, &[1.0, 1.0, 1.0, 1.0, -1.0, 0.0]);
        let rhs = DVector::from_vec(vec![1.0, 1.0]);
        let start = DVector::from_vec(vec![0.2, 0.7, 0.1]);
        let found = project(&matrix, &rhs, &start, &DVector::from_element(3, 1.0));
        assert!((found - DVector::from_vec(vec![1.0, 0.0, 0.0])).amax() < 1e-15);
    }

    #[test]
    fn without_bounds_it_is_the_shortest_way() {
        // One equation: x = start + s² a (b − a·start)/(a S² a).
        let matrix = DMatrix::from_row_slice(1, 3, &[1.0, 2.0, 3.0]);
        let start = DVector::from_vec(vec![1.0, 1.0, 1.0]);
        let scales = DVector::from_vec(vec![1.0, 2.0, 0.5]);
        let found = project(&matrix, &DVector::from_vec(vec![7.0]), &start, &scales);
        let step = 1.0 / (1.0 + 16.0 + 2.25);
        let expected = [1.0 + step, 1.0 + 8.0 * step, 1.0 + 0.75 * step];
        assert!((0..3).all(|k| (found[k] - expected[k]).abs() < 1e-14), "{found:?}");
    }

    #[test]
    fn no_other_solution_is_closer() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..200 {
            let matrix = DMatrix::from_fn(2, 6, |_, _| random() - 0.3);
            let [start, scales] = [-0.5, 0.5].map(|least| DVector::from_fn(6, |_, _| random() + least));
            let other = DVector::from_fn(6, |_, _| (random() - 0.4).max(0.0));
            let rhs = &matrix * &other;
            let found = project(&matrix, &rhs, &start, &scales);
            assert!(found.min() >= 0.0 && (&matrix * &found - rhs).amax() < 1e-9, "{found}");
            // On the way to any other solution the distance grows.
            let way = (&other - &found).component_div(&scales);
            let slope = way.dot(&(&found - &start).component_div(&scales));
            assert!(slope > -1e-9, "{slope:e}");
        }
    }

    #[test]
    fn what_cannot_be_solved_leaves_a_residual() {
        let matrix = DMatrix::from_row_slice(1, 2, &[1.0, 1.0]);
        let found = project(
            &matrix,
            &DVector::from_vec(vec![-1.0]),
            &DVector::from_vec(vec![1.0, 1.0]),
            &DVector::from_vec(vec![1.0, 1.0]),
        );
        assert_eq!(found.amax(), 0.0);
    }
}
