//! What a call of PETSc or MPI says went wrong.

use std::ffi::c_int;
use thiserror::Error;

/// What a call of PETSc or MPI says went wrong.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum PetscError {
    /// PETSc returned a code.
    #[error("PETSc failed in {call}, code {code}: {text}")]
    Petsc {
        /// The function.
        call: &'static str,
        /// Its code.
        code: c_int,
        /// What PETSc says of the code.
        text: String,
    },
    /// MPI returned a code.
    #[error("MPI failed in {call}, code {code}")]
    Mpi {
        /// The function.
        call: &'static str,
        /// Its code.
        code: c_int,
    },
    /// A vector is longer than PETSc and MPI can count.
    #[error("{count} numbers are more than PETSc counts with 32 bits")]
    TooLong {
        /// Its length.
        count: usize,
    },
    /// The process has a session already, or had one.
    #[error("PETSc starts once in a process")]
    Again,
}
