//! The command, by one process and by several.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Mutex, MutexGuard};

/// Several processes at a time are enough for the machines that tests run on.
static MACHINE: Mutex<()> = Mutex::new(());

/// Keeps other tests from starting processes.
pub(crate) fn machine() -> MutexGuard<'static, ()> {
    // What another test has found is its own affair.
    MACHINE.lock().unwrap_or_else(|held| held.into_inner())
}

/// Root of the repository.
pub(crate) fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.ancestors().nth(2).expect("a package is in crates").to_path_buf()
}

/// `peristat` as so many processes, in a folder.
pub(crate) fn mpirun(processes: usize, folder: &Path) -> Command {
    let mut command = Command::new("mpirun");
    command.current_dir(folder).args(["--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-n"]);
    command.arg(processes.to_string()).arg(env!("CARGO_BIN_EXE_peristat")).args(["--threads", "1"]);
    command
}

/// What a command that ended wrote to stderr.
pub(crate) fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Results of a run: displacements of all points, and the summary.
pub(crate) struct Results {
    pub(crate) displacements: Vec<f64>,
    pub(crate) summary: Value,
}

impl Results {
    /// Those of the last state in a folder.
    pub(crate) fn read(folder: &Path) -> Self {
        let text = fs::read_to_string(folder.join("summary.json")).expect("a run leaves a summary");
        let tables = fs::read_dir(folder.join("fields")).expect("fields are written").flatten();
        let tables =
            tables.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|e| e == "csv"));
        let table = fs::read_to_string(tables.max().expect("a state has a table")).expect("a table is text");
        let mut lines = table.lines().filter(|line| !line.starts_with('#'));
        let names = lines.next().expect("a table has a head").split(',');
        let is_displacement = |name: &str| ["ux", "uy", "uz", "w"].iter().any(|u| name.trim().starts_with(u));
        let columns: Vec<usize> =
            names.enumerate().filter(|(_, name)| is_displacement(name)).map(|n| n.0).collect();
        assert!(!columns.is_empty(), "displacements are in the table");
        let numbers = |line: &str| {
            let cells: Vec<&str> = line.split(',').collect();
            columns.iter().map(|&k| cells[k].trim().parse().expect("a number")).collect::<Vec<f64>>()
        };
        let displacements = lines.flat_map(numbers).collect();
        Self { displacements, summary: serde_json::from_str(&text).expect("a summary is JSON") }
    }

    /// Iterations of all states.
    pub(crate) fn iterations(&self) -> Vec<u64> {
        let list = self.summary["solver"]["iterations"].as_array().expect("iterations");
        list.iter().filter_map(Value::as_u64).collect()
    }

    /// The largest difference of a displacement from another result, per the largest displacement.
    pub(crate) fn difference(&self, other: &Self) -> f64 {
        assert_eq!(self.displacements.len(), other.displacements.len());
        let largest = other.displacements.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let pairs = self.displacements.iter().zip(&other.displacements);
        pairs.fold(0.0, |a: f64, (b, c)| a.max((b - c).abs())) / largest
    }

    /// The error of displacements that the certificate of the last state allows.
    pub(crate) fn error(&self) -> f64 {
        let states = self.summary["states"].as_array().expect("states");
        states.last().expect("a state")["certificate"]["error"].as_f64().expect("an error")
    }
}

/// Runs a case by one process without `mpirun`.
pub(crate) fn alone(folder: &Path) -> Results {
    let mut command = Command::new(env!("CARGO_BIN_EXE_peristat"));
    let arguments = ["run", "case.json", "-o", "alone", "--no-estimate", "-q"];
    let output = command.current_dir(folder).args(arguments).output().expect("the command starts");
    assert!(output.status.success(), "{}", stderr(&output));
    Results::read(&folder.join("alone"))
}

/// Runs a case by several processes.
pub(crate) fn together(folder: &Path, processes: usize) -> Results {
    let out = format!("by {processes}");
    let output = mpirun(processes, folder).args(["run", "case.json", "-o", &out, "-q"]).output();
    let output = output.expect("mpirun starts");
    assert!(output.status.success(), "{processes} processes: {}", stderr(&output));
    Results::read(&folder.join(out))
}
