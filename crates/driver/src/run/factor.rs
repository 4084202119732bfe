//! From a system to its factor: assembled in the layout that suits it, lifted where rounding made it indefinite.

use super::{Counters, Timing};
use crate::case::Solver;
use peristat_assembly::system::{Assembled, System};
use peristat_solve::{
    BandCholesky, BandMatrix, FactorError, Method, Preconditioner, Profile, SparseCholesky, choose,
};
use sprs::CsMat;
use std::time::Instant;
use thiserror::Error;

/// The stiffness cannot be factored.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SolveFailure {
    /// A pivot is not positive.
    #[error(
        "the stiffness is not positive definite: {count} pivots are not positive, the first at component {component} of point {point}"
    )]
    NotPositiveDefinite {
        /// Number of pivots.
        count: usize,
        /// Component of the first.
        component: usize,
        /// Point of the first.
        point: usize,
    },
    /// Anything else.
    #[error(transparent)]
    Factor(FactorError),
}

/// What was taken to solve, and why.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct SolverReport {
    /// `band_cholesky` or `sparse_cholesky`, finished by conjugate gradients.
    pub method: String,
    /// Why.
    pub reason: String,
    /// Entries of the factor.
    pub factor_entries: usize,
    /// Conjugate-gradient iterations per state.
    pub iterations: Vec<usize>,
}

/// Assembles and factors the constrained stiffness.
///
/// # Errors
/// [`SolveFailure`] if it has no factor.
pub(super) fn factor<const D: usize>(
    system: &System<D>,
    solver: Solver,
    timing: &mut Timing,
    counters: &mut Counters,
) -> Result<(Box<dyn Preconditioner>, SolverReport), SolveFailure> {
    let begin = Instant::now();
    let (assembled, method, reason) = assemble(system, solver);
    timing.assemble = begin.elapsed().as_secs_f64();
    let begin = Instant::now();
    counters.factorisations = 1;
    let (factor, bytes): (Box<dyn Preconditioner>, usize) = match assembled {
        Assembled::Band { half_bandwidth, values } => {
            let matrix = BandMatrix { order: system.size(), half_bandwidth, values };
            let factor = BandCholesky::factor(matrix, D)
                .or_else(|error| lifted(system, solver, error, counters))
                .map_err(|e| failure(system, e))?;
            let bytes = factor.bytes();
            (Box::new(factor), bytes)
        }
        Assembled::Sparse(matrix) => {
            counters.analyses = 1;
            let mut factor = SparseCholesky::analyse(&matrix).map_err(SolveFailure::Factor)?;
            factor.refactor(&matrix).map_err(|e| failure(system, e))?;
            let bytes = factor.bytes();
            (Box::new(factor), bytes)
        }
    };
    timing.factor = begin.elapsed().as_secs_f64();
    counters.factor_bytes = bytes;
    let report = SolverReport { method, reason, factor_entries: bytes / 8, iterations: Vec::new() };
    Ok((factor, report))
}

/// Relative lifts of the diagonal, tried in this order: the smallest that makes the factor exist costs the fewest
/// iterations.
const LIFTS: [f64; 4] = [f64::EPSILON, 2.0 * f64::EPSILON, 4.0 * f64::EPSILON, 8.0 * f64::EPSILON];

/// The band factor with its diagonal lifted by a few units in the last place, after a first try ended with `error`.
///
/// On a long uniform beam the rounding of equal rows adds up instead of averaging out, and the rounded matrix can have
/// negative eigenvalues although the stiffness has none. The lift is of the size of that rounding; conjugate gradients
/// on the bonds take it out again. A matrix that fails all the same is not positive definite.
fn lifted<const D: usize>(
    system: &System<D>,
    solver: Solver,
    mut error: FactorError,
    counters: &mut Counters,
) -> Result<BandCholesky, FactorError> {
    for lift in LIFTS {
        let FactorError::NonPositivePivot { .. } = error else { break };
        let Assembled::Band { half_bandwidth, values } = assemble(system, solver).0 else {
            unreachable!("the same system has the same layout");
        };
        let mut matrix = BandMatrix { order: system.size(), half_bandwidth, values };
        matrix.lift_diagonal(lift);
        counters.factorisations += 1;
        match BandCholesky::factor(matrix, D) {
            Ok(factor) => return Ok(factor),
            Err(again) => error = again,
        }
    }
    Err(error)
}

/// The constrained stiffness in the layout of the method that suits it.
fn assemble<const D: usize>(system: &System<D>, solver: Solver) -> (Assembled, String, String) {
    let sparse = if system.constraints().has_slaves() { Some(system.assemble_sparse()) } else { None };
    let profile = match &sparse {
        Some(Assembled::Sparse(k)) => profile::<D>(k),
        _ => Profile {
            unknowns: system.size(),
            half_bandwidth: D * (system.reach() + 1) - 1,
            entries: system.points() * D * (D + 1) / 2 + system.elements() * D * D,
        },
    };
    let (method, reason) = match solver {
        Solver::Auto => choose(&profile),
        Solver::Band => (Method::Band, "the case asks for it".into()),
        Solver::Sparse => (Method::Sparse, "the case asks for it".into()),
    };
    let assembled = match (method, sparse) {
        (Method::Band, None) => system.assemble_band(),
        (Method::Band, Some(Assembled::Sparse(k))) => band::<D>(&k, profile.half_bandwidth),
        (_, Some(sparse)) => sparse,
        (Method::Sparse, None) => system.assemble_sparse(),
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
    Profile { unknowns: size, half_bandwidth, entries: (k.nnz() + size) / 2 }
}

/// A matrix in compressed rows as a lower band.
fn band<const D: usize>(k: &CsMat<f64>, half_bandwidth: usize) -> Assembled {
    let size = k.rows();
    let width = half_bandwidth + 1;
    let mut values = vec![0.0; size * width];
    for (&value, (i, j)) in k {
        let (i, j) = (interleaved::<D>(i, size), interleaved::<D>(j, size));
        if i >= j {
            values[j * width + i - j] = value;
        }
    }
    Assembled::Band { half_bandwidth, values }
}

fn failure<const D: usize>(system: &System<D>, error: FactorError) -> SolveFailure {
    match error {
        FactorError::NonPositivePivot { index, count } => SolveFailure::NotPositiveDefinite {
            count,
            component: index / system.points(),
            point: index % system.points(),
        },
        other => SolveFailure::Factor(other),
    }
}
