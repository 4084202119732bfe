//! Solids from files: the cells are those of blocks where the surface is that of a block, and loads have the forces of the surface.

use peristat::case;
use peristat::input::Folder;
use peristat::run::RunOptions;
use peristat::{Loaded, Solved};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};

fn gallery(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/solid").join(file)
}

/// A case solved beside its files.
fn solved(case: &Value, folder: &Path) -> Solved {
    let source = case::from_text("case", case.to_string(), &[], &Folder::default())
        .unwrap_or_else(|report| panic!("{}", report.render(false)));
    let loaded = Loaded::from_source(source, folder.into(), None).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { recover: true, max_memory: None, compare: false };
    loaded.solve(&options).unwrap_or_else(|error| panic!("{error}"))
}

fn resultants(found: &Solved) -> [[[f64; 3]; 2]; 2] {
    let of = found.summary.states[0].certificate.resultants.clone().expect("resultants");
    [&of.asked, &of.reactions]
        .map(|total| [total.forces(), total.moments()].map(|three| three.map(|t| t.expect("a number"))))
}

/// A ball of triangles between meridians and parallels, as a binary file.
fn ball(centre: [f64; 3], radius: f64, n: u32) -> Vec<u8> {
    let at = |i: u32, j: u32| {
        let [a, b] = [i, j % (2 * n)].map(|k| std::f64::consts::PI * f64::from(k) / f64::from(n));
        let ring = if i == 0 || i == n { 0.0 } else { a.sin() };
        let unit = [ring * b.cos(), ring * b.sin(), a.cos()];
        [0, 1, 2].map(|k| (centre[k] + radius * unit[k]) as f32)
    };
    let mut bytes = vec![0; 80];
    bytes.extend((4 * n * n).to_le_bytes());
    for (i, j) in (0..n).flat_map(|i| (0..2 * n).map(move |j| (i, j))) {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        for corners in [[a, b, c], [a, c, d]] {
            bytes.extend([0; 12]);
            bytes.extend(corners.iter().flatten().flat_map(|x| x.to_le_bytes()));
            bytes.extend([0; 2]);
        }
    }
    bytes
}

fn models() -> [Value; 2] {
    [
        json!({ "bond_solid": { "youngs_modulus": 1000.0 } }),
        json!({ "state_solid": { "youngs_modulus": 1000.0, "poisson_ratio": 0.3 } }),
    ]
}

#[test]
fn loads_on_a_slope_have_the_forces_of_the_surface_and_of_the_reactions() {
    // The slope has 10 by 6 and the normal (0.6, 0.8, 0), at whatever spacing.
    let area = 60.0;
    let loads: [(Value, [f64; 3]); 3] = [
        (json!({ "pressure": 2.0 }), [-0.6 * 2.0 * area, -0.8 * 2.0 * area, 0.0]),
        (json!({ "uniform": [0.5, -0.25, 1.0] }), [0.5 * area, -0.25 * area, area]),
        (json!({ "total": [3.0, 5.0, -7.0] }), [3.0, 5.0, -7.0]),
    ];
    for model in models() {
        for spacing in [1.0, 0.7] {
            for (load, expected) in &loads {
                let mut traction = load.clone();
                traction["face"] = json!("slope");
                let case = json!({
                    "title": "t", "units": "none", "model": model, "body": { "solid": { "file": "slope.stl", "spacing": spacing } },
                    "supports": [{ "at": { "region": "bottom" }, "ux": 0.0, "uy": 0.0, "uz": 0.0 }], "loads": [{ "traction": traction }],
                });
                let [asked, held] = resultants(&solved(&case, gallery("").as_path()));
                let most = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                for k in 0..3 {
                    assert!((asked[0][k] - expected[k]).abs() < 1e-12 * most, "{asked:?} {expected:?}");
                    // 1e-13 measured.
                    assert!((asked[0][k] + held[0][k]).abs() < 1e-9 * most, "{asked:?} {held:?}");
                    assert!((asked[1][k] + held[1][k]).abs() < 1e-8 * most, "{asked:?} {held:?}");
                }
                // They act at (8, 6, 3), the middle of the slope, within a tenth of a spacing: at a spacing of 1 exactly.
                let moment = [
                    6.0 * expected[2] - 3.0 * expected[1],
                    3.0 * expected[0] - 8.0 * expected[2],
                    8.0 * expected[1] - 6.0 * expected[0],
                ];
                for k in 0..3 {
                    let far = (asked[1][k] - moment[k]).abs();
                    assert!(far < if spacing == 1.0 { 1e-10 } else { 0.3 } * most, "{asked:?} {moment:?}");
                }
            }
        }
    }
}

