//! Convergence studies.

use crate::background::{Failure, beside, refuse_after_fork};
use crate::case_input::CaseInput;
use crate::error::json;
use peristat::Error;
use peristat::output::lock::Hold;
use peristat::run::RunError;
use peristat::study::{Findings, Plan, Record, Solving, Store, Task, write};
use pyo3::prelude::*;
use std::collections::HashMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::sync::{Mutex, PoisonError};

/// Solves the tasks of a study, those that a folder does not hold yet if one is given; what they say together and the tasks that cannot
/// be solved, both as JSON.
#[pyfunction]
pub(crate) fn study(
    py: Python<'_>,
    given: CaseInput,
    threads: Option<u16>,
    output: Option<PathBuf>,
    force: bool,
) -> PyResult<(String, String)> {
    refuse_after_fork()?;
    let max_memory = given.max_memory;
    let (findings, faults) = beside(py, None, move |stop| {
        let plan = given.plan()?;
        let store = output.map(|folder| open(&folder, &plan, force)).transpose().map_err(Error::Io)?;
        let kept = |task: &Task| store.as_ref()?.get(&task.key);
        let finished = plan.tasks.iter().filter_map(|task| Some((task.key.clone(), kept(task)?)));
        let records: Mutex<HashMap<String, Record>> = Mutex::new(finished.collect());
        let record_of = |task: &Task| lock(&records).get(&task.key).cloned();
        let todo: Vec<&Task> = plan.tasks.iter().filter(|task| record_of(task).is_none()).collect();
        let is_interrupted = || stop.load(Ordering::Relaxed);
        let faults = Solving {
            threads,
            max_memory,
            is_interrupted: &is_interrupted,
            keep: &|record| {
                store.as_ref().map_or(Ok(()), |store| store.put(&record))?;
                lock(&records).insert(record.key.clone(), record);
                Ok(())
            },
        }
        .solve(&plan, &todo)?;
        if is_interrupted() {
            return Err(Failure::Library(Error::Run(RunError::Interrupted)));
        }
        let records: Vec<Option<Record>> = plan.tasks.iter().map(record_of).collect();
        let findings = Findings::new(&plan, &records);
        if let Some(store) = &store {
            write(store.folder(), &plan, &findings).map_err(Error::Io)?;
        }
        Ok((findings, Error::Tasks(faults).records()))
    })?;
    Ok((json(&findings)?, json(&faults)?))
}

/// The folder of a study, which keeps finished tasks.
fn open(folder: &Path, plan: &Plan, force: bool) -> io::Result<Store> {
    let store = Store::open(folder, force, Hold::Alone)?;
    if !force {
        store.admit(plan)?;
    }
    Ok(store)
}

fn lock<T>(of: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}
