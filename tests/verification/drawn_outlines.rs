//! Outlines from meshes and drawings, arcs, and several edges at once: bodies that are drawn are those that are written.

use peristat::case;
use peristat::input::Folder;
use peristat::run::RunOptions;
use peristat::scene::{BodyScene, Scene};
use peristat::summary::Forces;
use peristat::{Loaded, Solved};
use serde_json::{Value, json};
use std::f64::consts::PI;
use std::fs;
use std::path::Path;

/// A case solved beside a file of this name and text.
fn solved(case: &Value, (name, text): (&str, &str)) -> Solved {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join(name), text).expect("a file");
    let source = case::from_text("case", case.to_string(), &[], &Folder::default())
        .unwrap_or_else(|r| panic!("{}", r.render(false)));
    let loaded =
        Loaded::from_source(source, folder.path().into(), None).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { recover: true, max_memory: None, compare: false };
    loaded.solve(&options).unwrap_or_else(|error| panic!("{error}"))
}

fn written(case: &Value) -> Solved {
    solved(case, ("nothing", ""))
}

fn values(found: &Solved) -> Vec<f64> {
    found.summary.probes.iter().map(|probe| probe.value).collect()
}

fn scene(case: &Value) -> BodyScene {
    let source = case::from_text("case", case.to_string(), &[], &Folder::default()).expect("a case");
    let scene = Scene::new(source.case, Path::new("."), "case", &source.text, None);
    scene.unwrap_or_else(|error| panic!("{error}")).into_body().expect("a body in the plane")
}

/// Asked forces and reactions along x and y.
fn balance(found: &Solved) -> [[f64; 2]; 2] {
    let of = found.summary.states[0].certificate.resultants.clone().expect("resultants");
    [&of.asked, &of.reactions].map(|total| [0, 1].map(|k| total.forces()[k].expect("a number")))
}

/// A plate 8 by 4 in DXF, its lines in any order, with a hole of radius 0.8 if it is asked for.
fn dxf(hole: bool) -> String {
    let line = |layer: &str, [x, y, u, v]: [f64; 4]| {
        format!("0\nLINE\n8\n{layer}\n10\n{x}\n20\n{y}\n11\n{u}\n21\n{v}\n")
    };
    let mut text = "0\nSECTION\n2\nENTITIES\n".to_string();
    text += &line("right", [8.0, 4.0, 8.0, 0.0]);
    text += &line("flanks", [0.0, 0.0, 8.0, 0.0]);
    text += &line("left", [0.0, 4.0, 0.0, 0.0]);
    text += &line("flanks", [0.0, 4.0, 8.0, 4.0]);
    if hole {
        text += "0\nCIRCLE\n8\nbore\n10\n4\n20\n2\n40\n0.8\n";
    }
    text + "0\nENDSEC\n0\nEOF\n"
}

/// The same in SVG, in tenths, within a group that is moved.
fn svg(hole: bool) -> String {
    let bore = if hole { "<circle id='bore' cx='40' cy='20' r='8'/>" } else { "" };
    format!(
        "<svg viewBox='0 0 80 60'><g transform='translate(0, 20)'><path id='left' d='M0 0v40'/>\
         <path id='flanks' d='M0 40h80'/><path id='right' d='M80 40V0'/><path d='M80,0H0'/>{bore}</g></svg>"
    )
}

