//! Runs that end otherwise than with a result.

use super::support::{machine, mpirun, root, stderr};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Exit code and stderr of a case that is not solved, by three processes; no summary is left.
fn refused(case: &str, arguments: &[&str]) -> (Option<i32>, String) {
    let _machine = machine();
    let folder = tempfile::tempdir().unwrap();
    let path = root().join("cases").join(case);
    let output =
        mpirun(3, folder.path()).arg("run").arg(path).args(["-o", "out"]).args(arguments).output().unwrap();
    assert!(!folder.path().join("out/summary.json").exists());
    (output.status.code(), stderr(&output))
}

#[test]
fn what_cannot_be_shared_is_told_once_with_what_to_do() {
    for (case, what) in [
        ("beam/cantilever.json", "beams and frames"),
        ("plate/breaking_plate.json", "bodies that break or soften"),
        ("plate/scattered_points.json", "bodies of listed points"),
        ("plate/edge_crack.json", "stress intensities, which need solves of their own,"),
        ("plate/uniaxial_tension.json", "cases that are solved by a factor, as this one,"),
    ] {
        let (code, text) = refused(case, &[]);
        assert_eq!(code, Some(2), "{case}: {text}");
        let message = format!(
            "error: {what} cannot be solved by several processes\nhint: run the case without `mpirun`"
        );
        assert_eq!(text.matches(&message).count(), 1, "{case}: {text}");
        assert_eq!(text.matches("error:").count(), 1, "{case}: {text}");
    }
}

#[test]
fn a_fault_of_the_case_is_told_once() {
    let (code, text) = refused("solid/bored_plate.json", &["--set", "horizon_ratio=0.2"]);
    assert_eq!(code, Some(2), "{text}");
    assert_eq!(text.matches("error:").count(), 1, "{text}");
    let (code, text) = refused("no_such_case.json", &[]);
    assert_eq!((code, text.matches("error:").count()), (Some(2), 1), "{text}");
    let (code, text) = refused("solid/bored_plate.json", &["--estimate"]);
    assert_eq!((code, text.matches("error:").count()), (Some(2), 1), "{text}");
}

#[test]
fn other_commands_want_no_mpirun() {
    let _machine = machine();
    let output = mpirun(2, &root()).args(["check", "cases/beam/cantilever.json"]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(stderr(&output).matches("error: `mpirun` is for `peristat run` alone").count(), 1);
}

/// Processes below one.
fn children(process: u32) -> Vec<u32> {
    let path = format!("/proc/{process}/task/{process}/children");
    let text = fs::read_to_string(path).unwrap_or_default();
    text.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

/// Waits until the results folder is there, which is claimed before the solve.
fn wait_for(path: &Path) {
    let begin = Instant::now();
    while !path.exists() {
        assert!(begin.elapsed() < Duration::from_secs(60), "{} comes", path.display());
        sleep(Duration::from_millis(5));
    }
}

#[test]
fn a_killed_process_ends_all_without_a_summary() {
    let _machine = machine();
    let folder = tempfile::tempdir().unwrap();
    let case = root().join("cases/solid/bored_plate.json");
    let mut run = mpirun(3, folder.path())
        .arg("run")
        .arg(case)
        .args(["-o", "out", "--set", "body.block.spacing=0.5"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    wait_for(&folder.path().join("out"));
    let processes = children(run.id());
    assert_eq!(processes.len(), 3, "mpirun starts them itself");
    let kill = Command::new("kill").args(["-s", "KILL", &processes[1].to_string()]).status().unwrap();
    assert!(kill.success());
    let begin = Instant::now();
    let status = loop {
        if let Some(status) = run.try_wait().unwrap() {
            break status;
        }
        assert!(begin.elapsed() < Duration::from_secs(60), "the others end, too");
        sleep(Duration::from_millis(20));
    };
    assert!(!status.success());
    assert!(!folder.path().join("out/summary.json").exists());
    // One that has ended may wait for its parent to take note.
    let is_running = |process: &u32| {
        let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
        status.contains("State:") && !status.contains("State:\tZ")
    };
    while processes.iter().any(is_running) {
        assert!(begin.elapsed() < Duration::from_secs(60), "{processes:?} end");
        sleep(Duration::from_millis(20));
    }
}
