//! Conjugate gradients of PETSc with the products of the program.

use crate::check::{int, petsc};
use crate::error::PetscError;
use crate::ffi::{self, Product};
use crate::handle::Handle;
use crate::session::Session;
use crate::shell::{OperatorShell, PreconditionerShell, multiply, precondition};
use peristat_solve::{LinearOperator, PcgOptions, PcgReport, PcgStatus, Preconditioner, Ranks};
use std::ptr;

/// A growth of the residual that no solve comes back from.
const GROWTH: f64 = 1e30;

/// Solves `A x = b` from zero, as [`Ranks::conjugate_gradients`] says.
///
/// # Errors
/// [`PetscError`]
#[allow(unsafe_code)]
pub(crate) fn solve(
    session: &Session,
    (operator, preconditioner): (&dyn LinearOperator, &mut dyn Preconditioner),
    (b, x): (&[f64], &mut [f64]),
    options: &PcgOptions,
) -> Result<PcgReport, PetscError> {
    assert!([operator.size(), preconditioner.size(), x.len()].iter().all(|l| *l == b.len()), "one length");
    let mut of_operator = OperatorShell { operator, first: None };
    let mut of_preconditioner = PreconditionerShell { preconditioner, first: None };
    let (size, world) = (int(b.len())?, session.world());
    // SAFETY: PETSc runs while there is a session, on whose thread this is. `b`, `x` and both shells outlive what is made of them
    // here, which is dropped at the end; PETSc writes to `x` alone, and nothing else uses the shells until the solve is over.
    let report = unsafe {
        let matrix = Handle::new("MatCreateShell", ffi::MatDestroy, |matrix| {
            ffi::MatCreateShell(world, size, size, -1, -1, (&raw mut of_operator).cast(), matrix)
        })?;
        petsc(
            "MatShellSetOperation",
            ffi::MatShellSetOperation(matrix.get(), ffi::MULTIPLY, multiply as Product),
        )?;
        let solver = Handle::new("KSPCreate", ffi::KSPDestroy, |solver| ffi::KSPCreate(world, solver))?;
        let ksp = solver.get();
        petsc("KSPSetOperators", ffi::KSPSetOperators(ksp, matrix.get(), matrix.get()))?;
        petsc("KSPSetType", ffi::KSPSetType(ksp, c"cg".as_ptr()))?;
        petsc("KSPSetNormType", ffi::KSPSetNormType(ksp, ffi::TRUE_RESIDUAL))?;
        let most = int(options.max_iterations)?;
        petsc("KSPSetTolerances", ffi::KSPSetTolerances(ksp, options.residual_drop, 0.0, GROWTH, most))?;
        petsc("KSPSetComputeEigenvalues", ffi::KSPSetComputeEigenvalues(ksp, ffi::TRUE))?;
        let mut pc = ptr::null_mut();
        petsc("KSPGetPC", ffi::KSPGetPC(ksp, &raw mut pc))?;
        petsc("PCSetType", ffi::PCSetType(pc, c"shell".as_ptr()))?;
        petsc("PCShellSetContext", ffi::PCShellSetContext(pc, (&raw mut of_preconditioner).cast()))?;
        petsc("PCShellSetApply", ffi::PCShellSetApply(pc, precondition as Product))?;
        let vector = |values: *const f64| {
            Handle::new("VecCreateMPIWithArray", ffi::VecDestroy, |vector| {
                ffi::VecCreateMPIWithArray(world, 1, size, -1, values, vector)
            })
        };
        let (right, solution) = (vector(b.as_ptr())?, vector(x.as_mut_ptr())?);
        petsc("KSPSolve", ffi::KSPSolve(ksp, right.get(), solution.get()))?;
        report(&solver)?
    };
    // Over all processes: first of the right-hand side and what is found, then of the first step.
    let found = |first: Option<f64>| first.unwrap_or(0.0);
    let own = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut sums = [own(b, x), own(b, b), found(of_preconditioner.first), found(of_operator.first)];
    session.sum(&mut sums);
    let [energy, square, work, curvature] = sums;
    let first = if curvature > 0.0 { work * work / curvature } else { 0.0 };
    let later = if energy > 0.0 { (1.0 - first / energy).max(0.0).sqrt() } else { 0.0 };
    let residual_ratio = if square > 0.0 { report.residual / square.sqrt() } else { 0.0 };
    Ok(PcgReport {
        status: report.status,
        iterations: report.iterations,
        energy_ratio: residual_ratio * residual_ratio,
        residual_ratio: Some(residual_ratio),
        first_correction: later,
        least_eigenvalue: report.least_eigenvalue,
    })
}

/// What PETSc says of a solve.
struct Report {
    status: PcgStatus,
    iterations: usize,
    residual: f64,
    least_eigenvalue: f64,
}

/// # Safety
/// The solver is a `KSP` that has solved, on the thread of its session.
#[allow(unsafe_code)]
unsafe fn report(solver: &Handle) -> Result<Report, PetscError> {
    let (mut iterations, mut reason, mut residual, mut count) = (0, 0, 0.0, 0);
    // SAFETY: as the caller says; every number is written to a place of its type.
    unsafe {
        petsc("KSPGetIterationNumber", ffi::KSPGetIterationNumber(solver.get(), &raw mut iterations))?;
        petsc("KSPGetConvergedReason", ffi::KSPGetConvergedReason(solver.get(), &raw mut reason))?;
        petsc("KSPGetResidualNorm", ffi::KSPGetResidualNorm(solver.get(), &raw mut residual))?;
    }
    let steps = usize::try_from(iterations).unwrap_or(0);
    let mut eigenvalues = [vec![0.0; steps], vec![0.0; steps]];
    if steps > 0 && reason > 0 {
        let [real, imaginary] = &mut eigenvalues;
        // SAFETY: both have room for as many numbers as there were steps.
        let code = unsafe {
            let (real, imaginary) = (real.as_mut_ptr(), imaginary.as_mut_ptr());
            ffi::KSPComputeEigenvalues(solver.get(), iterations, real, imaginary, &raw mut count)
        };
        petsc("KSPComputeEigenvalues", code)?;
    }
    let seen = &eigenvalues[0][..usize::try_from(count).unwrap_or(0).min(steps)];
    let status = match reason {
        1.. => PcgStatus::Converged,
        ffi::OUT_OF_ITERATIONS => PcgStatus::IterationLimit,
        ffi::INDEFINITE_PRECONDITIONER | ffi::INDEFINITE_MATRIX => PcgStatus::IndefiniteOperator,
        ffi::NOT_FINITE => PcgStatus::NotFinite,
        _ => PcgStatus::Stagnated,
    };
    // Rounding may leave one below zero at the end of a long solve.
    let least_eigenvalue = seen.iter().copied().filter(|value| *value > 0.0).fold(1.0, f64::min);
    Ok(Report { status, iterations: steps, residual, least_eigenvalue })
}