/// The plate without a hole as a mesh of 8 by 4 squares of two triangles each, the left and the right half in groups of their own.
fn mesh() -> String {
    let node = |i: usize, j: usize| 1 + i + 9 * j;
    let squares = || (0..4).flat_map(|j| (0..8).map(move |i| (i, j)));
    let mut text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n1 1 \"left\"\n1 2 \"right\"\n2 3 \"near\"\n2 4 \"far\"\n$EndPhysicalNames\n".to_string();
    text += "$Entities\n0 2 2 0\n1 0 0 0 0 4 0 1 1 0\n2 8 0 0 8 4 0 1 2 0\n1 0 0 0 4 4 0 1 3 0\n2 4 0 0 8 4 0 1 4 0\n$EndEntities\n";
    text += "$Nodes\n1 45 1 45\n2 1 0 45\n";
    (1..=45).for_each(|tag| text += &format!("{tag}\n"));
    (0..5).for_each(|j| (0..9).for_each(|i| text += &format!("{i} {j} 0\n")));
    text += "$EndNodes\n$Elements\n4 72 1 72\n";
    for (curve, i) in [(1, 0), (2, 8)] {
        text += &format!("1 {curve} 1 4\n");
        (0..4).for_each(|j| text += &format!("{} {} {}\n", 4 * curve + j, node(i, j), node(i, j + 1)));
    }
    for (surface, range) in [(1, 0..4), (2, 4..8)] {
        text += &format!("2 {surface} 2 32\n");
        for (i, j) in squares().filter(|(i, _)| range.contains(i)) {
            let [a, b, c, d] = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
            let tag = 100 + 2 * (i + 8 * j);
            text += &format!("{tag} {a} {b} {c}\n{} {a} {c} {d}\n", tag + 1);
        }
    }
    text + "$EndElements\n"
}

fn models() -> [Value; 3] {
    [
        json!({ "bond_plane": { "youngs_modulus": 7e4, "state": "plane_stress" } }),
        json!({ "state_plane": { "youngs_modulus": 7e4, "poisson_ratio": 0.2, "state": "plane_strain" } }),
        json!({ "beam_bond_orthotropic": { "youngs_modulus_1": 41000, "youngs_modulus_2": 10400, "poisson_ratio_12": 0.28,
            "shear_modulus_12": 4300, "fibre_angle": 0 } }),
    ]
}

fn pulled(model: &Value, body: Value) -> Value {
    json!({
        "title": "plate", "units": "mm-N-MPa", "model": model, "body": body,
        "supports": [ { "at": { "region": "left" }, "ux": 0 }, { "at": { "x": 0.1, "y": 0.1 }, "uy": 0 } ],
        "loads": [ { "traction": { "edge": "right", "uniform": [100, 0] } } ],
        "probes": [ { "name": "stress", "at": { "x": 5.1, "y": 1.5 }, "field": "stress_xx" },
            { "name": "at the edge", "at": { "x": 7.9, "y": 3.9 }, "field": "stress_xx" },
            { "name": "across", "at": { "x": 5.1, "y": 1.5 }, "field": "stress_yy" } ]
    })
}

#[test]
fn a_plate_from_a_file_in_tension_has_one_stress() {
    for model in models() {
        let files =
            [("plate.msh", mesh(), 1.0), ("plate.dxf", dxf(false), 1.0), ("plate.svg", svg(false), 0.1)];
        for (name, text, scale) in files {
            let body = json!({ "outline": { "file": name, "spacing": 0.2, "scale": scale } });
            let found = values(&solved(&pulled(&model, body), (name, &text)));
            for (value, exact) in found.iter().zip([100.0, 100.0, 0.0]) {
                assert!((value - exact).abs() < 1e-9, "{name} {model}: {found:?}");
            }
        }
    }
}

