//! A body in the plane from its case to its folder.

use super::support::{Outcome, json, names, run};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// A plate of 8 × 16 with a slot and a crack from its left edge.
fn case() -> Value {
    json!({
        "title": "Plate with a slot", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 2e5, "state": "plane_strain", "thickness": 2.0 } },
        "body": { "rectangle": { "size": [8, 16], "spacing": 0.5,
            "holes": [ { "slot": { "name": "slot", "from": [5, 2], "to": [6, 2], "radius": 0.6 } } ] } },
        "cracks": [ { "name": "edge crack", "path": [[-1, 9], [2, 9]] } ],
        "supports": [ { "at": { "region": "bottom" }, "ux": 0.0, "uy": 0.0 } ],
        "load_cases": [
            { "name": "pull", "loads": [ { "traction": { "edge": "top", "uniform": [0.0, 20.0] } } ] },
            { "name": "shear", "loads": [ { "traction": { "edge": "top", "uniform": [5.0, 0.0] } } ] }
        ],
        "probes": [
            { "name": "corner", "at": { "x": 8.0, "y": 16.0 }, "field": "uy" },
            { "name": "side", "at": { "x": 8.0, "y": 3.0, "inward": [-1, 0] }, "field": "stress_yy" },
            { "name": "foot", "at": { "region": "bottom" }, "field": "reaction_y" }
        ],
        "lines": [ { "name": "across", "from": [0, 2], "to": [8, 2], "points": 33 } ],
        "stress_intensity": [ { "name": "K", "crack": "edge crack", "tips": "end" } ],
        "checks": [ { "value": { "probe": "foot", "expected": -320.0, "tolerance": 1e-12, "source": "stress times area", "load_case": "pull" } } ]
    })
}

fn solve(folder: &Path, case: &Value, more: &[&str]) -> Outcome {
    fs::write(folder.join("plate.json"), format!("{case:#}")).unwrap();
    let mut arguments = vec!["run", "plate.json", "-o", "out"];
    arguments.extend(more);
    run(folder, &arguments)
}

#[test]
fn a_plate_leaves_its_fields_lines_maps_and_summary() {
    let folder = tempfile::tempdir().unwrap();
    let outcome = solve(folder.path(), &case(), &["-v"]);
    assert_eq!(outcome.code, 0, "{}\n{}", outcome.stdout, outcome.stderr);
    let told = [
        "plane strain",
        "ν = 1/4, thickness 2 mm",
        "1 crack, ",
        "the region `bottom`",
        "| K ",
        "crack `edge crack`",
        "(8, 16)",
        "skipped",
        " rotations: ",
    ];
    for text in told {
        assert!(outcome.stdout.contains(text), "no `{text}` in\n{}", outcome.stdout);
    }
    let out = folder.path().join("out");
    let all = [
        ".peristat",
        "case.json",
        "envelope.csv",
        "fields",
        "fields.pvd",
        "history.csv",
        "plots",
        "report.html",
        "summary.json",
    ];
    assert_eq!(names(&out), all);
    let fields = (0..2).flat_map(|k| ["", "_across"].map(|line| format!("step_00{k}{line}.csv")));
    let mut fields: Vec<String> = fields.chain((0..2).map(|k| format!("step_00{k}.vtu"))).collect();
    fields.sort();
    assert_eq!(names(&out.join("fields")), fields);
    let plots = [
        "damage.svg",
        "displacement.svg",
        "line_across_displacement.svg",
        "line_across_stress.svg",
        "von_mises.svg",
    ];
    assert_eq!(names(&out.join("plots")), plots);
    let map = fs::read_to_string(out.join("plots/displacement.svg")).unwrap();
    assert!(
        map.contains("displacements times") && map.contains("[mm]") && map.trim_end().ends_with("</svg>")
    );
    let history = fs::read_to_string(out.join("history.csv")).unwrap();
    assert_eq!(history.lines().next(), Some("step,load_factor,corner [mm],side [MPa],foot [N],K [MPa √mm]"));
}

