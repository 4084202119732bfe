//! PETSc from start to end, and what its processes tell each other.

use crate::check::{int, mpi, petsc};
use crate::conjugate_gradients;
use crate::error::PetscError;
use crate::ffi::{self, Comm};
use crate::halo::PetscHalo;
use peristat_solve::{Halo, LinearOperator, PcgOptions, PcgReport, Preconditioner, Ranks};
use std::ffi::c_int;
use std::io::Write;
use std::ptr;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, ThreadId};

/// Exit code of processes that another one ends.
const ENDED: c_int = 3;
/// Numbers that go into one message: MPI counts them with 32 bits.
const MESSAGE: usize = 1 << 28;

/// Whether a session was started.
static STARTED: AtomicBool = AtomicBool::new(false);

/// PETSc, started; the processes that `mpirun` started with this one.
pub struct Session {
    thread: ThreadId,
    world: Comm,
    number: usize,
    count: usize,
}

// SAFETY: the communicator is used only on the thread that started PETSc, which every use checks.
#[allow(unsafe_code)]
unsafe impl Sync for Session {}

impl Session {
    /// Starts PETSc, once in a process.
    ///
    /// # Errors
    /// [`PetscError`]
    #[allow(unsafe_code)]
    pub fn start() -> Result<Self, PetscError> {
        if STARTED.swap(true, Ordering::SeqCst) {
            return Err(PetscError::Again);
        }
        let (mut number, mut count) = (0, 0);
        // SAFETY: options may be set before PETSc starts, and it starts once; both numbers are written to places of their type.
        let world = unsafe {
            // A process that is killed is to die of it, without a report of PETSc.
            let option = c"-no_signal_handler";
            petsc(
                "PetscOptionsSetValue",
                ffi::PetscOptionsSetValue(ptr::null_mut(), option.as_ptr(), c"true".as_ptr()),
            )?;
            petsc("PetscInitializeNoArguments", ffi::PetscInitializeNoArguments())?;
            petsc("PetscPushErrorHandler", ffi::peristat_return_errors())?;
            mpi("MPI_Comm_rank", ffi::peristat_rank(&raw mut number))?;
            mpi("MPI_Comm_size", ffi::peristat_size(&raw mut count))?;
            ffi::peristat_world()
        };
        let natural = |k: c_int| usize::try_from(k).unwrap_or(0);
        let thread = thread::current().id();
        Ok(Self { thread, world, number: natural(number), count: natural(count) })
    }

    /// # Panics
    /// This is not the thread that started PETSc, which alone may call it.
    pub(crate) fn check(&self) {
        assert_eq!(thread::current().id(), self.thread, "PETSc is called on the thread that started it");
    }

    /// The communicator of all processes.
    pub(crate) fn world(&self) -> Comm {
        self.check();
        self.world
    }

    /// Where the parts of all begin in the long vector and how long they are, on the first process; nothing on others.
    #[allow(unsafe_code)]
    fn layout(&self, own: usize) -> Result<[Vec<c_int>; 2], PetscError> {
        self.check();
        let mut counts = vec![0; if self.number == 0 { self.count } else { 0 }];
        // SAFETY: the first process has room for a number of each, others write none.
        mpi("MPI_Gather", unsafe { ffi::peristat_gather_counts(int(own)?, counts.as_mut_ptr()) })?;
        let total: usize = counts.iter().map(|&count| usize::try_from(count).unwrap_or(0)).sum();
        int(total)?;
        let starts = counts.iter().scan(0, |end, count| Some(std::mem::replace(end, *end + count)));
        Ok([starts.collect(), counts])
    }

