//! The folder of a run.

use super::support::{files, gallery, json, names, run};
use std::fs;
use std::path::Path;

fn solve(folder: &Path, case: &str, more: &[&str]) -> super::support::Outcome {
    let case = gallery(case);
    let mut arguments = vec!["run", &case, "-o", "out"];
    arguments.extend(more);
    run(folder, &arguments)
}

#[test]
fn a_run_leaves_its_case_fields_history_plots_and_summary() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(solve(folder.path(), "load_steps.json", &[]).code, 0);
    let out = folder.path().join("out");
    assert_eq!(
        names(&out),
        [
            ".peristat",
            "case.json",
            "fields",
            "fields.pvd",
            "history.csv",
            "plots",
            "report.html",
            "summary.json"
        ]
    );
    assert_eq!(names(&out.join("plots")), ["deflection.svg", "moment.svg", "rotation.svg", "shear.svg"]);
    let steps = (0..4).flat_map(|k| [format!("step_00{k}.csv"), format!("step_00{k}.vtu")]);
    assert_eq!(names(&out.join("fields")), steps.collect::<Vec<_>>());
    let collection = fs::read_to_string(out.join("fields.pvd")).unwrap();
    assert_eq!(collection.matches("<DataSet").count(), 4);
    let history = fs::read_to_string(out.join("history.csv")).unwrap();
    let mut lines = history.lines();
    assert_eq!(lines.next(), Some("step,load_factor,tip [m],stress [Pa]"));
    assert_eq!(lines.count(), 4);
    let header = fs::read_to_string(out.join("fields/step_000.csv")).unwrap();
    assert!(
        header.starts_with(
            "x [m],w [m],phi [rad],M [N m],V [N],stress_top [Pa],stress_bottom [Pa],energy_density [Pa],M_left [N m],V_left [N]\n"
        ),
        "{header}"
    );
}

#[test]
fn a_frame_leaves_its_members_places_in_the_plane_and_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let case = super::support::root().join("cases/frame/haunch.json").display().to_string();
    let outcome = run(folder.path(), &["run", &case, "-o", "out"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    for line in ["| column | ", "| joint `foot` |", "| tip ", "joint `tip`"] {
        assert!(outcome.stdout.contains(line), "no `{line}` in\n{}", outcome.stdout);
    }
    let out = folder.path().join("out");
    assert_eq!(names(&out.join("plots")), ["axial_force.svg", "deformed.svg", "moment.svg", "shear.svg"]);
    let moment = fs::read_to_string(out.join("plots/moment.svg")).unwrap();
    assert!(moment.contains("on the side in tension") && moment.contains("−20×10³"));
    let table = fs::read_to_string(out.join("fields/step_000.csv")).unwrap();
    let header = "member,s [m],x [m],y [m],ux [m],uy [m],w [m],u [m],phi [rad],N [N],V [N],M [N m],stress_top [Pa],stress_bottom [Pa],energy_density [Pa],N_left [N],V_left [N],M_left [N m]";
    assert_eq!(table.lines().next(), Some(header));
    // The foot, and the tip: member 2, s = 2, at (2, 3).
    assert!(table.lines().nth(1).unwrap().starts_with("1.0,0.0,0.0,0.0,"));
    assert!(table.lines().last().unwrap().starts_with("2.0,2.0,2.0,3.0,"));
    assert_eq!(table.lines().count(), 1 + 13 + 21);
    let summary = json(&out.join("summary.json"));
    let (state, arm) = (&summary["states"][0], &summary["states"][0]["members"][1]);
    assert_eq!(arm["name"], "arm");
    assert!((arm["M"][0].as_f64().unwrap() + 2e4).abs() < 1e-6 && arm["M"][1].as_f64().unwrap().abs() < 1e-6);
    assert_eq!(state["extremes"]["uy"]["smallest"]["member"], "arm");
    assert_eq!(state["joint_reactions"][0]["place"], "joint `foot`");
    assert!((state["joint_reactions"][0]["force_y"].as_f64().unwrap() - 1e4).abs() < 1e-6);
}

#[test]
fn a_frame_is_a_baseline_of_itself() {
    let folder = tempfile::tempdir().unwrap();
    let case = super::support::root().join("cases/frame/portal.json");
    let first = run(folder.path(), &["run", &case.display().to_string(), "-o", "out"]);
    assert_eq!(first.code, 0, "{}", first.stderr);
    let mut case = json(&case);
    case["checks"] = serde_json::json!([
        { "baseline": { "file": "out/fields/step_000.csv", "field": "uy", "tolerance": 1e-12 } }
    ]);
    fs::write(folder.path().join("again.json"), case.to_string()).unwrap();
    let again = run(folder.path(), &["run", "again.json", "-o", "again"]);
    assert_eq!(again.code, 0, "{}\n{}", again.stdout, again.stderr);
}

#[test]
fn a_line_that_stretches_has_columns_for_it() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(solve(folder.path(), "axial_bar.json", &[]).code, 0);
    let table = fs::read_to_string(folder.path().join("out/fields/step_000.csv")).unwrap();
    assert_eq!(table.lines().next(), Some("x,w,phi [rad],u,M,V,N,M_left,V_left,N_left"));
}

