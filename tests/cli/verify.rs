//! `verify`: the checks of many cases.

use crate::support::{gallery, names, run};
use std::fs;
use std::path::Path;

/// A folder with a passing, a failing and a faulty case.
fn mixed(folder: &Path) {
    let text = fs::read_to_string(gallery("cantilever.json")).unwrap();
    fs::write(folder.join("good.json"), &text).unwrap();
    fs::write(folder.join("weak & soft.json"), text.replace("1000.0", "2000.0")).unwrap();
}

#[test]
fn a_failing_case_is_named_with_its_checks_and_gives_exit_code_1() {
    let folder = tempfile::tempdir().unwrap();
    mixed(folder.path());
    let outcome = run(folder.path(), &["verify", "."]);
    assert_eq!(outcome.code, 1);
    assert!(outcome.stdout.contains("1 passed, 1 failed"), "{}", outcome.stdout);
    assert!(outcome.stdout.contains("tip <= L/250"), "{}", outcome.stdout);
    assert_eq!(names(folder.path()).len(), 2, "nothing is written");
    assert_eq!(run(folder.path(), &["verify", "good.json"]).code, 0);
}

#[test]
fn a_faulty_case_does_not_keep_the_others_from_running() {
    let folder = tempfile::tempdir().unwrap();
    mixed(folder.path());
    fs::write(folder.path().join("bad.json"), "{}").unwrap();
    let outcome = run(folder.path(), &["verify", "."]);
    assert_eq!(outcome.code, 2);
    assert!(outcome.stderr.contains("`title` is missing"), "{}", outcome.stderr);
    assert!(
        outcome.stdout.contains("ERROR") && outcome.stdout.contains("1 passed, 2 failed"),
        "{}",
        outcome.stdout
    );
}

#[test]
fn nothing_to_verify_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(run(folder.path(), &["verify", "."]).code, 2);
    let missing = run(folder.path(), &["verify"]);
    assert_eq!(missing.code, 2);
    assert!(missing.stderr.contains("cases"), "{}", missing.stderr);
}

#[test]
fn slow_benchmark_and_invalid_cases_run_only_when_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(gallery("cantilever.json")).unwrap();
    let slow = text.replacen('{', "{ \"slow\": true,", 1);
    for (name, text) in [("quick.json", &text), ("slow.json", &slow)] {
        fs::write(folder.path().join(name), text).unwrap();
    }
    for name in ["bench", "invalid"] {
        fs::create_dir(folder.path().join(name)).unwrap();
        fs::write(folder.path().join(name).join("case.json"), if name == "bench" { &text } else { "" })
            .unwrap();
    }
    let passed = |arguments: &[&str]| {
        let outcome = run(folder.path(), arguments);
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        outcome.stdout.lines().last().unwrap().to_string()
    };
    assert_eq!(passed(&["verify", "."]), "1 passed, 0 failed");
    assert_eq!(passed(&["verify", ".", "--all"]), "3 passed, 0 failed");
    assert_eq!(passed(&["verify", "slow.json"]), "1 passed, 0 failed");
    assert_eq!(passed(&["verify", "bench"]), "1 passed, 0 failed");
}

#[test]
fn the_junit_report_counts_and_escapes() {
    let folder = tempfile::tempdir().unwrap();
    mixed(folder.path());
    run(folder.path(), &["verify", ".", "--junit", "report.xml", "-q"]);
    let report = fs::read_to_string(folder.path().join("report.xml")).unwrap();
    assert!(report.starts_with("<?xml version=\"1.0\""));
    assert!(report.contains("<testsuite name=\"peristat\" tests=\"2\" failures=\"1\">"), "{report}");
    assert_eq!(report.matches("<testcase ").count(), 2);
    assert!(report.contains("weak &amp; soft.json") && report.contains("tip &lt;= L/250"), "{report}");
    assert!(report.trim_end().ends_with("</testsuite>"));
}