    #[allow(unsafe_code)]
    fn try_gather(&self, own: &[f64], all: &mut [f64]) -> Result<(), PetscError> {
        let [starts, counts] = self.layout(own.len())?;
        let total: c_int = counts.iter().sum();
        assert!(self.number > 0 || all.len() == usize::try_from(total).unwrap_or(0), "a long vector");
        let (counts, starts) = (counts.as_ptr(), starts.as_ptr());
        // SAFETY: on the first process `all` has room for all parts, where they begin; others write nothing.
        mpi("MPI_Gatherv", unsafe {
            ffi::peristat_gather(own.as_ptr(), int(own.len())?, all.as_mut_ptr(), counts, starts)
        })
    }

    #[allow(unsafe_code)]
    fn try_deal(&self, all: &[f64], own: &mut [f64]) -> Result<(), PetscError> {
        let [starts, counts] = self.layout(own.len())?;
        let total: c_int = counts.iter().sum();
        assert!(self.number > 0 || all.len() == usize::try_from(total).unwrap_or(0), "a long vector");
        let count = int(own.len())?;
        // SAFETY: on the first process `all` has all parts, where they begin; others read nothing of it.
        mpi("MPI_Scatterv", unsafe {
            ffi::peristat_deal(all.as_ptr(), counts.as_ptr(), starts.as_ptr(), own.as_mut_ptr(), count)
        })
    }
}

impl Ranks for Session {
    fn number(&self) -> usize {
        self.number
    }

    fn count(&self) -> usize {
        self.count
    }

    #[allow(unsafe_code)]
    fn broadcast(&self, values: &mut [f64]) {
        self.check();
        for part in values.chunks_mut(MESSAGE) {
            // SAFETY: as many numbers are read or written as there are.
            let code = unsafe { ffi::peristat_broadcast(part.as_mut_ptr(), part.len() as c_int) };
            mpi("MPI_Bcast", code).unwrap_or_else(|error| end_all(&error));
        }
    }

    #[allow(unsafe_code)]
    fn sum(&self, values: &mut [f64]) {
        self.check();
        for part in values.chunks_mut(MESSAGE) {
            // SAFETY: as many numbers are read and written as there are.
            let code = unsafe { ffi::peristat_sum(part.as_mut_ptr(), part.len() as c_int) };
            mpi("MPI_Allreduce", code).unwrap_or_else(|error| end_all(&error));
        }
    }

    fn gather(&self, own: &[f64], all: &mut [f64]) {
        self.try_gather(own, all).unwrap_or_else(|error| end_all(&error));
    }

    fn deal(&self, all: &[f64], own: &mut [f64]) {
        self.try_deal(all, own).unwrap_or_else(|error| end_all(&error));
    }

    fn halo(&self, own: usize, wanted: &[usize]) -> Box<dyn Halo + '_> {
        match PetscHalo::new(self, own, wanted) {
            Ok(halo) => Box::new(halo),
            Err(error) => end_all(&error),
        }
    }

    fn conjugate_gradients(
        &self,
        operator: &dyn LinearOperator,
        preconditioner: &mut dyn Preconditioner,
        b: &[f64],
        x: &mut [f64],
        options: &PcgOptions,
    ) -> PcgReport {
        let solved = conjugate_gradients::solve(self, (operator, preconditioner), (b, x), options);
        solved.unwrap_or_else(|error| end_all(&error))
    }
}

impl Drop for Session {
    #[allow(unsafe_code)]
    fn drop(&mut self) {
        // SAFETY: PETSc runs, and this is its last call. A process that panics would wait for others that wait for it.
        unsafe {
            if thread::panicking() {
                ffi::peristat_abort(ENDED);
            } else {
                ffi::PetscFinalize();
            }
        }
    }
}

/// Tells an error and ends all processes.
#[allow(unsafe_code)]
pub(crate) fn end_all(error: &PetscError) -> ! {
    let _ = writeln!(std::io::stderr(), "error: {error}");
    // SAFETY: MPI runs, since an object of a session met the error.
    unsafe { ffi::peristat_abort(ENDED) };
    // The call does not return; if it did, this one would end this process, and `mpirun` the others.
    std::process::abort()
}
