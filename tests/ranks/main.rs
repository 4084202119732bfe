//! `mpirun -n N peristat run CASE` gives what one process gives, or says why it does not.
//!
//! These need Open MPI and PETSc: `cargo test --release -p peristat-cli --features petsc --test ranks`.

mod bodies;
mod endings;
mod support;