#[test]
fn load_cases_leave_their_envelope() {
    let folder = tempfile::tempdir().unwrap();
    solve(folder.path(), "load_cases.json", &[]);
    let envelope = fs::read_to_string(folder.path().join("out/envelope.csv")).unwrap();
    let header = "x [mm],w_smallest [mm],w_largest [mm],phi_smallest [rad],phi_largest [rad],M_smallest [N mm],M_largest [N mm],V_smallest [N],V_largest [N]";
    assert_eq!(envelope.lines().next(), Some(header));
    // At mid-span the lowest deflection is that of the combination `ultimate`, the highest that of `dead`.
    let middle: Vec<f64> = envelope.lines().nth(41).unwrap().split(',').map(|c| c.parse().unwrap()).collect();
    let summary = json(&folder.path().join("out/summary.json"));
    let probe = |state: &str| {
        let probes = summary["probes"].as_array().unwrap();
        let found = probes.iter().find(|p| p["state"] == state && p["name"] == "middle").unwrap();
        found["value"].as_f64().unwrap()
    };
    assert_eq!(middle[..3], [2000.0, probe("ultimate"), probe("dead")]);
}

#[test]
fn a_summary_holds_what_it_promises() {
    let folder = tempfile::tempdir().unwrap();
    solve(folder.path(), "cantilever.json", &[]);
    let summary = json(&folder.path().join("out/summary.json"));
    for key in [
        "status",
        "model",
        "points",
        "bonds",
        "unknowns",
        "checks",
        "probes",
        "states",
        "skipped",
        "counters",
        "warnings",
        "solver",
        "timing_s",
        "peak_memory_bytes",
        "version",
    ] {
        assert!(summary.get(key).is_some(), "`{key}` is missing");
    }
    for key in ["name", "expected", "found", "error", "tolerance", "passed", "source"] {
        assert!(summary["checks"][0].get(key).is_some(), "`{key}` of a check is missing");
    }
    assert_eq!(summary["states"][0]["certificate"]["converged"], true);
}

#[test]
fn an_earlier_run_is_replaced_as_a_whole_if_that_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    solve(folder.path(), "load_steps.json", &[]);
    let out = folder.path().join("out");
    let before = fs::read(out.join("summary.json")).unwrap();
    let refused = solve(folder.path(), "cantilever.json", &[]);
    assert_eq!(refused.code, 2);
    let message = "error: out holds a finished run of `A load in steps`\n\
                   hint: choose another folder with `-o`, or add `--force` to replace it\n";
    assert_eq!(refused.stderr, message);
    assert_eq!(fs::read(out.join("summary.json")).unwrap(), before);
    assert_eq!(solve(folder.path(), "cantilever.json", &["--force"]).code, 0);
    assert_eq!(
        names(&out.join("fields")),
        ["step_000.csv", "step_000.vtu"],
        "no step of the earlier run is left"
    );
    assert_eq!(json(&out.join("summary.json"))["title"], "Cantilever under a tip load");
}

