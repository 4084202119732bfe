//! The command, its repository, and cases to run.

use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Root of the repository.
pub(crate) fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.ancestors().nth(2).expect("a package is in crates").to_path_buf()
}

/// The command, in a folder.
pub(crate) fn peristat(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_peristat"));
    command.current_dir(folder);
    command
}

/// What a finished command left behind.
pub(crate) struct Outcome {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

/// Runs the command in a folder.
pub(crate) fn run(folder: &Path, arguments: &[&str]) -> Outcome {
    let output = peristat(folder).args(arguments).output().expect("the command starts");
    Outcome {
        code: output.status.code().expect("no signal ended the command"),
        stdout: String::from_utf8(output.stdout).expect("stdout is text"),
        stderr: String::from_utf8(output.stderr).expect("stderr is text"),
    }
}

/// Path of a case of the gallery, as an argument.
pub(crate) fn gallery(name: &str) -> String {
    root().join("cases/beam").join(name).display().to_string()
}

/// All files below a folder whose names end like this, sorted.
pub(crate) fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("the entry can be read").path();
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.to_string_lossy().ends_with(ending) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Names in a folder, sorted.
pub(crate) fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder can be read");
    let name =
        |e: std::io::Result<fs::DirEntry>| e.expect("an entry").file_name().to_string_lossy().into_owned();
    let mut names: Vec<String> = entries.map(name).collect();
    names.sort();
    names
}

/// A JSON file.
pub(crate) fn json(path: &Path) -> Value {
    let text = fs::read_to_string(path).expect("the file can be read");
    serde_json::from_str(&text).expect("the file is JSON")
}

/// A report of a run but for its section of times.
pub(crate) fn report_without_times(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("the report can be read");
    let (before, after) = text.split_once("<h2>Time and work</h2>").expect("the report has times");
    let (_, after) = after.split_once("</section>").expect("sections end");
    [before, after].concat()
}

/// The Python of `PERISTAT_PYTHON`, or any, if it has a module; else a notice.
pub(crate) fn python_with(module: &str) -> Option<String> {
    let python = std::env::var("PERISTAT_PYTHON").unwrap_or_else(|_| "python3".into());
    let import = Command::new(&python).args(["-c", &format!("import {module}")]).output();
    if import.is_ok_and(|output| output.status.success()) {
        return Some(python);
    }
    notice(&format!("`{python}` has no {module}; set PERISTAT_PYTHON to one that has"));
    None
}

/// Tells what cannot be tested here, past the captured output of a passing test.
pub(crate) fn notice(reason: &str) {
    let _ = std::io::stderr().write_all(format!("\nnotice: not tested: {reason}\n").as_bytes());
}
