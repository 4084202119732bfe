//! `run`, `check`, `new`, `list` and `completions`.

use super::support::{Outcome, gallery, json, names, root, run};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// A run of the cantilever with overrides, into `out`.
fn cantilever(folder: &Path, overrides: &[&str]) -> Outcome {
    let case = gallery("cantilever.json");
    let mut arguments = vec!["run", &case, "-o", "out", "--force"];
    arguments.extend(overrides.iter().flat_map(|o| ["--set", o]));
    run(folder, &arguments)
}

#[test]
fn exit_codes_tell_passed_failed_and_bad_input_apart() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(cantilever(folder.path(), &[]).code, 0);
    let failed = cantilever(folder.path(), &["loads[0].point.force=2000"]);
    assert_eq!(failed.code, 1, "the deflection is above L/250 then");
    assert!(failed.stdout.contains("FAILED"));
    assert_eq!(cantilever(folder.path(), &["loads[0].point.force=no"]).code, 2);
    assert_eq!(run(folder.path(), &["run"]).code, 2);
    assert_eq!(run(folder.path(), &["walk", "case.json"]).code, 2);
    assert_eq!(run(folder.path(), &["--version"]).code, 0);
}

#[test]
fn a_failed_check_leaves_a_complete_folder() {
    let folder = tempfile::tempdir().unwrap();
    cantilever(folder.path(), &["loads[0].point.force=2000"]);
    let summary = json(&folder.path().join("out/summary.json"));
    assert_eq!(summary["status"], "check_failed");
    assert_eq!(summary["checks"][1]["passed"], false);
}

#[test]
fn overrides_change_the_case_that_is_run_and_recorded() {
    let folder = tempfile::tempdir().unwrap();
    cantilever(folder.path(), &["body.line.cells=24", "loads[0].point.force=500"]);
    let out = folder.path().join("out");
    assert_eq!(json(&out.join("summary.json"))["points"], 25);
    assert_eq!(json(&out.join("case.json"))["loads"][0]["point"]["force"], 500.0);
}

#[test]
fn a_bad_override_says_how_to_write_one() {
    let folder = tempfile::tempdir().unwrap();
    for (overriding, reason) in [
        ("body.line.cells", "no `=` in it: write `--set body.line.cells=VALUE`"),
        ("loads[3].point.force=1", "names element 3 of a list of 1"),
        ("title.more=1", "goes through a value that is neither an object nor a list"),
        ("body.line.cels=24", "unknown key `cels`"),
    ] {
        let outcome = cantilever(folder.path(), &[overriding]);
        assert_eq!(outcome.code, 2, "{overriding}");
        assert!(outcome.stderr.contains(reason), "{overriding}: {}", outcome.stderr);
    }
    assert!(!folder.path().join("out").exists());
}

#[test]
fn json_on_stdout_is_the_summary_of_the_folder() {
    let folder = tempfile::tempdir().unwrap();
    let case = gallery("load_cases.json");
    let outcome = run(folder.path(), &["run", &case, "--json", "-o", "out"]);
    let printed: Value = serde_json::from_str(&outcome.stdout).unwrap();
    assert_eq!(printed, json(&folder.path().join("out/summary.json")));
    assert_eq!(printed["states"].as_array().unwrap().len(), 5);
}

#[test]
fn lists_sizes_and_verdicts_are_json_for_machines() {
    let folder = root();
    let parse = |arguments: &[&str]| -> Value {
        let outcome = run(&folder, arguments);
        assert_eq!(outcome.code, 0, "{arguments:?}: {}", outcome.stderr);
        serde_json::from_str(&outcome.stdout).unwrap()
    };
    let list = parse(&["list", "--json"]);
    assert_eq!(list.as_object().unwrap().len(), 12);
    assert_eq!(parse(&["list", "references", "--json"])["references"], list["references"]);
    let sizes = parse(&["check", "cases/beam/cantilever.json", "--json"]);
    assert_eq!(sizes[0]["sizes"]["points"], 97);
    let verdicts = parse(&["verify", "cases/beam/cantilever.json", "--json"]);
    assert_eq!(verdicts[0]["verdict"], "passed");
    assert_eq!(verdicts[0]["checks"].as_array().unwrap().len(), 2);
}