#[test]
fn a_folder_with_other_files_is_left_alone_unless_forced() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    fs::write(out.join("thesis.tex"), "years of work").unwrap();
    let refused = solve(folder.path(), "cantilever.json", &[]);
    assert_eq!(refused.code, 2);
    let message = "error: out holds `thesis.tex`, which peristat did not write\n\
                   hint: choose another folder with `-o`, or add `--force`\n";
    assert_eq!(refused.stderr, message);
    assert_eq!(names(&out), ["thesis.tex"]);
    assert_eq!(solve(folder.path(), "cantilever.json", &["--force"]).code, 0);
    assert_eq!(solve(folder.path(), "cantilever.json", &["--force"]).code, 0);
    assert!(out.join("summary.json").exists());
    assert_eq!(fs::read_to_string(out.join("thesis.tex")).unwrap(), "years of work");
}

#[test]
fn a_folder_that_cannot_be_made_is_an_error_that_names_it() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("file"), "").unwrap();
    let case = gallery("cantilever.json");
    // A file stands where a folder should be: no user can write there, not even root.
    for output in ["file", "file/below"] {
        let outcome = run(folder.path(), &["run", &case, "-o", output]);
        assert_eq!(outcome.code, 2, "{output}");
        assert!(
            outcome.stderr.starts_with("error: ") && outcome.stderr.contains(output),
            "{}",
            outcome.stderr
        );
        if output == "file" {
            // `--force` does not help, and no hint says so.
            assert!(!outcome.stderr.contains("--force"), "{}", outcome.stderr);
        }
        assert_eq!(outcome.stdout, "");
    }
    assert_eq!(names(folder.path()), ["file"]);
    let machine = run(folder.path(), &["run", &case, "-o", "file", "--json"]);
    let told: serde_json::Value = serde_json::from_str(&machine.stdout).unwrap();
    assert!(told["error"].as_str().is_some_and(|text| text.contains("is a file, not a folder")), "{told}");
}

#[test]
fn an_input_fault_keeps_the_results_of_the_earlier_run() {
    let folder = tempfile::tempdir().unwrap();
    solve(folder.path(), "cantilever.json", &[]);
    let summary = folder.path().join("out/summary.json");
    let before = fs::read_to_string(&summary).unwrap();
    for fault in ["body.line.cells=0", "supports[0].phi=null", "loads[0].point.force=1e300"] {
        assert_eq!(solve(folder.path(), "cantilever.json", &["--force", "--set", fault]).code, 2, "{fault}");
        assert_eq!(fs::read_to_string(&summary).unwrap(), before, "{fault}");
    }
}

#[test]
fn no_temporary_file_is_left() {
    let folder = tempfile::tempdir().unwrap();
    solve(folder.path(), "load_cases.json", &["--write-matrix", "k.mtx"]);
    let known = ["", "json", "csv", "svg", "vtu", "pvd", "mtx", "html"];
    for file in files(folder.path(), "") {
        let extension = file.extension().unwrap_or_default().to_string_lossy().into_owned();
        assert!(known.contains(&extension.as_str()), "{}", file.display());
    }
}

#[test]
fn a_case_beside_its_results_is_not_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(gallery("cantilever.json"), folder.path().join("case.json")).unwrap();
    let before = fs::read(folder.path().join("case.json")).unwrap();
    let refused = run(folder.path(), &["run", "case.json", "-o", "."]);
    assert_eq!(refused.code, 2, "{}", refused.stderr);
    assert_eq!(fs::read(folder.path().join("case.json")).unwrap(), before);
    assert_eq!(names(folder.path()), ["case.json"]);
}

#[test]
fn a_file_of_the_user_among_the_fields_is_not_deleted() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(solve(folder.path(), "cantilever.json", &[]).code, 0);
    fs::write(folder.path().join("out/fields/notes.txt"), "mine").unwrap();
    let refused = solve(folder.path(), "cantilever.json", &[]);
    assert_eq!(refused.code, 2);
    assert!(refused.stderr.contains("out holds `fields/notes.txt`"), "{}", refused.stderr);
    assert!(folder.path().join("out/fields/notes.txt").exists());
    assert_eq!(solve(folder.path(), "cantilever.json", &["--force"]).code, 0);
    assert_eq!(fs::read_to_string(folder.path().join("out/fields/notes.txt")).unwrap(), "mine");
}

