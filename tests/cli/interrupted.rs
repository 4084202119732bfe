//! Runs over many states that are interrupted: they leave what they have.
#![cfg(unix)]

use super::support::{json, names, root};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Runs a case into `out` until a file is there, and terminates it.
fn interrupted(folder: &Path, case: &Value, file: &str) -> Value {
    fs::write(folder.join("case.json"), case.to_string()).unwrap();
    let mut child = Command::new(env!("CARGO_BIN_EXE_peristat"))
        .current_dir(folder)
        .args(["run", "case.json", "-o", "out"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let begin = Instant::now();
    while !folder.join("out").join(file).exists() {
        assert!(begin.elapsed() < Duration::from_secs(60) && child.try_wait().unwrap().is_none());
        sleep(Duration::from_millis(2));
    }
    assert!(Command::new("kill").args(["-s", "TERM", &child.id().to_string()]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let summary = json(&folder.join("out/summary.json"));
    assert_eq!(summary["status"], "interrupted");
    let told = format!("Interrupted {}", summary["interrupted"].as_str().unwrap());
    assert!(fs::read_to_string(folder.join("out/report.html")).unwrap().contains(&told), "{told}");
    summary
}

#[test]
fn load_steps_leave_those_that_are_solved() {
    let folder = tempfile::tempdir().unwrap();
    let mut case = json(&root().join("cases/plate/steel_plate.json"));
    case["steps"] = json!({ "load_factors": (1..400).map(|k| 0.001 * f64::from(k)).collect::<Vec<_>>() });
    case["checks"] = json!([]);
    let summary = interrupted(folder.path(), &case, "fields/step_003.vtu");
    let states = summary["states"].as_array().unwrap().len();
    assert!((4..399).contains(&states), "{states}");
    assert_eq!(summary["interrupted"], format!("after {states} of 399 states"));
    let out = folder.path().join("out");
    // Table, grid and line.
    assert_eq!(names(&out.join("fields")).len(), 3 * states);
    assert_eq!(fs::read_to_string(out.join("history.csv")).unwrap().lines().count(), states + 1);
    assert!(!out.join("restart.bin").exists(), "there is nothing to go on with");
}

#[test]
fn a_path_leaves_its_curve() {
    let folder = tempfile::tempdir().unwrap();
    let mut case = json(&root().join("cases/ductile/notched_strip.json"));
    case["path"]["increment"] = json!(1e-4);
    case["checks"] = json!([]);
    let summary = interrupted(folder.path(), &case, "curve.csv");
    assert_eq!(summary["path"]["ending"], "the run was interrupted");
    // No state needs to have been recorded: `--resume` goes on from the last one of the curve.
    assert!(summary["path"]["steps"].as_u64().unwrap() > 0);
}
