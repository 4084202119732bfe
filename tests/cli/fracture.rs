//! Runs of bodies that break or soften, as a user stops, kills and resumes them.

use super::support::{Outcome, json, names, report_without_times, run};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A plate with a crack at its left edge that is pulled apart, bond by bond.
pub(crate) fn case() -> Value {
    json!({
        "title": "Plate that breaks", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 70000, "state": "plane_stress", "thickness": 1.0 } },
        "body": { "rectangle": { "size": [8, 14], "spacing": 1.0 } },
        "cracks": [ { "path": [[-1, 7], [2, 7]] } ],
        "regions": {
            "low": { "box": { "from": [0, 0], "to": [8, 3] } }, "high": { "box": { "from": [0, 11], "to": [8, 14] } }
        },
        "supports": [ { "at": { "region": "low" }, "ux": 0, "uy": 0 }, { "at": { "region": "high" }, "ux": 0, "uy": 0.3 } ],
        "probes": [ { "name": "pull", "at": { "region": "high" }, "field": "reaction_y" } ],
        "fracture": { "critical": { "energy_release_rate": 5.0 }, "strategy": "worst", "load": "pull", "record_every": 12 }
    })
}

/// Cantilevers that break one after the other, bond by bond.
fn beams() -> Value {
    let all = 0..CANTILEVERS;
    let of = |make: &dyn Fn(f64) -> Value| all.clone().map(|k| make(f64::from(k))).collect::<Vec<_>>();
    json!({
        "title": "Cantilevers that break",
        "model": { "timoshenko_beam": {
            "stiffness": { "bending": { "uniform": 2.0 }, "shear": { "uniform": 900.0 } }, "bond_law": "exact" } },
        "body": { "lines": of(&|k| json!({ "from": 2.0 * k, "length": 1.0, "cells": 10 })) },
        "supports": of(&|k| json!({ "at": { "x": 2.0 * k }, "w": 0.0, "phi": 0.0 })),
        "loads": of(&|k| json!({ "point": { "at": { "x": 2.0 * k + 1.0 }, "force": 1.0 / (1.0 + 0.1 * k) } })),
        "probes": [ { "name": "R", "at": { "x": 2.0 * f64::from(CANTILEVERS - 1) }, "field": "reaction_force" } ],
        "fracture": { "critical": { "curvature": 0.05 }, "strategy": "worst", "load": "R", "record_every": 5 }
    })
}

const CANTILEVERS: u32 = 20;

pub(crate) fn solve(folder: &Path, case: &Value, more: &[&str]) -> Outcome {
    fs::write(folder.join("breaking.json"), format!("{case:#}")).unwrap();
    let mut arguments = vec!["run", "breaking.json"];
    arguments.extend(more);
    run(folder, &arguments)
}

/// The run in `out`, to be stopped; it goes on with what is there, if there is anything to go on with.
pub(crate) fn spawn(folder: &Path) -> Child {
    spawn_with(folder, &[])
}

/// The same with options.
pub(crate) fn spawn_with(folder: &Path, options: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_peristat"));
    command.current_dir(folder).args(["run", "breaking.json", "-o", "out"]).args(options);
    if folder.join("out/restart.bin").exists() {
        command.arg("--resume");
    } else if folder.join("out").exists() {
        command.arg("--force");
    }
    command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the command starts")
}

/// Waits until the table of equilibria has more rows than some number, or the process has ended.
pub(crate) fn wait_for_rows(folder: &Path, child: &mut Child, rows: usize) {
    let begin = Instant::now();
    let count = || fs::read_to_string(folder.join("out/curve.csv")).map_or(0, |text| text.lines().count());
    while count() <= rows && child.try_wait().unwrap().is_none() {
        assert!(begin.elapsed() < Duration::from_secs(60), "the run does not get on");
        sleep(Duration::from_millis(2));
    }
}

