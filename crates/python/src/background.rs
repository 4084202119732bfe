//! Work beside the interpreter, which is free meanwhile and hears Ctrl-C.

use crate::error::exception;
use peristat::Error;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::Duration;

/// How often signals are looked for.
const TICK: Duration = Duration::from_millis(50);
/// How long work that was interrupted may take to leave its files in order before the interpreter goes on without it.
const GRACE: Duration = Duration::from_millis(800);

/// What is said of a panic.
const NO_RESULT: &str = "the solver ended without a result";

/// Why work has no result.
pub(crate) enum Failure {
    /// The library says so.
    Library(Error),
    /// A function of Python raised.
    Python(PyErr),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Library(error)
    }
}

/// Whether work is to end.
pub(crate) type Stop = Arc<AtomicBool>;

/// Does work that is too short to be interrupted, on the thread that asks for it.
pub(crate) fn at_once<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&Stop) -> Result<T, Failure> + Send,
) -> PyResult<T> {
    match py.detach(|| catch_unwind(AssertUnwindSafe(|| work(&Stop::default())))) {
        Ok(done) => done.map_err(|failure| raised(py, failure)),
        Err(_) => Err(PyRuntimeError::new_err(NO_RESULT)),
    }
}

/// The exception that Python sees.
fn raised(py: Python<'_>, failure: Failure) -> PyErr {
    match failure {
        Failure::Library(error) => exception(py, &error),
        Failure::Python(error) => error,
    }
}

/// Does work in a pool of so many threads, of all cores if not given.
pub(crate) fn beside<T: Send + 'static>(
    py: Python<'_>,
    threads: Option<u16>,
    work: impl FnOnce(&Stop) -> Result<T, Failure> + Send + 'static,
) -> PyResult<T> {
    let pool = match threads {
        Some(count) => pool(count.into()).map(Arc::new),
        // A callback runs on a thread of the pool, which waits for it: what it solves needs threads of its own.
        None => common().and_then(|common| match common.current_thread_index() {
            Some(_) => pool(0).map(Arc::new),
            None => Ok(common),
        }),
    };
    let pool = pool.map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
    let stop = Stop::default();
    let (send, receive) = channel();
    let watched = Arc::clone(&stop);
    pool.spawn(move || {
        // Nobody listens after an interrupt.
        let _ = send.send(work(&watched));
    });
    // A receiver may not be shared with the code that runs while the interpreter is free.
    let receive = Mutex::new(receive);
    loop {
        match py.detach(|| wait(&receive, TICK)) {
            Ok(done) => return done.map_err(|failure| raised(py, failure)),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return Err(PyRuntimeError::new_err(NO_RESULT)),
        }
        if let Err(interrupt) = py.check_signals() {
            stop.store(true, Ordering::Relaxed);
            // What cannot stop at an equilibrium ends by itself, unheard.
            let _ = py.detach(|| wait(&receive, GRACE));
            return Err(interrupt);
        }
    }
}

fn wait<T>(receive: &Mutex<Receiver<T>>, time: Duration) -> Result<T, RecvTimeoutError> {
    match receive.lock() {
        Ok(receive) => receive.recv_timeout(time),
        Err(_) => Err(RecvTimeoutError::Disconnected),
    }
}

/// Refuses work on threads beside the pool in a process that was forked after such work: the threads that it counts on are those of the
/// parent.
pub(crate) fn refuse_after_fork() -> PyResult<()> {
    static PROCESS: OnceLock<u32> = OnceLock::new();
    match *PROCESS.get_or_init(std::process::id) == std::process::id() {
        true => Ok(()),
        false => Err(PyRuntimeError::new_err(
            "this process was forked from one that had solved many cases at once, and has not its threads: start processes by `spawn`",
        )),
    }
}

fn pool(threads: usize) -> Result<ThreadPool, ThreadPoolBuildError> {
    // Without a handler a panic would end the interpreter; so the caller finds that nobody answers.
    ThreadPoolBuilder::new().num_threads(threads).panic_handler(|_| {}).build()
}

/// The pool of all cores. A process that was forked has none of the threads of its parent, and gets a pool of its own.
pub(crate) fn common() -> Result<Arc<ThreadPool>, ThreadPoolBuildError> {
    static COMMON: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);
    let mut common = COMMON.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((process, pool)) = &*common
        && *process == std::process::id()
    {
        return Ok(Arc::clone(pool));
    }
    let made = Arc::new(pool(0)?);
    // The pool of a parent cannot be ended from here.
    std::mem::forget(common.replace((std::process::id(), Arc::clone(&made))));
    Ok(made)
}
