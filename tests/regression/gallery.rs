//! Every case of the gallery passes its own checks, one test per folder.

use crate::support::{files, gallery, load, root, short, solve};
use peristat::input::Reach;
use peristat::study::{Findings, Plan, Record};
use peristat::summary::Status;
use std::fmt::Write;

/// Failures of the cases of a folder, one line per check.
fn failures(folder: &str) -> String {
    let cases = files(&root().join("cases").join(folder), ".json");
    assert!(!cases.is_empty(), "cases/{folder} has no cases");
    let mut text = String::new();
    for case in cases {
        let summary = solve(&case);
        if summary.status == Status::NotConverged {
            let _ = writeln!(text, "{}: not converged", short(&case));
        }
        for warning in summary.warnings.iter().filter(|w| w.contains("can be trusted")) {
            let _ = writeln!(text, "{}: {warning}", short(&case));
        }
        for check in summary.checks.iter().filter(|c| !c.passed) {
            let _ = writeln!(
                text,
                "{}: {}: expected {:e}, found {:e}, error {:.2e}, tolerance {:.0e} ({})",
                short(&case),
                check.name,
                check.expected,
                check.found,
                check.error,
                check.tolerance,
                check.source
            );
        }
    }
    text
}

fn all_pass(folder: &str) {
    let failures = failures(folder);
    assert!(failures.is_empty(), "\n{failures}");
}

/// Folders with a test below.
const FOLDERS: [&str; 8] =
    ["beam", "frame", "plate", "axisymmetric", "orthotropic", "ductile", "shell", "bench"];

#[test]
fn beams_pass_their_checks() {
    all_pass("beam");
}

#[test]
fn frames_pass_their_checks() {
    all_pass("frame");
}

#[test]
fn plates_pass_their_checks() {
    all_pass("plate");
}

#[test]
fn bodies_of_revolution_pass_their_checks() {
    all_pass("axisymmetric");
}

#[test]
fn orthotropic_plates_pass_their_checks() {
    all_pass("orthotropic");
}

#[test]
fn crack_specimens_pass_their_checks() {
    all_pass("ductile");
}

#[test]
fn shells_pass_their_checks() {
    all_pass("shell");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "a million points take a release build")]
fn benchmarks_pass_their_checks() {
    all_pass("bench");
}

#[test]
fn every_folder_of_cases_has_its_test() {
    for case in gallery() {
        let path = case.strip_prefix(root().join("cases")).unwrap();
        let folder = path.components().next().unwrap().as_os_str().to_string_lossy();
        assert!(FOLDERS.contains(&&*folder), "{} is in no folder of this test", short(&case));
    }
}

#[test]
fn studies_find_what_they_expect() {
    let studies = files(&root().join("cases"), ".study.json");
    assert!(!studies.is_empty());
    for file in studies {
        let plan = Plan::read(&file, &[], Reach::Inside).unwrap_or_else(|report| panic!("{report}"));
        let solve = |task| {
            Some(Record::solve(task, &plan.folder, None).unwrap_or_else(|e| panic!("{}: {e}", short(&file))))
        };
        let records: Vec<Option<Record>> = plan.tasks.iter().map(solve).collect();
        let findings = Findings::new(&plan, &records);
        assert!(!findings.expectations.is_empty(), "{} expects nothing", short(&file));
        assert!(findings.passed(), "{}: {:#?}", short(&file), findings.expectations);
    }
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
