//! What has no end, or far more points than letters, is refused before it is collected.

use super::support::{gallery, json, peristat, root, run};
use serde_json::{Value, json};
use std::fs;
use std::process::{Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// What a command leaves behind that says little; it must not take long.
fn in_time(command: &mut Command) -> Output {
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let begin = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if begin.elapsed() > Duration::from_secs(20) {
            child.kill().unwrap();
            panic!("{command:?} does not end");
        }
        sleep(Duration::from_millis(5));
    }
    child.wait_with_output().unwrap()
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
    fs::write(path("breaking.json"), super::fracture::case().to_string()).unwrap();
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
            let output = in_time(peristat(folder.path()).args(arguments));
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
