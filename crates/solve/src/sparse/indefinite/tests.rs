use super::*;
use crate::plane::{Plane, dense, left, negative_eigenvalues, random, wavy};
use sprs::TriMat;

/// Some of the pairs soften, and every unknown has a softening support.
fn softening(plane: &Plane, components: usize, shift: f64) -> CsMat<f64> {
    let mut next = random(3);
    let mut matrix = plane.weighted(components, || if next() < 0.2 { -0.7 } else { 1.0 });
    for i in 0..matrix.rows() {
        *matrix.get_mut(i, i).unwrap() -= shift;
    }
    matrix
}

/// Five-point Laplacian of a square grid, minus a shift.
fn grid(side: usize, shift: f64) -> CsMat<f64> {
    let n = side * side;
    let mut entries = TriMat::new((n, n));
    for i in 0..n {
        entries.add_triplet(i, i, 4.0 - shift);
        for j in (i % side > 0).then(|| i - 1).into_iter().chain(i.checked_sub(side)) {
            entries.add_triplet(i, j, -1.0);
        }
    }
    entries.to_csr()
}

/// Two unknowns, given the lower triangle row by row.
fn two([a, b, c]: [f64; 3]) -> CsMat<f64> {
    TriMat::from_triplets((2, 2), vec![0, 1, 1], vec![0, 0, 1], vec![a, b, c]).to_csr()
}

fn factored(matrix: &CsMat<f64>) -> SparseIndefinite {
    let mut factor = SparseIndefinite::analyse(matrix, Ordering::MinimumDegree).unwrap();
    factor.refactor(matrix).unwrap();
    factor
}

fn solve(factor: &mut SparseIndefinite, r: &[f64]) -> Vec<f64> {
    let mut z = vec![f64::NAN; r.len()];
    factor.apply(r, &mut z);
    z
}

/// Largest residual after one refinement, relative to the solution.
fn refined(matrix: &CsMat<f64>, factor: &mut SparseIndefinite) -> f64 {
    let b = wavy(matrix.rows());
    let largest = |x: &[f64]| x.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
    let mut x = solve(factor, &b);
    let correction = solve(factor, &left(matrix, &x, &b));
    x.iter_mut().zip(&correction).for_each(|(x, d)| *x += d);
    let rest = left(matrix, &x, &b);
    assert!(rest.iter().all(|r| r.is_finite()));
    rest.iter().fold(0.0_f64, |most, r| most.max(r.abs())) / largest(&x)
}

#[test]
fn whatever_is_coupled_is_solved() {
    for (name, plane) in Plane::gallery() {
        for components in [1, 2, 3] {
            for shift in [0.0, 1.3, 4.7] {
                let matrix = softening(&plane, components, shift);
                let found = refined(&matrix, &mut factored(&matrix));
                assert!(found < 1.0e-13, "{name}, {components} components, shift {shift}: {found:e}");
            }
        }
    }
    for shift in [0.3, 1.7, 4.1] {
        let matrix = grid(60, shift);
        let found = refined(&matrix, &mut factored(&matrix));
        assert!(found < 1.0e-13, "grid, shift {shift}: {found:e}");
    }
}

#[test]
fn negative_pivots_are_negative_eigenvalues() {
    let plate = Plane::new(Plane::lattice(9, |_| true), 3.0, |_, _| true);
    for components in [1, 2] {
        for shift in [-30.0, -3.0, 0.0, 1.3, 4.7, 60.0] {
            let matrix = softening(&plate, components, shift);
            let expected = negative_eigenvalues(&dense(&matrix));
            assert_eq!(factored(&matrix).negative_pivots(), expected, "shift {shift}");
        }
    }
    for shift in [0.1, 0.77, 4.3, 9.0] {
        let matrix = grid(12, shift);
        let expected = negative_eigenvalues(&dense(&matrix));
        assert_eq!(factored(&matrix).negative_pivots(), expected, "shift {shift}");
    }
}

#[test]
fn a_failed_cholesky_factor_hands_over_its_analysis() {
    let plate = Plane::new(Plane::lattice(20, |_| true), 3.0, |_, _| true);
    for (matrix, blocks) in [(grid(6, 1.3), false), (softening(&plate, 2, 1.3), true)] {
        let mut cholesky = SparseCholesky::analyse(&matrix, Ordering::MinimumDegree).unwrap();
        assert!(matches!(cholesky.refactor(&matrix), Err(FactorError::NonPositivePivot { .. })));
        let mut factor = SparseIndefinite::of(&cholesky, &matrix).unwrap();
        assert_eq!(Arc::ptr_eq(&factor.analysis, &cholesky.analysis), blocks);
        factor.refactor(&matrix).unwrap();
        assert!(refined(&matrix, &mut factor) < 1.0e-13);
        assert_eq!(factor.negative_pivots(), factored(&matrix).negative_pivots());
        assert!(factor.bytes() >= 8 * factor.fill());
    }
}

#[test]
fn refactor_equals_a_fresh_factor() {
    let plate = Plane::new(Plane::lattice(14, |_| true), 3.0, |_, _| true);
    let first = softening(&plate, 2, 4.7);
    let mut again = factored(&first);
    // Pairs of rows at one shift are single rows at another.
    for shift in [-30.0, 1.3, 60.0, 4.7] {
        let next = softening(&plate, 2, shift);
        again.refactor(&next).unwrap();
        let mut fresh = factored(&next);
        assert_eq!(again.negative_pivots(), fresh.negative_pivots());
        let b = wavy(next.rows());
        assert_eq!(solve(&mut again, &b), solve(&mut fresh, &b));
    }
}

