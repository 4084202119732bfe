//! `--fields` and `--field-files`: what a folder then holds, and that the rest of it is the same.

use super::fracture::{assert_same, case, solve, spawn_with, wait_for_rows};
use super::support::{gallery, names, run};
use std::fs;
use std::path::Path;

fn fields(out: &Path) -> Vec<String> {
    if out.join("fields").exists() { names(&out.join("fields")) } else { Vec::new() }
}

/// Grids that the collection names.
fn collected(out: &Path) -> Option<Vec<String>> {
    let text = fs::read_to_string(out.join("fields.pvd")).ok()?;
    let of = |part: &str| part.split('"').next().map(String::from);
    Some(text.split("file=\"").skip(1).filter_map(of).collect())
}

#[test]
fn states_and_files_of_fields_are_chosen() {
    let folder = tempfile::tempdir().unwrap();
    let path = gallery("load_cases.json");
    let all = ["step_000", "step_001", "step_002", "step_003", "step_004"];
    let named = |states: &[&str], kinds: &[&str]| -> Vec<String> {
        states.iter().flat_map(|state| kinds.iter().map(move |kind| format!("{state}.{kind}"))).collect()
    };
    for (options, states, kinds) in [
        (&[][..], &all[..], &["csv", "vtu"][..]),
        (&["--fields", "last"], &all[4..], &["csv", "vtu"]),
        (&["--fields", "none"], &[], &[]),
        (&["--field-files", "vtu"], &all, &["vtu"]),
        (&["--fields", "last", "--field-files", "csv"], &all[4..], &["csv"]),
    ] {
        let out = folder.path().join("out");
        let run = run(folder.path(), &[&["run", &path, "-o", "out", "--force", "-q"], options].concat());
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert_eq!(fields(&out), named(states, kinds), "{options:?}");
        let grids =
            kinds.contains(&"vtu").then(|| states.iter().map(|s| format!("fields/{s}.vtu")).collect());
        assert_eq!(collected(&out), grids, "{options:?}");
        assert!(["summary.json", "report.html", "envelope.csv"].iter().all(|name| out.join(name).exists()));
    }
}

#[test]
fn a_run_that_keeps_the_last_fields_goes_on_after_it_was_killed() {
    let folder = tempfile::tempdir().unwrap();
    let last = ["--fields", "last"];
    let whole = solve(folder.path(), &case(), &[&["-o", "whole"], &last[..]].concat());
    assert_eq!(whole.code, 0, "{}", whole.stderr);
    let kept = fields(&folder.path().join("whole"));
    assert_eq!(kept.len(), 2, "{kept:?}");
    let out = folder.path().join("out");
    // With the fields of all states before, and of the last one after it was killed and resumed twice.
    for (rows, options) in [(15, &[][..]), (30, &last), (45, &last)] {
        let mut child = spawn_with(folder.path(), options);
        wait_for_rows(folder.path(), &mut child, rows);
        child.kill().unwrap();
        child.wait().unwrap();
    }
    let resumed = solve(folder.path(), &case(), &[&["-o", "out", "--resume"], &last[..]].concat());
    assert_eq!(resumed.code, 0, "{}", resumed.stderr);
    let found = fields(&out);
    assert!(found.len() > 2 && found.ends_with(&kept), "those of the first call and the last one: {found:?}");
    assert_eq!(collected(&out).map(|grids| 2 * grids.len()), Some(found.len()));
    for file in found.iter().filter(|file| !kept.contains(file)) {
        fs::remove_file(out.join("fields").join(file)).unwrap();
    }
    fs::copy(folder.path().join("whole/fields.pvd"), out.join("fields.pvd")).unwrap();
    assert_same(&out, &folder.path().join("whole"));
}
