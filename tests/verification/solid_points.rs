//! Solids of listed points: statics, uniform states, and what they share with blocks.

use peristat::case;
use peristat::input::Folder;
use peristat::run::RunOptions;
use peristat::{Loaded, Solved};
use serde_json::{Value, json};
use std::fmt::Write;
use std::fs;

/// Points of a block of `[columns, rows, layers]` cells of a side of 0.5, moved at random by this part of it at most.
fn list([columns, rows, layers]: [usize; 3], moved: f64) -> (String, Vec<[f64; 3]>) {
    let mut state = 7_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let (mut text, mut positions) = (String::from("x,y,z,volume\n"), Vec::new());
    for k in 0..layers {
        for j in 0..rows {
            for i in 0..columns {
                let at = [i, j, k].map(|n| 0.5 * (n as f64 + 0.5 + 2.0 * moved * random()));
                let _ = writeln!(text, "{},{},{},0.125", at[0], at[1], at[2]);
                positions.push(at);
            }
        }
    }
    (text, positions)
}

/// A case of these points, solved.
fn solved(points: &str, case: &Value) -> Solved {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("points.csv"), points).expect("a file");
    let mut whole = json!({
        "title": "t", "units": "none", "model": { "bond_solid": { "youngs_modulus": 1000.0 } },
        "body": { "points": { "file": "points.csv" } }
    });
    let keys = case.as_object().expect("keys").clone();
    keys.into_iter().for_each(|(key, value)| whole[key] = value);
    let source = case::from_text("case", whole.to_string(), &[], &Folder::default())
        .unwrap_or_else(|report| panic!("{}", report.render(false)));
    let loaded = Loaded::from_source(source, folder.path().into(), None).unwrap_or_else(|e| panic!("{e}"));
    let options = RunOptions { recover: true, max_memory: None, compare: false };
    loaded.solve(&options).unwrap_or_else(|error| panic!("{error}"))
}

fn resultants(found: &Solved) -> [[[f64; 3]; 2]; 2] {
    let of = found.summary.states[0].certificate.resultants.clone().expect("resultants");
    [&of.asked, &of.reactions]
        .map(|total| [total.forces(), total.moments()].map(|three| three.map(|t| t.expect("a number"))))
}

fn probe(found: &Solved, k: usize) -> f64 {
    found.summary.probes[k].value
}

#[test]
fn body_forces_and_gravity_are_those_of_the_volumes() {
    let (text, positions) = list([6, 5, 4], 0.2);
    let found = solved(
        &text,
        &json!({
            "density": 2.0,
            "regions": { "end": { "box": { "from": [0, 0, 0], "to": [0.5, 3, 3] } } },
            "supports": [{ "at": { "region": "end" }, "ux": 0, "uy": 0, "uz": 0 }],
            "loads": [
                { "body_force": { "density": [3.0, -1.0, 0.5] } },
                { "gravity": { "along": [0, 0, -1], "acceleration": 10.0 } }
            ]
        }),
    );
    let [asked, held] = resultants(&found);
    let density = [3.0, -1.0, 0.5 - 20.0].map(|f: f64| 0.125 * f);
    let mut expected = [[0.0; 3]; 2];
    for [x, y, z] in positions {
        let moment = [
            y * density[2] - z * density[1],
            z * density[0] - x * density[2],
            x * density[1] - y * density[0],
        ];
        (0..3).for_each(|k| {
            expected[0][k] += density[k];
            expected[1][k] += moment[k];
        });
    }
    for (row, own) in expected.iter().enumerate() {
        for k in 0..3 {
            assert!((asked[row][k] - own[k]).abs() < 1e-10, "{asked:?} {expected:?}");
            assert!((held[row][k] + own[k]).abs() < 1e-8, "{held:?} {expected:?}");
        }
    }
}

/// Every point of three outer layers, one more than the horizon has, moves linearly: on a lattice the points inside follow, and stresses are those of the material.
#[test]
fn a_lattice_of_points_follows_a_linear_motion() {
    let (text, _) = list([10, 9, 9], 0.0);
    let outer = [
        ([0.0, 0.0, 0.0], [1.5, 4.5, 4.5]),
        ([3.5, 0.0, 0.0], [5.0, 4.5, 4.5]),
        ([0.0, 0.0, 0.0], [5.0, 1.5, 4.5]),
        ([0.0, 3.0, 0.0], [5.0, 4.5, 4.5]),
        ([0.0, 0.0, 0.0], [5.0, 4.5, 1.5]),
        ([0.0, 0.0, 3.0], [5.0, 4.5, 4.5]),
    ];
    let regions: serde_json::Map<String, Value> = outer
        .iter()
        .enumerate()
        .map(|(k, (from, to))| (format!("s{k}"), json!({ "box": { "from": from, "to": to } })))
        .chain([("outer".into(), json!({ "union": ["s0", "s1", "s2", "s3", "s4", "s5"] }))])
        .collect();
    let found = solved(
        &text,
        &json!({
            "horizon_ratio": 2,
            "regions": regions,
            "supports": [{
                "at": { "region": "outer" },
                "ux": "0.001*x + 0.002*y", "uy": "-0.0005*y", "uz": "0.001*y"
            }],
            "probes": [
                { "name": "ux", "at": { "x": 2.4, "y": 2.2, "z": 2.3 }, "field": "ux" },
                { "name": "xx", "at": { "x": 2.25, "y": 2.25, "z": 2.25 }, "field": "stress_xx" },
                { "name": "xy", "at": { "x": 2.25, "y": 2.25, "z": 2.25 }, "field": "stress_xy" }
            ]
        }),
    );
    // C11 = 1200, C12 = C44 = 400.
    for (k, expected) in [0.0024 + 0.0044, 1.2 - 0.4 * 0.5, 0.8].into_iter().enumerate() {
        // 1e-15 measured.
        assert!((probe(&found, k) - expected).abs() < 1e-11, "{k}: {}", probe(&found, k));
    }
}