#[test]
fn check_solves_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let outcome = run(folder.path(), &["check", &gallery("cantilever.json"), &gallery("tube.json")]);
    assert_eq!(outcome.code, 0);
    assert!(outcome.stdout.contains("cantilever.json") && outcome.stdout.contains("tube.json"));
    assert_eq!(names(folder.path()), Vec::<String>::new());
}

#[test]
fn a_new_case_runs_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let new = run(folder.path(), &["new", "timoshenko_beam"]);
    assert_eq!(new.code, 0);
    fs::write(folder.path().join("mine.json"), &new.stdout).unwrap();
    let outcome = run(folder.path(), &["run", "mine.json"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert!(folder.path().join("results/mine/summary.json").exists(), "the folder is named after the case");
    let unknown = run(folder.path(), &["new", "shell"]);
    assert_eq!(unknown.code, 2);
    for said in ["[possible values: timoshenko_beam", "a similar value exists: 'shell_membrane'"] {
        assert!(unknown.stderr.contains(said), "{}", unknown.stderr);
    }
}

#[test]
fn the_first_case_of_a_newcomer_is_the_one_of_the_gallery() {
    for (name, file) in [
        ("timoshenko_beam", "beam/cantilever.json"),
        ("plane_frame", "frame/steel_portal.json"),
        ("bond_plane", "plate/steel_plate.json"),
        ("beam_bond_orthotropic", "orthotropic/plate_with_hole.json"),
    ] {
        let new = run(&root(), &["new", name]).stdout;
        let of_gallery = fs::read_to_string(root().join("cases").join(file)).unwrap();
        let (first, rest) = of_gallery.split_once('\n').unwrap();
        assert_eq!(new, format!("{first}\n  \"$schema\": \"case.schema.json\",\n{rest}"), "{file}");
    }
}

#[test]
fn every_list_is_printed_alone_and_with_the_others() {
    let folder = root();
    let all = run(&folder, &["list"]).stdout;
    for kind in ["models", "loads", "fracture", "references", "solvers"] {
        let alone = run(&folder, &["list", kind]).stdout;
        assert!(alone.starts_with(kind) && all.contains(&alone), "{kind}");
    }
    assert!(all.contains("cantilever_tip_force") && all.contains("bond_law corrected"));
    // What belongs to a model stands below it.
    let place = |word: &str| all.find(word).unwrap();
    assert!(place("bond_law corrected") < place("bond_plane "));
}

#[test]
fn completions_know_the_commands() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let outcome = run(&root(), &["completions", shell]);
        assert_eq!(outcome.code, 0, "{shell}");
        assert!(outcome.stdout.contains("verify") && outcome.stdout.contains("write-matrix"), "{shell}");
    }
    assert_eq!(run(&root(), &["completions", "cmd"]).code, 2);
}

#[test]
fn the_written_matrix_has_the_order_of_all_unknowns_and_is_symmetric() {
    let folder = tempfile::tempdir().unwrap();
    let case = gallery("cantilever.json");
    let arguments = [
        "run",
        &case,
        "--set",
        "body.line.cells=12",
        "--set",
        "checks=[]",
        "-o",
        "out",
        "--write-matrix",
        "k.mtx",
    ];
    assert_eq!(run(folder.path(), &arguments).code, 0);
    let text = fs::read_to_string(folder.path().join("k.mtx")).unwrap();
    assert!(text.starts_with("%%MatrixMarket matrix coordinate real symmetric\n"), "{}", &text[..80]);
    let mut lines = text.lines().filter(|l| !l.starts_with('%'));
    let size: Vec<usize> = lines.next().unwrap().split(' ').map(|n| n.parse().unwrap()).collect();
    // 13 points of two unknowns; one triangle of the blocks of 13 points and of 12 + 11 + 10 bonds.
    assert_eq!(size[..2], [26, 26]);
    assert!(size[2] <= 13 * 3 + 33 * 4, "{} entries", size[2]);
    let entries: Vec<Vec<f64>> =
        lines.map(|l| l.split_whitespace().map(|n| n.parse().unwrap()).collect()).collect();
    assert_eq!(entries.len(), size[2]);
    assert!(entries.iter().all(|e| e[0] >= e[1] && e[2].is_finite()), "the lower triangle only");
}

