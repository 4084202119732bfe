//! Numbers in result files.

use super::support::{Outcome, files, gallery, json, names, report_without_times, root, run};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Paths of the values of a tree that are not there.
fn nulls(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Null => found.push(path.into()),
        Value::Array(list) => list.iter().for_each(|v| nulls(v, path, found)),
        Value::Object(keys) => keys.iter().for_each(|(k, v)| nulls(v, &format!("{path}.{k}"), found)),
        _ => {}
    }
}

#[test]
fn no_file_of_the_gallery_holds_a_value_that_is_not_a_number() {
    let folder = tempfile::tempdir().unwrap();
    // Those of other models that are solved in less than a second or so.
    let quick = [
        "axisymmetric/solid_bar",
        "axisymmetric/open_ends",
        "orthotropic/off_axis_tension",
        "plate/breaking_batch",
    ];
    let quick =
        quick.into_iter().chain(["plate/crack_tips", "plate/scattered_points", "ductile/notched_strip"]);
    let quick = quick.map(|name| root().join(format!("cases/{name}.json")));
    let whole = ["beam", "frame", "shell"].map(|name| files(&root().join("cases").join(name), ".json"));
    for (k, case) in whole.into_iter().flatten().chain(quick).enumerate() {
        let out = format!("{k}");
        run(folder.path(), &["run", &case.display().to_string(), "-q", "-o", &out]);
        assert!(folder.path().join(out).join("summary.json").exists(), "{}", case.display());
    }
    for file in files(folder.path(), ".csv") {
        for line in fs::read_to_string(&file).unwrap().lines().skip(1) {
            // A cell without a value is empty.
            let cells = line.split(',').filter(|cell| !cell.is_empty());
            let mut values = cells.map(|cell| cell.parse::<f64>().unwrap());
            assert!(values.all(f64::is_finite), "{}: {line}", file.display());
        }
    }
    for file in files(folder.path(), ".json") {
        let mut missing = Vec::new();
        nulls(&json(&file), "", &mut missing);
        // Not every system tells the memory of a process.
        missing.retain(|path| path != ".peak_memory_bytes");
        assert!(missing.is_empty(), "{}: {missing:?}", file.display());
    }
    for file in files(folder.path(), ".svg") {
        let text = fs::read_to_string(&file).unwrap().to_lowercase();
        let mut words = text.split(|c: char| !c.is_alphanumeric());
        assert!(!words.any(|w| ["nan", "inf", "infinity"].contains(&w)), "{}", file.display());
    }
}

#[test]
fn results_beyond_double_precision_are_an_error_and_no_folder() {
    let folder = tempfile::tempdir().unwrap();
    let case = gallery("cantilever.json");
    // Every number alone is admissible; the energy density is not.
    let sets = [
        "model.timoshenko_beam.section.rectangle.height=1e-40",
        "model.timoshenko_beam.section.rectangle.width=1e-40",
        "loads[0].point.force=1e60",
        "checks=[]",
    ];
    let mut arguments = vec!["run", &case, "-o", "out"];
    arguments.extend(sets.iter().flat_map(|s| ["--set", s]));
    let outcome = run(folder.path(), &arguments);
    assert_eq!(outcome.code, 2, "{}{}", outcome.stdout, outcome.stderr);
    assert!(
        outcome.stderr.starts_with("error: the results do not fit into double precision"),
        "{}",
        outcome.stderr
    );
    assert_eq!(names(folder.path()), Vec::<String>::new());
}

/// A cantilever that turns on a spring in place of its clamp, N m, solved in displacements.
fn on_a_spring(folder: &Path, stiffness: f64) -> Outcome {
    let supports = format!(r#"supports=[{{"at":{{"x":0}},"w":0,"phi_spring":{stiffness}}}]"#);
    let case = gallery("cantilever.json");
    let sets = [supports.as_str(), "solver=band", "checks=[]"];
    let mut arguments = vec!["run", &case, "-o", "out", "--force"];
    arguments.extend(sets.iter().flat_map(|s| ["--set", s]));
    run(folder, &arguments)
}

#[test]
fn few_digits_are_a_warning_and_none_is_no_result() {
    let folder = tempfile::tempdir().unwrap();
    for (stiffness, code, status, warned) in
        [(1e4, 0, "passed", false), (1e-8, 0, "passed", true), (1e-20, 1, "not_converged", true)]
    {
        let outcome = on_a_spring(folder.path(), stiffness);
        assert_eq!(outcome.code, code, "{stiffness}: {}{}", outcome.stdout, outcome.stderr);
        let summary = json(&folder.path().join("out/summary.json"));
        assert_eq!(summary["status"], status, "{stiffness}");
        let certificate = &summary["states"][0]["certificate"];
        let digits = ["digits", "strain_digits"].map(|key| certificate[key].as_u64().unwrap());
        let text = format!(
            "loads: only {} digits of displacements and {} of strains and forces can be trusted, by rounding and iteration",
            digits[0], digits[1]
        );
        let told = summary["warnings"].as_array().unwrap().iter().any(|w| *w == text.as_str());
        assert_eq!([told, outcome.stderr.contains(&text)], [warned; 2], "{stiffness}: {text}");
        let printed = format!("digits you can trust: {} of displacements, {} of", digits[0], digits[1]);
        assert!(outcome.stdout.contains(&printed), "{}", outcome.stdout);
        assert_eq!(outcome.stdout.contains("NOT CONVERGED"), code == 1);
        assert_eq!(warned, digits.iter().any(|d| *d < 6), "{digits:?}");
        assert_eq!(code == 1, digits.contains(&0), "{digits:?}");
    }
}

/// Everything a run wrote, but times.
fn numbers(folder: &Path) -> Vec<(String, String)> {
    let mut all: Vec<(String, String)> = Vec::new();
    for file in files(folder, "") {
        let name = file.strip_prefix(folder).unwrap().display().to_string();
        let text = if name == "summary.json" {
            let mut summary = json(&file);
            let keys = summary.as_object_mut().unwrap();
            keys.remove("timing_s");
            keys.remove("peak_memory_bytes");
            summary.to_string()
        } else if name == "report.html" {
            report_without_times(&file)
        } else {
            String::from_utf8_lossy(&fs::read(&file).unwrap()).into_owned()
        };
        all.push((name, text));
    }
    all
}

#[test]
fn the_case_of_a_run_runs_again_to_the_same_bytes() {
    for case in [
        "cantilever.json",
        "load_cases.json",
        "load_steps.json",
        "published_cells_ghost.json",
        "rigid_link.json",
    ] {
        let folder = tempfile::tempdir().unwrap();
        run(folder.path(), &["run", &gallery(case), "-q", "-o", "first"]);
        run(folder.path(), &["run", "first/case.json", "-q", "-o", "second"]);
        let (first, second) = (numbers(&folder.path().join("first")), numbers(&folder.path().join("second")));
        assert!(first.len() >= 8, "{case} wrote only {} files", first.len());
        assert_eq!(first.len(), second.len(), "{case}");
        for (a, b) in first.iter().zip(&second) {
            // The mark names the file of the case.
            assert!(a == b || a.0 == ".peristat", "{case}: {} and {} differ", a.0, b.0);
        }
    }
}