#[test]
fn verify_writes_below_the_folder_it_was_given_and_nowhere_else() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("cases")).unwrap();
    fs::create_dir(folder.path().join("here")).unwrap();
    fs::copy(gallery("cantilever.json"), folder.path().join("cases/one.json")).unwrap();
    let absolute = folder.path().join("cases/one.json").display().to_string();
    for case in [absolute.as_str(), "../cases/one.json"] {
        let out = run(&folder.path().join("here"), &["verify", case, "-o", "out"]);
        assert_eq!(out.code, 0, "{}", out.stderr);
    }
    assert_eq!(names(&folder.path().join("cases")), ["one.json"]);
    assert_eq!(files(&folder.path().join("here/out"), "summary.json").len(), 2);
}

#[test]
fn a_case_with_a_baseline_runs_again_from_its_results() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(solve(folder.path(), "baseline.json", &[]).code, 0);
    assert_eq!(run(folder.path(), &["run", "out/case.json", "-o", "again"]).code, 0);
}

#[test]
fn a_matrix_does_not_overwrite_a_file_unless_forced() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("k.mtx"), "mine").unwrap();
    let refused = solve(folder.path(), "cantilever.json", &["--write-matrix", "k.mtx"]);
    assert_eq!(refused.code, 2);
    assert_eq!(fs::read_to_string(folder.path().join("k.mtx")).unwrap(), "mine");
    assert_eq!(solve(folder.path(), "cantilever.json", &["--write-matrix", "k.mtx", "--force"]).code, 0);
    assert!(fs::read_to_string(folder.path().join("k.mtx")).unwrap().starts_with("%%MatrixMarket"));
}

#[test]
fn a_matrix_is_not_written_where_the_results_would_replace_it() {
    let folder = tempfile::tempdir().unwrap();
    for file in ["out/summary.json", "out/.peristat", "out/../out/history.csv"] {
        let refused = solve(folder.path(), "cantilever.json", &["--write-matrix", file]);
        assert_eq!(refused.code, 2, "{file}: {}", refused.stderr);
        assert!(names(folder.path()).is_empty(), "{file}");
        if file != "out/.peristat" {
            let message = format!("error: the results would replace {file}\nhint: ");
            assert!(refused.stderr.starts_with(&message), "{}", refused.stderr);
        }
    }
    assert_eq!(solve(folder.path(), "cantilever.json", &["--write-matrix", "out/k.mtx"]).code, 0);
    assert!(folder.path().join("out/k.mtx").exists());
    for file in ["out/summary.json", "out/fields/k.mtx"] {
        let refused = solve(folder.path(), "cantilever.json", &["--force", "--write-matrix", file]);
        assert_eq!(refused.code, 2, "{file}");
        assert!(refused.stderr.contains("the results would replace"), "{}", refused.stderr);
    }
}

#[test]
fn a_folder_of_the_user_with_the_name_of_a_file_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    let drawing = folder.path().join("out/summary.json/drawing.svg");
    fs::create_dir_all(drawing.parent().unwrap()).unwrap();
    fs::write(&drawing, "mine").unwrap();
    fs::create_dir(folder.path().join("out/plots")).unwrap();
    fs::write(folder.path().join("out/plots/notes.txt"), "mine").unwrap();
    let refused = solve(folder.path(), "cantilever.json", &["--force"]);
    assert_eq!(refused.code, 2, "{}", refused.stderr);
    let message = "error: out holds a folder `summary.json`, where a file of this name belongs\nhint: ";
    assert!(refused.stderr.starts_with(message), "{}", refused.stderr);
    for file in [drawing, folder.path().join("out/plots/notes.txt")] {
        assert_eq!(fs::read_to_string(file).unwrap(), "mine");
    }
    fs::remove_dir_all(folder.path().join("out/summary.json")).unwrap();
    assert_eq!(solve(folder.path(), "cantilever.json", &["--force"]).code, 0);
    assert!(folder.path().join("out/plots/notes.txt").exists());
}