#[test]
fn tetrahedra_of_a_block_are_a_block() {
    for model in models() {
        let case = |body: Value, faces: [&str; 2]| {
            json!({
                "title": "t", "units": "none", "model": model, "body": body,
                "supports": [{ "at": { "region": faces[0] }, "ux": 0.0, "uy": 0.0, "uz": 0.0 }],
                "loads": [{ "traction": { "face": faces[1], "linear": [[1.0, 0.0, 0.0], [2.0, 0.5, 0.0]], "along": "y" } }],
            })
        };
        let file = case(
            json!({ "solid": { "file": "bar.msh", "spacing": 1.0, "scale": 0.5 } }),
            ["fixed", "pulled"],
        );
        let block = case(json!({ "block": { "size": [8.0, 2.0, 2.0], "spacing": 1.0 } }), ["left", "right"]);
        let [file, block] = [&file, &block].map(|case| solved(case, gallery("").as_path()));
        for name in ["ux", "uy", "uz", "stress_xx", "stress_xy", "stress_zz"] {
            let [file, block] =
                [&file, &block].map(|solved| solved.field(0, name).expect("a field").into_owned());
            // The same numbers but for the rounding of areas.
            let most = block.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            assert!(file.len() == block.len() && !file.is_empty());
            assert!(file.iter().zip(&block).all(|(a, b)| (a - b).abs() < 1e-9 * most), "{name}");
        }
    }
}

#[test]
fn a_ball_from_a_file_is_the_ball_that_is_cut_out_of_a_block() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("ball.stl"), ball([5.0; 3], 5.0, 40)).unwrap();
    let pressure = |face: &str| json!([{ "traction": { "face": face, "pressure": 3.0 } }]);
    let supports = json!([
        { "at": { "x": 5.25, "y": 5.25, "z": 5.25 }, "ux": 0.0, "uy": 0.0, "uz": 0.0 },
        { "at": { "x": 7.25, "y": 5.25, "z": 5.25 }, "uy": 0.0, "uz": 0.0 },
        { "at": { "x": 5.25, "y": 7.25, "z": 5.25 }, "uz": 0.0 },
    ]);
    let case = |body: Value, face: &str| json!({ "title": "t", "units": "none", "model": models()[0], "body": body, "supports": supports, "loads": pressure(face) });
    let file = case(json!({ "solid": { "file": "ball.stl", "spacing": 0.5 } }), "rest");
    let cut = json!([{ "outside_ball": { "name": "ball", "centre": [5.0, 5.0, 5.0], "radius": 5.0 } }]);
    let block = case(json!({ "block": { "size": [10.0, 10.0, 10.0], "spacing": 0.5, "cuts": cut } }), "ball");
    let [file, block] = [&file, &block].map(|case| solved(case, folder.path()));
    let points = [&file, &block].map(|solved| solved.points().len());
    // Chords of 4.5 degrees are 0.08 % of the radius inside of the ball: a few centres of cells are beyond them.
    assert!(points[1] >= points[0] && points[1] - points[0] < points[1] / 100, "{points:?}");
    // All of a closed surface: one stress, to rounding.
    for solved in [&file, &block] {
        let stress = solved.field(0, "stress_xx").expect("a field");
        assert!(stress.iter().all(|s| (s + 3.0).abs() < 1e-6), "{:?}", &stress[..4]);
    }
}
