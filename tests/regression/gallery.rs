//! Every case of the gallery passes its own checks.

use super::support::{files, gallery, load, root, short, try_solve};
use peristat::case::read;
use peristat::input::{Folder, Reach};
use peristat::study::{Findings, Plan, Record};
use peristat::summary::{Status, Summary};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::thread;

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

/// Cases that a thread begins with: one alone takes as long as most of the others together.
fn takes_long(case: &Path) -> bool {
    short(case).starts_with("cases/bench/")
        || read(case, &[], &Folder::of(case, Reach::Inside), None).is_ok_and(|source| source.case.slow)
}

/// Failures of all cases, each solved by whichever thread is free.
fn failures_of_all(cases: Vec<PathBuf>) -> Vec<String> {
    let (queue, found) = (Mutex::new(cases.into_iter()), Mutex::new(Vec::new()));
    // A guard in the condition of a loop would be held while the case is solved.
    let next = || queue.lock().unwrap().next();
    let work = || {
        while let Some(case) = next() {
            let failures = failures(&case);
            found.lock().unwrap().extend(failures);
        }
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(work))));
    found.into_inner().unwrap()
}

#[test]
fn cases_pass_their_checks() {
    let mut cases = gallery();
    assert!(cases.len() > 150, "found only {} cases", cases.len());
    // A million points take a release build.
    cases.retain(|case| !cfg!(debug_assertions) || !short(case).starts_with("cases/bench/"));
    cases.sort_by_cached_key(|case| !takes_long(case));
    let failures = failures_of_all(cases);
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
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
