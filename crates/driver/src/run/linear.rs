//! A factored system and its solutions.

use super::{Counters, Timing};
use crate::case::Solver;
use peristat_assembly::system::{Assembled, System};
use peristat_solve::{
    BandCholesky, BandMatrix, FactorError, LinearOperator, Method, Pcg, PcgOptions, PcgStatus,
    Preconditioner, Profile, SparseCholesky, choose,
};
use sprs::CsMat;
use std::time::Instant;
use thiserror::Error;

/// The element-wise stiffness of a system as the solver sees it.
struct Elementwise<'a, const D: usize>(&'a System<D>);

impl<const D: usize> LinearOperator for Elementwise<'_, D> {
    fn size(&self) -> usize {
        self.0.size()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        self.0.product(x, y);
    }
}

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

/// Unknowns of one state with the record of how they were found.
#[derive(Clone, Debug)]
pub(super) struct StateSolution {
    /// `D` component planes.
    pub(super) u: Vec<f64>,
    /// Energy of the prescribed motions as a sudden jump of the constrained unknowns alone; 0 without such motions.
    pub(super) jump_energy: f64,
    /// Forces of the constraints on the unknowns they hold and on their masters, by number of the unknown.
    pub(super) held: Vec<(usize, f64)>,
    /// Largest element-wise residual per component, constrained unknowns left out.
    pub(super) residual: Vec<f64>,
    /// The correction that one more solve with the factor would make, relative to the unknowns.
    pub(super) next_correction: f64,
    /// Size of all corrections after the first solve with the factor, relative to the solution, in energy norm.
    pub(super) first_correction: f64,
    /// Iterations of all passes.
    pub(super) iterations: usize,
    /// How the last pass ended.
    pub(super) status: PcgStatus,
}

/// A system with its factor: one factorisation, any number of right-hand sides.
pub struct LinearSolver<'a, const D: usize> {
    system: &'a System<D>,
    factor: Box<dyn Preconditioner>,
    pcg: Pcg,
    residual: Vec<f64>,
    scales: [f64; D],
    report: SolverReport,
    counters: Counters,
}

/// Passes of conjugate gradients on the true residual.
const PASSES: usize = 4;
/// A next correction below this ends the passes: rounding of the unknowns themselves.
const CONVERGED: f64 = 1e-13;

