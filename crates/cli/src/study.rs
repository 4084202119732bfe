//! `study`: many discretisations of a case.

use super::args::{Global, Study};
use super::interrupt::Interrupt;
use super::{DONE, FAILED, INTERRUPTED, complain_of_tasks, note, print_study, say, viewer};
use peristat::Error;
use peristat::output::folder::below;
use peristat::output::lock::Hold;
use peristat::run::RunError;
use peristat::study::{self, Claimed, Findings, Plan, Record, Solving, Store, Task};
use std::io;
use std::path::{Path, PathBuf};

/// Plans a study, solves what is not finished, and says what it found.
pub(super) fn study(request: &Study, global: &Global) -> Result<u8, Error> {
    let plan = Plan::read(&request.study, &request.overrides, global.reach())?;
    let folder = folder(request)?;
    if request.plan {
        return show_plan(&plan, &Store::at(&folder), global);
    }
    let chosen = chosen(&plan, &request.task)?;
    // Numbered tasks are for many processes; what is collected may still grow.
    let shares = request.collect || !request.task.is_empty();
    let store = Store::open(&folder, request.force, if shares { Hold::Together } else { Hold::Alone })?;
    if request.task.is_empty() && !request.force {
        store.admit(&plan)?;
    }
    let _claims = claims(&chosen, &store, request)?;
    if !request.collect {
        match solve(&plan, &chosen, &store, global) {
            Err(Error::Run(RunError::Interrupted)) => {
                note("interrupted\nhint: the same command goes on from here\n");
                return Ok(INTERRUPTED);
            }
            outcome => outcome?,
        }
        if !request.task.is_empty() {
            return tell_tasks(&chosen, &store, global);
        }
    }
    let records: Vec<Option<Record>> = plan.tasks.iter().map(|task| store.get(&task.key)).collect();
    let findings = Findings::new(&plan, &records);
    study::write(store.folder(), &plan, &findings)?;
    if global.json {
        say(&format!("{:#}\n", serde_json::to_value(&findings).map_err(io::Error::from)?))?;
    } else if !global.quiet {
        say(&print_study::findings(&findings, global.verbose))?;
        say(&format!("results in {}\n", folder.display()))?;
    }
    if request.open {
        viewer::show(&folder);
    }
    Ok(if findings.passed() { DONE } else { FAILED })
}

/// The folder of the study: as asked, or named like the file with its `.study`, so that a case beside it has its own.
fn folder(request: &Study) -> io::Result<PathBuf> {
    let name = request.study.file_stem().unwrap_or_default();
    match &request.output {
        Some(folder) => Ok(folder.clone()),
        None => below(Path::new(""), &Path::new("results").join(name)),
    }
}

/// The tasks that are asked for, all if none is.
fn chosen<'a>(plan: &'a Plan, numbers: &[usize]) -> io::Result<Vec<&'a Task>> {
    if numbers.is_empty() {
        return Ok(plan.tasks.iter().collect());
    }
    let mut once: Vec<usize> = Vec::new();
    for &number in numbers {
        if !once.contains(&number) {
            once.push(number);
        }
    }
    let find = |number: &usize| {
        number.checked_sub(1).and_then(|k| plan.tasks.get(k)).ok_or_else(|| {
            let message =
                format!("there is no task {number}\nhint: this study has tasks 1 to {}", plan.tasks.len());
            io::Error::new(io::ErrorKind::InvalidInput, message)
        })
    };
    once.iter().map(find).collect()
}

/// Keeps other processes from solving the tasks that are asked for one by one, where they are not finished.
fn claims(chosen: &[&Task], store: &Store, request: &Study) -> io::Result<Vec<Claimed>> {
    let open = |task: &&&Task| !request.task.is_empty() && store.get(&task.key).is_none();
    let claim = |task: &&Task| {
        store.claim(&task.key)?.ok_or_else(|| {
            let message = format!(
                "another peristat is solving task {}\nhint: wait until it has ended, or solve other tasks",
                task.number
            );
            io::Error::new(io::ErrorKind::AlreadyExists, message)
        })
    };
    chosen.iter().filter(open).map(claim).collect()
}

/// What came of the tasks that were asked for.
fn tell_tasks(chosen: &[&Task], store: &Store, global: &Global) -> Result<u8, Error> {
    let records: Vec<Option<Record>> = chosen.iter().map(|task| store.get(&task.key)).collect();
    if global.json {
        let list = serde_json::to_value(&records).map_err(io::Error::from)?;
        say(&format!("{list:#}\n"))?;
    }
    let fine = records.iter().all(|record| record.as_ref().is_some_and(|r| r.converged));
    Ok(if fine { DONE } else { FAILED })
}

/// Solves tasks that are not finished.
fn solve(plan: &Plan, chosen: &[&Task], store: &Store, global: &Global) -> Result<(), Error> {
    let todo: Vec<&Task> = chosen.iter().copied().filter(|task| store.get(&task.key).is_none()).collect();
    if todo.is_empty() {
        return Ok(());
    }
    let interrupt = Interrupt::listen(global.quiet)?;
    let bar = super::progress::of_tasks(global, todo.len());
    let faults = Solving {
        threads: global.threads,
        max_memory: global.max_memory,
        is_interrupted: &|| interrupt.is_asked(),
        keep: &|record| {
            bar.inc(1);
            store.put(&record)
        },
    }
    .solve(plan, &todo)?;
    bar.finish_and_clear();
    complain_of_tasks(&faults, global);
    if interrupt.is_asked() {
        return Err(Error::Run(RunError::Interrupted));
    }
    Ok(())
}

fn show_plan(plan: &Plan, store: &Store, global: &Global) -> Result<u8, Error> {
    if global.json {
        let list = plan.tasks.iter().map(|task| {
            serde_json::json!({
                "task": task.number, "key": task.key, "finished": store.get(&task.key).is_some(),
                "settings": task.settings, "set": task.overrides, "remarks": task.remarks,
            })
        });
        let plan = serde_json::json!({ "case": plan.case_file, "tasks": list.collect::<Vec<_>>() });
        say(&format!("{plan:#}\n"))?;
    } else if !global.quiet {
        say(&print_study::plan(plan, |task| store.get(&task.key).is_some()))?;
    }
    Ok(DONE)
}
