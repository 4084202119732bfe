//! Codes as errors, lengths as PETSc counts them.

use crate::error::PetscError;
use crate::ffi::{self, Code, Int};
use std::ffi::CStr;
use std::ptr;

/// An error for a code of PETSc that is not zero.
pub(crate) fn petsc(call: &'static str, code: Code) -> Result<(), PetscError> {
    if code == 0 {
        return Ok(());
    }
    let mut text = ptr::null();
    // SAFETY: the pointer to the text is written, the other one may be null; the text is a static string of PETSc, or null.
    #[allow(unsafe_code)]
    let text = unsafe {
        ffi::PetscErrorMessage(code, &raw mut text, ptr::null_mut());
        (!text.is_null()).then(|| CStr::from_ptr(text).to_string_lossy().into_owned())
    };
    Err(PetscError::Petsc { call, code, text: text.unwrap_or_else(|| "no text".into()) })
}

/// An error for a code of MPI that is not zero.
pub(crate) fn mpi(call: &'static str, code: Code) -> Result<(), PetscError> {
    if code == 0 { Ok(()) } else { Err(PetscError::Mpi { call, code }) }
}

/// A length, or a place in a long vector.
pub(crate) fn int(count: usize) -> Result<Int, PetscError> {
    Int::try_from(count).map_err(|_| PetscError::TooLong { count })
}
