//! Probes of beams between points of the grid, and extremes there: the exact element that joins the points has no error of its
//! own.

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
    let values = values.chunks(fields.len().max(1)).map(<[f64]>::to_vec).collect();
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
fn a_uniform_load_is_exact_everywhere() {
    for cells in [1, 4, 9] {
        let x = 0.41;
        let (_, found) = solve(cells, &on_two_supports(), &["w", "phi", "M", "V"], &[x]);
        let y = LENGTH - x;
        let w = FORCE * (x * (1.0 - 2.0 * x * x + x * x * x) / 24.0 + x * y / 80.0);
        let phi = FORCE * (1.0 - 6.0 * x * x + 4.0 * x * x * x) / 24.0;
        let exact = [w, phi, -FORCE * x * y / 2.0, FORCE * (0.5 - x)];
        for (found, exact) in found[0].iter().zip(exact) {
            // 1.7e-16 is found.
            assert!((found - exact).abs() < 1e-14, "{cells}: {found} is not {exact}");
        }
    }
}

fn on_two_supports() -> Value {
    json!({
        "supports": [{ "at": { "x": 0.0 }, "w": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }],
        "loads": [{ "distributed": { "force": { "uniform": FORCE } } }]
    })
}

/// Values and places of probes `(field, what is made of it)` of the whole beam, with the changes of `solve`, then those of the
/// extremes of the state: smallest and largest w and M.
fn reduce(cells: usize, changes: &Value, probes: &[(&str, &str)]) -> Vec<(f64, Option<f64>)> {
    let mut changes = changes.clone();
    let probe =
        |(field, of): &(&str, &str)| json!({ "name": format!("{field} {of}"), "of": of, "field": field });
    changes["probes"] = probes.iter().map(probe).collect();
    let summary = solve(cells, &changes, &[], &[]).0.summary;
    let extremes = |field: &str| {
        let e = &summary.states[0].extremes[field];
        [&e.smallest, &e.largest].map(|at| (at.value, Some(at.x)))
    };
    let probes = summary.probes.iter().map(|p| (p.value, p.x));
    probes.chain(["w", "M"].into_iter().flat_map(extremes)).collect()
}

#[test]
fn extremes_means_and_integrals_are_those_between_points() {
    // On two supports: the sag and the moment in the middle of a cell.
    let probes =
        [("w", "largest"), ("M", "largest_magnitude"), ("phi", "mean"), ("w", "integral"), ("M", "integral")];
    let (sag, moment) = (FORCE * (5.0 / 384.0 + 1.0 / 320.0), FORCE / 8.0);
    for cells in [1, 3, 7] {
        let found = reduce(cells, &on_two_supports(), &probes);
        let exact = [sag, moment, 0.0, FORCE * (1.0 / 120.0 + 1.0 / 480.0), -FORCE / 12.0];
        for (k, (found, exact)) in found.iter().zip(exact).enumerate() {
            // 2.8e-16 is found.
            assert!((found.0 - exact).abs() < 1e-14, "{cells}, {:?}: {} is not {exact}", probes[k], found.0);
        }
        let middle = |at: Option<f64>| (at.unwrap() - 0.5).abs() < 1e-6;
        assert!(middle(found[0].1) && middle(found[1].1), "{:?}", &found[..2]);
        // As in the extremes of the state.
        assert!((found[6].0 - sag).abs() < 1e-12 && (found[7].0 + moment).abs() < 1e-12, "{:?}", &found[5..]);
    }
    // A propped cantilever, clamped at 0: 9 q L²/128 at 5/8 where shear is rigid.
    let rigid = json!({ "bending": { "uniform": 1.0 }, "shear": { "uniform": 1e12 } });
    let propped = json!({
        "model": { "timoshenko_beam": { "stiffness": rigid } },
        "supports": [{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }],
        "loads": [{ "distributed": { "force": { "uniform": -FORCE } } }]
    });
    let found = reduce(5, &propped, &[("M", "largest"), ("M", "smallest")]);
    // M = E I φ′ is positive in the span under a load towards −w, and at the clamp q L²/8 the other way.
    let [span, clamp] = [9.0 * FORCE / 128.0, -FORCE / 8.0];
    assert!((found[0].0 - span).abs() < 1e-9 && (found[0].1.unwrap() - 0.625).abs() < 1e-6, "{found:?}");
    assert!((found[1].0 - clamp).abs() < 1e-9 && found[1].1 == Some(0.0), "{found:?}");
}

