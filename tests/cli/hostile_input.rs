//! Inputs that could bring a program down.

use crate::support::{gallery, json, peristat, root, run};
use serde_json::{Value, json};
use std::fs;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

#[test]
fn a_hundred_megabytes_of_brackets_get_a_short_message_quickly() {
    let folder = tempfile::tempdir().unwrap();
    for (name, size) in [("small.json", 100_000), ("large.json", 100_000_000)] {
        fs::write(folder.path().join(name), vec![b'['; size]).unwrap();
        let begin = Instant::now();
        let outcome = run(folder.path(), &["run", name]);
        // Measured 0.3 s for the large one.
        assert!(begin.elapsed() < Duration::from_secs(10), "{name} took {:?}", begin.elapsed());
        assert_eq!(outcome.code, 2, "{name}");
        assert!(outcome.stderr.starts_with("error: ") && outcome.stderr.len() < 1000, "{}", outcome.stderr);
        assert!(outcome.stderr.contains(&format!("--> {name}:1:")), "{}", outcome.stderr);
    }
    assert!(!folder.path().join("results").exists());
}

#[test]
fn a_case_cut_off_anywhere_gets_a_message() {
    let text = fs::read(root().join("cases/beam/load_cases.json")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let whole = text.iter().rposition(|&b| b == b'}').unwrap();
    for length in (0..whole).step_by(97) {
        fs::write(folder.path().join("cut.json"), &text[..length]).unwrap();
        let outcome = run(folder.path(), &["check", "cut.json"]);
        assert_eq!(outcome.code, 2, "cut after {length} bytes: {}", outcome.stderr);
        assert!(outcome.stderr.starts_with("error: "), "cut after {length} bytes: {}", outcome.stderr);
    }
}

#[test]
fn a_number_replaced_by_anything_never_brings_the_command_down() {
    let folder = tempfile::tempdir().unwrap();
    let values = ["0", "-1", "1e308", "1e-308", "-1e50", "\"x\"", "null", "[]", "{}", "true", "4294967296"];
    let paths = [
        "model.timoshenko_beam.youngs_modulus",
        "model.timoshenko_beam.section.rectangle.height",
        "body.line.length",
        "body.line.from",
        "horizon_ratio",
        "supports[0].w",
        "supports[0].at.x",
        "loads[0].point.force",
        "loads[0].point.at.x",
    ];
    for path in paths {
        for value in values {
            let set = format!("{path}={value}");
            let case = gallery("cantilever.json");
            let outcome = run(folder.path(), &["run", &case, "--set", &set, "-o", "out", "--force"]);
            assert!((0..=2).contains(&outcome.code), "{set}: exit code {}", outcome.code);
            assert!(!outcome.stderr.contains("panicked"), "{set}: {}", outcome.stderr);
            assert!(outcome.code != 2 || outcome.stderr.starts_with("error: "), "{set}: {}", outcome.stderr);
        }
    }
}

#[test]
fn a_reader_that_goes_away_is_no_crash() {
    let case = gallery("load_cases.json");
    let folder = tempfile::tempdir().unwrap();
    let commands: [&[&str]; 6] = [
        &["list"],
        &["schema"],
        &["new", "timoshenko_beam"],
        &["completions", "bash"],
        &["run", &case, "--json"],
        &["--help"],
    ];
    for arguments in commands {
        let mut child = Command::new(env!("CARGO_BIN_EXE_peristat"))
            .args(arguments)
            .current_dir(folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{arguments:?}: {:?} {stderr}", output.status);
        assert_eq!(stderr, "", "{arguments:?}");
    }
}

#[test]
fn a_case_that_needs_too_much_memory_is_refused_before_anything_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let case = gallery("cantilever.json");
    let outcome = run(folder.path(), &["run", &case, "--max-memory", "10kB", "-o", "out"]);
    assert_eq!(outcome.code, 2);
    assert!(outcome.stderr.starts_with("error: ") && outcome.stderr.contains("memory"), "{}", outcome.stderr);
    assert!(!folder.path().join("out").exists());
    let enough = run(folder.path(), &["run", &case, "--max-memory", "20MB", "-o", "out"]);
    assert_eq!(enough.code, 0, "{}", enough.stderr);
    peristat(folder.path()).args(["run", &case, "--max-memory", "3 apples"]).assert().code(2);
}

#[test]
fn a_huge_case_is_refused_by_its_memory_and_not_by_the_system() {
    let folder = tempfile::tempdir().unwrap();
    let case = gallery("cantilever.json");
    let arguments = ["run", &case, "--set", "body.line.cells=1000000", "--max-memory", "50MB", "-o", "out"];
    let outcome = run(folder.path(), &arguments);
    assert_eq!(outcome.code, 2);
    assert!(outcome.stderr.contains("memory"), "{}", outcome.stderr);
    assert!(!folder.path().join("out").exists());
}

#[test]
fn what_a_few_digits_ask_for_is_refused_before_it_is_made() {
    let folder = tempfile::tempdir().unwrap();
    let plate = root().join("cases/plate/uniaxial_tension.json").display().to_string();
    let beam = gallery("cantilever.json");
    let hole = r#"[{ "circle": { "centre": [-1e9, 10], "radius": 1000000003 } }]"#;
    let line = r#"{ "name": "k", "from": [0, 0], "to": [1, 1], "points": 100000 }"#;
    let lines: Vec<String> = (0..40).map(|k| line.replace('k', &format!("k{k}"))).collect();
    let load = r#"{ "point": { "at": { "x": 1.0 }, "force": 1 } }"#;
    let several = |part: &str, count: usize| format!("[{}]", vec![part; count].join(","));
    let thick = root().join("cases/axisymmetric/lame.json").display().to_string();
    let crack = r#"cracks=[{ "path": [[20.5, -1], [20.5, 10]] }]"#;
    let cases: [(&str, &str, Vec<String>); 7] = [
        ("families of their own", &thick, vec!["horizon_ratio=60".into()]),
        ("bonds that a crack cuts", &plate, vec![crack.into(), "horizon_ratio=50".into()]),
        ("the border of a hole", &plate, vec![format!("body.rectangle.holes={hole}")]),
        ("positions on lines", &plate, vec![format!("lines=[{}]", lines.join(","))]),
        (
            "graded cells",
            &beam,
            vec!["body.line.cells=50000000".into(), "body.line.grading.geometric.ratio=3".into()],
        ),
        ("cells", &beam, vec!["body.line.cells=2000000000".into()]),
        (
            "load steps",
            &beam,
            vec![
                format!("loads={}", several(load, 2000)),
                format!("steps.load_factors={}", several("1", 2000)),
            ],
        ),
    ];
    for (what, case, set) in cases {
        let mut arguments = vec!["check", case, "--max-memory", "40MB", "--set", "checks=[]"];
        set.iter().for_each(|set| arguments.extend(["--set", set]));
        let begin = Instant::now();
        let outcome = run(folder.path(), &arguments);
        // Measured 0.2 s.
        assert!(begin.elapsed() < Duration::from_secs(20), "{what} took {:?}", begin.elapsed());
        assert_eq!(outcome.code, 2, "{what}: {}", outcome.stderr);
        assert!(outcome.stderr.contains("of memory would be needed"), "{what}: {}", outcome.stderr);
    }
}

#[test]
fn what_is_meant_at_many_points_is_counted_before_it_is_collected() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(root().join("cases/beam/baseline.csv"), folder.path().join("baseline.csv")).unwrap();
    let many = |count: usize, part: Value| Value::from(vec![part; count]);
    let named = |count: usize, part: &dyn Fn(String) -> Value| {
        (0..count).map(|k| part(format!("n{k}"))).collect::<Vec<_>>().into()
    };
    let (everywhere, check) = (json!({ "region": "all" }), |kind: &str, own: Value| json!({ kind: own }));
    let force = json!({ "body_force": { "region": "all", "total": [1, 0] } });
    let plate: [(&str, &str, Value); 7] = [
        ("points that supports hold", "supports", many(100, json!({ "at": everywhere, "ux": 0, "uy": 0 }))),
        ("points that supports hold", "supports", many(500, json!({ "at": everywhere, "ux_spring": 1 }))),
        (
            "points that loads act on",
            "loads",
            many(3000, json!({ "point": { "at": everywhere, "force_x": 1 } })),
        ),
        ("points that loads act on", "loads", many(3000, force.clone())),
        (
            "points that loads act on",
            "load_cases",
            named(3000, &|name| json!({ "name": name, "loads": [force.clone()] })),
        ),
        (
            "points of probes",
            "probes",
            named(5000, &|name| json!({ "name": name, "at": everywhere, "field": "ux" })),
        ),
        (
            "values at all points",
            "checks",
            many(9000, check("formula", json!({ "field": "ux", "is": "x", "tolerance": 1, "source": "" }))),
        ),
    ];
    let bed = json!([{ "stiffness": { "uniform": 1.0 } }]);
    let baseline = check("baseline", json!({ "file": "baseline.csv", "field": "w", "tolerance": 1 }));
    let beam: [(&str, &str, Value); 2] = [
        ("3.00e6 springs of foundations", "foundation", bed),
        ("9 baselines at 3000001 points", "checks", many(9, baseline)),
    ];
    let read = |path: &str| json(&root().join("cases").join(path));
    let (mut square, mut line) = (read("plate/uniaxial_tension.json"), read("beam/cantilever.json"));
    square["regions"] = json!({ "all": { "box": { "from": [0, 0], "to": [40, 20] } } });
    square["checks"] = json!([]);
    line["checks"] = json!([]);
    line["body"]["line"]["cells"] = 3_000_000.into();
    let plate = plate.into_iter().map(|case| (&square, case));
    for (base, (what, key, value)) in plate.chain(beam.into_iter().map(|case| (&line, case))) {
        let mut case = base.clone();
        case[key] = value;
        if key == "load_cases" {
            case["loads"] = json!([]);
        }
        fs::write(folder.path().join("case.json"), case.to_string()).unwrap();
        let outcome = run(folder.path(), &["check", "case.json", "--max-memory", "40MB"]);
        assert_eq!(outcome.code, 2, "{what}: {}", outcome.stderr);
        let said = format!("of memory would be needed for {what}, 40.0 MB may be used\n");
        assert!(outcome.stderr.contains(&said), "{what}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(&format!("at `{key}`")), "{what}: {}", outcome.stderr);
    }
}

#[test]
fn points_close_together_are_counted_before_their_bonds_are_made() {
    let folder = tempfile::tempdir().unwrap();
    // Two dense lines of points, each with most others within its horizon.
    let row = |k: usize| format!("{},{},1\n", 0.5 + 0.0025 * k as f64, 3.0 + 0.1 * (k % 2) as f64);
    let list = |points: usize| format!("x,y,area\n{}", (0..points).map(row).collect::<String>());
    let case = json!({
        "title": "Dense", "body": { "points": { "file": "points.csv" } },
        "model": { "bond_plane": { "youngs_modulus": 1e11, "state": "plane_stress" } },
        "regions": { "left": { "box": { "from": [0, 0], "to": [0.6, 9] } } },
        "supports": [{ "at": { "region": "left" }, "ux": 0, "uy": 0 }],
        "loads": [{ "body_force": { "density": [1, 0] } }]
    });
    fs::write(folder.path().join("case.json"), case.to_string()).unwrap();
    // 4000 are far too many; of 1500 every point looks for triangles among all others, which lie in its line.
    for (points, memory, code) in [(4000, "100MB", 2), (1500, "2GB", 0)] {
        fs::write(folder.path().join("points.csv"), list(points)).unwrap();
        let begin = Instant::now();
        let outcome = run(folder.path(), &["check", "case.json", "--max-memory", memory]);
        assert_eq!(outcome.code, code, "{}", outcome.stderr);
        let counted =
            outcome.stderr.contains("of memory would be needed for bonds over a horizon of 3 spacings");
        assert_eq!(counted, code == 2, "{}", outcome.stderr);
        // Measured 0.01 s and 0.3 s; 20 s and 3.5 s where all pairs are made first and all triangles are tried.
        assert!(begin.elapsed() < Duration::from_secs(3), "took {:?}", begin.elapsed());
    }
}

#[cfg(unix)]
#[test]
fn files_without_an_end_are_not_read() {
    use std::os::unix::fs::symlink;
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    assert!(Command::new("mkfifo").arg(path("pipe.json")).status().unwrap().success());
    symlink("/dev/zero", path("zero.json")).unwrap();
    fs::write(path("breaking.json"), crate::fracture::case().to_string()).unwrap();
    fs::copy(gallery("cantilever.json"), path("beam.json")).unwrap();
    let study = json!({ "title": "t", "case": "beam.json", "vary": [{ "body.line.cells": [8] }] });
    fs::write(path("t.study.json"), study.to_string()).unwrap();
    // Folders of results that somebody made up.
    for name in ["pipe.json", "zero.json"] {
        let out = path(name).with_extension("");
        fs::create_dir_all(out.join("inputs")).unwrap();
        for file in ["case.json", "restart.bin", "study.json"] {
            symlink(path(name), out.join(file)).unwrap();
        }
        fs::write(out.join(".peristat"), "").unwrap();
        fs::write(out.join("inputs/a.csv"), "").unwrap();
        let (out, refused) = (out.display().to_string(), "is no regular file\n");
        let cases: [(&[&str], i32, &str); 8] = [
            (&["check", name], 2, refused),
            (&["run", name, "--max-memory", "100MB"], 2, refused),
            (&["verify", name], 2, refused),
            (&["study", name], 2, refused),
            (&["run", "beam.json", "-o", &out], 2, "which peristat did not write"),
            (&["run", "breaking.json", "-o", &out, "--resume"], 2, "restart.bin is no regular file\n"),
            (&["study", "t.study.json", "-o", &out, "--force"], 0, ""),
            (&["run", "beam.json", "-o", &out, "--force"], 0, ""),
        ];
        for (arguments, code, said) in cases {
            // Every one takes a fraction of a second; a pipe that nobody writes into has no end.
            let output = peristat(folder.path()).timeout(Duration::from_secs(20)).args(arguments).output();
            let output = output.unwrap_or_else(|error| panic!("{arguments:?}: {error}"));
            let stderr = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(code), "{arguments:?}: {stderr}");
            assert!(stderr.contains(said), "{arguments:?}: {stderr}");
        }
    }
    fs::write(path("large.json"), vec![b' '; 20_000]).unwrap();
    let large = run(folder.path(), &["check", "large.json", "--max-memory", "10kB"]);
    assert!(
        large.code == 2 && large.stderr.contains("is larger than the 10.0 kB of memory"),
        "{}",
        large.stderr
    );
}

#[test]
fn very_many_faults_are_told_in_part_and_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let probe = r#"{ "name": "x", "at": { "x": 0.5 }, "field": "w" }"#;
    let probes = format!("[{}]", vec![probe; 20_000].join(","));
    let text = fs::read_to_string(gallery("cantilever.json")).unwrap();
    let mut case: serde_json::Value = serde_json::from_str(&text).unwrap();
    case["probes"] = serde_json::from_str(&probes).unwrap();
    fs::write(folder.path().join("case.json"), case.to_string()).unwrap();
    let begin = Instant::now();
    let outcome = run(folder.path(), &["check", "case.json"]);
    // Measured 0.4 s; 11 s where the place of every fault is looked for.
    assert!(begin.elapsed() < Duration::from_secs(8), "took {:?}", begin.elapsed());
    assert_eq!(outcome.code, 2);
    assert!(outcome.stderr.ends_with("errors in case.json, 100 are shown\n"), "{}", outcome.stderr.len());
    assert_eq!(outcome.stderr.matches("error: ").count(), 100);
}