#[test]
fn a_plate_with_a_hole_from_a_file_is_the_one_that_is_written() {
    let bore = json!([{ "circle": { "name": "bore", "centre": [4, 2], "radius": 0.8 } }]);
    for model in &models()[..2] {
        let with = |body: Value| {
            let mut case = pulled(model, body);
            case["probes"].as_array_mut().unwrap().push(
                json!({ "name": "beside the bore", "at": { "region": "bore" }, "field": "von_mises", "of": "largest" }),
            );
            case
        };
        let outline = json!({ "outline": { "vertices": [[0, 0], [8, 0], [8, 4], [0, 4]], "spacing": 0.2, "holes": bore,
            "edges": { "left": "edge_4", "right": "edge_2" } } });
        let own = values(&written(&with(outline)));
        for (name, text, scale) in [("plate.dxf", dxf(true), 1.0), ("plate.svg", svg(true), 0.1)] {
            let body = json!({ "outline": { "file": name, "spacing": 0.2, "scale": scale } });
            let found = values(&solved(&with(body), (name, &text)));
            for (value, own) in found.iter().zip(&own) {
                assert!((value - own).abs() < 1e-9 * 100.0, "{name}: {found:?} {own:?}");
            }
        }
        // A mesh that knows nothing of a hole, which the case cuts.
        let body = json!({ "outline": { "file": "plate.msh", "spacing": 0.2, "holes": bore } });
        assert_eq!(values(&solved(&with(body), ("plate.msh", &mesh()))), own);
    }
}

#[test]
fn physical_surfaces_are_regions() {
    let mut case = pulled(&models()[0], json!({ "outline": { "file": "plate.msh", "spacing": 0.25 } }));
    case["probes"] = json!([
        { "name": "near", "at": { "region": "near" }, "field": "ux", "of": "integral" },
        { "name": "far", "at": { "region": "far" }, "field": "ux", "of": "integral" }
    ]);
    // u = x σ/E over 4 by 4: means of x are 2 and 6.
    let found = values(&solved(&case, ("plate.msh", &mesh())));
    for (value, exact) in found.iter().zip([2.0, 6.0].map(|x| 16.0 * x * 100.0 / 7e4)) {
        assert!((value / exact - 1.0).abs() < 1e-9, "{found:?}");
    }
}

/// A disc of two arcs.
fn disc(radius: f64, spacing: f64) -> Value {
    json!({
        "title": "disc", "units": "none", "model": models()[0],
        "body": { "outline": { "vertices": [{ "arc_to": [-radius, 0], "through": [0, radius] }, { "arc_to": [radius, 0], "centre": [0, 0] }],
            "spacing": spacing } },
        "supports": [ { "at": { "x": 0.5, "y": 0.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 4.5, "y": 0.5 }, "uy": 0 } ],
        "loads": [ { "traction": { "edge": "all", "pressure": 10 } } ],
        "probes": [ { "name": "inside", "at": { "x": 0.5, "y": 0.5 }, "field": "stress_xx" } ]
    })
}

#[test]
fn the_area_of_a_disc_of_arcs_is_that_of_its_chords() {
    for (radius, spacing) in [(10.0, 1.0), (10.0, 0.5), (7.3, 1.0)] {
        let case = disc(radius, spacing);
        let scene = scene(&case);
        let area: f64 = scene.real_points().map(|p| scene.model.volume(p)).sum();
        let missing = 1.0 - area / (PI * radius * radius);
        // Two thirds of the deviation all around; the chords are inside.
        let most = 2.0 * 2.0 / 3.0 * 0.01 * spacing / radius;
        assert!((0.0..=most).contains(&missing), "{missing:e}, {most:e}");
    }
}

#[test]
fn pressure_all_around_arcs_and_holes_is_one_stress() {
    let found = values(&written(&disc(10.0, 1.0)));
    assert!((found[0] / -10.0 - 1.0).abs() < 1e-11, "{found:?}");
}

