//! Products of the program as PETSc calls them.

use crate::check::petsc;
use crate::error::PetscError;
use crate::ffi::{self, Code, Object};
use peristat_solve::{LinearOperator, Preconditioner};
use std::ffi::c_void;
use std::ptr;

/// An operator, with `x · A x` of the first product with it.
pub(crate) struct OperatorShell<'a> {
    pub(crate) operator: &'a dyn LinearOperator,
    pub(crate) first: Option<f64>,
}

/// A preconditioner, with `r · M⁻¹ r` of the first product with it.
pub(crate) struct PreconditionerShell<'a> {
    pub(crate) preconditioner: &'a mut dyn Preconditioner,
    pub(crate) first: Option<f64>,
}

/// `y = A x`, for `MatShellSetOperation`; the context of the matrix is an [`OperatorShell`].
///
/// # Safety
/// PETSc calls it with a matrix of such a context, which nothing else uses meanwhile, and two of its vectors.
#[allow(unsafe_code)]
pub(crate) unsafe extern "C" fn multiply(matrix: Object, x: Object, y: Object) -> Code {
    let mut context: *mut c_void = ptr::null_mut();
    // SAFETY: the matrix is alive, since PETSc multiplies with it.
    let code = unsafe { ffi::peristat_mat_context(matrix, &raw mut context) };
    if code != 0 {
        return code;
    }
    // SAFETY: the context is that of `conjugate_gradients`, which outlives the matrix and is not used elsewhere during a solve.
    let shell = unsafe { &mut *context.cast::<OperatorShell>() };
    let size = shell.operator.size();
    let product = |x: &[f64], y: &mut [f64]| {
        shell.operator.apply(x, y);
        shell.first.get_or_insert_with(|| dot(x, y));
    };
    // SAFETY: the vectors have the layout of the matrix, whose own rows are `size`.
    unsafe { with_arrays(x, y, size, product) }.map_or_else(|error| code_of(&error), |()| 0)
}

/// `z = M⁻¹ r`, for `PCShellSetApply`; the context is a [`PreconditionerShell`].
///
/// # Safety
/// As [`multiply`].
#[allow(unsafe_code)]
pub(crate) unsafe extern "C" fn precondition(preconditioner: Object, r: Object, z: Object) -> Code {
    let mut context: *mut c_void = ptr::null_mut();
    // SAFETY: the preconditioner is alive, since PETSc applies it.
    let code = unsafe { ffi::peristat_pc_context(preconditioner, &raw mut context) };
    if code != 0 {
        return code;
    }
    // SAFETY: as in `multiply`.
    let shell = unsafe { &mut *context.cast::<PreconditionerShell>() };
    let size = shell.preconditioner.size();
    let product = |r: &[f64], z: &mut [f64]| {
        shell.preconditioner.apply(r, z);
        shell.first.get_or_insert_with(|| dot(r, z));
    };
    // SAFETY: as in `multiply`.
    unsafe { with_arrays(r, z, size, product) }.map_or_else(|error| code_of(&error), |()| 0)
}

/// Calls `product` with the own parts of two vectors.
///
/// # Safety
/// Both are alive, differ, and have `size` own entries.
#[allow(unsafe_code)]
unsafe fn with_arrays(
    x: Object,
    y: Object,
    size: usize,
    product: impl FnOnce(&[f64], &mut [f64]),
) -> Result<(), PetscError> {
    let (mut from, mut to) = (ptr::null(), ptr::null_mut());
    // SAFETY: the arrays have `size` entries, one is read and the other written, until both are given back.
    unsafe {
        petsc("VecGetArrayRead", ffi::VecGetArrayRead(x, &raw mut from))?;
        petsc("VecGetArray", ffi::VecGetArray(y, &raw mut to))?;
        if size > 0 {
            product(std::slice::from_raw_parts(from, size), std::slice::from_raw_parts_mut(to, size));
        } else {
            product(&[], &mut []);
        }
        petsc("VecRestoreArrayRead", ffi::VecRestoreArrayRead(x, &raw mut from))?;
        petsc("VecRestoreArray", ffi::VecRestoreArray(y, &raw mut to))
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The code that goes back to PETSc for an error of its own functions.
fn code_of(error: &PetscError) -> Code {
    match error {
        PetscError::Petsc { code, .. } | PetscError::Mpi { code, .. } => *code,
        PetscError::TooLong { .. } | PetscError::Again => 1,
    }
}
