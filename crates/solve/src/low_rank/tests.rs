use super::*;
use crate::plane::{Plane, dense, left, negative_eigenvalues, random, wavy};
use crate::{Ordering, SparseIndefinite};
use faer::Mat;
use faer::prelude::Solve;
use sprs::CsMat;

/// Counts the solves.
struct Counted {
    factor: SparseIndefinite,
    solves: usize,
}

impl Counted {
    fn new(matrix: &CsMat<f64>) -> Self {
        let mut factor = SparseIndefinite::analyse(matrix, Ordering::MinimumDegree).unwrap();
        factor.refactor(matrix).unwrap();
        Self { factor, solves: 0 }
    }
}

impl Preconditioner for Counted {
    fn size(&self) -> usize {
        self.factor.size()
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        self.solves += 1;
        self.factor.apply(r, z);
    }
}

/// Small plates, definite and not: 50 unknowns.
fn plates() -> [CsMat<f64>; 2] {
    let plate = Plane::new(Plane::lattice(5, |_| true), 2.0, |_, _| true);
    let mut next = random(3);
    [plate.matrix(2), plate.weighted(2, || if next() < 0.5 { -1.0 } else { 1.0 })]
}

/// Columns of four entries each.
fn columns(count: usize, order: usize) -> Vec<Vec<(usize, f64)>> {
    let mut next = random(17);
    let mut entry = || ((order as f64 * next()) as usize, next() - 0.5);
    (0..count).map(|_| (0..4).map(|_| entry()).collect()).collect()
}

fn changed(matrix: &CsMat<f64>, columns: &[Vec<(usize, f64)>], changes: &[f64]) -> Mat<f64> {
    let mut dense = dense(matrix);
    for (column, change) in columns.iter().zip(changes) {
        for (i, x) in column {
            for (j, y) in column {
                dense[(*i, *j)] += change * x * y;
            }
        }
    }
    dense
}

/// Whatever is changed must be solved as by the dense matrix and have as many negative eigenvalues.
fn agrees(
    low_rank: &mut LowRank,
    factor: &mut Counted,
    matrix: &CsMat<f64>,
    columns: &[Vec<(usize, f64)>],
    changes: &[f64],
) {
    let order = matrix.rows();
    changes.iter().enumerate().for_each(|(index, change)| low_rank.set(index, *change));
    let r = wavy(order);
    let mut z = vec![f64::NAN; order];
    low_rank.apply(factor, &r, &mut z).unwrap();
    let dense = changed(matrix, columns, changes);
    let expected = dense.partial_piv_lu().solve(Mat::from_fn(order, 1, |i, _| r[i]));
    let largest = expected.norm_max();
    for (i, z) in z.iter().enumerate() {
        let error = (z - expected[(i, 0)]).abs() / largest;
        assert!(error < 1.0e-10, "unknown {i}: {error:e}, changes {changes:?}");
    }
    let found = low_rank.negative_eigenvalues(factor.factor.negative_pivots());
    assert_eq!(found, negative_eigenvalues(&dense), "changes {changes:?}");
}

#[test]
fn columns_come_and_go() {
    for matrix in plates() {
        let columns = columns(12, matrix.rows());
        let mut factor = Counted::new(&matrix);
        let mut low_rank = LowRank::new(matrix.rows());
        let mut next = random(29);
        for (index, column) in columns.iter().enumerate() {
            assert_eq!(low_rank.push(&mut factor, column), index);
            assert_eq!(low_rank.rank(), index + 1);
            for _ in 0..4 {
                let change = |_| if next() < 0.3 { 0.0 } else { 40.0 * (next() - 0.5) };
                let changes: Vec<f64> = (0..=index).map(change).collect();
                agrees(&mut low_rank, &mut factor, &matrix, &columns[..=index], &changes);
            }
        }
        // Without changes it is the factor, to the last bit.
        (0..12).for_each(|index| low_rank.set(index, 0.0));
        let (mut z, mut expected) = (vec![0.0; matrix.rows()], vec![0.0; matrix.rows()]);
        low_rank.apply(&mut factor, &wavy(matrix.rows()), &mut z).unwrap();
        factor.apply(&wavy(matrix.rows()), &mut expected);
        assert_eq!(z, expected);
    }
}

#[test]
fn the_rank_may_be_the_order() {
    for matrix in plates() {
        let order = matrix.rows();
        let columns: Vec<_> = (0..order).map(|i| vec![(i, 1.0), ((i + 1) % order, 0.5)]).collect();
        let mut factor = Counted::new(&matrix);
        let mut low_rank = LowRank::new(order);
        for column in &columns {
            low_rank.push(&mut factor, column);
        }
        let mut next = random(31);
        for _ in 0..5 {
            let changes: Vec<f64> = (0..order).map(|_| 60.0 * (next() - 0.5)).collect();
            agrees(&mut low_rank, &mut factor, &matrix, &columns, &changes);
        }
    }
}

