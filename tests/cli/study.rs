//! Studies, as a user plans, stops, kills, spreads and collects them.

use super::support::{files, gallery, json, names, peristat, root, run};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant, SystemTime};

/// A study of a cantilever in a folder of its own, beside the cases that it may name.
fn study(folder: &Path, changes: &Value) -> String {
    for case in ["cantilever.json", "breaking_cantilever.json"] {
        fs::copy(gallery(case), folder.join(case)).unwrap();
    }
    let mut study = json!({
        "title": "cantilever",
        "case": "cantilever.json",
        "set": { "body.line.cells": 24, "checks": [] },
        "vary": [{ "model.timoshenko_beam.bond_law": ["published", "exact"] }],
        "refine": { "delta_convergence": { "factors": [1, 2, 4] } },
        "exact": [{ "quantity": "tip", "value": 3.20624e-3, "source": "F L³/(3 EI) + F L/(κGA)" }]
    });
    for (key, value) in changes.as_object().unwrap() {
        study[key] = value.clone();
    }
    fs::write(folder.join("tip.study.json"), format!("{study:#}")).unwrap();
    "tip.study.json".into()
}

/// Records of finished tasks with the times of their files.
fn finished(folder: &Path) -> BTreeMap<PathBuf, SystemTime> {
    let tasks = folder.join("results/tip.study/tasks");
    let all = if tasks.is_dir() { files(&tasks, ".json") } else { Vec::new() };
    all.into_iter().map(|file| (file.clone(), fs::metadata(file).unwrap().modified().unwrap())).collect()
}

