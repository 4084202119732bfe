//! Inputs that could bring a program down.

use super::support::{gallery, root, run};
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
    let enough = run(folder.path(), &["run", &case, "--max-memory", "23MB", "-o", "out"]);
    assert_eq!(enough.code, 0, "{}", enough.stderr);
    assert_eq!(run(folder.path(), &["run", &case, "--max-memory", "3 apples"]).code, 2);
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
    let mirrors = r#"symmetry=["left","right","bottom","top"]"#;
    let cases: [(&str, &str, Vec<String>); 8] = [
        ("bonds of images", &plate, vec![mirrors.into(), "horizon_ratio=90".into()]),
        ("families of their own", &thick, vec!["horizon_ratio=60".into()]),
        ("bonds that a crack cuts", &plate, vec![crack.into(), "horizon_ratio=44".into()]),
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
