//! `verify`: the checks of many cases.

use super::support::{gallery, names, run};
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
    for (text, told) in [(r#"{ "title": "t" }"#, "`model` is missing"), (r#"{ "title": "#, "bad.json:1")] {
        fs::write(folder.path().join("bad.json"), text).unwrap();
        let outcome = run(folder.path(), &["verify", "."]);
        assert_eq!(outcome.code, 2);
        assert!(outcome.stderr.contains(told), "{}", outcome.stderr);
        assert!(
            outcome.stdout.contains("ERROR") && outcome.stdout.contains("1 passed, 2 failed"),
            "{}",
            outcome.stdout
        );
    }
}

/// A folder with a case that passes, one without checks, and files that are skipped: two studies, a schema, a slow case, a
/// list and the file of another program.
fn crowded(folder: &Path) {
    let text = fs::read_to_string(gallery("cantilever.json")).unwrap();
    let mut unchecked: serde_json::Value = serde_json::from_str(&text).unwrap();
    unchecked.as_object_mut().unwrap().remove("checks");
    let schema = run(folder, &["schema"]).stdout;
    let study = r#"{ "title": "orders", "case": "good.json", "refine": { "delta_convergence": { "factors": [1, 2] } } }"#;
    for (name, text) in [
        ("good.json", text.as_str()),
        ("plain.json", &unchecked.to_string()),
        ("slow.json", &text.replacen('{', "{ \"slow\": true,", 1)),
        ("orders.json", study),
        ("more.study.json", study),
        ("case.schema.json", &schema),
        ("list.json", "[1, 2]"),
        ("package.json", r#"{ "name": "shelf", "version": "1" }"#),
    ] {
        fs::write(folder.join(name), text).unwrap();
    }
}

#[test]
fn what_tests_nothing_is_counted_as_such_and_what_is_no_case_is_skipped() {
    let folder = tempfile::tempdir().unwrap();
    crowded(folder.path());
    let outcome = run(folder.path(), &["verify", "."]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let last = outcome.stdout.lines().last().unwrap();
    assert_eq!(last, "1 passed, 0 failed, 1 without checks, 6 skipped");
    for reason in
        ["skipped 2 files: study", "skipped 1 file: schema", "skipped 1 file: slow", "2 files: no case"]
    {
        assert!(outcome.stdout.contains(reason), "{reason}: {}", outcome.stdout);
    }
    assert!(outcome.stdout.contains("without checks |"), "{}", outcome.stdout);
    let named = run(folder.path(), &["verify", ".", "-v"]).stdout;
    for line in ["skipped ./orders.json: study", "skipped ./package.json: no case"] {
        assert!(named.lines().any(|l| l == line), "{line}: {named}");
    }
    let list: serde_json::Value =
        serde_json::from_str(&run(folder.path(), &["verify", ".", "--json"]).stdout).unwrap();
    let verdicts: Vec<&str> =
        list.as_array().unwrap().iter().map(|o| o["verdict"].as_str().unwrap()).collect();
    assert_eq!(verdicts.iter().filter(|v| **v == "skipped").count(), 6, "{verdicts:?}");
    // What is named is taken for a case.
    assert_eq!(run(folder.path(), &["verify", "package.json"]).code, 2);
}

#[test]
fn the_junit_report_skips_what_tests_nothing() {
    let folder = tempfile::tempdir().unwrap();
    crowded(folder.path());
    run(folder.path(), &["verify", ".", "--junit", "report.xml", "-q"]);
    let report = fs::read_to_string(folder.path().join("report.xml")).unwrap();
    assert!(report.contains("tests=\"8\" failures=\"0\" skipped=\"7\">"), "{report}");
    assert_eq!(report.matches("<skipped message=").count(), 7, "{report}");
    assert!(report.contains("<skipped message=\"without checks\"/>"), "{report}");
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
    assert_eq!(passed(&["verify", "."]), "1 passed, 0 failed, 1 skipped");
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
    assert!(
        report.contains("<testsuite name=\"peristat\" tests=\"2\" failures=\"1\" skipped=\"0\">"),
        "{report}"
    );
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