#[test]
fn a_study_leaves_tables_diagrams_and_orders() {
    let folder = tempfile::tempdir().unwrap();
    let set = json!({ "body.line.cells": 24, "checks": [], "drawing": { "formats": ["png"] } });
    let file = study(folder.path(), &json!({ "set": set }));
    let outcome = run(folder.path(), &["study", &file]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert!(
        outcome.stdout.contains("bond_law published")
            && outcome.stdout.contains("results in results/tip.study")
    );
    let out = folder.path().join("results/tip.study");
    assert_eq!(
        names(&out),
        [".peristat", "plots", "report.html", "study.csv", "study.json", "tasks"],
        "{}",
        outcome.stdout
    );
    let found = json(&out.join("study.json"));
    let tip = &found["series"][0]["quantities"][0];
    assert_eq!(tip["name"], "tip");
    // 2.32 and 2.09 for 24, 48 and 96 cells; 2.02 at 192.
    let orders: Vec<f64> = tip["orders"].as_array().unwrap().iter().map(|o| o.as_f64().unwrap()).collect();
    assert!((orders[0] - 2.32).abs() < 0.01 && (orders[1] - 2.09).abs() < 0.01, "{orders:?}");
    assert!(found["series"][1]["quantities"][0]["limit"]["exact"]["value"].is_number(), "{found:#}");
    let table = fs::read_to_string(out.join("study.csv")).unwrap();
    assert!(table.starts_with("task,model.timoshenko_beam.bond_law,horizon [m],spacing [m],"), "{table}");
    assert!(table.contains(",quantity,unit,value,error,order\n") && table.contains(",tip,m,"), "{table}");
    assert_eq!(tip["unit"], "m");
    // Two quantities, the tip and the energy, of six tasks.
    assert_eq!(table.lines().count(), 13);
    let plots = names(&out.join("plots"));
    assert!(
        ["01_tip.svg", "01_tip.png"].iter().all(|name| plots.contains(&(*name).to_string())),
        "{plots:?}"
    );
}

#[test]
fn a_finished_task_is_never_solved_again() {
    let folder = tempfile::tempdir().unwrap();
    let file = study(folder.path(), &json!({}));
    let first = run(folder.path(), &["study", &file, "--task", "2", "--task", "5"]);
    assert_eq!((first.code, first.stdout.as_str()), (0, ""), "{}", first.stderr);
    let before = finished(folder.path());
    assert_eq!(before.len(), 2);
    // What is there is collected, and what lacks is said.
    let partial = run(folder.path(), &["study", &file, "--collect"]);
    assert_eq!(partial.code, 1);
    assert!(partial.stdout.contains("tasks without a result: 1, 3, 4, 6"), "{}", partial.stdout);
    assert_eq!(run(folder.path(), &["study", &file]).code, 0);
    let after = finished(folder.path());
    assert_eq!(after.len(), 6);
    assert!(before.iter().all(|(file, time)| after.get(file) == Some(time)));
    // Words change nothing, numbers do.
    study(folder.path(), &json!({ "title": "another" }));
    assert_eq!(run(folder.path(), &["study", &file]).code, 0);
    assert_eq!(finished(folder.path()), after);
    // Tables of other tasks are not lost without a word.
    let other = ["study", &file, "--set", "horizon_ratio=2"];
    let refused = run(folder.path(), &other);
    assert_eq!(refused.code, 2);
    let message = "error: results/tip.study holds tables of `another` with 6 tasks that this study has not\n\
                   hint: choose another folder with `-o`, or add `--force` to replace the tables; finished tasks stay\n";
    assert_eq!(refused.stderr, message);
    assert_eq!(finished(folder.path()), after);
    assert_eq!(run(folder.path(), &[&other[..], &["--force"]].concat()).code, 0);
    assert_eq!(finished(folder.path()).len(), 12);
}

#[test]
fn a_study_that_is_killed_goes_on_where_it_was() {
    let folder = tempfile::tempdir().unwrap();
    // Fractions of a second for each task in the displacement form.
    let slow = json!({
        "set": { "body.line.cells": 20_000, "checks": [], "solver": "band" },
        "vary": [{ "horizon_ratio": [2, 3, 4, 5, 6] }],
        "refine": { "delta_convergence": { "factors": [1, 2, 4] } }
    });
    let file = study(folder.path(), &slow);
    for signal in ["KILL", "INT"] {
        let known = finished(folder.path());
        let mut child = Command::new(env!("CARGO_BIN_EXE_peristat"))
            .current_dir(folder.path())
            .args(["study", &file, "--threads", "1"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let begin = Instant::now();
        while finished(folder.path()).len() < known.len() + 2 && begin.elapsed() < Duration::from_secs(60) {
            std::thread::sleep(Duration::from_millis(2));
        }
        let pid = child.id().to_string();
        assert!(Command::new("kill").args(["-s", signal, &pid]).status().unwrap().success());
        let code = child.wait().unwrap().code();
        let now = finished(folder.path());
        assert!(now.len() >= known.len() + 2 && now.len() < 15, "{signal}: {}", now.len());
        assert!(known.iter().all(|(file, time)| now.get(file) == Some(time)), "{signal}");
        assert!(signal == "KILL" || code == Some(130), "{code:?}");
    }
    let known = finished(folder.path());
    assert_eq!(run(folder.path(), &["study", &file]).code, 0);
    let all = finished(folder.path());
    assert_eq!(all.len(), 15);
    assert!(known.iter().all(|(file, time)| all.get(file) == Some(time)));
}

#[test]
fn the_plan_names_every_task_as_run_takes_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = study(folder.path(), &json!({}));
    let outcome = run(folder.path(), &["study", &file, "--plan", "--json"]);
    let plan: Value = serde_json::from_str(&outcome.stdout).unwrap();
    let tasks = plan["tasks"].as_array().unwrap();
    assert_eq!(tasks.len(), 6);
    assert!(!folder.path().join("results").exists(), "a plan writes nothing");
    let set: Vec<&str> = tasks[1]["set"].as_array().unwrap().iter().map(|s| s.as_str().unwrap()).collect();
    assert_eq!(set.last(), Some(&"body.line.cells=48"));
    let mut command = peristat(folder.path());
    command.args(["run", plan["case"].as_str().unwrap(), "--json"]);
    for set in set {
        command.args(["--set", set]);
    }
    let summary: Value = serde_json::from_slice(&command.output().unwrap().stdout).unwrap();
    assert_eq!(run(folder.path(), &["study", &file, "--task", "2"]).code, 0);
    let record = json(finished(folder.path()).keys().next().unwrap());
    assert_eq!(record["values"][0]["value"], summary["probes"][0]["value"]);
}

#[test]
fn all_limits_of_a_plate_work_whatever_the_spacing() {
    let folder = tempfile::tempdir().unwrap();
    for file in ["uniaxial_tension.json", "uniaxial_tension.csv"] {
        fs::copy(root().join("cases/plate").join(file), folder.path().join(file)).unwrap();
    }
    // 40 mm × 20 mm at a horizon of 3 mm: spacings are 20 mm over whole numbers, the next ones not above those asked for.
    let [m2, m4] = [20.0 / 14.0, 20.0 / 27.0];
    for (name, refine, set, horizons, spacings) in [
        ("m", json!({ "m_convergence": { "ratios": [2, 3, 4] } }), 3, [3.0, 3.0, 3.0], [m2, 1.0, m4]),
        (
            "delta",
            json!({ "delta_convergence": { "factors": [0.7, 1, 2] } }),
            3,
            [3.0 * m2, 3.0, 1.5],
            [m2, 1.0, 0.5],
        ),
        (
            "joint",
            json!({ "joint_convergence": { "factors": [1, 2, 4], "ratios": [2, 3, 4] } }),
            2,
            [2.0, 1.0, 0.5],
            [1.0, 20.0 / 60.0, 0.125],
        ),
    ] {
        let study = json!({ "title": name, "case": "uniaxial_tension.json", "set": { "horizon_ratio": set }, "refine": refine });
        fs::write(folder.path().join(format!("{name}.json")), study.to_string()).unwrap();
        let outcome = run(folder.path(), &["study", &format!("{name}.json")]);
        assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
        let fits = "note: horizon ratio 2.1 in place of 2: the next one at which the body is whole cells";
        assert_eq!(outcome.stdout.contains(fits), name == "m", "{}", outcome.stdout);
        assert!(
            outcome.stdout.contains("note: checks against a `baseline` are left out"),
            "{}",
            outcome.stdout
        );
        let found = json(&folder.path().join(format!("results/{name}/study.json")));
        let report = fs::read_to_string(folder.path().join(format!("results/{name}/report.html"))).unwrap();
        assert!(report.contains("baseline"), "{name}");
        let series = &found["series"][0];
        let close = |a: &Value, b: f64, most: f64| (a.as_f64().unwrap() - b).abs() <= most * b;
        for (k, level) in series["levels"].as_array().unwrap().iter().enumerate() {
            assert!(close(&level["horizon"], horizons[k], 1e-12), "{name}: {}", level["horizon"]);
            assert!(close(&level["spacing"], spacings[k], 1e-12), "{name}: {}", level["spacing"]);
        }
        // The bonds are exact for a uniform stress, whatever the horizon: σ²/(2E) times the volume, 1e-12.
        let energy = series["quantities"].as_array().unwrap().iter().find(|q| q["name"] == "energy").unwrap();
        let exact = 100.0 * 100.0 / (2.0 * 70_000.0) * 40.0 * 20.0 * 2.0;
        assert!(
            energy["values"].as_array().unwrap().iter().all(|v| close(v, exact, 1e-10)),
            "{name}: {energy}"
        );
    }
}

#[test]
fn a_limit_starts_from_the_horizon_that_the_model_has() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(root().join("cases/plate/springs.json"), folder.path().join("springs.json")).unwrap();
    let study =
        r#"{ "title": "m", "case": "springs.json", "refine": { "m_convergence": { "ratios": [2, 4] } } }"#;
    fs::write(folder.path().join("m.json"), study).unwrap();
    assert_eq!(run(folder.path(), &["study", "m.json"]).code, 0);
    let levels = &json(&folder.path().join("results/m/study.json"))["series"][0]["levels"];
    // Two spacings of 1 mm, of a plate that stays whole.
    assert!((0..2).all(|k| levels[k]["horizon"].as_f64() == Some(2.0)), "{levels}");
}

#[test]
fn faults_of_a_study_are_told_at_their_place() {
    let folder = tempfile::tempdir().unwrap();
    for (changes, told) in [
        (
            json!({ "refine": { "delta_convergence": { "factors": [1] } } }),
            "at `refine.delta_convergence.factors`",
        ),
        (json!({ "refine": { "delta_convergence": { "factors": [2, 1] } } }), "finer than the one before"),
        (
            json!({ "refine": { "joint_convergence": { "factors": [1, 2], "ratios": [6, 3] } } }),
            "finer than the one before",
        ),
        (json!({ "refine": { "values": { "sizes": [1, 1], "set": {} } } }), "finer than the one before"),
        (
            json!({ "refine": { "values": { "sizes": [2, 1], "set": { "horizon_ratio": [2] } } } }),
            "as many values",
        ),
        (json!({ "vary": [{ "horizon_ratio": [2, 3] }, { "horizon_ratio": [4] }] }), "another axis"),
        (json!({ "vary": [{ "horizon_ratio": [3, 3] }] }), "are the same"),
        (json!({ "expect": [{ "quantity": "tip" }] }), "expects nothing"),
        (
            json!({ "expect": [{ "quantity": "tip", "order": 2,
                "where": { "model.timoshenko_beam.bond_law": "publishd" } }] }),
            "no series has these values",
        ),
        (
            json!({ "refine": { "delta_convergence": { "factors": [1, 1.01, 1.02] } } }),
            "the factor 1.02 takes the spacing of the value before it",
        ),
        (
            json!({ "refine": { "delta_convergence": { "factors": [0.03, 1] } } }),
            "the factor 0.03 leaves a part of a cell",
        ),
        (
            json!({ "refine": { "joint_convergence": { "factors": [1, 2], "ratios": [2] } } }),
            "as many ratios",
        ),
        (json!({ "refine": { "halving": {} } }), "halving"),
        (json!({ "vary": [{ "horizon_ratio": [] }] }), "a list of values"),
        (json!({ "vary": [{ "horizon_ratio": [2, 3], "slow": [true] }] }), "equally long"),
        (json!({ "vary": [{ "horizon_rato": [2, 3] }] }), "horizon_rato"),
        (json!({ "case": "nowhere.json" }), "nowhere.json"),
        (json!({ "expect": [{ "quantity": "tip", "where": { "solver": "band" } }] }), "is not varied"),
        (json!({ "sets": {} }), "sets"),
    ] {
        let file = study(folder.path(), &changes);
        let outcome = run(folder.path(), &["study", &file]);
        assert_eq!(outcome.code, 2, "{changes}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(told), "{changes}: {}", outcome.stderr);
    }
    let file = study(folder.path(), &json!({}));
    let outcome = run(folder.path(), &["study", &file, "--task", "7"]);
    assert!(outcome.code == 2 && outcome.stderr.contains("tasks 1 to 6"), "{}", outcome.stderr);
}

#[test]
fn faults_of_all_tasks_are_told_before_one_is_solved() {
    let folder = tempfile::tempdir().unwrap();
    // Two supports between points, which only a grid shows, and one that leaves the beam free.
    let changes = json!({
        "vary": [{ "supports[0].at.x": [0.0, 0.3, 0.7] }, { "supports[0].phi": [0.0, null] }], "exact": []
    });
    let file = study(folder.path(), &changes);
    let outcome = run(folder.path(), &["study", &file]);
    assert_eq!(outcome.code, 2, "{}", outcome.stderr);
    // The tasks of (0.0, held) are sound; of the others, 0.3 and 0.7 are on no grid of 24, 48 or 96 cells.
    for told in [
        "tasks 4 to 6 of 18",
        "free to rotate",
        "tasks 7 and 10 of 18",
        "between two points",
        "tasks 15 and 18 of 18",
    ] {
        assert!(outcome.stderr.contains(told), "{told}: {}", outcome.stderr);
    }
    assert!(!outcome.stderr.contains("tasks 1 "), "{}", outcome.stderr);
    assert_eq!(finished(folder.path()).len(), 0);
    // Sound tasks that are asked for one by one are solved.
    assert_eq!(run(folder.path(), &["study", &file, "--task", "2"]).code, 0);
    assert_eq!(finished(folder.path()).len(), 1);
}

#[test]
fn values_that_are_none_are_told_of_all_tasks() {
    let folder = tempfile::tempdir().unwrap();
    let changes = json!({ "vary": [{ "body.line.length": [1.0, "long", [2]] }], "exact": [] });
    let file = study(folder.path(), &changes);
    let outcome = run(folder.path(), &["study", &file]);
    assert_eq!(outcome.code, 2, "{}", outcome.stderr);
    for told in ["tasks 4 to 6 of 9", "tasks 7 to 9 of 9"] {
        assert!(outcome.stderr.contains(told), "{told}: {}", outcome.stderr);
    }
    assert!(!folder.path().join("results").exists());
}

#[test]
fn expectations_decide_about_the_exit_code() {
    let folder = tempfile::tempdir().unwrap();
    for (expect, code) in [
        (json!({ "quantity": "tip", "order": 2, "within": 0.5 }), 0),
        (json!({ "quantity": "tip", "order": 3 }), 1),
        (json!({ "quantity": "tip", "error_at_most": 1e-3 }), 0),
        (json!({ "quantity": "tip", "error_at_most": 1e-9 }), 1),
        (json!({ "quantity": "tap", "order": 2 }), 1),
        // No exact energy is known.
        (json!({ "quantity": "energy", "error_at_most": 1.0 }), 1),
    ] {
        let changes =
            json!({ "vary": [{ "model.timoshenko_beam.bond_law": ["published"] }], "expect": [expect] });
        let file = study(folder.path(), &changes);
        let outcome = run(folder.path(), &["study", &file]);
        assert_eq!(outcome.code, code, "{expect}: {}", outcome.stdout);
    }
}

#[test]
fn an_exact_value_of_nothing_fails() {
    let folder = tempfile::tempdir().unwrap();
    let file =
        study(folder.path(), &json!({ "exact": [{ "quantity": "tpi", "value": 1.0, "source": "none" }] }));
    let outcome = run(folder.path(), &["study", &file]);
    assert!(outcome.code == 1 && outcome.stdout.contains("no such quantity"), "{}", outcome.stdout);
}

#[test]
fn bodies_that_break_have_no_orders() {
    let folder = tempfile::tempdir().unwrap();
    let changes = json!({
        "case": "breaking_cantilever.json", "set": { "checks": [] }, "vary": [], "exact": [],
        "refine": { "delta_convergence": { "factors": [1, 2] } }
    });
    let file = study(folder.path(), &changes);
    run(folder.path(), &["study", &file]);
    let found = json(&folder.path().join("results/tip.study/study.json"));
    let quantities = found["series"][0]["quantities"].as_array().unwrap();
    assert!(!quantities.is_empty());
    assert!(
        quantities.iter().all(|q| q.get("limit").is_none() && q["orders"] == json!([])),
        "{quantities:#?}"
    );
}

#[test]
fn tasks_beyond_their_share_of_memory_are_solved_alone() {
    let folder = tempfile::tempdir().unwrap();
    let changes = json!({
        "set": { "body.line.cells": 40_000, "checks": [], "solver": "band" },
        "vary": [{ "horizon_ratio": [2, 3, 4] }],
        "refine": { "delta_convergence": { "factors": [1, 2] } }
    });
    let file = study(folder.path(), &changes);
    // The largest needs more than a quarter of this.
    let outcome = run(folder.path(), &["study", &file, "--threads", "4", "--max-memory", "100MB"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let outcome =
        run(folder.path(), &["study", &file, "-o", "small", "--threads", "1", "--max-memory", "25MB"]);
    assert!(outcome.code == 1 && outcome.stderr.contains("of memory would be needed"), "{}", outcome.stderr);
}

#[test]
fn other_files_are_not_mixed_with_those_of_a_study() {
    let folder = tempfile::tempdir().unwrap();
    let file = study(folder.path(), &json!({}));
    fs::create_dir_all(folder.path().join("results/tip.study")).unwrap();
    fs::write(folder.path().join("results/tip.study/mine.txt"), "mine").unwrap();
    let outcome = run(folder.path(), &["study", &file]);
    assert!(outcome.code == 2 && outcome.stderr.contains("mine.txt"), "{}", outcome.stderr);
    assert_eq!(run(folder.path(), &["study", &file, "--force"]).code, 0);
}

#[test]
fn what_a_killed_study_was_writing_is_removed() {
    let folder = tempfile::tempdir().unwrap();
    let file = study(folder.path(), &json!({ "vary": [] }));
    assert_eq!(run(folder.path(), &["study", &file]).code, 0);
    let part = |name: &str| folder.path().join("results/tip.study").join(name);
    for name in ["tasks/.a1.part", "plots/.b2.part"] {
        fs::write(part(name), "half").unwrap();
    }
    // Others may be writing where one task is solved.
    assert_eq!(run(folder.path(), &["study", &file, "--task", "1"]).code, 0);
    assert!(part("tasks/.a1.part").exists() && part("plots/.b2.part").exists());
    assert_eq!(run(folder.path(), &["study", &file]).code, 0);
    assert!(files(folder.path(), ".part").is_empty());
}

#[test]
fn a_run_estimates_its_error() {
    let folder = tempfile::tempdir().unwrap();
    let estimated = |case: &str, option: &str, out: &str| {
        let outcome = run(folder.path(), &["run", &gallery(case), option, "-o", out]);
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        (outcome.stdout, json(&folder.path().join(out).join("summary.json")))
    };
    // 1.00, 1.05 and, by the exact beam, 1.00.
    for (case, option, kind, exact) in [
        ("foundation_table.json", "--estimate", "finer_and_coarser", 0.014596295258865619),
        ("foundation_table.json", "--verbose", "coarser", 0.014596295258865619),
        ("published.json", "--verbose", "exact_beam", 3.20624e-3),
    ] {
        let (printed, summary) = estimated(case, option, kind);
        assert!(printed.contains("error of the grid, against the local solution"), "{printed}");
        assert_eq!(summary["estimate"]["kind"], kind);
        let tip = &summary["estimate"]["quantities"][0];
        let ratio = tip["error"].as_f64().unwrap() / (tip["value"].as_f64().unwrap() - exact).abs();
        assert!((0.5..=2.0).contains(&ratio), "{ratio} {tip}");
    }
    let (printed, summary) = estimated("published.json", "--no-estimate", "without");
    assert!(summary.get("estimate").is_none() && !printed.contains("error of the grid"), "{printed}");
}

#[test]
fn why_there_is_no_estimate_is_said_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let outcome = run(folder.path(), &["run", &gallery("graded_positions.json"), "-o", "out"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let lines: Vec<&str> = outcome.stdout.lines().filter(|l| l.contains("error of the grid")).collect();
    assert!(lines.len() == 1 && lines[0].contains("not estimated; `body.line.cells`"), "{lines:?}");
    let summary = json(&folder.path().join("out/summary.json"));
    assert!(summary["no_estimate"].as_str().unwrap().contains("no spacing to change"));
}

#[test]
fn a_study_and_a_case_of_one_name_have_folders_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    let file = study(folder.path(), &json!({}));
    fs::copy(gallery("cantilever.json"), folder.path().join("tip.json")).unwrap();
    assert_eq!(run(folder.path(), &["run", "tip.json"]).code, 0);
    let outcome = run(folder.path(), &["study", &file]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert_eq!(names(&folder.path().join("results")), ["tip", "tip.study"]);
    assert_eq!(run(folder.path(), &["run", "tip.json"]).code, 0);
}

#[test]
fn a_case_is_no_study_and_a_study_no_case() {
    let folder = tempfile::tempdir().unwrap();
    let file = study(folder.path(), &json!({}));
    let case = run(folder.path(), &["study", "cantilever.json"]);
    assert_eq!(case.code, 2);
    assert!(case.stderr.starts_with("error: this is a case, not a study"), "{}", case.stderr);
    assert!(case.stderr.contains("hint: `peristat run cantilever.json` solves it"), "{}", case.stderr);
    for more in [&[][..], &["--set", "body.line.cells=4"]] {
        let study = run(folder.path(), &[&["run", &file], more].concat());
        assert_eq!(study.code, 2);
        assert!(study.stderr.starts_with("error: this is a study, not a case"), "{}", study.stderr);
        assert!(study.stderr.contains("hint: `peristat study tip.study.json` solves it"), "{}", study.stderr);
    }
}