/// Everything that two runs must have in common: all but wall time, memory and the number of evaluations.
fn outcome(out: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found = Vec::new();
    for part in ["", "fields", "plots"] {
        for name in names(&out.join(part)) {
            let path = out.join(part).join(&name);
            if path.is_file() && name == "report.html" {
                found.push((name, report_without_times(&path).into_bytes()));
            } else if path.is_file() && name != "summary.json" {
                found.push((format!("{part}/{name}"), fs::read(path).unwrap()));
            }
        }
    }
    let mut summary = json(&out.join("summary.json"));
    let whole = summary.as_object_mut().unwrap();
    whole.remove("timing_s");
    whole.remove("peak_memory_bytes");
    whole["counters"].as_object_mut().unwrap().remove("bond_evaluations");
    found.push(("summary.json".into(), format!("{summary:#}").into_bytes()));
    found
}

pub(crate) fn assert_same(found: &Path, expected: &Path) {
    let (found, expected) = (outcome(found), outcome(expected));
    let names = |all: &[(String, Vec<u8>)]| all.iter().map(|f| f.0.clone()).collect::<Vec<_>>();
    assert_eq!(names(&found), names(&expected));
    for ((name, found), (_, expected)) in found.iter().zip(&expected) {
        let [found, expected] = [found, expected].map(|bytes| String::from_utf8_lossy(bytes).into_owned());
        let differing = found.lines().zip(expected.lines()).find(|(a, b)| a != b);
        assert!(found == expected, "{name} differs: {differing:?}");
    }
}

#[test]
fn a_run_that_is_killed_again_and_again_ends_like_one_that_was_not() {
    killed_again_and_again(&case());
}

#[test]
fn so_does_a_run_in_load_steps() {
    let mut steps = case();
    (steps["fracture"]["strategy"], steps["fracture"]["increment"]) = (json!("batch"), json!(0.005));
    killed_again_and_again(&steps);
}

#[test]
fn so_does_a_solid_with_a_factor_and_with_cycles() {
    let bonds = json!({ "bond_solid": { "youngs_modulus": 1000 } });
    let families = json!({ "state_solid": { "youngs_modulus": 1000, "poisson_ratio": 0.3 } });
    for (solver, model, critical) in [
        ("sparse", &bonds, json!({ "energy_release_rate": 1 })),
        ("multigrid", &bonds, json!({ "energy_release_rate": 1 })),
        ("sparse", &families, json!({ "stretch": 0.012 })),
    ] {
        let solid = json!({
            "title": "Bar that breaks", "units": "none", "solver": solver, "horizon_ratio": 2,
            "model": model,
            "body": { "block": { "size": [8, 16, 4], "spacing": 1 } },
            "cracks": [ { "polygon": [[-1, 8, -1], [3, 8, -1], [3, 8, 5], [-1, 8, 5]] } ],
            "supports": [
                { "at": { "region": "bottom" }, "ux": 0, "uy": 0, "uz": 0 },
                { "at": { "region": "top" }, "ux": 0, "uy": 0.3, "uz": 0 }
            ],
            "probes": [ { "name": "pull", "at": { "region": "top" }, "field": "reaction_y" } ],
            "fracture": {
                "critical": critical, "strategy": "worst", "load": "pull", "record_every": 12
            }
        });
        killed_again_and_again(&solid);
    }
}

#[test]
fn so_do_runs_along_paths() {
    let mut path = case();
    path.as_object_mut().unwrap().remove("fracture");
    path["model"]["bond_plane"]["bond_law"] =
        json!({ "bilinear": { "yield_stretch": 0.003, "failure_stretch": 0.006 } });
    for control in ["event", "displacement"] {
        path["path"] = json!({ "load": "pull", "control": control, "increment": 0.005, "record_every": 7 });
        killed_again_and_again(&path);
    }
}

