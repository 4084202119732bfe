//! The message of every bad input, to the letter. `UPDATE_EXPECTED=1` writes the messages anew.

use super::support::{files, peristat, root, run};
use std::env;
use std::fs;

#[test]
fn every_bad_input_gets_its_message_and_leaves_nothing_behind() {
    let folder = root().join("cases/invalid");
    let update = env::var_os("UPDATE_EXPECTED").is_some();
    let cases = files(&folder, ".json");
    assert!(cases.len() >= 370, "found only {} bad inputs", cases.len());
    let mut faults = Vec::new();
    for case in cases {
        let name = case.file_name().unwrap().to_string_lossy().into_owned();
        let temporary = tempfile::tempdir().unwrap();
        let output = temporary.path().join("results");
        let outcome = run(&folder, &["run", &name, "-o", &output.display().to_string()]);
        if outcome.code != 2 || !outcome.stdout.is_empty() || output.exists() {
            faults.push(format!("{name}: exit code {}, stdout `{}`", outcome.code, outcome.stdout));
        }
        let expected = case.with_extension("txt");
        if update {
            fs::write(&expected, &outcome.stderr).unwrap();
        }
        let expected = fs::read_to_string(&expected).unwrap_or_default();
        if outcome.stderr != expected {
            faults.push(format!("{name}: found\n{}\nexpected\n{expected}", outcome.stderr));
        }
    }
    assert!(faults.is_empty(), "{} differ\n\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn every_expected_message_belongs_to_a_case_and_says_what_and_where() {
    for message in files(&root().join("cases/invalid"), ".txt") {
        let case = message.with_extension("json");
        assert!(case.exists(), "{} has no case", message.display());
        let text = fs::read_to_string(&message).unwrap();
        let name = case.file_name().unwrap().to_string_lossy().into_owned();
        assert!(text.starts_with("error: "), "{name}: {text}");
        assert!(text.contains(&format!("--> {name}")), "{name} does not name its place: {text}");
        for jargon in ["panicked", "serde", "os error", "unwrap", "Some(", "struct "] {
            assert!(!text.contains(jargon), "{name} speaks of `{jargon}`: {text}");
        }
    }
}

#[test]
fn check_gives_the_same_message_as_run() {
    let folder = root().join("cases/invalid");
    for name in ["mechanism_rotation", "unknown_key", "supports_contradict"] {
        let outcome = run(&folder, &["check", &format!("{name}.json")]);
        assert_eq!(outcome.code, 2);
        assert_eq!(outcome.stderr, fs::read_to_string(folder.join(format!("{name}.txt"))).unwrap());
    }
}

#[test]
fn a_missing_file_and_a_folder_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("cases")).unwrap();
    let missing = run(folder.path(), &["run", "beam.json"]);
    let expected = "error: there is no such file\n  --> beam.json\n\
                    hint: `peristat new timoshenko_beam` prints a case to begin with\n";
    assert_eq!((missing.code, missing.stderr.as_str()), (2, expected));
    let directory = run(folder.path(), &["run", "cases"]);
    let expected = "error: this is a folder, not a case\n  --> cases\n\
                    hint: `peristat verify` runs all cases of a folder\n";
    assert_eq!((directory.code, directory.stderr.as_str()), (2, expected));
    assert!(!folder.path().join("results").exists());
}

#[test]
fn a_message_is_coloured_only_where_that_is_asked_for() {
    let folder = root().join("cases/invalid");
    let stderr = |color: &str| {
        let output =
            peristat(&folder).args(["check", "unknown_key.json", "--color", color]).output().unwrap();
        String::from_utf8(output.stderr).unwrap()
    };
    assert!(stderr("always").contains("\x1b["));
    assert!(!stderr("never").contains('\x1b') && !stderr("auto").contains('\x1b'));
}

#[test]
fn a_horizon_longer_than_the_beam_is_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    let case = super::support::gallery("cantilever_end_moment.json");
    let outcome = run(folder.path(), &["run", &case, "--set", "body.line.cells=2", "--set", "checks=[]"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert!(
        outcome.stderr.starts_with("warning: the horizon 1.5 is longer than the beam, 1"),
        "{}",
        outcome.stderr
    );
    let again = ["run", &case, "--set", "body.line.cells=2", "--set", "checks=[]", "-q", "--force"];
    let quiet = run(folder.path(), &again);
    assert_eq!((quiet.stdout.as_str(), quiet.stderr.as_str()), ("", ""));
}
