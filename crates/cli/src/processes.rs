//! What `mpirun` says to the processes that it starts.

/// How many processes `mpirun` of Open MPI has started, if it has started this one.
pub(super) fn count() -> Option<usize> {
    number("OMPI_COMM_WORLD_SIZE")
}

/// How many of them run on this machine.
#[cfg(feature = "petsc")]
pub(super) fn beside() -> usize {
    number("OMPI_COMM_WORLD_LOCAL_SIZE").unwrap_or(1)
}

/// Why several processes of a command without PETSc do nothing; the first one alone says it.
#[cfg(not(feature = "petsc"))]
pub(super) fn refusal() -> Option<String> {
    let count = count().filter(|&count| count > 1)?;
    let is_first = number("OMPI_COMM_WORLD_RANK").unwrap_or(0) == 0;
    let text = format!(
        "error: `mpirun` has started {count} processes, and each would do the same: this command was built without PETSc\n\
         hint: build it with `cargo install --path crates/cli --features petsc`, or leave `mpirun` out\n"
    );
    Some(if is_first { text } else { String::new() })
}

fn number(variable: &str) -> Option<usize> {
    std::env::var(variable).ok()?.parse().ok()
}