#[test]
fn a_matrix_that_cannot_be_written_stops_the_run_before_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    let case = gallery("cantilever.json");
    let outcome = run(folder.path(), &["run", &case, "-o", "out", "--write-matrix", "no/such/folder/k.mtx"]);
    assert_eq!(outcome.code, 2);
    assert!(outcome.stderr.contains("cannot write no/such/folder/k.mtx"), "{}", outcome.stderr);
    assert_eq!(names(folder.path()), Vec::<String>::new());
}

#[test]
fn cases_may_have_comments_and_trailing_commas() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(gallery("cantilever.json")).unwrap();
    let text = text.replacen('{', "// A beam. { \"title\": 3\n{ /* é,\n ] */", 1);
    let end = text.rfind('}').unwrap();
    let text = format!("{},\n// the end\n}} // done", text[..end].trim_end());
    std::fs::write(folder.path().join("a.jsonc"), &text).unwrap();
    assert_eq!(run(folder.path(), &["run", "a.jsonc"]).code, 0);
    let verified = run(folder.path(), &["verify", "."]);
    assert!(
        verified.code == 0 && verified.stdout.contains("a.jsonc"),
        "{}{}",
        verified.stdout,
        verified.stderr
    );
    // Faults stand where they stand, whatever was commented before them.
    let line = 1 + text.lines().position(|line| line.contains("\"cells\"")).unwrap();
    let faulty = text.replace("\"cells\"", "/* how many: */ \"cels\"");
    let column = 1 + faulty.lines().nth(line - 1).unwrap().find("\"cels\"").unwrap();
    std::fs::write(folder.path().join("b.json"), faulty).unwrap();
    let refused = run(folder.path(), &["check", "b.json"]);
    assert_eq!(refused.code, 2);
    assert!(refused.stderr.contains(&format!("--> b.json:{line}:{column}, at")), "{}", refused.stderr);
    assert!(refused.stderr.contains("/* how many: */ \"cels\""), "{}", refused.stderr);
}

#[test]
fn check_says_what_bounds_the_equilibria_of_a_body_that_breaks_or_softens() {
    for (case, told) in [
        (
            "cases/plate/breaking_batch.json",
            "1 equilibrium if no bond breaks, about 60 in less than a second if a crack goes through, both to a factor of three; at most 5000 equilibria, by `fracture.max_solves`",
        ),
        ("cases/ductile/notched_strip.json", "at most 2000 equilibria, by `path.max_steps`"),
    ] {
        let outcome = run(&root(), &["check", case]);
        assert!(outcome.stdout.ends_with(&format!("{case}: {told}\n")), "{}", outcome.stdout);
        let json: Value = serde_json::from_str(&run(&root(), &["check", case, "--json"]).stdout).unwrap();
        assert!(json[0]["equilibria_at_most"].as_u64().unwrap() >= 2000);
    }
}

#[test]
#[cfg(not(feature = "petsc"))]
fn a_command_without_petsc_is_not_started_several_times() {
    let start = |count: &str, number: &str| {
        let mut command = super::support::peristat(&root());
        command.args(["check", "cases/beam/cantilever.json"]);
        command.envs([("OMPI_COMM_WORLD_SIZE", count), ("OMPI_COMM_WORLD_RANK", number)]).output().unwrap()
    };
    let [first, second] = ["0", "1"].map(|number| start("2", number));
    assert_eq!([first.status.code(), second.status.code()], [Some(2); 2]);
    let told = String::from_utf8(first.stderr).unwrap();
    assert!(
        told.starts_with("error: `mpirun` has started 2 processes") && told.contains("--features petsc"),
        "{told}"
    );
    assert!(second.stderr.is_empty());
    assert_eq!(start("1", "0").status.code(), Some(0));
}