impl<'a, const D: usize> LinearSolver<'a, D> {
    /// Assembles and factors. `scales` are displacements of each component that count as equally large.
    ///
    /// # Errors
    /// [`SolveFailure`] if the stiffness has no factor.
    pub fn new(
        system: &'a System<D>,
        scales: [f64; D],
        solver: Solver,
        timing: &mut Timing,
    ) -> Result<Self, SolveFailure> {
        let begin = Instant::now();
        let (assembled, method, reason) = assemble(system, solver);
        timing.assemble = begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        let mut counters = Counters { factorisations: 1, ..Default::default() };
        let (factor, bytes): (Box<dyn Preconditioner>, usize) = match assembled {
            Assembled::Band { half_bandwidth, values } => {
                let matrix = BandMatrix { order: system.size(), half_bandwidth, values };
                let factor = BandCholesky::factor(matrix, D)
                    .or_else(|error| lifted(system, solver, error, &mut counters))
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
        Ok(Self {
            system,
            factor,
            pcg: Pcg::new(system.size()),
            residual: vec![0.0; system.size()],
            scales,
            report,
            counters,
        })
    }

    /// Method, reason and iterations so far.
    pub fn report(&self) -> &SolverReport {
        &self.report
    }

    /// Counters so far.
    pub fn counters(&self) -> &Counters {
        &self.counters
    }

    /// Unknowns under a load (`D` planes) and `motion_factor` times the prescribed motions.
    ///
    /// Every pass solves for the correction of the true, element-wise residual. Without prescribed motions the first
    /// pass is nearly always the last; with them the first residual is that of a sudden jump and carries its rounding,
    /// so a second pass starts from the smooth solution.
    pub(super) fn solve(&mut self, load: &[f64], motion_factor: f64) -> StateSolution {
        let constraints = self.system.constraints();
        let mut solution = StateSolution {
            u: vec![0.0; self.system.size()],
            jump_energy: 0.0,
            held: Vec::new(),
            residual: Vec::new(),
            next_correction: f64::INFINITY,
            first_correction: 0.0,
            iterations: 0,
            status: PcgStatus::Converged,
        };
        let operator = Elementwise(self.system);
        if constraints.moves() {
            constraints.expand(motion_factor, &mut solution.u);
            solution.jump_energy = self.system.survey(&solution.u).energy;
            self.refresh_residual(load, &solution.u);
        } else {
            self.residual.copy_from_slice(load);
        }
        constraints.restrict(&mut self.residual);
        for pass in 0..PASSES {
            let (factor, options) = (&mut *self.factor, PcgOptions::default());
            let report = self.pcg.solve(&operator, factor, &mut self.residual, &mut solution.u, &options);
            if pass == 0 {
                solution.first_correction = report.first_correction;
            }
            solution.iterations += report.iterations;
            solution.status = report.status;
            constraints.expand(motion_factor, &mut solution.u);
            self.refresh_residual(load, &solution.u);
            solution.held = self.constraint_forces();
            constraints.restrict(&mut self.residual);
            let correction = self.pcg.precondition(&mut *self.factor, &self.residual);
            let next =
                size(correction, &self.scales) / size(&solution.u, &self.scales).max(f64::MIN_POSITIVE);
            let settled = next <= CONVERGED && !(pass == 0 && constraints.moves());
            let stalled = next >= 0.1 * solution.next_correction;
            solution.next_correction = next;
            if settled || stalled || !next.is_finite() {
                break;
            }
        }
        let n = self.system.points();
        solution.residual = (0..D).map(|c| largest(&self.residual[c * n..][..n])).collect();
        self.counters.right_hand_sides += 1;
        self.counters.pcg_iterations += solution.iterations;
        self.report.iterations.push(solution.iterations);
        solution
    }

    /// The residual `load − F(u)`, whole: forces of constraints, negative, on what they hold.
    fn refresh_residual(&mut self, load: &[f64], u: &[f64]) {
        self.system.force(u, &mut self.residual);
        self.residual.iter_mut().zip(load).for_each(|(r, f)| *r = f - *r);
    }

    /// Forces of constraints from a whole residual, on the unknowns they hold and on their masters.
    fn constraint_forces(&self) -> Vec<(usize, f64)> {
        let rows = self.system.constraints().rows();
        let mut held: Vec<usize> = rows.iter().map(|r| r.unknown).collect();
        held.extend(rows.iter().flat_map(|r| r.masters.iter().map(|m| m.0)));
        held.sort_unstable();
        held.dedup();
        held.into_iter().map(|k| (k, -self.residual[k])).collect()
    }
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

/// Largest magnitude; infinite if an entry is not a number.
fn largest(v: &[f64]) -> f64 {
    const LANES: usize = 8;
    // Comparisons pass over what is not a number; the sum of products with zero does not.
    let (mut most, mut odd) = ([0.0_f64; LANES], [0.0_f64; LANES]);
    let mut take = |chunk: &[f64]| {
        for ((most, odd), x) in most.iter_mut().zip(&mut odd).zip(chunk) {
            *most = if x.abs() > *most { x.abs() } else { *most };
            *odd += 0.0 * x;
        }
    };
    let (chunks, rest) = v.as_chunks::<LANES>();
    chunks.iter().for_each(|c| take(c));
    take(rest);
    if odd.iter().sum::<f64>() == 0.0 { most.into_iter().fold(0.0, f64::max) } else { f64::INFINITY }
}

/// Largest entry of a vector of unknowns with every component in units of its scale.
fn size<const D: usize>(v: &[f64], scales: &[f64; D]) -> f64 {
    let n = v.len() / D;
    (0..D).map(|c| largest(&v[c * n..][..n]) / scales[c]).fold(0.0, f64::max)
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