#[test]
fn tables_and_grids_hold_the_points_of_the_body() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(solve(folder.path(), &case(), &[]).code, 0);
    let out = folder.path().join("out/fields");
    let table = fs::read_to_string(out.join("step_000.csv")).unwrap();
    let header = "x [mm],y [mm],ux [mm],uy [mm],strain_xx,strain_yy,strain_xy,stress_xx [MPa],stress_yy [MPa],stress_xy [MPa],stress_zz [MPa],von_mises [MPa],energy_density [MPa],damage";
    assert_eq!(table.lines().next(), Some(header));
    // 16 × 32 cells without those that have their centres in the slot.
    let points = table.lines().count() - 1;
    let in_slot = |x: f64, y: f64| {
        let along = x.clamp(5.0, 6.0);
        (x - along).hypot(y - 2.0) < 0.6
    };
    let cells =
        (0..16).flat_map(|i| (0..32).map(move |j| (0.25 + 0.5 * f64::from(i), 0.25 + 0.5 * f64::from(j))));
    assert_eq!(points, cells.filter(|&(x, y)| !in_slot(x, y)).count());
    let grid = fs::read_to_string(out.join("step_000.vtu")).unwrap();
    let cells: usize =
        grid.split("NumberOfCells=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap();
    assert!(grid.contains(&format!("NumberOfPoints=\"{points}\"")));
    // 15 × 31 quads, less those of the slot and of the crack.
    assert!((440..15 * 31).contains(&cells), "{cells}");
    for field in ["displacement", "stress_xx", "strain_xy", "von_mises", "energy_density", "damage"] {
        assert!(grid.contains(&format!("Name=\"{field}\"")), "{field}");
    }
    // The line is broken by the slot: the places in it are left out.
    let line = fs::read_to_string(out.join("step_000_across.csv")).unwrap();
    assert!(line.starts_with("s [mm],x [mm],y [mm],ux [mm],uy [mm],"));
    let x: Vec<f64> = line.lines().skip(1).map(|l| l.split(',').nth(1).unwrap().parse().unwrap()).collect();
    assert!(x.len() < 33 && x.len() > 20 && !x.iter().any(|x| (4.5..6.5).contains(x)), "{x:?}");
}

#[test]
fn the_summary_tells_model_forces_and_stress_intensities() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(solve(folder.path(), &case(), &[]).code, 0);
    let summary = json(&folder.path().join("out/summary.json"));
    let model = &summary["model"];
    assert_eq!(
        [&model["name"], &model["state"], &model["calibration"]],
        ["bond_plane", "plane_strain", "matched"]
    );
    assert_eq!((&model["edges"], &model["poisson_ratio"]), (&json!("border"), &json!(0.25)));
    assert!(model["cut_bonds"].as_u64() > Some(0) && model["cut_triangles"].as_u64() > Some(0));
    let state = &summary["states"][0];
    let extreme = &state["extremes"]["stress_yy"]["largest"];
    assert!(extreme["value"].as_f64() > Some(20.0) && extreme["y"].is_number(), "{extreme}");
    let reaction = &state["reactions"][0];
    assert_eq!(reaction["place"], "the region `bottom`");
    assert!((reaction["force_y"].as_f64().unwrap() + 320.0).abs() < 1e-9);
    let k = summary["probes"].as_array().unwrap().iter().find(|p| p["name"] == "K").unwrap();
    assert_eq!((&k["field"], &k["place"]), (&json!("stress_intensity"), &json!("end of crack `edge crack`")));
    // The handbook has 75.2 for a long plate; 84.7 is found with four spacings per crack length.
    let value = k["value"].as_f64().unwrap();
    assert!((75.0..90.0).contains(&value), "{value}");
    let corner = summary["probes"].as_array().unwrap().iter().find(|p| p["name"] == "corner").unwrap();
    assert_eq!((&corner["x"], &corner["y"]), (&json!(8.0), &json!(16.0)));
}

#[test]
fn a_plate_is_a_baseline_of_itself() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(solve(folder.path(), &case(), &[]).code, 0);
    let mut again = case();
    again["checks"] = json!(["uy", "stress_xx", "von_mises", "damage"].map(|field| json!({
        "baseline": { "file": "out/fields/step_001.csv", "field": field, "tolerance": 1e-10, "load_case": "shear" }
    })));
    fs::write(folder.path().join("again.json"), again.to_string()).unwrap();
    let outcome = run(folder.path(), &["run", "again.json", "-o", "again"]);
    assert_eq!(outcome.code, 0, "{}\n{}", outcome.stdout, outcome.stderr);
    again["checks"][0]["baseline"]["file"] = json!("out/fields/step_000.csv");
    fs::write(folder.path().join("again.json"), again.to_string()).unwrap();
    let other = run(folder.path(), &["run", "again.json", "-o", "other"]);
    assert_eq!(other.code, 1, "{}", other.stdout);
}
