//! One case on many processes: halos and conjugate gradients of PETSc, and sums over processes of MPI, behind
//! [`peristat_solve::Ranks`].
//!
//! Without the feature `link` there is nothing here, and nothing to link. With it `Session` starts PETSc; `ffi.rs` declares the
//! few functions that are used, which `shim.c` checks against the headers as it is compiled, and every other file is safe to
//! call.
#![cfg(feature = "link")]

mod check;
mod conjugate_gradients;
mod error;
mod ffi;
mod halo;
mod handle;
mod session;
mod shell;

pub use error::PetscError;
pub use session::Session;