#[test]
fn tractions_on_several_edges_and_half_holes_have_the_force_that_is_asked() {
    let file = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/plate/lug.dxf"))
        .expect("a file");
    for model in models() {
        let case = |loads: Value| {
            json!({ "title": "lug", "units": "mm-N-MPa", "model": model,
                "body": { "outline": { "file": "lug.dxf", "spacing": 2 } },
                "supports": [ { "at": { "region": "wall" }, "ux": 0, "uy": 0 } ], "loads": loads })
        };
        let loads = [
            (json!({ "edge": "pin", "total": [300, -40] }), [300.0, -40.0]),
            // What presses on the right half of a hole pushes to the right, by its width of 28.
            (json!({ "edge": "pin", "pressure": 10 }), [280.0, 0.0]),
            (json!({ "edge": ["pin", "clearance"], "pressure": 10 }), [0.0, 0.0]),
            (json!({ "edge": ["head", "sides"], "total": [50, 70] }), [50.0, 70.0]),
            (json!({ "edge": ["head", "head"], "pressure": 10 }), [-600.0, 0.0]),
        ];
        for (traction, exact) in loads {
            let found = solved(&case(json!([{ "traction": traction }])), ("lug.dxf", &file));
            let [asked, reactions] = balance(&found);
            for k in 0..2 {
                assert!((asked[k] - exact[k]).abs() < 1e-9 * 600.0, "{traction}: asked {asked:?}");
                assert!((reactions[k] + asked[k]).abs() < 1e-8 * 600.0, "{traction}: {reactions:?}");
            }
        }
    }
}

#[test]
fn edges_that_are_held_together_have_one_reaction() {
    for model in models() {
        for spacing in [0.25, 0.4] {
            let case = json!({ "title": "corner", "units": "mm-N-MPa", "model": model,
                "body": { "outline": { "vertices": [[0, 0], [8, 0], [8, 2], [3, 2], [0, 4]], "spacing": spacing } },
                "supports": [ { "at": { "region": ["edge_1", "edge_5"] }, "ux": 0, "uy": 0 } ],
                "loads": [ { "traction": { "edge": ["edge_2", "edge_3"], "total": [30, 50] } } ] });
            let [asked, reactions] = balance(&written(&case));
            for (k, exact) in [30.0, 50.0].into_iter().enumerate() {
                assert!((asked[k] - exact).abs() < 1e-9, "{asked:?}");
                assert!((reactions[k] + exact).abs() < 1e-6, "{model} {spacing}: {reactions:?}");
            }
        }
    }
}

#[test]
fn several_edges_are_held_as_one_by_one_and_springs_are_shared() {
    let case = |supports: Value| {
        json!({ "title": "ends", "units": "mm-N-MPa", "model": models()[1],
            "body": { "rectangle": { "size": [8, 4], "spacing": 0.25 } }, "supports": supports,
            "loads": [ { "body_force": { "density": [3, 5] } } ],
            "probes": [ { "name": "u", "at": { "x": 4, "y": 2 }, "field": "ux" }, { "name": "v", "at": { "x": 4, "y": 2 }, "field": "uy" } ] })
    };
    let together = case(json!([{ "at": { "region": ["left", "right"] }, "ux": 0, "uy": 0 }]));
    let apart = case(
        json!([{ "at": { "region": "left" }, "ux": 0, "uy": 0 }, { "at": { "region": "right" }, "ux": 0, "uy": 0 }]),
    );
    let [a, b] = [together, apart].map(|case| values(&written(&case)));
    a.iter().zip(&b).for_each(|(a, b)| assert!((a / b - 1.0).abs() < 1e-10, "{a} {b}"));
    // A force of 3 by 32 on springs of 1000 moves all by as much, and the strain beside it is small.
    let springs = case(json!([{ "at": { "region": ["left", "right"] }, "ux_spring": 1000, "uy": 0 }]));
    let found = values(&written(&springs));
    assert!((found[0] / 0.096 - 1.0).abs() < 0.02, "{found:?}");
}

#[test]
fn the_outer_border_leaves_out_holes_and_mirrors() {
    let case = json!({ "title": "quarter", "units": "mm-N-MPa", "model": models()[1],
        "body": { "rectangle": { "size": [8, 8], "spacing": 0.5, "holes": [ { "circle": { "centre": [0, 0], "radius": 2 } } ] } },
        "symmetry": ["left", "bottom"],
        "loads": [ { "traction": { "edge": "outer", "uniform": [1, 2] } } ] });
    let [asked, _] = balance(&written(&case));
    // The right side and the top, 8 each.
    assert!((asked[0] - 16.0).abs() < 1e-9 && (asked[1] - 32.0).abs() < 1e-9, "{asked:?}");
}

