//! Solving a case.

use crate::background::{Failure, Stop, at_once, beside};
use crate::case_input::CaseInput;
use crate::error::{exception, json};
use crate::solved::Solved;
use crate::states::{Equilibrium, States};
use peristat::Error;
use peristat::case::{Body, Source};
use peristat::results::{Claim, FieldFiles, FieldStates, Results, Writing};
use peristat::run::{RunError, RunOptions, sizes};
use peristat::study::EstimateEffort;
use peristat::summary::Status;
use pyo3::prelude::*;
use std::path::PathBuf;

/// Where results are written beside memory.
#[derive(FromPyObject)]
pub(crate) struct Output {
    folder: PathBuf,
    force: bool,
    resume: bool,
    fields: String,
    field_files: String,
}

impl Output {
    /// The files of fields that are asked for; the Python half has checked the words.
    fn field_files(&self) -> FieldFiles {
        let states = match self.fields.as_str() {
            "last" => FieldStates::Last,
            "none" => FieldStates::Nothing,
            _ => FieldStates::All,
        };
        FieldFiles { states, tables: self.field_files != "vtu", grids: self.field_files != "csv" }
    }
}

/// Checks a case without solving it: its warnings, and the numbers of points, bonds and unknowns; both as JSON.
#[pyfunction]
pub(crate) fn check(py: Python<'_>, given: CaseInput) -> PyResult<(String, String)> {
    let max_memory = given.max_memory;
    let (warnings, sizes) = beside(py, None, move |_| {
        let loaded = given.load()?;
        let sizes = sizes(&loaded.scene, &options(max_memory)).map_err(|error| loaded.explain(error))?;
        Ok((loaded.warnings().map_or(Vec::new(), |report| report.records()), sizes))
    })?;
    Ok((json(&warnings)?, json(&sizes)?))
}

/// Solves a case. `on_state` is called with the name and the load factor of every recorded state; the run ends after it if it returns
/// `False`. `estimate` asks for errors of discretisation from a finer grid, `None` for what is cheap, `False` for none.
#[pyfunction]
pub(crate) fn run(
    py: Python<'_>,
    given: CaseInput,
    threads: Option<u16>,
    on_state: Option<Py<PyAny>>,
    estimate: Option<bool>,
    output: Option<Output>,
) -> PyResult<Solved> {
    let mut given = given;
    let source = py.detach(|| given.read()).map_err(|error| exception(py, &error))?;
    let is_quick = is_quick(&source) && threads.is_none() && on_state.is_none() && output.is_none();
    let work = move |stop: &Stop| solve(&given, source, on_state, estimate, output, stop);
    if is_quick { at_once(py, work) } else { beside(py, threads, work) }
}

/// Cells of a straight beam that is solved before a thread beside the interpreter would have begun: one of 100 takes 0.1 ms, and to
/// hand it over half as much.
const FEW_CELLS: usize = 1000;
/// Its horizon over its spacing: with 400 such a beam takes minutes.
const SHORT_HORIZON: f64 = 10.0;
/// Bytes of its case, which bound its load cases.
const SHORT: usize = 1 << 16;

/// Whether a case is solved in less time than somebody takes to interrupt it, and on one thread.
fn is_quick(source: &Source) -> bool {
    let Source { case, text, .. } = source;
    let is_short = matches!(&case.body, Body::Line(line) if line.cells <= FEW_CELLS) && text.len() <= SHORT;
    let is_local = case.horizon.is_none() && case.horizon_ratio.is_none_or(|ratio| ratio <= SHORT_HORIZON);
    is_short && is_local && !case.is_traced()
}

fn options(max_memory: Option<u64>) -> RunOptions {
    RunOptions { recover: true, max_memory, compare: true }
}

fn solve(
    given: &CaseInput,
    source: Source,
    on_state: Option<Py<PyAny>>,
    estimate: Option<bool>,
    output: Option<Output>,
    stop: &Stop,
) -> Result<Solved, Failure> {
    let max_memory = given.max_memory;
    let loaded = given.resolve(source)?;
    let (mut writing, mut restart) = (None, None);
    if let Some(output) = output {
        let kept = output.field_files();
        let Output { folder, force, resume, .. } = output;
        let claim = if resume {
            let (claim, found) = Results::interrupted(&folder, &loaded.scene).map_err(Error::Io)?;
            restart = Some(found);
            claim
        } else {
            Claim::new(&folder, force, None).map_err(Error::Io)?
        };
        // Faults of the case come before the first file.
        sizes(&loaded.scene, &options(max_memory)).map_err(|error| loaded.explain(error))?;
        writing = Some(Writing::new(&loaded.scene, claim).with_fields(kept));
    }
    if let (Some(writing), Some(restart)) = (&mut writing, &restart) {
        writing.resume(restart).map_err(Error::Io)?;
    }
    let curve = restart.as_ref().map_or(Vec::new(), |restart| Equilibrium::before(&restart.from));
    let is_asked = loaded.scene.case().is_traced();
    let mut states =
        States { kept: Vec::new(), curve, writing, on_state, stop, is_asked, ended: false, raised: None };
    let summary = loaded.run(&options(max_memory), restart, &mut states);
    let States { kept, curve, writing, ended, raised, .. } = states;
    if let Some(error) = raised {
        return Err(Failure::Python(error));
    }
    if ended {
        return Err(Failure::Library(Error::Run(RunError::Interrupted)));
    }
    let mut summary = summary?;
    if writing.is_some() {
        summary = summary.measured();
    }
    if summary.status == Status::Interrupted {
        if let Some(writing) = writing {
            writing.finish(&summary).map_err(Error::Io)?;
        }
        return Err(Failure::Library(Error::Run(RunError::Interrupted)));
    }
    let effort = match estimate {
        None => EstimateEffort::Cheap,
        Some(true) => EstimateEffort::FromFiner,
        Some(false) => EstimateEffort::Nothing,
    };
    loaded.add_estimate(&mut summary, effort, max_memory);
    if let Some(writing) = writing {
        writing.finish(&summary).map_err(Error::Io)?;
    }
    Ok(Solved { solved: peristat::Solved { scene: loaded.scene, summary, states: kept }, curve })
}
