//! Finds PETSc and MPI, and checks what `src/ffi.rs` says of them against their headers.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=src/shim.c");
    println!("cargo::rerun-if-env-changed=PKG_CONFIG_PATH");
    #[cfg(feature = "link")]
    link::link();
}

#[cfg(feature = "link")]
mod link {
    use std::process::Command;

    /// The message for a missing library.
    const HINT: &str = "the feature `petsc` needs PETSc 3.18 or later with real numbers, and Open MPI; \
        on Debian and Ubuntu: apt-get install libpetsc-real-dev libopenmpi-dev openmpi-bin pkg-config";

    pub(super) fn link() {
        let petsc = ["PETSc", "petsc"].into_iter().find_map(flags);
        // Open MPI says its flags under names of its own.
        let mpi = ["ompi-c", "ompi", "mpi"].into_iter().find_map(flags);
        let (Some(petsc), Some(mpi)) = (petsc, mpi) else { return stop(HINT) };
        let mut shim = cc::Build::new();
        shim.file("src/shim.c").flag("-Werror=incompatible-pointer-types").flag_if_supported("-std=c11");
        for flag in petsc.iter().chain(&mpi) {
            if let Some(folder) = flag.strip_prefix("-I") {
                // As a folder of the system it gives no warnings of its own.
                shim.flag("-isystem").flag(folder);
            } else if let Some(folder) = flag.strip_prefix("-L") {
                println!("cargo::rustc-link-search=native={folder}");
            }
        }
        if let Err(error) = shim.try_compile("peristat_petsc_shim") {
            stop(&format!("PETSc or MPI is not as it is used here: {error}; {HINT}"));
        }
        for library in petsc.iter().chain(&mpi).filter_map(|flag| flag.strip_prefix("-l")) {
            println!("cargo::rustc-link-lib={library}");
        }
    }

    /// The flags of a library that `pkg-config` knows.
    fn flags(name: &str) -> Option<Vec<String>> {
        let found = Command::new("pkg-config").args(["--cflags", "--libs", name]).output().ok()?;
        let text = String::from_utf8(found.stdout).ok().filter(|_| found.status.success())?;
        Some(text.split_whitespace().map(Into::into).collect())
    }

    /// Makes the build fail when this program has ended.
    fn stop(message: &str) {
        println!("cargo::error={message}");
    }
}
