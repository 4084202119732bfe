//! The energy density of beams against section forces and against the energy of closed forms.

use serde_json::{Value, json};

/// Values of probes of the energy density of a beam with EI = 2, κGA = 40, EA = 7 and A = 0.5.
fn solve(cells: usize, changes: &Value, probes: &Value) -> Vec<f64> {
    let mut case = json!({
        "title": "beam", "units": "none",
        "model": { "timoshenko_beam": { "stiffness": {
            "bending": { "uniform": 2.0 }, "shear": { "uniform": 40.0 }, "axial": { "uniform": 7.0 }, "area": 0.5
        } } },
        "body": { "line": { "length": 1.0, "cells": cells } },
        "supports": [{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0, "ux": 0.0 }],
    });
    for (key, value) in changes.as_object().expect("keys of a case") {
        case[key] = value.clone();
    }
    case["probes"] = probes.clone();
    let solved = peristat::solve_text(&format!("{case:#}")).expect("a case that can be solved");
    solved.summary.probes.iter().map(|p| p.value).collect()
}

fn at(x: f64) -> Value {
    json!({ "name": format!("at {x}"), "at": { "x": x }, "field": "energy_density" })
}

fn of(reduction: &str) -> Value {
    json!({ "name": reduction, "of": reduction, "field": "energy_density" })
}

#[test]
fn it_is_that_of_the_section_forces_everywhere() {
    let (force, axial) = (3.0, 2.0);
    let load = json!({ "loads": [{ "point": { "at": { "x": 1.0 }, "force": force, "axial": axial } }] });
    // On points and between them, at both ends.
    let places = [0.0, 0.25, 0.31, 0.5, 0.93, 1.0];
    let probes: Value = places.iter().map(|x| at(*x)).chain(["largest", "smallest"].map(of)).collect();
    let density = |x: f64| {
        let m: f64 = force * (1.0 - x);
        (m * m / 2.0 + force * force / 40.0 + axial * axial / 7.0) / 2.0 / 0.5
    };
    for cells in [1, 4, 7, 200] {
        let found = solve(cells, &load, &probes);
        let exact = places.into_iter().chain([0.0, 1.0]).map(density);
        for (found, exact) in found.into_iter().zip(exact) {
            // 2.4e-15 of it is found.
            assert!((found - exact).abs() < 1e-14 * exact, "{cells}: {found} is not {exact}");
        }
    }
}

#[test]
fn its_integral_is_the_energy_of_closed_forms_on_any_grid() {
    let uniform = json!([{ "distributed": { "force": { "uniform": 3.0 } } }]);
    let inside = json!([{ "point": { "at": { "x": 0.63 }, "force": 3.0, "axial": -2.0 } }]);
    let bent = json!([{ "initial_strain": { "curvature": 0.3 } }]);
    let propped = json!([
        { "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0, "ux": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }
    ]);
    // Of the tip of a cantilever: its compliance, and its deflections under these loads.
    let compliance = 1.0 / 6.0 + 1.0 / 40.0;
    let a = 0.63;
    let [sag, deflection] = [3.0 / 16.0 + 3.0 / 80.0, 3.0 * (a * a * (3.0 - a) / 12.0 + a / 40.0)];
    let [spread, point] = [9.0 / 80.0 + 9.0 / 240.0, 9.0 * (a * a * a / 12.0 + a / 80.0) + 4.0 * a / 14.0];
    let cases = [
        (&uniform, None, spread),
        // A prop takes half of what it does off, by the theorem of least work.
        (&uniform, Some(&propped), spread - 0.5 * sag * sag / compliance),
        (&inside, Some(&propped), point - 0.5 * deflection * deflection / compliance),
        (&bent, None, 0.0),
        (&bent, Some(&propped), 0.5 * 0.15 * 0.15 / compliance),
    ];
    for (loads, supports, exact) in cases {
        let mut changes = json!({ "loads": loads });
        supports.into_iter().for_each(|supports: &Value| changes["supports"] = supports.clone());
        for cells in [1, 5, 60] {
            let found = solve(cells, &changes, &json!([of("integral")]));
            // Over the length: times the area. 8.3e-17 is found.
            assert!(
                (0.5 * found[0] - exact).abs() < 1e-15,
                "{loads} {cells}: {} is not {exact}",
                0.5 * found[0]
            );
        }
    }
}

#[test]
fn beams_that_break_have_one_where_their_area_is_known() {
    let density = |area: Value| {
        let mut stiffness = json!({ "bending": { "uniform": 2.0 }, "shear": { "uniform": 40.0 } });
        if !area.is_null() {
            stiffness["area"] = area;
        }
        let case = json!({
            "title": "beam", "units": "none", "model": { "timoshenko_beam": { "stiffness": stiffness } },
            "body": { "line": { "length": 1.0, "cells": 20 } },
            "supports": [{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }],
            "loads": [{ "point": { "at": { "x": 1.0 }, "force": 1.0 } }],
            "probes": [{ "name": "held", "at": { "x": 0.0 }, "field": "reaction_force" }],
            "fracture": { "critical": { "curvature": 0.25 }, "load": "held", "record_every": 1 }
        });
        let solved = peristat::solve_text(&format!("{case:#}")).expect("a case that can be solved");
        solved.field(0, "energy_density").map(|values| values[10]).ok()
    };
    let [one, half] = [json!(1.0), json!(0.5)].map(|area| density(area).expect("a density"));
    assert!(one > 0.0 && (half / one - 2.0).abs() < 1e-14, "{one} {half}");
    assert_eq!(density(Value::Null), None);
}