#[test]
fn extremes_do_not_hide_in_cells_whose_ends_say_nothing() {
    let pins = |number: usize| -> Value {
        (0..=number).map(|k| json!({ "at": { "x": k as f64 / number as f64 }, "w": 0.0 })).collect()
    };
    let load = |force: Value| json!([{ "distributed": { "force": force } }]);
    // Ten spans of one cell; three half-waves over four cells; loads and shear forces that turn inside a cell.
    let cases = [
        (10, json!({ "supports": pins(10), "loads": load(json!({ "uniform": FORCE })) })),
        (
            4,
            json!({ "supports": pins(1), "loads": load(json!({ "sine": { "amplitude": 1.0, "half_waves": 3 } })) }),
        ),
        (1, json!({ "supports": pins(1), "loads": load(json!({ "linear": [-1.0, 2.0] })) })),
        (12, json!({ "supports": pins(4), "loads": load(json!({ "linear": [-1.0, 2.0] })) })),
    ];
    for (cells, changes) in cases {
        // Smallest and largest w and M.
        let [coarse, fine] = [cells, 20 * cells].map(|cells| reduce(cells, &changes, &[]));
        let size = |of: &[(f64, Option<f64>)]| of[0].0.abs().max(of[1].0.abs());
        for (of, same) in coarse.chunks(2).zip(fine.chunks(2)) {
            for (a, b) in of.iter().zip(same) {
                // 2.4e-15 is found.
                assert!((a.0 - b.0).abs() < 1e-13 * size(same), "{cells} cells: {of:?} are not {same:?}");
            }
        }
    }
}

#[test]
fn a_force_inside_a_cell_makes_a_peak_there() {
    // At 0.275 of the span, in the fourth of 13 cells and in the only one: M = F a b/L, and the largest sag where φ vanishes.
    let (a, b) = (0.275, 0.725);
    let load = json!({
        "supports": [{ "at": { "x": 0.0 }, "w": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }],
        "loads": [{ "point": { "at": { "x": a }, "force": FORCE } }]
    });
    for cells in [1, 13] {
        let probes = [("M", "smallest"), ("V", "largest"), ("V", "smallest"), ("M", "mean")];
        let found = reduce(cells, &load, &probes);
        let exact =
            [(-FORCE * a * b, Some(a)), (FORCE * b, None), (-FORCE * a, None), (-0.5 * FORCE * a * b, None)];
        for (found, exact) in found.iter().zip(exact) {
            assert!((found.0 - exact.0).abs() < 1e-12, "{cells}: {found:?} is not {exact:?}");
            assert!(exact.1.is_none_or(|x| (x - found.1.unwrap()).abs() < 1e-12), "{cells}: {found:?}");
        }
        // w right of the force, with the shear of 1/40.
        let sag = |x: f64| {
            let y = 1.0 - x;
            FORCE * a * (y * (1.0 - y * y - a * a) / 6.0 + y / 40.0)
        };
        let most = (0..=100_000).map(|k| sag(a + b * f64::from(k) * 1e-5)).fold(0.0, f64::max);
        assert!((found[5].0 - most).abs() < 1e-9, "{cells}: {:?} is not {most}", found[5]);
    }
}

#[test]
fn tapered_beams_are_exact_between_points() {
    // A cantilever with EI = 1 + 2 x, S = 40 (1 + x) and EA = 7 under q and a pull of 2 at its end: M(x) = q (1 − x)²/2.
    let stiffness = json!({ "bending": { "table": [[0.0, 1.0], [1.0, 3.0]] }, "shear": { "table": [[0.0, 40.0], [1.0, 80.0]] }, "axial": { "uniform": 7.0 } });
    let case = json!({
        "model": { "timoshenko_beam": { "stiffness": stiffness } },
        "loads": [{ "distributed": { "force": { "uniform": FORCE } } }, { "point": { "at": { "x": 1.0 }, "axial": 2.0 } }]
    });
    let places = [0.1, 0.47, 0.83];
    for cells in [1, 3, 8] {
        let (_, found) = solve(cells, &case, &["w", "phi", "u", "M"], &places);
        for (x, found) in places.into_iter().zip(found) {
            // The midpoint rule with 1e5 steps: 1.9e-11 is found.
            let step = x * 1e-5;
            let (mut w, mut phi) = (0.0, 0.0);
            for k in 0..100_000 {
                let s = (f64::from(k) + 0.5) * step;
                let curvature = 0.5 * FORCE * (1.0 - s) * (1.0 - s) / (1.0 + 2.0 * s);
                phi += step * curvature;
                w += step * ((x - s) * curvature + FORCE * (1.0 - s) / (40.0 * (1.0 + s)));
            }
            let exact = [w, phi, 2.0 * x / 7.0, 0.5 * FORCE * (1.0 - x) * (1.0 - x)];
            for (found, exact) in found.iter().zip(exact) {
                assert!((found - exact).abs() < 1e-10, "{cells} cells, at {x}: {found} is not {exact}");
            }
        }
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