#[test]
fn only_a_run_of_a_body_that_breaks_or_softens_is_resumed() {
    let folder = tempfile::tempdir().unwrap();
    let refused = solve(folder.path(), "cantilever.json", &["--resume"]);
    assert_eq!(refused.code, 2);
    let message = "error: only a run with `fracture` or `path` can be resumed\n\
                   hint: leave out `--resume` to run the case\n";
    assert_eq!(refused.stderr, message);
    let both = solve(folder.path(), "cantilever.json", &["--resume", "--force"]);
    assert_eq!(both.code, 2);
    assert!(both.stderr.contains("cannot be used with"), "{}", both.stderr);
    assert!(names(folder.path()).is_empty());
}

#[test]
fn a_file_that_a_killed_run_was_writing_does_not_stand_in_the_way() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(solve(folder.path(), "cantilever.json", &[]).code, 0);
    for file in ["out/.a1b2.part", "out/fields/.c3.part", "out/plots/.d4.part"] {
        fs::write(folder.path().join(file), "half").unwrap();
    }
    let again = solve(folder.path(), "cantilever.json", &["--force"]);
    assert_eq!(again.code, 0, "{}", again.stderr);
    assert!(files(folder.path(), ".part").is_empty());
}

#[test]
fn a_finished_run_is_replaced_by_the_next_one_of_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let case = gallery("cantilever.json");
    let again = |more: &[&str]| run(folder.path(), &[&["run", &case], more].concat());
    assert_eq!(again(&[]).code, 0);
    let out = folder.path().join("results/cantilever");
    fs::write(out.join("fields/step_007.csv"), "").unwrap();
    assert_eq!(again(&["--set", "body.line.cells=24"]).code, 0);
    assert_eq!(json(&out.join("case.json"))["body"]["line"]["cells"], 24);
    assert_eq!(names(&out.join("fields")), ["step_000.csv", "step_000.vtu"]);
    // Not one of another file, nor beside files of somebody else, nor one that did not end.
    let copy = folder.path().join("cantilever.json");
    fs::copy(&case, &copy).unwrap();
    let refused = run(folder.path(), &["run", "cantilever.json"]);
    assert_eq!(refused.code, 2);
    assert!(
        refused.stderr.contains("holds a finished run of `Cantilever under a tip load`"),
        "{}",
        refused.stderr
    );
    fs::write(out.join("thesis.tex"), "years of work").unwrap();
    assert!(again(&[]).stderr.contains("thesis.tex"));
    fs::remove_file(out.join("thesis.tex")).unwrap();
    fs::remove_file(out.join("summary.json")).unwrap();
    assert!(again(&[]).stderr.contains("holds an unfinished run"));
    assert_eq!(solve(folder.path(), "cantilever.json", &[]).code, 0);
    assert_eq!(solve(folder.path(), "cantilever.json", &[]).code, 0);
}

/// A force upwards at the tip of a cantilever: V is F as a field, and −F in the sign of structural engineers, for whom what pulls the
/// left piece down at its support is negative; M sags.
#[test]
fn diagrams_have_the_signs_that_are_asked_for_and_tables_keep_theirs() {
    let folder = tempfile::tempdir().unwrap();
    let drawn = |signs: &str| {
        let set = format!("drawing.signs={signs}");
        assert_eq!(solve(folder.path(), "cantilever.json", &["--set", &set, "--force"]).code, 0);
        let out = folder.path().join("out");
        let plot = |name: &str| fs::read_to_string(out.join(format!("plots/{name}.svg"))).unwrap();
        let table = fs::read(out.join("fields/step_000.csv")).unwrap();
        (plot("shear"), plot("moment"), table, fs::read_to_string(out.join("report.html")).unwrap())
    };
    let [fields, structural, tension] = ["fields", "structural", "tension_side"].map(drawn);
    assert!(fields.0.contains("1000") && !fields.0.contains("clockwise") && !fields.0.contains("−1000"));
    for (shear, ..) in [&structural, &tension] {
        assert!(shear.contains("−1000") && shear.contains("clockwise positive"), "{shear}");
    }
    assert!(structural.1.contains("sagging positive") && tension.1.contains("on the side in tension"));
    assert!(tension.3.contains("\"turned\":true") && !structural.3.contains("\"turned\":true"));
    assert!(fields.2 == structural.2 && fields.2 == tension.2);
}
