//! `mpirun -n N peristat run CASE` gives what one process gives, or says why it does not.
//!
//! These need Open MPI and PETSc: `cargo test --release -p peristat-cli --features petsc --test ranks`.
#![allow(clippy::unwrap_used, reason = "helpers of tests are tests")]

mod bodies;
mod endings;
mod support;
