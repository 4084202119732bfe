//! `verify`: the checks of many cases.

use super::args::Global;
use super::writing::Writing;
use super::{DONE, FAILED, USAGE, complain, note, print, say, solve};
use crate::Error;
use crate::input::file;
use crate::output::folder::below;
use crate::results::{Claim, MARK};
use crate::run::{RunOptions, taking};
use crate::summary::{Status, Summary};
use crate::workers::side_by_side;
use std::collections::{HashMap, HashSet};
use std::fmt::Write;
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::time::Instant;

/// How the names of studies end, which lie beside cases.
const STUDY: &str = ".study.json";

/// What to verify.
pub(super) struct Request {
    pub(super) paths: Vec<PathBuf>,
    pub(super) all: bool,
    pub(super) junit: Option<PathBuf>,
    pub(super) output: Option<PathBuf>,
    pub(super) force: bool,
}

/// The outcome of one case.
struct Outcome {
    case: PathBuf,
    seconds: f64,
    result: Result<Summary, Error>,
}

/// Makes the checks of all cases.
pub(super) fn verify(request: &Request, global: &Global) -> Result<u8, Error> {
    let mut cases = Vec::new();
    let default = [PathBuf::from("cases")];
    let paths = if request.paths.is_empty() { &default[..] } else { &request.paths };
    for path in paths {
        collect(path, request.all, &mut cases)?;
    }
    let mut named = HashSet::new();
    cases.retain(|case| named.insert(case.clone()));
    if request.output.is_some() {
        apart(&cases)?;
    }
    if let Some(file) = request.junit.as_ref().filter(|_| !request.force) {
        replaceable(file)?;
    }
    let outcomes = solve_all(&cases, request, global);
    if outcomes.is_empty() {
        note(&match cases.len() {
            0 => "error: there are no cases to verify\nhint: name case files or folders that hold some\n"
                .into(),
            slow => format!(
                "error: all {slow} cases here are marked `slow`\nhint: add `--all`, or name them one by one\n"
            ),
        });
        return Ok(USAGE);
    }
    for outcome in &outcomes {
        if let Err(error) = &outcome.result {
            complain(error, global);
            note("\n");
        }
    }
    if let Some(file) = &request.junit {
        crate::output::atomic::write_atomically(file, junit(&outcomes).as_bytes())?;
    }
    if global.json {
        say(&json(&outcomes))?;
    } else if !global.quiet {
        say(&report(&outcomes))?;
    }
    let bad_input = outcomes.iter().any(|o| o.result.is_err());
    let passed = outcomes.iter().all(|o| o.result.as_ref().is_ok_and(|s| s.status == Status::Passed));
    Ok(if bad_input {
        USAGE
    } else if passed {
        DONE
    } else {
        FAILED
    })
}

/// Case files at a path, sorted; folders of benchmarks and of invalid cases are entered only if they are named, those of
/// results never.
fn collect(path: &Path, all: bool, cases: &mut Vec<PathBuf>) -> io::Result<()> {
    let describe = |error: io::Error| io::Error::new(error.kind(), format!("{}: {error}", path.display()));
    if !path.is_dir() {
        fs::metadata(path).map_err(describe)?;
        cases.push(path.into());
        return Ok(());
    }
    if path.join(MARK).exists() {
        return Ok(());
    }
    let entries = fs::read_dir(path).map_err(describe)?;
    let mut entries: Vec<PathBuf> = entries.map(|e| e.map(|e| e.path())).collect::<Result<_, _>>()?;
    entries.sort();
    for entry in entries {
        let name = entry.file_name().unwrap_or_default().to_string_lossy().into_owned();
        // A link to a folder may lead anywhere, round in circles, too.
        if entry.is_dir() {
            if !entry.is_symlink() && name != "invalid" && (all || name != "bench") {
                collect(&entry, all, cases)?;
            }
        } else if entry.is_file() && name.ends_with(".json") && !name.ends_with(STUDY) {
            cases.push(entry);
        }
    }
    Ok(())
}

fn solve_all(cases: &[PathBuf], request: &Request, global: &Global) -> Vec<Outcome> {
    let outcomes = side_by_side(global.threads, cases.len(), |k| solve_one(&cases[k], request, global));
    outcomes.into_iter().flatten().collect()
}

/// The path of a case without its root and its steps upwards, so that results stay in the folder that was asked for.
fn inside(case: &Path) -> PathBuf {
    let case = case.with_extension("");
    case.components().filter(|c| matches!(c, Component::Normal(_))).collect()
}

