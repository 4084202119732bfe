//! Every case of the gallery passes its own checks.

use super::support::{files, gallery, load, root, short, try_solve};
use peristat::input::Reach;
use peristat::study::{Findings, Plan, Record};
use peristat::summary::{Status, Summary};
use rstest::rstest;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a case fails by, a line each.
fn failures(case: &Path) -> Vec<String> {
    let told = match try_solve(case) {
        Ok(summary) => faults(&summary),
        Err(error) => vec![error.to_string()],
    };
    told.into_iter().map(|fault| format!("{}: {fault}", short(case))).collect()
}

fn faults(summary: &Summary) -> Vec<String> {
    let mut faults = Vec::new();
    if summary.status == Status::NotConverged {
        faults.push("not converged".into());
    }
    faults.extend(summary.warnings.iter().filter(|w| w.contains("can be trusted")).cloned());
    faults.extend(summary.checks.iter().filter(|c| !c.passed).map(|check| {
        format!(
            "{}: expected {:e}, found {:e}, error {:.2e}, tolerance {:.0e} ({})",
            check.name, check.expected, check.found, check.error, check.tolerance, check.source
        )
    }));
    faults
}

/// A test of its own for every case.
#[rstest]
fn passes(
    #[files("../../cases/**/*.json")]
    #[exclude("/cases/invalid/|\\.study\\.json$")]
    case: PathBuf,
) {
    // A million points take a release build.
    if cfg!(debug_assertions) && short(&case).starts_with("cases/bench/") {
        return;
    }
    let failures = failures(&case);
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

#[rstest]
fn finds_what_it_expects(#[files("../../cases/**/*.study.json")] study: PathBuf) {
    let plan = Plan::read(&study, &[], Reach::Inside).unwrap_or_else(|report| panic!("{report}"));
    let solve = |task| {
        Some(Record::solve(task, &plan.folder, None).unwrap_or_else(|e| panic!("{}: {e}", short(&study))))
    };
    let records: Vec<Option<Record>> = plan.tasks.iter().map(solve).collect();
    let findings = Findings::new(&plan, &records);
    assert!(!findings.expectations.is_empty(), "{} expects nothing", short(&study));
    assert!(findings.passed(), "{}: {:#?}", short(&study), findings.expectations);
}

/// The compiler does not see that a file was added to a folder.
#[test]
fn every_file_has_its_test() {
    let list = |test: &str| {
        let this = std::env::current_exe().unwrap();
        let told = Command::new(this).args(["--list", test]).output().unwrap();
        String::from_utf8(told.stdout).unwrap().lines().filter(|line| line.ends_with(": test")).count()
    };
    let studies = files(&root().join("cases"), ".study.json").len();
    let (listed, there) =
        ((list("gallery::passes"), list("gallery::finds_what_it_expects")), (gallery().len(), studies));
    assert_eq!(listed, there, "files came or went: `touch tests/regression/gallery.rs`");
    assert!(there.0 > 150 && there.1 > 0);
}

#[test]
fn every_case_says_what_it_shows_and_checks_it() {
    for case in gallery() {
        let name = short(&case);
        let scene = load(&case).scene;
        let about = scene.case().about.as_deref().unwrap_or_default();
        assert!(about.len() > 20, "{name} has no sentence in `about`");
        assert!(!scene.case().checks.is_empty(), "{name} has no checks");
    }
}

#[test]
fn a_wrong_expectation_fails() {
    let case = root().join("cases/beam/cantilever_uniform.json");
    let text = std::fs::read_to_string(case).unwrap().replacen("1.0e4", "1.01e4", 1);
    let solved = peristat::solve_text(&text).unwrap();
    assert_eq!(solved.summary.status, Status::Passed, "the closed form knows the load of the case");
    let text = text.replace(
        "cantilever_uniform\", \"field\": \"w\", \"tolerance\": 1.0e-13",
        "cantilever_uniform\", \"field\": \"w\", \"tolerance\": 1.0e-18",
    );
    assert_eq!(peristat::solve_text(&text).unwrap().summary.status, Status::CheckFailed);
}
