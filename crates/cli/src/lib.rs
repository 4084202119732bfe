//! The command `peristat`: parse, dispatch, print, exit code. A library, so that the Python package brings the command, too.

mod args;
mod case_reference;
mod choices;
mod completions;
mod interrupt;
mod lists;
mod manual;
mod model_fields;
mod print;
mod print_state;
mod print_study;
mod processes;
mod progress;
#[cfg(feature = "petsc")]
mod ranks;
mod schema;
mod solve;
mod study;
mod tidy;
mod tips;
mod verify;
mod viewer;
mod vocabulary;
mod watched;

use args::{Arguments, Command, Global};
use choices::Color;
use clap::Parser;
use peristat::Error;
use peristat::run::RunError;
use peristat::study::TaskFaults;
use peristat::verify::Request;
use std::ffi::OsString;
use std::io::{self, IsTerminal, Write};

/// Done, and all checks passed.
const DONE: u8 = 0;
/// Ran, but did not converge or a check failed.
const FAILED: u8 = 1;
/// Bad input or usage.
const USAGE: u8 = 2;
/// Ended by a signal, as shells number it.
const INTERRUPTED: u8 = 130;

/// Does what the arguments say, the first of which is the name of the command, and returns the exit code: 0 if done, 1 if a check failed,
/// 2 for bad input or usage, 130 if interrupted.
pub fn command(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let given: Vec<OsString> = arguments.into_iter().collect();
    let arguments = match Arguments::try_parse_from(&given) {
        Ok(arguments) => arguments,
        Err(refusal) => {
            // Help and version go to stdout, faults to stderr. If that is closed, the exit code remains.
            let refusal = tips::with_tip(refusal, &given);
            let _ = refusal.print();
            return if refusal.use_stderr() { USAGE } else { DONE };
        }
    };
    let global = arguments.global;
    #[cfg(feature = "petsc")]
    if processes::count().is_some() {
        return ranks::command(arguments.command, global);
    }
    #[cfg(not(feature = "petsc"))]
    if let Some(refusal) = processes::refusal() {
        note(&refusal);
        return USAGE;
    }
    if let Some(threads) = global.threads {
        // A pool that is there already, in a process that runs more than this, keeps its size.
        let _ = rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global();
    }
    dispatch(arguments.command, &global).unwrap_or_else(|error| failed(&error, &global))
}

fn dispatch(command: Command, global: &Global) -> Result<u8, Error> {
    match command {
        Command::Run(run) => solve::run(&run, global),
        Command::Check { cases, overrides } => solve::check(&cases, &overrides, global),
        Command::Verify { paths, all, junit, output, force } => {
            let paths = if paths.is_empty() { vec!["cases".into()] } else { paths };
            let (threads, max_memory, reach) = (global.threads, global.max_memory, global.reach());
            let request = Request { paths, all, output, force, threads, max_memory, reach };
            verify::verify(&request, junit.as_deref(), global)
        }
        Command::Study(request) => study::study(&request, global),
        Command::Fmt { cases, check } => tidy::fmt(&cases, check, global),
        Command::New { model } => lists::new(&model),
        Command::List { kind } => lists::list(kind, global),
        Command::Schema { study, markdown } => lists::schema(study, markdown),
        Command::Completions { shell } => completions::completions(shell),
        Command::Man { output } => manual::man(output.as_deref()),
    }
}

/// Tells an error, and returns its exit code.
fn failed(error: &Error, global: &Global) -> u8 {
    match global.json {
        true => {
            // Machines read one object whatever happens; where stdout is gone, the exit code tells.
            let _ = say(&format!(
                "{:#}\n",
                serde_json::json!({ "error": error.text(), "faults": error.records() })
            ));
        }
        false => complain(error, global),
    }
    match error {
        Error::Run(RunError::Interrupted) => INTERRUPTED,
        _ => USAGE,
    }
}

/// Writes to stdout; a reader that went away is no error.
fn say(text: &str) -> io::Result<()> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        other => other,
    }
}

/// Writes to stderr, where a failure has nowhere to be told.
fn note(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

fn colored(global: &Global) -> bool {
    match global.color {
        Color::Always => true,
        Color::Never => false,
        Color::Auto => io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none(),
    }
}

/// Tells every fault of tasks with the numbers of those that have it.
fn complain_of_tasks(faults: &TaskFaults, global: &Global) {
    for (tasks, error) in faults.groups() {
        note(&format!("{tasks}:\n"));
        complain(error, global);
        note("\n");
    }
}

fn complain(error: &Error, global: &Global) {
    match error {
        Error::Tasks(faults) => complain_of_tasks(faults, global),
        Error::Case(report) => note(&format!("{}\n", report.render(colored(global)).trim_end())),
        Error::Run(error @ RunError::Memory { .. }) => {
            note(&format!(
                "error: {error}\nhint: use fewer cells or a shorter horizon, or raise `--max-memory`\n"
            ));
        }
        Error::Run(error @ RunError::Misfit) => {
            note(&format!(
                "error: {error}\nhint: add `--force` in place of `--resume` to run the case anew\n"
            ));
        }
        Error::Run(error @ RunError::NotShared(_)) => {
            note(&format!(
                "error: {error}\nhint: run the case without `mpirun`: one process takes all cores of a machine\n"
            ));
        }
        other => note(&format!("error: {other}\n")),
    }
}
