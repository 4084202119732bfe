//! Solving with the interpreter free, and with Ctrl-C heard.

use crate::error::{Fault, exception, faults};
use crate::solved::Solved;
use peristat::case;
use peristat::input::{Folder, Reach};
use peristat::run::fracture::Restart;
use peristat::run::{Advance, RunOptions, Sink, StateResult, sizes};
use peristat::{Error, Loaded};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use serde_json::Value;
use std::io;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

/// How often signals are looked for.
const TICK: Duration = Duration::from_millis(50);

/// A case as the Python half hands it over.
#[derive(Clone, FromPyObject)]
pub(crate) struct Given {
    /// Its text.
    text: String,
    /// What messages call it.
    name: String,
    /// Where files that it names are.
    folder: String,
    /// `path=value` for each value that is replaced.
    overrides: Vec<String>,
    /// Largest memory, bytes.
    max_memory: Option<u64>,
}

impl Given {
    fn load(self) -> Result<Loaded, Error> {
        let source = case::from_text(&self.name, self.text, &self.overrides)?;
        // The name of a file in the folder stands for the folder.
        let folder = Folder::of(&Path::new(&self.folder).join("case.json"), Reach::Inside);
        Loaded::from_source(source, folder, self.max_memory)
    }
}

/// Checks a case without solving it: its warnings, and the numbers of points, bonds and unknowns.
#[pyfunction]
pub(crate) fn check(py: Python<'_>, given: Given) -> PyResult<(Vec<Fault>, String)> {
    let max_memory = given.max_memory;
    let found = py.detach(|| {
        let loaded = given.load()?;
        let sizes = sizes(&loaded.scene, &options(max_memory)).map_err(|error| loaded.explain(error))?;
        let text = serde_json::to_string(&sizes).map_err(io::Error::from)?;
        Ok((loaded.warnings().map_or(Vec::new(), |report| faults(&report)), text))
    });
    found.map_err(|error| exception(py, &error))
}

/// Solves a case. `on_state` is called with the name and the load factor of every recorded state; the run ends after it if it returns
/// `False`.
#[pyfunction]
pub(crate) fn run(
    py: Python<'_>,
    given: Given,
    threads: Option<usize>,
    on_state: Option<Py<PyAny>>,
) -> PyResult<Solved> {
    let stop = Arc::new(AtomicBool::new(false));
    let (send, receive) = channel();
    let watched = Arc::clone(&stop);
    thread::spawn(move || {
        // Nobody listens after an interrupt.
        let _ = send.send(solve(given, threads, on_state, watched));
    });
    // A receiver may not be shared with the code that runs while the interpreter is free.
    let receive = Mutex::new(receive);
    let wait = || match receive.lock() {
        Ok(receive) => receive.recv_timeout(TICK),
        Err(_) => Err(RecvTimeoutError::Disconnected),
    };
    loop {
        match py.detach(wait) {
            Ok(Ok(solved)) => return Ok(solved),
            Ok(Err(Failure::Library(error))) => return Err(exception(py, &error)),
            Ok(Err(Failure::Python(error))) => return Err(error),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the solver ended without a result"));
            }
        }
        if let Err(interrupt) = py.check_signals() {
            // What cannot stop at an equilibrium ends by itself, unheard.
            stop.store(true, Ordering::Relaxed);
            return Err(interrupt);
        }
    }
}

enum Failure {
    Library(Error),
    Python(PyErr),
}

fn options(max_memory: Option<u64>) -> RunOptions {
    RunOptions { recover: true, max_memory, compare: true }
}

fn solve(
    given: Given,
    threads: Option<usize>,
    on_state: Option<Py<PyAny>>,
    stop: Arc<AtomicBool>,
) -> Result<Solved, Failure> {
    let run = || {
        let max_memory = given.max_memory;
        let loaded = given.load().map_err(Failure::Library)?;
        let mut states = States { kept: Vec::new(), curve: Vec::new(), on_state, stop, raised: None };
        let summary = loaded.run(&options(max_memory), None, &mut states);
        if let Some(error) = states.raised {
            return Err(Failure::Python(error));
        }
        let summary = summary.map_err(Failure::Library)?;
        let solved = peristat::Solved { scene: loaded.scene, summary, states: states.kept };
        Ok(Solved { solved, curve: states.curve })
    };
    match threads {
        None => run(),
        Some(count) => {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(count.max(1)).build();
            let pool = pool.map_err(|error| Failure::Python(PyRuntimeError::new_err(error.to_string())))?;
            pool.install(run)
        }
    }
}

/// Keeps every state, and asks Python whether to go on.
struct States {
    kept: Vec<StateResult>,
    /// Every equilibrium on the way, as JSON.
    curve: Vec<Value>,
    on_state: Option<Py<PyAny>>,
    stop: Arc<AtomicBool>,
    raised: Option<PyErr>,
}

impl Sink for States {
    fn take(&mut self, result: StateResult) -> io::Result<()> {
        let record = result.record();
        let (name, load_factor) = (record.name.clone(), record.load_factor);
        self.kept.push(result);
        let Some(on_state) = &self.on_state else { return Ok(()) };
        let answer = Python::attach(|py| {
            let answer = on_state.call1(py, (name, load_factor))?;
            Ok(answer.is_none(py) || answer.is_truthy(py)?)
        });
        match answer {
            Ok(true) => {}
            Ok(false) => self.stop.store(true, Ordering::Relaxed),
            Err(error) => {
                self.raised = Some(error);
                return Err(io::Error::other("`on_state` failed"));
            }
        }
        Ok(())
    }

    fn advance(&mut self, event: Advance<'_>, _: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        self.curve.push(match event {
            Advance::Break(event) => serde_json::to_value(event)?,
            Advance::Path(point) => serde_json::to_value(point)?,
        });
        Ok(())
    }

    fn is_interrupted(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