#[test]
fn tiny_and_huge_changes_are_solved() {
    for matrix in plates() {
        let columns = columns(6, matrix.rows());
        let mut factor = Counted::new(&matrix);
        let mut low_rank = LowRank::new(matrix.rows());
        for column in &columns {
            low_rank.push(&mut factor, column);
        }
        let (r, mut z) = (wavy(matrix.rows()), vec![0.0; matrix.rows()]);
        for changes in [
            [1.0e-300, -1.0e-300, 5.0e-324, -5.0e-324, 0.0, 1.0],
            [1.0e12, -1.0e12, 1.0e-12, -1.0e-12, 1.0, -1.0],
            [1.0e300, 1.0e-300, f64::MAX, -1.0e200, -0.5, 0.0],
        ] {
            changes.iter().enumerate().for_each(|(index, change)| low_rank.set(index, *change));
            low_rank.apply(&mut factor, &r, &mut z).unwrap();
            // A change takes the force c v (v z); whatever is huge holds its column.
            let mut rest = left(&matrix, &z, &r);
            for (column, change) in columns.iter().zip(changes) {
                let elongation: f64 = column.iter().map(|(i, v)| v * z[*i]).sum();
                if change.abs() < 1.0e3 {
                    column.iter().for_each(|(i, v)| rest[*i] -= change * elongation * v);
                } else {
                    assert!(elongation.abs() < 1.0e-11, "{elongation:e}");
                }
            }
            // What is left are the forces of the columns held.
            let held: Vec<_> = columns.iter().zip(changes).filter(|(_, c)| c.abs() > 1.0e3).collect();
            let touched = |i: usize| held.iter().any(|(column, _)| column.iter().any(|(j, _)| *j == i));
            for (i, r) in rest.iter().enumerate().filter(|(i, _)| !touched(*i)) {
                assert!(r.abs() < 1.0e-10, "unknown {i}: {r:e}");
            }
        }
    }
}

#[test]
fn a_column_costs_one_solve_and_so_does_a_right_hand_side() {
    let [matrix, _] = plates();
    let mut factor = Counted::new(&matrix);
    let mut low_rank = LowRank::new(matrix.rows());
    let mut z = vec![0.0; matrix.rows()];
    for (index, column) in columns(7, matrix.rows()).iter().enumerate() {
        let before = factor.solves;
        low_rank.push(&mut factor, column);
        assert_eq!(factor.solves, before + 1);
        for change in [1.0, -0.1, 0.0, 3.0] {
            low_rank.set(index, change);
            low_rank.negative_eigenvalues(0);
            let before = factor.solves;
            low_rank.apply(&mut factor, &wavy(50), &mut z).unwrap();
            assert_eq!(factor.solves, before + 1);
        }
    }
}

#[test]
fn a_matrix_that_becomes_singular_is_reported() {
    // The identity less the square of a unit vector.
    let identity = CsMat::eye(6);
    let mut factor = Counted::new(&identity);
    let mut low_rank = LowRank::new(6);
    let half = 0.5_f64.sqrt();
    low_rank.push(&mut factor, &[(0, 1.0)]);
    low_rank.push(&mut factor, &[(4, half), (2, -half)]);
    let mut z = [0.0; 6];
    low_rank.set(0, 7.0);
    low_rank.set(1, -1.0);
    let outcome = low_rank.apply(&mut factor, &[1.0; 6], &mut z);
    assert_eq!(outcome, Err(FactorError::Singular { index: 4 }));
    // Less of it, and more.
    for (change, negative) in [(-0.5, 0), (-2.0, 1)] {
        low_rank.set(1, change);
        low_rank.apply(&mut factor, &[0.0, 0.0, 1.0, 0.0, -1.0, 8.0], &mut z).unwrap();
        let expected = [0.0, 0.0, 1.0 / (1.0 + change), 0.0, -1.0 / (1.0 + change), 8.0];
        for (z, x) in z.iter().zip(expected) {
            assert!((z - x).abs() < 1.0e-14);
        }
        assert_eq!(low_rank.negative_eigenvalues(0), negative);
    }
}

#[test]
fn an_equal_column_adds_up() {
    let [matrix, _] = plates();
    let column = columns(1, matrix.rows()).remove(0);
    let both = vec![column.clone(), column];
    let mut factor = Counted::new(&matrix);
    let mut low_rank = LowRank::new(matrix.rows());
    for column in &both {
        low_rank.push(&mut factor, column);
    }
    for changes in [[2.0, 3.0], [5.0, -5.0], [1.0e6, -0.5e6]] {
        agrees(&mut low_rank, &mut factor, &matrix, &both, &changes);
    }
}

#[test]
fn clearing_forgets_the_columns() {
    let [matrix, other] = plates();
    let columns = columns(3, matrix.rows());
    let mut low_rank = LowRank::new(matrix.rows());
    for matrix in [matrix, other] {
        let mut factor = Counted::new(&matrix);
        low_rank.clear();
        assert_eq!(low_rank.rank(), 0);
        agrees(&mut low_rank, &mut factor, &matrix, &[], &[]);
        for column in &columns {
            low_rank.push(&mut factor, column);
        }
        agrees(&mut low_rank, &mut factor, &matrix, &columns, &[1.0, -2.0, 3.0]);
        assert!(low_rank.bytes() >= 3 * 8 * matrix.rows());
    }
}

#[test]
#[should_panic(expected = "a change is finite")]
fn an_infinite_change_is_a_mistake() {
    let mut factor = Counted::new(&CsMat::eye(2));
    let mut low_rank = LowRank::new(2);
    low_rank.push(&mut factor, &[(0, 1.0)]);
    low_rank.set(0, f64::INFINITY);
}
