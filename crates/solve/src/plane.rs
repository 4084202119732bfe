//! Matrices of plane lattices and clouds for tests.

use crate::{PointGraph, Preconditioner};
use faer::{Mat, Side};
use sprs::{CsMat, TriMat};

/// Points of a plane and the pairs that are coupled.
pub(crate) struct Plane {
    pub(crate) positions: Vec<[f64; 2]>,
    pub(crate) pairs: Vec<[usize; 2]>,
}

/// Deterministic numbers in 0..1 (multiplicative congruence of Lewis, Goodman and Miller).
pub(crate) fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state * 16_807 % 2_147_483_647;
        state as f64 / 2_147_483_647.0
    }
}

impl Plane {
    /// Pairs of given points up to a distance that are coupled.
    pub(crate) fn new(
        positions: Vec<[f64; 2]>,
        reach: f64,
        coupled: impl Fn([f64; 2], [f64; 2]) -> bool,
    ) -> Self {
        let mut pairs = Vec::new();
        for (i, a) in positions.iter().enumerate() {
            for (j, b) in positions.iter().enumerate().take(i) {
                if (a[0] - b[0]).hypot(a[1] - b[1]) <= reach && coupled(*a, *b) {
                    pairs.push([i, j]);
                }
            }
        }
        Self { positions, pairs }
    }

    /// Cells of a square lattice that are inside.
    pub(crate) fn lattice(side: usize, inside: impl Fn([f64; 2]) -> bool) -> Vec<[f64; 2]> {
        (0..side * side).map(|k| [(k % side) as f64, (k / side) as f64]).filter(|x| inside(*x)).collect()
    }

    /// Lattices and clouds of every awkward kind, with names.
    pub(crate) fn gallery() -> Vec<(&'static str, Self)> {
        let all = |_: [f64; 2], _: [f64; 2]| true;
        let mut next = random(7);
        let cloud: Vec<[f64; 2]> = (0..900).map(|_| [30.0 * next(), 30.0 * next()]).collect();
        let coincident = Self::lattice(20, |_| true).into_iter().map(|[x, y]| [x.min(3.0), y]).collect();
        let hole = |[x, y]: [f64; 2]| (x - 15.0).hypot(y - 12.0) > 6.0;
        // Above the middle row nothing is coupled across the column 14.5.
        let slit = |a: [f64; 2], b: [f64; 2]| (a[0] < 14.5) == (b[0] < 14.5) || a[1].min(b[1]) < 15.0;
        let apart = |a: [f64; 2], b: [f64; 2]| (a[0] < 14.5) == (b[0] < 14.5);
        let lonely = |a: [f64; 2], b: [f64; 2]| a[0] + b[0] < 40.0;
        vec![
            ("plate", Self::new(Self::lattice(30, |_| true), 3.0, all)),
            ("hole", Self::new(Self::lattice(30, hole), 3.0, all)),
            ("slit", Self::new(Self::lattice(30, |_| true), 3.0, slit)),
            ("apart", Self::new(Self::lattice(30, |_| true), 3.0, apart)),
            ("lonely points", Self::new(Self::lattice(30, |_| true), 2.0, lonely)),
            ("cloud", Self::new(cloud, 3.0, all)),
            ("coincident points", Self::new(coincident, 2.0, all)),
            ("row", Self::new((0..300).map(|k| [f64::from(k), 0.0]).collect(), 3.0, all)),
            ("few points", Self::new(Self::lattice(3, |_| true), 1.0, all)),
            ("one place", Self::new(vec![[1.0, 2.0]; 90], 1.0, all)),
            ("no points", Self::new(Vec::new(), 1.0, all)),
        ]
    }

    /// Lower triangle of a positive definite matrix with `components` unknowns per point: of each pair a random
    /// square of the difference, and the identity.
    pub(crate) fn matrix(&self, components: usize) -> CsMat<f64> {
        self.weighted(components, || 1.0)
    }

    /// The same with a weight for each pair, which may be negative.
    pub(crate) fn weighted(&self, components: usize, mut weight: impl FnMut() -> f64) -> CsMat<f64> {
        let (points, mut next) = (self.positions.len(), random(11));
        let mut entries = TriMat::new((points * components, points * components));
        for [p, q] in &self.pairs {
            let w = weight();
            let rows: Vec<(usize, f64)> = (0..components)
                .map(|c| (c * points, next() - 0.3))
                .flat_map(|(plane, x)| [(plane + p, x), (plane + q, -x)])
                .collect();
            for (i, x) in &rows {
                for (j, y) in rows.iter().filter(|(j, _)| j <= i) {
                    entries.add_triplet(*i, *j, w * x * y);
                }
            }
        }
        (0..points * components).for_each(|i| entries.add_triplet(i, i, 1.0));
        entries.to_csr()
    }

    pub(crate) fn graph(&self) -> PointGraph {
        PointGraph::from_matrix(&self.matrix(1), 1)
    }
}

/// `r - A x` (lower triangle).
pub(crate) fn left(matrix: &CsMat<f64>, x: &[f64], r: &[f64]) -> Vec<f64> {
    let mut left = r.to_vec();
    for (value, (i, j)) in matrix {
        left[i] -= value * x[j];
        if i != j {
            left[j] -= value * x[i];
        }
    }
    left
}

/// A right-hand side of size 1.
pub(crate) fn wavy(order: usize) -> Vec<f64> {
    (0..order).map(|i| (i as f64 * 0.7).sin()).collect()
}

/// Largest residual of `A x = b` with a wavy `b` of size 1 (lower triangle).
pub(crate) fn residual(matrix: &CsMat<f64>, factor: &mut impl Preconditioner) -> f64 {
    let b = wavy(matrix.rows());
    let mut x = vec![f64::NAN; b.len()];
    factor.apply(&b, &mut x);
    let left = left(matrix, &x, &b);
    left.into_iter().fold(0.0, |most, r| if r.abs() <= most { most } else { r.abs() })
}

/// The whole matrix, given its lower triangle.
pub(crate) fn dense(matrix: &CsMat<f64>) -> Mat<f64> {
    let mut dense = Mat::zeros(matrix.rows(), matrix.rows());
    for (value, (i, j)) in matrix {
        dense[(i, j)] = *value;
        dense[(j, i)] = *value;
    }
    dense
}

/// Number of negative eigenvalues of a matrix that has none near zero.
pub(crate) fn negative_eigenvalues(matrix: &Mat<f64>) -> usize {
    let values = matrix.self_adjoint_eigenvalues(Side::Lower).expect("finite entries");
    assert!(values.iter().all(|value| value.abs() > 1.0e-9), "a test with an eigenvalue near zero");
    values.iter().filter(|value| **value < 0.0).count()
}