#[test]
fn the_junit_report_replaces_only_a_report_unless_forced() {
    let folder = tempfile::tempdir().unwrap();
    mixed(folder.path());
    let before = fs::read_to_string(folder.path().join("good.json")).unwrap();
    let onto = |file: &str, more: &[&str]| {
        run(folder.path(), &[&["verify", "good.json", "--junit", file], more].concat())
    };
    let refused = onto("good.json", &[]);
    assert_eq!(refused.code, 2);
    let message =
        "error: good.json exists and is no JUnit report\nhint: choose another file, or add `--force`\n";
    assert_eq!((refused.stderr.as_str(), refused.stdout.as_str()), (message, ""));
    assert_eq!(fs::read_to_string(folder.path().join("good.json")).unwrap(), before);
    for file in ["report.xml", "report.xml"] {
        assert_eq!(onto(file, &[]).code, 0);
    }
    fs::write(folder.path().join("notes.xml"), "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<notes/>")
        .unwrap();
    assert_eq!(onto("notes.xml", &[]).code, 2);
    assert_eq!(onto("notes.xml", &["--force"]).code, 0);
    assert_eq!(onto("both.xml", &["-o", "out", "--force"]).code, 0);
}

#[test]
fn results_of_every_case_are_written_where_that_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    mixed(folder.path());
    run(folder.path(), &["verify", "good.json", "weak & soft.json", "-o", "out"]);
    assert_eq!(names(&folder.path().join("out")), ["good", "weak & soft"]);
    assert!(folder.path().join("out/good/summary.json").exists());
    let again = ["verify", "good.json", "-o", "out"];
    let refused = run(folder.path(), &again);
    assert_eq!(refused.code, 2);
    assert!(refused.stderr.contains("error: out/good holds a finished run of `"), "{}", refused.stderr);
    assert!(refused.stdout.contains("ERROR"), "{}", refused.stdout);
    assert_eq!(run(folder.path(), &[&again[..], &["--force"]].concat()).code, 0);
    assert_eq!(run(folder.path(), &["verify", "good.json", "--force"]).code, 2);
}

#[test]
fn cases_named_twice_are_solved_once_and_do_not_share_a_folder() {
    let folder = tempfile::tempdir().unwrap();
    mixed(folder.path());
    let twice = run(folder.path(), &["verify", "good.json", "good.json", "-o", "out"]);
    assert!(twice.code == 0 && twice.stdout.contains("1 passed, 0 failed"), "{}", twice.stderr);
    let outcome = run(folder.path(), &["verify", "good.json", "./good.json", "-o", "other"]);
    assert_eq!(outcome.code, 2);
    assert!(
        outcome.stderr.contains("good.json would have their results in one folder"),
        "{}",
        outcome.stderr
    );
    assert!(!folder.path().join("other").exists());
}

#[test]
fn threads_do_not_change_the_table() {
    let folder = Path::new(&gallery("")).to_path_buf();
    let cases = |threads: &str| {
        let outcome = run(&folder, &["verify", ".", "--threads", threads, "--json"]);
        let mut list: serde_json::Value = serde_json::from_str(&outcome.stdout).unwrap();
        for case in list.as_array_mut().unwrap() {
            case.as_object_mut().unwrap().remove("time_s");
        }
        list
    };
    let one = cases("1");
    assert!(one.as_array().unwrap().len() >= 14);
    assert_eq!(one, cases("7"));
    assert_eq!(run(&folder, &["verify", ".", "--threads", "0"]).code, 2);
}

#[test]
fn folders_of_results_hold_no_cases() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(gallery("cantilever.json")).unwrap();
    fs::write(folder.path().join("good.json"), &text).unwrap();
    assert_eq!(run(folder.path(), &["run", "good.json", "-q"]).code, 0);
    let outcome = run(folder.path(), &["verify", "."]);
    assert!(outcome.code == 0 && outcome.stdout.contains("1 passed, 0 failed"), "{}", outcome.stdout);
}

#[test]
fn a_folder_of_slow_cases_says_how_to_run_them() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(gallery("cantilever.json")).unwrap();
    fs::write(folder.path().join("slow.json"), text.replacen('{', "{ \"slow\": true,", 1)).unwrap();
    let outcome = run(folder.path(), &["verify", "."]);
    assert!(outcome.code == 2 && outcome.stderr.contains("add `--all`"), "{}", outcome.stderr);
    assert_eq!(run(folder.path(), &["verify", "slow.json"]).code, 0);
}
