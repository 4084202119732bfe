//! Probes of beams between points of the grid: the exact element that joins the points has no error of its own where nothing
//! loads it, and that of one cell where something does.

use peristat::Solved;
use serde_json::{Value, json};

const LENGTH: f64 = 1.0;
const FORCE: f64 = 3.0;

/// A thick beam with EI = 1 and κGA = 40, and probes of some fields at some places, place by place.
fn solve(cells: usize, changes: &Value, fields: &[&str], places: &[f64]) -> (Solved, Vec<Vec<f64>>) {
    let stiffness =
        json!({ "bending": { "uniform": 1.0 }, "shear": { "uniform": 40.0 }, "axial": { "uniform": 7.0 } });
    let probe =
        |x: &f64, field: &str| json!({ "name": format!("{field} {x}"), "at": { "x": x }, "field": field });
    let probes: Vec<Value> = places.iter().flat_map(|x| fields.iter().map(move |f| probe(x, f))).collect();
    let mut case = json!({
        "title": "beam", "units": "none", "model": { "timoshenko_beam": { "stiffness": stiffness } },
        "body": { "line": { "length": LENGTH, "cells": cells } },
        "supports": [{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0, "ux": 0.0 }],
        "probes": probes
    });
    for (key, value) in changes.as_object().expect("keys of a case") {
        case[key] = value.clone();
    }
    let solved = peristat::solve_text(&format!("{case:#}")).expect("a case that can be solved");
    let values: Vec<f64> = solved.summary.probes.iter().map(|p| p.value).collect();
    let values = values.chunks(fields.len()).map(<[f64]>::to_vec).collect();
    (solved, values)
}

#[test]
fn a_cantilever_under_forces_at_its_tip_is_exact_everywhere() {
    let load = json!({ "loads": [{ "point": { "at": { "x": 1.0 }, "force": FORCE, "axial": 2.0 } }] });
    let places = [0.013, 0.26, 0.55, 0.949];
    let (solved, found) = solve(10, &load, &["w", "phi", "M", "V", "u", "N"], &places);
    for (x, found) in places.into_iter().zip(found) {
        let w = FORCE * (x * x * (3.0 * LENGTH - x) / 6.0 + x / 40.0);
        let phi = FORCE * x * (LENGTH - 0.5 * x);
        let exact = [w, phi, FORCE * (LENGTH - x), FORCE, 2.0 * x / 7.0, 2.0];
        for (found, exact) in found.iter().zip(exact) {
            // 3e-16 of the force is found.
            assert!((found - exact).abs() <= 1e-12 * FORCE, "at {x}: {found} is not {exact}");
        }
    }
    let probe = &solved.summary.probes[0];
    assert_eq!((probe.x, probe.place.as_deref()), (Some(0.013), None));
}

#[test]
fn a_uniform_load_leaves_what_one_cell_adds() {
    let load = json!({
        "supports": [{ "at": { "x": 0.0 }, "w": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }],
        "loads": [{ "distributed": { "force": { "uniform": FORCE } } }]
    });
    for cells in [4, 8, 16] {
        let h = LENGTH / f64::from(cells);
        // In the middle of a cell.
        let x = (f64::from(cells / 2) - 0.5) * h;
        let (_, found) = solve(cells as usize, &load, &["w", "M", "V"], &[x]);
        let y = LENGTH - x;
        let w = FORCE * (x * (1.0 - 2.0 * x * x + x * x * x) / 24.0 + x * y / 80.0);
        // What a clamped element sags under the load, by bending and by shear.
        let own = FORCE * (h.powi(4) / 384.0 + h * h / 320.0);
        assert!((w - found[0][0] - own).abs() < 1e-13, "{cells}: {} of {own}", w - found[0][0]);
        // Statics has no error: 3e-16 is found.
        assert!((found[0][1] + FORCE * x * y / 2.0).abs() < 1e-13, "{cells}: {}", found[0][1]);
        assert!((found[0][2] - FORCE * (0.5 - x)).abs() < 1e-12, "{cells}: {}", found[0][2]);
    }
}

#[test]
fn members_of_frames_answer_in_both_axes() {
    let fields = ["ux", "uy", "N", "stress_top", "energy_density"];
    let probes =
        fields.map(|field| json!({ "name": field, "at": { "member": "rafter", "x": 2.0 }, "field": field }));
    // A place on a point of one grid is between points of the other.
    let values = |cells: usize| {
        let case = json!({
            "title": "frame", "units": "m-N-Pa",
            "model": { "timoshenko_beam": { "youngs_modulus": 2e11, "poisson_ratio": 0.3,
                "section": { "rectangle": { "width": 0.1, "height": 0.2 } } } },
            "body": { "frame": {
                "joints": [{ "name": "A", "x": 0, "y": 0 }, { "name": "B", "x": 3, "y": 4 }],
                "members": [{ "name": "rafter", "from": "A", "to": "B", "cells": cells }] } },
            "supports": [{ "at": { "joint": "A" }, "ux": 0, "uy": 0, "phi": 0 }],
            "loads": [{ "point": { "at": { "joint": "B" }, "force_x": 500.0, "force_y": -2000.0 } }],
            "probes": probes
        });
        peristat::solve_text(&format!("{case:#}")).unwrap().summary.probes
    };
    let (on, between) = (values(10), values(9));
    for (on, between) in on.iter().zip(&between).take(4) {
        assert!(
            (on.value - between.value).abs() < 1e-11 * on.value.abs(),
            "{}: {} {}",
            on.field,
            on.value,
            between.value
        );
        assert_eq!(between.place.as_deref(), Some("member `rafter` at x = 2"));
    }
    // The density of energy is linear between points, and that of bending a parabola: 1.4 % is found.
    assert!((on[4].value - between[4].value).abs() < 0.02 * on[4].value);
}

#[test]
fn section_forces_beside_loads_off_the_grid_are_those_of_statics() {
    // A force at 1.1/4 of a span, 13 cells; a triangle of load over a part; a couple; a pull; between supports.
    let at = 0.275;
    let supports = json!([{ "at": { "x": 0.0 }, "w": 0.0, "ux": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }]);
    let places = [0.2625, at, 0.2875, 0.5, 0.7];
    let of = |load: Value| {
        solve(13, &json!({ "supports": supports, "loads": [load] }), &["M", "V", "N"], &places).1
    };
    let check = |found: Vec<Vec<f64>>, exact: &dyn Fn(f64) -> [f64; 3]| {
        for (x, found) in places.into_iter().zip(found) {
            for (found, exact) in found.iter().zip(exact(x)) {
                // 1e-15 is found.
                assert!((found - exact).abs() < 1e-12, "at {x}: {found} is not {exact}");
            }
        }
    };
    let (left, right) = (FORCE * (1.0 - at), FORCE * at);
    check(of(json!({ "point": { "at": { "x": at }, "force": FORCE, "axial": 2.0 } })), &|x| match x < at {
        true => [-left * x, left, 2.0],
        false => [-right * (1.0 - x), -right, 0.0],
    });
    check(of(json!({ "point": { "at": { "x": at }, "moment": FORCE } })), &|x| {
        [FORCE * x - if x < at { 0.0 } else { FORCE }, -FORCE, 0.0]
    });
    // q = 2 (x - 0.25) from 0.25 to 1: resultant 0.5625 at 0.75.
    let load = json!({ "distributed": { "from": 0.25, "force": { "linear": [0.0, 1.5] } } });
    check(of(load), &|x| {
        let (r, z) = (0.5625 * 0.25, (x - 0.25_f64).max(0.0));
        [-r * x + z.powi(3) / 3.0, r - z * z, 0.0]
    });
}