/// The corner of two edges is held once, whether one support or two hold them: held twice, the rounding of both was
/// what moved it, with reactions that grew threefold from row to row.
#[test]
fn edges_held_one_by_one_are_held_as_together() {
    for (model, spacing) in [("bond_plane", 1.0), ("bond_plane", 0.5), ("state_plane", 1.0)] {
        let held = |supports: Value| {
            let mut keys = json!({ "youngs_modulus": 70000, "state": "plane_stress" });
            if model == "state_plane" {
                keys["poisson_ratio"] = json!(0.3);
            }
            written(&json!({
                "title": "corner", "units": "mm-N-MPa", "model": { model: keys },
                "body": { "outline": { "vertices": [[0, 0], [10.6, 0], [10.6, 8.3], [0, 8.3]], "spacing": spacing } },
                "supports": supports,
                "loads": [ { "traction": { "edge": "edge_2", "uniform": [10, 4] } } ],
                "probes": [ { "name": "u", "at": { "x": 9.1, "y": 6.2 }, "field": "ux" },
                    { "name": "s", "at": { "x": 5.1, "y": 3.2 }, "field": "stress_xx" } ]
            }))
        };
        let clamped = |region: Value| json!({ "at": { "region": region }, "ux": 0, "uy": 0 });
        let together = held(json!([clamped(json!(["edge_1", "edge_4"]))]));
        let apart = held(json!([clamped(json!("edge_1")), clamped(json!("edge_4"))]));
        for (found, expected) in values(&apart).iter().zip(values(&together)) {
            // Measured: 1.3e-9, as either way groups other points.
            assert!((found / expected - 1.0).abs() < 1e-8, "{model} {spacing}: {found} for {expected}");
        }
        for found in [&apart, &together] {
            let [asked, reactions] = balance(found);
            assert!((asked[0] - 83.0).abs() < 1e-9 && (asked[1] - 33.2).abs() < 1e-9, "{asked:?}");
            assert!((0..2).all(|k| (asked[k] + reactions[k]).abs() < 1e-8), "{asked:?} {reactions:?}");
        }
        let Forces::Body(forces) = &apart.summary.states[0].forces else { panic!("a plate") };
        let each: Vec<f64> = forces.reactions.iter().flat_map(|r| [r.force_x, r.force_y]).collect();
        assert!(each.len() == 4 && each.iter().all(|force| force.abs() < 120.0), "{each:?}");
    }
}

/// Edges that are held by pieces of a border beside a line of symmetry: their rows reach images, and the sum of all reactions
/// is what is asked.
#[test]
fn reactions_beside_mirrors_add_up() {
    for (model, width) in [("bond_plane", 3.4), ("bond_plane", 12.4), ("state_plane", 12.4)] {
        let mut keys = json!({ "youngs_modulus": 70000, "state": "plane_stress" });
        if model == "state_plane" {
            keys["poisson_ratio"] = json!(0.3);
        }
        let found = written(&json!({
            "title": "mirror", "units": "mm-N-MPa", "model": { model: keys },
            "body": { "outline": { "vertices": [[0, 0], [width, 0], [width, 5], [0, 5]], "spacing": 1 } },
            "symmetry": ["bottom"],
            "supports": [ { "at": { "region": "edge_2" }, "ux": 0, "uy": 0 } ],
            "loads": [ { "traction": { "edge": "edge_3", "uniform": [0, 10] } } ]
        }));
        let [asked, reactions] = balance(&found);
        assert!((asked[1] - 10.0 * width).abs() < 1e-9, "{asked:?}");
        // Measured: 1e-13.
        assert!(
            (0..2).all(|k| (asked[k] + reactions[k]).abs() < 1e-9),
            "{model} {width}: {asked:?} {reactions:?}"
        );
    }
}