#[test]
fn a_definite_matrix_is_solved_as_by_cholesky() {
    let plate = Plane::new(Plane::lattice(20, |_| true), 3.0, |_, _| true);
    let matrix = plate.matrix(2);
    let mut cholesky = SparseCholesky::analyse(&matrix, Ordering::MinimumDegree).unwrap();
    cholesky.refactor(&matrix).unwrap();
    let mut factor = SparseIndefinite::of(&cholesky, &matrix).unwrap();
    factor.refactor(&matrix).unwrap();
    assert_eq!(factor.negative_pivots(), 0);
    let mut expected = vec![0.0; matrix.rows()];
    cholesky.apply(&wavy(matrix.rows()), &mut expected);
    for (z, x) in solve(&mut factor, &wavy(matrix.rows())).iter().zip(&expected) {
        assert!((z - x).abs() < 1.0e-13);
    }
}

#[test]
fn a_zero_diagonal_needs_pairs_of_rows() {
    let mut entries = TriMat::new((4, 4));
    for (i, j, value) in [(0, 0, 0.0), (1, 1, 0.0), (1, 0, 2.0), (2, 2, 0.0), (3, 3, 0.0), (3, 2, -4.0)] {
        entries.add_triplet(i, j, value);
    }
    let mut factor = factored(&entries.to_csr());
    assert_eq!(factor.negative_pivots(), 2);
    assert_eq!(solve(&mut factor, &[1.0, 2.0, 3.0, 4.0]), [1.0, 0.5, -1.0, -0.75]);
}

#[test]
fn unknowns_of_a_point_are_partners() {
    let plate = Plane::new(Plane::lattice(30, |_| true), 3.0, |_, _| true);
    for (components, diagonal) in [(2, 0.0), (2, 1.0e-12), (3, 0.0), (1, 1.0e-8)] {
        let mut matrix = softening(&plate, components, 0.0);
        for i in 0..matrix.rows() {
            *matrix.get_mut(i, i).unwrap() = diagonal;
        }
        // Measured 6e-16; before the refinement 5e-14, and 5e-9 for single unknowns, which have no partner.
        let found = refined(&matrix, &mut factored(&matrix));
        assert!(found < 1.0e-14, "{components} components, {diagonal:e} on the diagonal: {found:e}");
    }
}

#[test]
fn columns_that_vanish_on_the_way_are_solved() {
    // The first pivot leaves a diagonal matrix, without rounding.
    let n = 200;
    let mut entries = TriMat::new((n, n));
    for i in 0..n {
        for j in 0..=i {
            let own = if i == j && i > 0 { if i % 3 == 0 { -2.0 } else { 1.0 } } else { 0.0 };
            let value = [100.0, 50.0, 25.0][usize::from(i > 0) + usize::from(j > 0)];
            entries.add_triplet(i, j, value + own);
        }
    }
    let matrix = entries.to_csr();
    let mut factor = factored(&matrix);
    assert_eq!(factor.negative_pivots(), (1..n).filter(|i| i % 3 == 0).count());
    let found = refined(&matrix, &mut factor);
    assert!(found < 1.0e-13, "{found:e}");
}

#[test]
fn singular_matrices_are_reported() {
    // Nothing holds the unknown in the middle.
    let mut matrix = grid(9, 1.3);
    for (row, mut entries) in matrix.outer_iterator_mut().enumerate() {
        let held = entries.iter_mut().filter(|(column, _)| row == 40 || *column == 40);
        held.for_each(|(_, value)| *value = 0.0);
    }
    let mut factor = SparseIndefinite::analyse(&matrix, Ordering::MinimumDegree).unwrap();
    assert_eq!(factor.refactor(&matrix), Err(FactorError::Singular { index: 40 }));
    // Two unknowns that hold each other only.
    let matrix = two([1.0, -1.0, 1.0]);
    let mut factor = SparseIndefinite::analyse(&matrix, Ordering::MinimumDegree).unwrap();
    assert!(matches!(factor.refactor(&matrix), Err(FactorError::Singular { .. })));
    // The next matrix may be regular again.
    let mut regular = matrix.clone();
    *regular.get_mut(0, 0).unwrap() = -1.0;
    assert_eq!(factor.refactor(&regular), Ok(()));
    assert_eq!(factor.negative_pivots(), 1);
}

#[test]
fn mistakes_are_reported() {
    let oblong = CsMat::<f64>::zero((2, 3));
    let analysis = SparseIndefinite::analyse(&oblong, Ordering::MinimumDegree);
    assert!(matches!(analysis, Err(FactorError::Shape { .. })));
    let mut matrix = grid(6, 1.3);
    let mut factor = factored(&matrix);
    *matrix.get_mut(20, 14).unwrap() = f64::NAN;
    assert_eq!(factor.refactor(&matrix), Err(FactorError::NotFinite { index: 20 }));
    // 1 and -1 - 1 in units that overflow with two.
    let matrix = two([1.0e308, 1.0e308, -1.0e308]);
    let mut factor = SparseIndefinite::analyse(&matrix, Ordering::MinimumDegree).unwrap();
    assert_eq!(factor.refactor(&matrix), Err(FactorError::NotFinite { index: 1 }));
}

#[test]
#[should_panic(expected = "the matrix has the analysed pattern")]
fn another_pattern_is_a_mistake() {
    let _ = factored(&grid(6, 1.3)).refactor(&grid(5, 1.3));
}

#[test]
#[should_panic(expected = "a matrix has been factored")]
fn a_failed_factor_is_not_used() {
    let zero = TriMat::from_triplets((1, 1), vec![0], vec![0], vec![0.0]).to_csr();
    let mut factor = SparseIndefinite::analyse(&zero, Ordering::MinimumDegree).unwrap();
    assert_eq!(factor.refactor(&zero), Err(FactorError::Singular { index: 0 }));
    factor.apply(&[1.0], &mut [0.0]);
}