/// Bars of scattered points under tension at their ends, between sections: with a longer horizon they are less soft.
#[test]
fn scattered_points_are_softer_and_say_so() {
    let bar = |moved: f64, horizon: Option<f64>| {
        let (text, _) = list([18, 8, 8], moved);
        let mut case = json!({
            "regions": {
                "left": { "box": { "from": [0, 0, 0], "to": [0.5, 4, 4] } },
                "right": { "box": { "from": [8.5, 0, 0], "to": [9, 4, 4] } },
                "low": { "corner": [0, 0, 0] }, "high": { "corner": [0, 4, 0] }
            },
            "supports": [
                { "at": { "region": "left" }, "ux": 0 },
                { "at": { "region": "low" }, "uy": 0, "uz": 0 },
                { "at": { "region": "high" }, "uz": 0 }
            ],
            "loads": [{ "point": { "at": { "region": "right" }, "force_x": 16.0 } }],
            "probes": [
                { "name": "a", "at": { "x": 2.5, "y": 2, "z": 2 }, "field": "ux" },
                { "name": "b", "at": { "x": 6.5, "y": 2, "z": 2 }, "field": "ux" }
            ]
        });
        if let Some(horizon) = horizon {
            case["horizon_ratio"] = json!(horizon);
        }
        let found = solved(&text, &case);
        let warned = found.summary.warnings.iter().any(|text| text.contains("unevenly spaced"));
        ((probe(&found, 1) - probe(&found, 0)) / 4e-3 - 1.0, warned)
    };
    let (even, warned) = bar(0.0, None);
    assert!(even.abs() < 0.01 && !warned, "{even}");
    let [(two, _), (three, warned)] = [Some(2.0), None].map(|horizon| bar(0.25, horizon));
    assert!(warned);
    assert!((0.0..0.09).contains(&two) && (0.0..0.05).contains(&three) && three < two, "{two} {three}");
}

/// A warning names volumes that are a thousand times too large, such as those in another unit.
#[test]
fn volumes_in_other_units_are_told() {
    let (text, _) = list([5, 5, 5], 0.0);
    let warned = |text: &str, horizon_ratio: f64| {
        let case = json!({
            "horizon_ratio": horizon_ratio,
            "regions": { "end": { "box": { "from": [0, 0, 0], "to": [0.5, 3, 3] } } },
            "supports": [{ "at": { "region": "end" }, "ux": 0, "uy": 0, "uz": 0 }],
            "loads": [{ "body_force": { "density": [0, 1, 0] } }]
        });
        let found = solved(text, &case);
        found.summary.warnings.iter().any(|warning| warning.contains("much closer to each other"))
    };
    assert!(!warned(&text, 2.0));
    assert!(warned(&text.replace(",0.125", ",125"), 1.0));
}

/// Bonds in one plane do not hold a sheet of points across it: the run is refused, unless supports hold it there.
#[test]
fn a_sheet_of_points_is_loose_across_itself() {
    let (text, _) = list([6, 6, 1], 0.0);
    let refused = |supports: Value| {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("points.csv"), &text).expect("a file");
        let case = json!({
            "title": "t", "units": "none", "model": { "bond_solid": { "youngs_modulus": 1000.0 } },
            "body": { "points": { "file": "points.csv" } },
            "regions": {
                "end": { "box": { "from": [0, 0, 0], "to": [0.5, 3, 3] } },
                "sheet": { "box": { "from": [0, 0, 0], "to": [3, 3, 3] } }
            },
            "supports": supports, "loads": [{ "body_force": { "density": [1, 0, 0] } }]
        });
        let source = case::from_text("case", case.to_string(), &[], &Folder::default())
            .unwrap_or_else(|report| panic!("{}", report.render(false)));
        let loaded = Loaded::from_source(source, folder.path().into(), None);
        loaded.and_then(|loaded| {
            loaded.solve(&RunOptions { recover: true, max_memory: None, compare: false }).map(|_| ())
        })
    };
    let end = json!([{ "at": { "region": "end" }, "ux": 0, "uy": 0, "uz": 0 }]);
    let text = refused(end).expect_err("a mechanism").to_string();
    assert!(text.contains("bonds in one plane only"), "{text}");
    let sheet = json!([
        { "at": { "region": "end" }, "ux": 0, "uy": 0 }, { "at": { "region": "sheet" }, "uz": 0 }
    ]);
    assert_eq!(refused(sheet).map_err(|error| error.to_string()), Ok(()));
}
