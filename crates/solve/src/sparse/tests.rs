use super::*;
use crate::{BandCholesky, BandMatrix};
use sprs::TriMat;

/// Five-point Laplacian plus one on a square grid; `whole` stores both triangles.
fn grid(side: usize, whole: bool, diagonal: impl Fn(usize) -> f64) -> CsMat<f64> {
    let n = side * side;
    let mut entries = TriMat::new((n, n));
    for i in 0..n {
        entries.add_triplet(i, i, diagonal(i));
        let left = (i % side > 0).then(|| i - 1);
        for j in left.into_iter().chain(i.checked_sub(side)) {
            entries.add_triplet(i, j, -1.0);
            if whole {
                entries.add_triplet(j, i, -1.0);
            }
        }
    }
    entries.to_csr()
}

/// Lower triangle without a zero; small enough off the diagonal to be dominant.
fn full(n: usize, diagonal: impl Fn(usize) -> f64) -> CsMat<f64> {
    let mut entries = TriMat::new((n, n));
    for i in 0..n {
        entries.add_triplet(i, i, diagonal(i));
        for j in 0..i {
            entries.add_triplet(i, j, 1.0 / (n + i + j) as f64);
        }
    }
    entries.to_csr()
}

fn factored(matrix: &CsMat<f64>) -> SparseCholesky {
    let mut factor = SparseCholesky::analyse(matrix, Ordering::MinimumDegree).unwrap();
    factor.refactor(matrix).unwrap();
    factor
}

fn wavy(n: usize) -> Vec<f64> {
    (0..n).map(|i| (i as f64 * 0.7).sin()).collect()
}

fn solve(factor: &mut impl Preconditioner, r: &[f64]) -> Vec<f64> {
    let mut z = vec![f64::NAN; r.len()];
    factor.apply(r, &mut z);
    z
}

#[test]
fn band_and_sparse_agree_for_whole_and_half_matrices() {
    let side = 12;
    let n = side * side;
    let mut values = vec![0.0; n * (side + 1)];
    for (value, (row, column)) in grid(side, false, |_| 5.0).iter() {
        values[column * (side + 1) + row - column] = *value;
    }
    let band = BandMatrix { order: n, half_bandwidth: side, values };
    let expected = solve(&mut BandCholesky::factor(band, 1).unwrap(), &wavy(n));
    for whole in [false, true] {
        let z = solve(&mut factored(&grid(side, whole, |_| 5.0)), &wavy(n));
        for (z, x) in z.iter().zip(&expected) {
            assert!((z - x).abs() < 1.0e-15);
        }
    }
}

#[test]
fn refactor_equals_a_fresh_factor() {
    let next = grid(9, false, |i| 5.0 + i as f64);
    let mut again = factored(&grid(9, false, |_| 5.0));
    again.refactor(&next).unwrap();
    let mut fresh = factored(&next);
    assert_eq!(solve(&mut again, &wavy(81)), solve(&mut fresh, &wavy(81)));
}

#[test]
fn the_bad_pivot_is_named_in_the_callers_numbering() {
    // A small grid and a full matrix, for the simplicial and the supernodal kernel.
    for (n, supernodal) in [(25, false), (400, true)] {
        for bad in [0, n / 3, n - 1] {
            let diagonal = |i| if i == bad { -50.0 } else { 5.0 };
            let matrix = if supernodal { full(n, diagonal) } else { grid(5, false, diagonal) };
            let mut factor = SparseCholesky::analyse(&matrix, Ordering::MinimumDegree).unwrap();
            assert_eq!(factor.analysis.has_blocks(), supernodal);
            let expected = FactorError::NonPositivePivot { index: bad, count: 1 };
            assert_eq!(factor.refactor(&matrix), Err(expected));
        }
    }
}

#[test]
fn entries_that_are_not_finite_are_reported_by_row() {
    let mut matrix = grid(6, true, |_| 5.0);
    let pattern = matrix.clone();
    *matrix.get_mut(20, 14).unwrap() = f64::NAN;
    let mut factor = factored(&pattern);
    assert_eq!(factor.refactor(&matrix), Err(FactorError::NotFinite { index: 20 }));
    // The upper triangle is not read.
    let mut matrix = pattern.clone();
    *matrix.get_mut(14, 20).unwrap() = f64::NAN;
    assert_eq!(factor.refactor(&matrix), Ok(()));
}

#[test]
#[should_panic(expected = "the matrix has the analysed pattern")]
fn another_pattern_is_a_mistake() {
    let mut factor = factored(&grid(6, true, |_| 5.0));
    let _ = factor.refactor(&grid(6, false, |_| 5.0));
}

#[test]
fn shape_and_size() {
    let oblong = CsMat::<f64>::zero((2, 3));
    assert!(matches!(
        SparseCholesky::analyse(&oblong, Ordering::MinimumDegree),
        Err(FactorError::Shape { .. })
    ));
    // A diagonal matrix has no fill.
    let diagonal = CsMat::<f64>::eye(7);
    let mut factor = factored(&diagonal);
    assert_eq!(factor.fill(), 7);
    assert!(factor.bytes() >= 7 * 8);
    assert_eq!(solve(&mut factor, &[2.0; 7]), [2.0; 7]);
}

#[test]
fn points_by_minimum_degree_have_the_fill_of_their_unknowns() {
    const COMPONENTS: usize = 3;
    let points = grid(30, false, |_| 5.0);
    let n = points.rows();
    let mut entries = TriMat::new((COMPONENTS * n, COMPONENTS * n));
    for (value, (p, q)) in points.iter() {
        for (a, b) in (0..COMPONENTS).flat_map(|a| (0..COMPONENTS).map(move |b| (a, b))) {
            let (i, j) = (a * n + p, b * n + q);
            let entry = if i == j { 20.0 } else { 0.5 * value / (1 + a + b) as f64 };
            let is_twice = p == q && a < b;
            if !is_twice {
                entries.add_triplet(i.max(j), i.min(j), entry);
            }
        }
    }
    let matrix: CsMat<f64> = entries.to_csr();
    let mut plain = factored(&matrix);
    let ordering = Ordering::MinimumDegreeOfPoints { components: COMPONENTS };
    let mut factor = SparseCholesky::analyse(&matrix, ordering).unwrap();
    factor.refactor(&matrix).unwrap();
    let ratio = factor.fill() as f64 / plain.fill() as f64;
    // Found 1: the same fill.
    assert!((ratio - 1.0).abs() < 0.03, "{ratio}");
    let r = wavy(COMPONENTS * n);
    for (z, x) in solve(&mut factor, &r).iter().zip(&solve(&mut plain, &r)) {
        assert!((z - x).abs() < 1e-15, "{z} {x}");
    }
}

#[test]
fn rows_that_are_not_those_of_points_are_refused() {
    let seven = CsMat::<f64>::eye(7);
    for components in [0, 2] {
        let ordering = Ordering::MinimumDegreeOfPoints { components };
        assert!(matches!(SparseCholesky::analyse(&seven, ordering), Err(FactorError::Shape { .. })));
    }
    let none = CsMat::<f64>::zero((0, 0));
    let ordering = Ordering::MinimumDegreeOfPoints { components: 3 };
    assert_eq!(SparseCholesky::analyse(&none, ordering).unwrap().fill(), 0);
}