/// Whether no two cases would have their results in one folder.
fn apart(cases: &[PathBuf]) -> io::Result<()> {
    let mut folders: HashMap<PathBuf, &PathBuf> = HashMap::new();
    for case in cases {
        if let Some(other) = folders.insert(inside(case), case) {
            let message = format!(
                "{} and {} would have their results in one folder\nhint: verify them one by one, into folders of their own",
                other.display(),
                case.display()
            );
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
    }
    Ok(())
}

/// `None` for a slow case that nobody asked for.
fn solve_one(case: &Path, request: &Request, global: &Global) -> Option<Outcome> {
    let begin = Instant::now();
    let loaded = solve::load(case, &[], global);
    let named = request.paths.iter().any(|p| p == case);
    if let Ok(loaded) = &loaded
        && loaded.scene.case().slow
        && !request.all
        && !named
    {
        return None;
    }
    let result = loaded.and_then(|loaded| match &request.output {
        Some(folder) => {
            let claim = Claim::new(&below(folder, &inside(case))?, request.force)?;
            solve::solve_into(&loaded, None, Writing::new(&loaded.scene, claim), false, global)
        }
        None => {
            let options = RunOptions { recover: false, max_memory: global.max_memory };
            loaded.run(&options, None, &mut taking(|_| Ok(())))
        }
    });
    Some(Outcome { case: case.into(), seconds: begin.elapsed().as_secs_f64(), result })
}

/// Worst check of a summary: the largest error over tolerance. A limit is no error, so it comes last.
fn worst(summary: &Summary) -> Option<&crate::run::CheckResult> {
    let rank = |c: &crate::run::CheckResult| (c.kind != "limit", c.error / c.tolerance);
    summary.checks.iter().max_by(|a, b| {
        let (a, b) = (rank(a), rank(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    })
}

fn verdict(outcome: &Outcome) -> &'static str {
    match &outcome.result {
        Err(_) => "ERROR",
        Ok(s) if s.status == Status::Passed && s.checks.is_empty() => "no checks",
        Ok(s) => match s.status {
            Status::Passed => "passed",
            Status::CheckFailed => "FAILED",
            Status::NotConverged => "NOT CONVERGED",
        },
    }
}

fn report(outcomes: &[Outcome]) -> String {
    let row = |o: &Outcome| {
        let summary = o.result.as_ref().ok();
        let worst = summary.and_then(worst);
        vec![
            o.case.display().to_string(),
            summary.map_or(String::new(), |s| s.checks.len().to_string()),
            worst.map_or(String::new(), |c| {
                if c.error.is_finite() { format!("{:.1e}", c.error) } else { "none".into() }
            }),
            worst.map_or(String::new(), |c| format!("{:.0e}", c.tolerance)),
            format!("{:.3}", o.seconds),
            verdict(o).into(),
        ]
    };
    let rows: Vec<Vec<String>> = outcomes.iter().map(row).collect();
    let mut text = print::table(&["case", "checks", "worst error", "tolerance", "time, s", ""], &rows);
    for outcome in outcomes {
        if let Ok(summary) = &outcome.result
            && summary.status != Status::Passed
        {
            let _ = write!(text, "\n{}\n\n{}", outcome.case.display(), print::checks(&summary.checks));
        }
    }
    let passed = outcomes.iter().filter(|o| matches!(verdict(o), "passed" | "no checks")).count();
    let _ = writeln!(text, "\n{passed} passed, {} failed", outcomes.len() - passed);
    text
}

fn json(outcomes: &[Outcome]) -> String {
    let list = outcomes.iter().map(|o| {
        let checks = o.result.as_ref().map(|s| &s.checks).ok();
        let error = o.result.as_ref().err().map(ToString::to_string);
        serde_json::json!({
            "case": o.case, "verdict": verdict(o).to_lowercase(), "time_s": o.seconds, "checks": checks, "error": error
        })
    });
    format!("{:#}\n", serde_json::Value::from(list.collect::<Vec<_>>()))
}

/// How every JUnit report begins.
const JUNIT: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"peristat\" ";

/// Whether a JUnit report may be written to a file: it is not there, or holds an earlier report.
fn replaceable(path: &Path) -> io::Result<()> {
    let is_report = || file::read(path, None).is_ok_and(|bytes| bytes.starts_with(JUNIT.as_bytes()));
    if !path.exists() || is_report() {
        return Ok(());
    }
    let message = format!(
        "{} exists and is no JUnit report\nhint: choose another file, or add `--force`",
        path.display()
    );
    Err(io::Error::new(io::ErrorKind::AlreadyExists, message))
}

/// The outcomes in the form that CI servers read.
fn junit(outcomes: &[Outcome]) -> String {
    let xml = crate::output::xml;
    let failed = outcomes.iter().filter(|o| !matches!(verdict(o), "passed" | "no checks")).count();
    let mut text = format!("{JUNIT}tests=\"{}\" failures=\"{failed}\">\n", outcomes.len());
    for o in outcomes {
        let name = xml(&o.case.display().to_string());
        let _ = write!(text, "  <testcase name=\"{name}\" classname=\"peristat\" time=\"{:.3}\"", o.seconds);
        let details = match &o.result {
            Err(error) => error.to_string(),
            Ok(s) if s.status == Status::Passed => {
                text.push_str("/>\n");
                continue;
            }
            Ok(s) => print::checks(&s.checks),
        };
        let _ = write!(
            text,
            ">\n    <failure message=\"{}\">{}</failure>\n  </testcase>\n",
            verdict(o),
            xml(&details)
        );
    }
    text + "</testsuite>\n"
}
