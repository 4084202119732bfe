//! From a system to its factor: assembled in the layout that suits it, lifted where rounding made it indefinite.

use super::report::{Counters, Timing};
use super::solve_failure::SolveFailure;
use super::solver_report::SolverReport;
use crate::case::Solver;
use peristat_assembly::system::System;
use peristat_solve::{
    BandCholesky, BandMatrix, DissectedCholesky, FactorError, Method, Ordering, PointGraph, Preconditioner,
    Profile, SparseCholesky, SparseIndefinite, choose, nested_dissection,
};
use sprs::CsMat;
use std::time::Instant;

/// The stiffness in the layout of its method.
enum Matrix {
    /// Half bandwidth and values of a lower band.
    Band(usize, Vec<f64>),
    /// Compressed rows of the lower triangle.
    Sparse(CsMat<f64>),
}

/// Assembles and factors the constrained stiffness; `positions` are those of points that spread in a plane.
///
/// # Errors
/// [`SolveFailure`] if it has no factor.
pub(super) fn factor<const D: usize>(
    system: &System<D>,
    solver: Solver,
    positions: Option<&[[f64; 2]]>,
    timing: &mut Timing,
    counters: &mut Counters,
) -> Result<(Box<dyn Preconditioner>, SolverReport), SolveFailure> {
    let begin = Instant::now();
    let (assembled, method, reason) = assemble(system, solver);
    timing.assemble += begin.elapsed().as_secs_f64();
    let begin = Instant::now();
    let (factor, bytes): (Box<dyn Preconditioner>, usize) = match assembled {
        Matrix::Band(half_bandwidth, values) => {
            let mut first = Some((half_bandwidth, values));
            // The factor overwrites its matrix.
            let mut matrix =
                || match first.take().map_or_else(|| assemble(system, solver).0, |(b, v)| Matrix::Band(b, v))
                {
                    Matrix::Band(half_bandwidth, values) => {
                        BandMatrix { order: system.size(), half_bandwidth, values }
                    }
                    Matrix::Sparse(_) => unreachable!("the same system has the same layout"),
                };
            let factor = lifted(&LIFTS, counters, |lift| {
                let mut matrix = matrix();
                if lift > 0.0 {
                    matrix.lift_diagonal(lift);
                }
                BandCholesky::factor(matrix, D)
            });
            let factor = factor.map_err(|e| failure(system, e))?;
            let bytes = factor.bytes();
            (Box::new(factor), bytes)
        }
        Matrix::Sparse(mut matrix) => {
            counters.analyses += 1;
            let mut factor = SparseFactor::analyse::<D>(&matrix, positions).map_err(SolveFailure::Factor)?;
            let diagonal = matrix.diag();
            let done = lifted(&LIFTS, counters, |lift| {
                for (k, value) in diagonal.iter() {
                    matrix.set(k, k, value * (1.0 + lift));
                }
                factor.refactor(&matrix)
            });
            done.map_err(|e| failure(system, e))?;
            let bytes = factor.bytes();
            (Box::new(factor), bytes)
        }
    };
    timing.factor += begin.elapsed().as_secs_f64();
    counters.factor_bytes = bytes;
    let report = SolverReport { method, reason, factor_entries: bytes / 8, ..SolverReport::default() };
    Ok((factor, report))
}

/// A factor of a sparse matrix.
pub(super) enum SparseFactor {
    Whole(Box<SparseCholesky>),
    /// By halves.
    Dissected(Box<DissectedCholesky>),
}

impl SparseFactor {
    /// Points in a plane below which two threads cost more than they bring. How many threads there are does not count:
    /// the other factor rounds otherwise, and a body that softens may take another path.
    const FEW: usize = 2000;

    pub(super) fn analyse<const D: usize>(
        matrix: &CsMat<f64>,
        positions: Option<&[[f64; 2]]>,
    ) -> Result<Self, FactorError> {
        let Some(positions) = positions else {
            let ordering = Ordering::MinimumDegreeOfPoints { components: D };
            return SparseCholesky::analyse(matrix, ordering).map(Box::new).map(Self::Whole);
        };
        let dissection = nested_dissection(positions, &PointGraph::from_matrix(matrix, D));
        match positions.len() > Self::FEW {
            true => DissectedCholesky::analyse(matrix, &dissection, D).map(Box::new).map(Self::Dissected),
            false => {
                let ordering = Ordering::Points { order: dissection.order(), components: D };
                SparseCholesky::analyse(matrix, ordering).map(Box::new).map(Self::Whole)
            }
        }
    }

    pub(super) fn refactor(&mut self, matrix: &CsMat<f64>) -> Result<(), FactorError> {
        match self {
            Self::Whole(factor) => factor.refactor(matrix),
            Self::Dissected(factor) => factor.refactor(matrix),
        }
    }

