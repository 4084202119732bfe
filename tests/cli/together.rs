//! Two processes at one folder.

use super::fracture::{assert_same, case as breaking, solve, spawn, wait_for_rows};
use super::support::{gallery, names, run};
use serde_json::json;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Halts a process, and lets it go on.
fn signal(name: &str, child: &Child) {
    let sent = Command::new("kill").args(["-s", name, &child.id().to_string()]).status();
    assert!(sent.unwrap().success());
}

#[test]
fn a_second_run_into_a_folder_is_refused_for_as_long_as_the_first_lives() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(solve(folder.path(), &breaking(), &["-o", "whole"]).code, 0);
    let mut first = spawn(folder.path());
    wait_for_rows(folder.path(), &mut first, 3);
    signal("STOP", &first);
    let message = "error: another peristat is writing into out\n\
                   hint: choose another folder with `-o`, or wait until it has ended\n";
    for more in [None, Some("--force"), Some("--resume")] {
        let second = solve(folder.path(), &breaking(), &[&["-o", "out"], more.as_slice()].concat());
        assert_eq!((second.code, second.stderr.as_str()), (2, message), "{more:?}");
    }
    fs::create_dir(folder.path().join("deep")).unwrap();
    fs::copy(folder.path().join("breaking.json"), folder.path().join("out.json")).unwrap();
    let verified = run(folder.path(), &["verify", "out.json", "-o", ".", "--force"]);
    assert!(verified.code == 2 && verified.stderr.contains("another peristat is writing into ./out"));
    signal("CONT", &first);
    assert!(first.wait().unwrap().success());
    assert_same(&folder.path().join("out"), &folder.path().join("whole"));
    let refused = run(folder.path(), &["run", "out.json", "-o", "out"]);
    assert!(refused.code == 2 && refused.stderr.contains("out holds a finished run of `Plate that breaks`"));

    fs::remove_dir_all(folder.path().join("out")).unwrap();
    let mut killed = spawn(folder.path());
    wait_for_rows(folder.path(), &mut killed, 3);
    killed.kill().unwrap();
    killed.wait().unwrap();
    let told = solve(folder.path(), &breaking(), &["-o", "out"]);
    assert!(told.stderr.contains("holds an unfinished run of `Plate that breaks`"), "{}", told.stderr);
    assert!(told.code == 2 && told.stderr.contains("`peristat run` goes on with it if `--resume` is added"));
    assert_eq!(solve(folder.path(), &breaking(), &["-o", "out", "--force"]).code, 0);
}

#[test]
fn a_run_that_comes_to_nothing_leaves_no_folder_and_no_lock() {
    let folder = tempfile::tempdir().unwrap();
    let case = gallery("cantilever.json");
    for _ in 0..2 {
        let outcome = run(folder.path(), &["run", &case, "--max-memory", "10kB", "-o", "out"]);
        assert_eq!(outcome.code, 2, "{}", outcome.stderr);
        assert!(!folder.path().join("out").exists());
    }
    // Of one that was killed before its first result only the mark is left.
    fs::create_dir(folder.path().join("out")).unwrap();
    fs::write(folder.path().join("out/.peristat"), "").unwrap();
    assert_eq!(run(folder.path(), &["run", &case, "-o", "out"]).code, 0);
}

/// A study with two tasks that take long.
fn study(folder: &Path) {
    let study = json!({
        "title": "slow", "case": "cantilever.json",
        "set": { "body.line.cells": 60_000, "checks": [], "solver": "band" },
        "vary": [{ "horizon_ratio": [5, 6] }]
    });
    fs::copy(gallery("cantilever.json"), folder.join("cantilever.json")).unwrap();
    fs::write(folder.join("slow.study.json"), study.to_string()).unwrap();
}

/// Begins a study and halts it as soon as it has locked a file of such an ending.
fn halted(folder: &Path, more: &[&str], ending: &str) -> Child {
    let child = Command::new(env!("CARGO_BIN_EXE_peristat"))
        .current_dir(folder)
        .args(["study", "slow.study.json", "-o", "out", "--threads", "1", "-q"])
        .args(more)
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let begin = Instant::now();
    let find = |part: PathBuf| {
        let name = part.is_dir().then(|| names(&part).into_iter().find(|name| name.ends_with(ending)))??;
        Some(part.join(name))
    };
    // A file is there before it is locked, and only one who is halted does not lock it while this asks.
    let is_locked = |path: PathBuf| File::open(path).is_ok_and(|file| file.try_lock().is_err());
    let is_found =
        || find(folder.join("out/tasks")).or_else(|| find(folder.join("out"))).is_some_and(is_locked);
    signal("STOP", &child);
    while !is_found() {
        assert!(begin.elapsed() < Duration::from_secs(60), "the study does not begin");
        signal("CONT", &child);
        sleep(Duration::from_millis(1));
        signal("STOP", &child);
    }
    child
}

#[test]
fn tasks_of_a_study_are_shared_and_none_is_solved_twice_at_once() {
    let folder = tempfile::tempdir().unwrap();
    study(folder.path());
    let then = |more: &[&str]| {
        run(folder.path(), &[&["study", "slow.study.json", "-o", "out", "-q"], more].concat())
    };
    let mut first = halted(folder.path(), &["--task", "1"], ".lock");
    let same = then(&["--task", "1"]);
    let message = "error: another peristat is solving task 1\n\
                   hint: wait until it has ended, or solve other tasks\n";
    assert_eq!((same.code, same.stderr.as_str()), (2, message));
    assert_eq!(then(&["--task", "2"]).code, 0);
    assert_eq!(then(&["--collect"]).code, 1, "a task is missing");
    let all = then(&[]);
    let message = "error: another peristat is writing into out\n\
                   hint: wait until it has ended; with `--task` several share a study\n";
    assert_eq!((all.code, all.stderr.as_str()), (2, message));
    first.kill().unwrap();
    first.wait().unwrap();
    assert_eq!(then(&["--task", "1"]).code, 0);
    assert_eq!(names(&folder.path().join("out/tasks")).len(), 2, "no lock is left");
    assert_eq!(then(&["--collect"]).code, 0);
}

#[test]
fn a_whole_study_wants_its_folder_for_itself() {
    let folder = tempfile::tempdir().unwrap();
    study(folder.path());
    let mut first = halted(folder.path(), &[], ".peristat");
    for more in [&[][..], &["--task", "2"]] {
        let second = run(folder.path(), &[&["study", "slow.study.json", "-o", "out", "-q"], more].concat());
        assert!(
            second.code == 2 && second.stderr.contains("another peristat is writing into out"),
            "{more:?}"
        );
    }
    first.kill().unwrap();
    first.wait().unwrap();
    assert_eq!(run(folder.path(), &["study", "slow.study.json", "-o", "out", "-q", "--task", "2"]).code, 0);
}