fn killed_again_and_again(case: &Value) {
    let folder = tempfile::tempdir().unwrap();
    let whole = solve(folder.path(), case, &["-o", "whole"]);
    assert_eq!(whole.code, 0, "{}\n{}", whole.stdout, whole.stderr);
    let rows = fs::read_to_string(folder.path().join("whole/curve.csv")).unwrap().lines().count() - 1;
    assert!(rows > 40, "{rows} equilibria are too few to be interrupted");
    // Not at the same place in every run of the test: any place will do.
    let mut random = u64::from(std::process::id());
    for kill in 0..5 {
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let mut child = spawn(folder.path());
        wait_for_rows(folder.path(), &mut child, kill * rows / 6 + 1);
        sleep(Duration::from_micros((random >> 33) % 20_000));
        child.kill().unwrap();
        child.wait().unwrap();
    }
    let last = spawn(folder.path()).wait_with_output().unwrap();
    assert!(last.status.success(), "{}", String::from_utf8_lossy(&last.stderr));
    assert_same(&folder.path().join("out"), &folder.path().join("whole"));
    assert!(!folder.path().join("out/restart.bin").exists());
}

/// Runs a case into `whole`, and into `out` until some equilibria are found and it is interrupted; what that said.
#[cfg(unix)]
pub(crate) fn interrupted(folder: &Path, case: &Value, rows: usize) -> String {
    use std::os::unix::process::ExitStatusExt;
    let whole = solve(folder, case, &["-o", "whole"]);
    assert_eq!(whole.code, 0, "{}\n{}", whole.stdout, whole.stderr);
    let mut child = spawn(folder);
    wait_for_rows(folder, &mut child, rows);
    let pid = child.id().to_string();
    assert!(Command::new("kill").args(["-s", "INT", &pid]).status().unwrap().success());
    let ended = child.wait_with_output().unwrap();
    assert_eq!((ended.status.code(), ended.status.signal()), (Some(130), None));
    let out = folder.join("out");
    let summary = json(&out.join("summary.json"));
    assert_eq!(summary["status"], "interrupted");
    let how_far = format!("after {} equilibria", summary["fracture"]["solves"]);
    assert_eq!(summary["interrupted"], how_far.as_str());
    let report = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(report.contains(&format!("Interrupted {how_far}")) && out.join("restart.bin").exists());
    let anew = solve(folder, case, &["-o", "out"]);
    assert_eq!(anew.code, 2, "it is not replaced unasked: {}", anew.stdout);
    String::from_utf8_lossy(&ended.stderr).into_owned()
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_of_beams_goes_on_later() {
    let folder = tempfile::tempdir().unwrap();
    // Some cantilevers are gone by then, and some equilibria are recorded, with the reactions of all.
    interrupted(folder.path(), &beams(), 15);
    let resumed = solve(folder.path(), &beams(), &["-o", "out", "--resume"]);
    assert_eq!(resumed.code, 0, "{}\n{}", resumed.stdout, resumed.stderr);
    assert_same(&folder.path().join("out"), &folder.path().join("whole"));
    let summary = json(&folder.path().join("out/summary.json"));
    assert_eq!(summary["fracture"]["island_points"], 10 * CANTILEVERS);
    assert_eq!(summary["states"][0]["reactions"].as_array().map(Vec::len), Some(CANTILEVERS as usize));
}

/// A plate in bending that breaks under a pressure.
fn plate() -> Value {
    json!({
        "title": "Pane that breaks", "units": "mm-N-MPa",
        "model": { "plate_bending": { "youngs_modulus": 70000, "poisson_ratio": 0.22, "thickness": 6 } },
        "body": { "rectangle": { "size": [400, 240], "spacing": 20 } },
        "supports": [ { "at": { "region": "all" }, "w": 0, "phi_t": 0 } ],
        "loads": [ { "pressure": { "value": -0.2 } } ],
        "probes": [ { "name": "walls", "at": { "region": "all" }, "field": "reaction_force" } ],
        "fracture": { "critical": { "curvature": 2e-4 }, "strategy": "worst", "load": "walls", "record_every": 5 }
    })
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_of_a_plate_in_bending_goes_on_later() {
    let folder = tempfile::tempdir().unwrap();
    interrupted(folder.path(), &plate(), 12);
    let resumed = solve(folder.path(), &plate(), &["-o", "out", "--resume"]);
    assert_eq!(resumed.code, 0, "{}\n{}", resumed.stdout, resumed.stderr);
    assert_same(&folder.path().join("out"), &folder.path().join("whole"));
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_says_so_and_goes_on_later() {
    let folder = tempfile::tempdir().unwrap();
    let told = interrupted(folder.path(), &case(), 5);
    // A thread of its own says this while a solve goes on; this one may end first, and say so before it.
    let told = told.replace("\nending after a solve; once more ends it at once\n", "");
    assert_eq!(told, "interrupted\nhint: the same command with `--resume` goes on from here\n");
    let out = folder.path().join("out");
    // The last equilibrium is kept.
    let before = fs::read_to_string(out.join("curve.csv")).unwrap();

    let mut changed = case();
    changed["fracture"]["critical"] = json!({ "energy_release_rate": 6.0 });
    let refused = solve(folder.path(), &changed, &["-o", "out", "--resume"]);
    assert_eq!(refused.code, 2, "{}", refused.stderr);
    assert!(refused.stderr.contains("is of another case, or the case or peristat has been changed since"));

    let resumed = solve(folder.path(), &case(), &["-o", "out", "--resume"]);
    assert_eq!(resumed.code, 0, "{}\n{}", resumed.stdout, resumed.stderr);
    assert!(fs::read_to_string(out.join("curve.csv")).unwrap().starts_with(&before));
    assert_same(&out, &folder.path().join("whole"));
    let again = solve(folder.path(), &case(), &["-o", "out", "--resume"]);
    assert_eq!(again.code, 2);
    assert!(again.stderr.contains("is finished"), "{}", again.stderr);
}

#[test]
fn a_body_that_came_apart_keeps_no_limit() {
    let folder = tempfile::tempdir().unwrap();
    let mut case = case();
    case["probes"]
        .as_array_mut()
        .unwrap()
        .push(json!({ "name": "top", "at": { "x": 3.5, "y": 13.5 }, "field": "uy" }));
    let limit = |probe: &str| json!([ { "limit": { "probe": probe, "at_most": 1e9, "why": "bears it" } } ]);
    for probe in ["top", "pull"] {
        case["checks"] = limit(probe);
        let broken = solve(folder.path(), &case, &["--force"]);
        assert_eq!(broken.code, 1, "{}", broken.stdout);
        assert!(
            broken.stdout.contains("FAILED: not at the full load: the load fell below"),
            "{}",
            broken.stdout
        );
    }
    // What is known of the whole run is checked however it ended.
    case["checks"] = limit("peak_load");
    assert_eq!(solve(folder.path(), &case, &["--force"]).code, 0);
    // A body that bears its load keeps its limits.
    case["checks"] = limit("top");
    case["fracture"]["critical"]["energy_release_rate"] = json!(5000.0);
    assert_eq!(solve(folder.path(), &case, &["--force"]).code, 0);
}

#[test]
fn the_probes_of_the_last_state_are_printed() {
    let folder = tempfile::tempdir().unwrap();
    let outcome = solve(folder.path(), &case(), &[]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let rows: Vec<&str> = outcome.stdout.lines().filter(|line| line.starts_with("| pull ")).collect();
    let states = json(&folder.path().join("results/breaking/summary.json"))["states"].clone();
    let last = states.as_array().unwrap().last().unwrap()["name"].as_str().unwrap().to_string();
    assert!(rows.len() == 1 && rows[0].contains(&format!(" {last} ")), "{last}: {rows:?}");
    assert!(rows[0].trim_end_matches([' ', '|']).ends_with(" N"), "{rows:?}");
}