    /// A factor for matrices of this pattern that are not positive definite.
    pub(super) fn indefinite<const D: usize>(
        &self,
        matrix: &CsMat<f64>,
        positions: Option<&[[f64; 2]]>,
    ) -> Result<SparseIndefinite, FactorError> {
        match (self, positions) {
            (Self::Whole(factor), _) => SparseIndefinite::of(factor, matrix),
            (Self::Dissected(_), Some(positions)) => {
                let dissection = nested_dissection(positions, &PointGraph::from_matrix(matrix, D));
                let ordering = Ordering::Points { order: dissection.order(), components: D };
                SparseIndefinite::analyse(matrix, ordering)
            }
            (Self::Dissected(_), None) => {
                SparseIndefinite::analyse(matrix, Ordering::MinimumDegreeOfPoints { components: D })
            }
        }
    }

    pub(super) fn bytes(&self) -> usize {
        match self {
            Self::Whole(factor) => factor.bytes(),
            Self::Dissected(factor) => factor.bytes(),
        }
    }
}

impl Preconditioner for SparseFactor {
    fn size(&self) -> usize {
        match self {
            Self::Whole(factor) => factor.size(),
            Self::Dissected(factor) => factor.size(),
        }
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        match self {
            Self::Whole(factor) => factor.apply(r, z),
            Self::Dissected(factor) => factor.apply(r, z),
        }
    }
}

/// Relative lifts of the diagonal, tried in this order: the smallest that makes the factor exist costs the fewest
/// iterations.
const LIFTS: [f64; 5] = [0.0, f64::EPSILON, 2.0 * f64::EPSILON, 4.0 * f64::EPSILON, 8.0 * f64::EPSILON];

/// The first factor that exists when the diagonal is lifted by one part of itself after the other, of which there is one at
/// least: by nothing or by a few units in the last place.
///
/// On a long uniform beam the rounding of equal rows adds up instead of averaging out, and the rounded matrix can have
/// negative eigenvalues although the stiffness has none. The lift is of the size of that rounding; conjugate gradients
/// on the bonds take it out again. A matrix that fails all the same is not positive definite.
pub(super) fn lifted<T>(
    lifts: &[f64],
    counters: &mut Counters,
    mut attempt: impl FnMut(f64) -> Result<T, FactorError>,
) -> Result<T, FactorError> {
    let mut outcome = attempt(lifts[0]);
    counters.factorisations += 1;
    for lift in &lifts[1..] {
        let Err(FactorError::NonPositivePivot { .. }) = outcome else { break };
        counters.factorisations += 1;
        outcome = attempt(*lift);
    }
    outcome
}

/// The constrained stiffness in the layout of the method that suits it.
fn assemble<const D: usize>(system: &System<D>, solver: Solver) -> (Matrix, String, String) {
    let sparse = if system.constraints().has_slaves() { Some(system.assemble_sparse()) } else { None };
    let profile = match &sparse {
        Some(k) => profile::<D>(k),
        None => Profile {
            unknowns: system.size(),
            half_bandwidth: D * (system.reach() + 1) - 1,
            entries: system.points() * D * (D + 1) / 2 + system.elements() * D * D,
        },
    };
    let (method, reason) = match solver {
        Solver::Auto | Solver::Strain | Solver::Multigrid | Solver::Pcg => choose(&profile),
        Solver::Band => (Method::Band, "the case asks for it".into()),
        Solver::Sparse => (Method::Sparse, "the case asks for it".into()),
    };
    let assembled = match (method, sparse) {
        (Method::Band, None) => {
            let (half_bandwidth, values) = system.assemble_band();
            Matrix::Band(half_bandwidth, values)
        }
        (Method::Band, Some(k)) => band::<D>(&k, profile.half_bandwidth),
        (Method::Sparse, k) => Matrix::Sparse(k.unwrap_or_else(|| system.assemble_sparse())),
    };
    let name = match method {
        Method::Band => "band_cholesky",
        Method::Sparse => "sparse_cholesky",
    };
    (assembled, name.into(), reason)
}

/// Number of an unknown when the components of a point stand together.
fn interleaved<const D: usize>(unknown: usize, size: usize) -> usize {
    let points = size / D;
    D * (unknown % points) + unknown / points
}

fn profile<const D: usize>(k: &CsMat<f64>) -> Profile {
    let size = k.rows();
    let distance =
        |(_, (i, j)): (&f64, (usize, usize))| interleaved::<D>(i, size).abs_diff(interleaved::<D>(j, size));
    let half_bandwidth = k.iter().map(distance).max().unwrap_or(0);
    Profile { unknowns: size, half_bandwidth, entries: k.nnz() }
}

/// A lower triangle in compressed rows as a lower band of interleaved unknowns.
fn band<const D: usize>(k: &CsMat<f64>, half_bandwidth: usize) -> Matrix {
    let size = k.rows();
    let width = half_bandwidth + 1;
    let mut values = vec![0.0; size * width];
    for (&value, (i, j)) in k {
        let (i, j) = (interleaved::<D>(i, size), interleaved::<D>(j, size));
        values[i.min(j) * width + i.abs_diff(j)] = value;
    }
    Matrix::Band(half_bandwidth, values)
}

pub(super) fn failure<const D: usize>(system: &System<D>, error: FactorError) -> SolveFailure {
    match error {
        FactorError::NonPositivePivot { index, count } => SolveFailure::NotPositiveDefinite {
            count,
            component: index / system.points(),
            point: index % system.points(),
        },
        other => SolveFailure::Factor(other),
    }
}
