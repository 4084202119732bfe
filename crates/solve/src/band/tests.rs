use super::*;

/// Numbers in (-1, 1) that look random; Knuth's multiplier.
pub(crate) struct Noise(pub(crate) u64);

impl Noise {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Diagonally dominant, hence positive definite.
fn random_band(order: usize, half_bandwidth: usize, seed: u64) -> BandMatrix {
    let mut noise = Noise(seed);
    let width = half_bandwidth + 1;
    let mut values = vec![0.0; order * width];
    for j in 0..order {
        for k in 1..width.min(order - j) {
            values[j * width + k] = noise.next();
        }
        values[j * width] = 2.0 * half_bandwidth as f64 + 1.5 + noise.next();
    }
    BandMatrix { order, half_bandwidth, values }
}

fn dense(matrix: &BandMatrix) -> Vec<Vec<f64>> {
    let (n, b) = (matrix.order, matrix.half_bandwidth);
    let entry = |i: usize, j: usize| {
        let (low, high) = (i.min(j), i.max(j));
        if high - low > b { 0.0 } else { matrix.values[low * (b + 1) + high - low] }
    };
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

/// Gaussian elimination with row exchanges, the reference.
fn solve_dense(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for j in 0..n {
        let best = (j..n).max_by(|p, q| a[*p][j].abs().total_cmp(&a[*q][j].abs())).unwrap();
        a.swap(j, best);
        b.swap(j, best);
        let pivot_row = a[j].clone();
        for i in j + 1..n {
            let factor = a[i][j] / pivot_row[j];
            for (value, above) in a[i].iter_mut().zip(&pivot_row) {
                *value -= factor * above;
            }
            b[i] -= factor * b[j];
        }
    }
    for j in (0..n).rev() {
        let known: f64 = (j + 1..n).map(|k| a[j][k] * b[k]).sum();
        b[j] = (b[j] - known) / a[j][j];
    }
    b
}

/// From the numbering of the band to that of the planes.
fn to_planes(v: &[f64], planes: usize) -> Vec<f64> {
    let points = v.len() / planes;
    let mut out = vec![0.0; v.len()];
    for (k, value) in v.iter().enumerate() {
        out[(k % planes) * points + k / planes] = *value;
    }
    out
}

#[test]
fn every_width_order_and_plane_count_agrees_with_elimination() {
    for half_bandwidth in (0..=25).chain([33, 64]) {
        for order in (1..=60).chain([127, 300]) {
            let matrix = random_band(order, half_bandwidth, (61 * half_bandwidth + order) as u64);
            let mut noise = Noise(7);
            let load: Vec<f64> = (0..order).map(|_| noise.next()).collect();
            let expected = solve_dense(dense(&matrix), load.clone());
            for planes in (1..=4).filter(|p| order.is_multiple_of(*p)) {
                let mut factor = BandCholesky::factor(matrix.clone(), planes).unwrap();
                let mut z = vec![f64::NAN; order];
                factor.apply(&to_planes(&load, planes), &mut z);
                for (z, x) in z.iter().zip(to_planes(&expected, planes)) {
                    assert!((z - x).abs() < 1.0e-14, "b {half_bandwidth} n {order} p {planes}");
                }
            }
        }
    }
}

#[test]
fn an_empty_matrix_has_an_empty_solution() {
    for half_bandwidth in [0, 3, 50] {
        let mut factor = BandCholesky::factor(random_band(0, half_bandwidth, 1), 2).unwrap();
        factor.apply(&[], &mut []);
        assert_eq!(factor.size(), 0);
    }
}

#[test]
fn all_bad_pivots_are_counted() {
    // Sylvester: the signs of D are those of the eigenvalues, and A = L D L^T has
    // the signs put in here whatever L is.
    for half_bandwidth in [1, 2, 3, 5, 7, 9, 11, 13, 15, 16, 17, 18, 19, 20] {
        let (n, width) = (90, half_bandwidth + 1);
        let mut noise = Noise(half_bandwidth as u64);
        let mut l = vec![vec![0.0; n]; n];
        for j in 0..n {
            l[j][j] = 1.0;
            for row in l.iter_mut().take((j + width).min(n)).skip(j + 1) {
                row[j] = 0.3 * noise.next();
            }
        }
        let d: Vec<f64> = (0..n).map(|j| if j % 11 == 4 { -1.0 } else { 2.0 }).collect();
        let mut matrix = random_band(n, half_bandwidth, 1);
        for j in 0..n {
            for k in 0..width.min(n - j) {
                let sum = (0..=j).map(|q| l[j + k][q] * d[q] * l[j][q]).sum();
                matrix.values[j * width + k] = sum;
            }
        }
        // 8 of the numbers below 90 leave 4 when divided by 11; band index 4 in two
        // planes of 45 is entry 2 of the first plane.
        let expected = FactorError::NonPositivePivot { index: 2, count: 8 };
        assert_eq!(BandCholesky::factor(matrix, 2).unwrap_err(), expected);
    }
}

#[test]
fn a_zero_pivot_does_not_end_the_count() {
    // [[0, 1], [1, 0]] has the eigenvalues 1 and -1, so one bad pivot.
    let matrix = BandMatrix { order: 2, half_bandwidth: 1, values: vec![0.0, 1.0, 0.0, 0.0] };
    let expected = FactorError::NonPositivePivot { index: 0, count: 1 };
    assert_eq!(BandCholesky::factor(matrix, 1).unwrap_err(), expected);
    // All zero: every pivot is.
    let nothing = BandMatrix { order: 3, half_bandwidth: 1, values: vec![0.0; 6] };
    let expected = FactorError::NonPositivePivot { index: 0, count: 3 };
    assert_eq!(BandCholesky::factor(nothing, 1).unwrap_err(), expected);
    let nothing = BandMatrix { order: 30, half_bandwidth: 17, values: vec![0.0; 30 * 18] };
    let expected = FactorError::NonPositivePivot { index: 0, count: 30 };
    assert_eq!(BandCholesky::factor(nothing, 1).unwrap_err(), expected);
}

#[test]
fn entries_that_are_not_finite_are_reported_by_row() {
    for half_bandwidth in [3, 7, 16] {
        for bad in [f64::NAN, f64::INFINITY] {
            let mut matrix = random_band(60, half_bandwidth, 3);
            // Row 22 of column 20: in two planes of 30, entry 11 of the first.
            matrix.values[20 * (half_bandwidth + 1) + 2] = bad;
            let expected = FactorError::NotFinite { index: 11 };
            assert_eq!(BandCholesky::factor(matrix, 2).unwrap_err(), expected);
        }
    }
}

#[test]
fn refactor_equals_a_fresh_factor() {
    let mut factor = BandCholesky::factor(random_band(40, 7, 1), 2).unwrap();
    let next = random_band(60, 5, 2);
    factor.refactor(next.clone()).unwrap();
    assert_eq!(factor.values, BandCholesky::factor(next, 2).unwrap().values);
    assert_eq!(factor.bytes(), 60 * 6 * 8); // order * (b + 1) doubles
}

#[test]
fn a_failed_refactor_leaves_no_factor() {
    let mut factor = BandCholesky::factor(random_band(40, 7, 1), 2).unwrap();
    let mut bad = random_band(40, 7, 2);
    bad.values[0] = -1.0;
    assert!(factor.refactor(bad).is_err());
    assert_eq!(factor.size(), 0);
}

#[test]
fn shapes_that_do_not_fit_are_errors() {
    let mut short = random_band(10, 3, 1);
    short.values.pop();
    assert!(matches!(BandCholesky::factor(short, 1), Err(FactorError::Shape { .. })));
    let odd = random_band(9, 3, 1);
    assert!(matches!(BandCholesky::factor(odd.clone(), 2), Err(FactorError::Shape { .. })));
    assert!(matches!(BandCholesky::factor(odd, 0), Err(FactorError::Shape { .. })));
}

#[test]
fn a_lift_restores_a_matrix_that_rounding_made_singular() {
    // [[1, 1], [1, 1]] is singular; a lift by 1/4 has the determinant 9/16.
    let mut matrix = BandMatrix { order: 2, half_bandwidth: 1, values: vec![1.0, 1.0, 1.0, 0.0] };
    assert!(BandCholesky::factor(matrix.clone(), 1).is_err());
    matrix.lift_diagonal(0.25);
    let mut factor = BandCholesky::factor(matrix, 1).unwrap();
    let mut z = [0.0; 2];
    factor.apply(&[9.0, 0.0], &mut z);
    assert_eq!(z, [20.0, -16.0]); // 16/9 [[5/4, -1], [-1, 5/4]] [9, 0]
}
