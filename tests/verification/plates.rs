//! Plates in bending, from cases: closed forms, series, balance, and what is refused or doubted.

use crate::support::bending::{clamped, hard, model, probe, refusal, solved, square};
use serde_json::{Value, json};

#[test]
fn strips_are_exact_at_their_points_at_every_thickness_and_length() {
    for t in [0.2, 0.01, 1e-3, 1e-4] {
        for cells in [8, 64, 512, 2048] {
            let h = 1.0 / f64::from(cells);
            let case = json!({
                "title": "strip", "units": "none", "model": model(t),
                "body": { "rectangle": { "size": [1, 3.0 * h], "spacing": h } },
                "regions": { "strip": { "box": { "from": [0, 0], "to": [1, 3.0 * h] } } },
                "supports": [ { "at": { "region": "left" }, "w": 0, "phi_x": 0 },
                    { "at": { "region": "strip" }, "phi_y": 0 } ],
                "load_cases": [ { "name": "tip", "loads": [ { "line": { "edge": "right", "force": 1 } } ] },
                    { "name": "pressure", "loads": [ { "pressure": { "value": 1 } } ] } ],
                "probes": [ { "name": "tip", "at": { "x": 1, "y": 0 }, "field": "w" } ]
            });
            let found = solved(&case);
            let s = 3.5 / (t * t);
            let exact = [1.0 / 3.0 + 1.0 / s, 0.125 + 0.5 / s];
            for (probe, exact) in found.summary.probes.iter().zip(exact) {
                // 2e-15 is found in the prototype, 3e-15 here.
                let error = (probe.value / exact - 1.0).abs();
                assert!(error < 1e-13, "t = {t}, {cells} cells, {}: {error:.1e}", probe.state);
            }
        }
    }
}

#[test]
fn squares_are_right_at_every_thickness() {
    // Navier's series with shear, and Legendre-Ritz of degree 26 to 30.
    let rows = [
        (0.2, 0.00490431096, Some(0.0021721606)),
        (0.1, 0.00427284224, Some(0.0015046257)),
        (0.01, 0.00406445756, Some(0.00126786)),
        (1e-4, 0.00406235287, Some(0.00126531909)),
        // Kirchhoff's plate, to which the terms of shear add 1e-9.
        (1e-5, 0.00406235266, None),
    ];
    for (t, simple, clamp) in rows {
        let of = |supports: Value| solved(&square(64, t, supports));
        let found = of(hard());
        // 1.6e-4 at t = 0.2.
        assert!(
            (probe(&found, "middle") / simple - 1.0).abs() < 2e-4,
            "t = {t}: {}",
            probe(&found, "middle")
        );
        // Navier's moment, for a pressure along w.
        assert!((probe(&found, "moment") / -0.04788637958 - 1.0).abs() < 2e-3, "t = {t}");
        if let Some(clamp) = clamp {
            // 2.0e-4 at t = 0.1 and 0.01.
            let error = probe(&of(clamped()), "middle") / clamp - 1.0;
            assert!(error.abs() < 2.1e-4, "t = {t}: {error:.2e}");
        }
    }
}

#[test]
fn loads_are_held_and_their_work_is_stored() {
    for t in [0.2, 1e-2, 1e-4] {
        let found = solved(&square(32, t, clamped()));
        let certificate = &found.summary.states[0].certificate;
        assert!(certificate.converged, "t = {t}");
        // 1e-15 is found.
        assert!(certificate.balance.iter().all(|b| b.relative < 1e-14), "t = {t}: {:?}", certificate.balance);
        assert!(certificate.energy_balance < 1e-14, "t = {t}: {:.1e}", certificate.energy_balance);
        let resultants = certificate.resultants.as_ref().expect("resultants");
        assert!(resultants.difference < 1e-13, "{}", resultants.difference);
    }
}

#[test]
fn reactions_of_edges_sum_to_the_load() {
    let mut case = square(16, 0.1, hard());
    let edges = ["left", "right", "bottom", "top"];
    let reaction = |edge: &str| json!({ "name": edge, "at": { "region": edge }, "field": "reaction_force" });
    case["probes"] = edges.iter().map(|edge| reaction(edge)).collect();
    let together = solved(&case);
    let each = edges.map(|edge| probe(&together, edge));
    assert!(each.iter().all(|force| (force + 0.25).abs() < 1e-13), "{each:?}");
    // Supports of their own share corners as they are listed.
    let support = |edge: &str| json!({ "at": { "region": edge }, "w": 0, "phi_t": 0 });
    case["supports"] = edges.iter().map(|edge| support(edge)).collect();
    let apart = solved(&case);
    let sum: f64 = edges.iter().map(|edge| probe(&apart, edge)).sum();
    assert!((sum + 1.0).abs() < 1e-13, "{sum}");
}

#[test]
fn lines_of_symmetry_are_those_of_the_whole_plate() {
    let whole = solved(&square(32, 0.05, clamped()));
    let mut quarter = square(
        32,
        0.05,
        json!([
        { "at": { "region": ["left", "bottom"] }, "w": 0, "phi_n": 0, "phi_t": 0 } ]),
    );
    quarter["body"]["rectangle"]["size"] = json!([0.5, 0.5]);
    quarter["symmetry"] = json!(["right", "top"]);
    let part = solved(&quarter);
    let error = probe(&part, "middle") / probe(&whole, "middle") - 1.0;
    assert!(error.abs() < 1e-12, "{error:.1e}");
}

#[test]
fn moments_under_a_force_on_a_line_of_symmetry_are_those_of_the_whole_plate() {
    let fields = ["M_xx", "M_yy", "M_xy", "V_x", "V_y", "curvature_xx", "curvature_yy"];
    let loaded = |mut case: Value, force: f64| {
        case["loads"] = json!([{ "point": { "at": { "x": 0.5, "y": 0.25 }, "force": force } }]);
        // On the line, beside it, and where it ends.
        let places = [[0.5, 0.25], [0.5, 0.5], [0.4375, 0.25], [0.5, 0.0], [0.5, 1.0], [0.25, 0.0]];
        let probes = places.iter().flat_map(|[x, y]| {
            fields.map(|f| json!({ "name": format!("{f} {x} {y}"), "at": { "x": x, "y": y }, "field": f }))
        });
        case["probes"] = probes.collect();
        solved(&case)
    };
    let whole = loaded(square(16, 0.05, hard()), 2.0);
    let mut half =
        square(16, 0.05, json!([{ "at": { "region": ["left", "bottom", "top"] }, "w": 0, "phi_t": 0 }]));
    half["body"]["rectangle"]["size"] = json!([0.5, 1]);
    half["symmetry"] = json!(["right"]);
    // A force on the line is shared by both halves.
    let half = loaded(half, 1.0);
    for (a, b) in whole.summary.probes.iter().zip(&half.summary.probes) {
        assert!((a.value - b.value).abs() < 1e-9, "{}: {} {}", a.name, a.value, b.value);
    }
}

#[test]
fn a_quarter_around_a_clamped_hole_is_the_whole_plate() {
    let clamp = || json!([ { "at": { "region": "hole" }, "w": 0, "phi_n": 0, "phi_t": 0 } ]);
    let pierced = |from: f64, size: f64| {
        let mut case = square(1, 1e-2, clamp());
        let hole = json!({ "circle": { "name": "hole", "centre": [0, 0], "radius": 0.4 } });
        case["body"] = json!({ "rectangle": { "from": [from, from], "size": [size, size], "spacing": 0.05, "holes": [hole] } });
        case["probes"] = json!([
            { "name": "corner", "at": { "x": 1, "y": 1 }, "field": "w" },
            { "name": "force", "at": { "region": "hole" }, "field": "reaction_force" }
        ]);
        case
    };
    let whole = solved(&pierced(-1.0, 2.0));
    let mut case = pierced(0.0, 1.0);
    case["symmetry"] = json!(["left", "bottom"]);
    let quarter = solved(&case);
    let apart = probe(&quarter, "corner") / probe(&whole, "corner") - 1.0;
    assert!(apart.abs() < 1e-9, "{apart:.1e}");
    // A support alone bears all of the load, whatever points of the plate its equations reach.
    for (name, found, parts) in [("whole", &whole, 1.0), ("quarter", &quarter, 4.0)] {
        let load = probe(&whole, "force") / parts;
        let apart = probe(found, "force") / load - 1.0;
        assert!(apart.abs() < 1e-9, "{name}: {apart:.1e}");
    }
    // A unit of pressure on the 1392 cells of 1600 whose middles are not in the hole.
    let apart = probe(&whole, "force").abs() / (1392.0 * 0.0025) - 1.0;
    assert!(apart.abs() < 1e-9, "{apart:.1e}");
}

#[test]
fn a_round_plate_is_held_on_its_true_edge() {
    let round = |supports: Value| {
        let mut case = square(1, 1e-3, supports);
        case["body"] = json!({ "outline": { "spacing": 0.025,
            "vertices": [ { "arc_to": [1, 0], "through": [0, -1] }, { "arc_to": [-1, 0], "through": [0, 1] } ] } });
        case["probes"][0]["at"] = json!({ "x": 0, "y": 0 });
        case["probes"][1]["at"] = json!({ "x": 0, "y": 0 });
        solved(&case)
    };
    // Kirchhoff's plate; steps that were held would make it 73 % too stiff.
    let simple = round(json!([ { "at": { "region": "all" }, "w": 0 } ]));
    let error = probe(&simple, "middle") / (5.3 / 1.3 / 64.0) - 1.0;
    assert!(error.abs() < 5e-3, "{error:.1e}");
    let clamped = round(clamped());
    let error = probe(&clamped, "middle") * 64.0 - 1.0;
    // -8e-4; with the points of the steps held, 2.8e-2.
    assert!(error.abs() < 2e-3, "{error:.1e}");
    // An edge that moves takes all of the plate with it.
    let moved = round(json!([ { "at": { "region": "all" }, "w": 0.5, "phi_n": 0, "phi_t": 0 } ]));
    let error = probe(&moved, "middle") - probe(&clamped, "middle") - 0.5;
    assert!(error.abs() < 1e-10, "{error:.1e}");
}

#[test]
fn a_pressure_on_two_parts_is_that_on_the_whole() {
    let whole = solved(&square(16, 0.05, clamped()));
    let mut parts = square(16, 0.05, clamped());
    parts["regions"] = json!({ "left half": { "box": { "from": [0, 0], "to": [0.5, 1] } },
        "right half": { "box": { "from": [0.5, 0], "to": [1, 1] } } });
    parts["loads"] = json!([ { "pressure": { "value": 1, "region": "left half" } },
        { "pressure": { "formula": "1 + 0*x", "region": "right half" } } ]);
    let error = probe(&solved(&parts), "middle") / probe(&whole, "middle") - 1.0;
    assert!(error.abs() < 1e-12, "{error:.1e}");
}

#[test]
fn what_cannot_be_is_refused_and_what_is_doubtful_is_told() {
    let mut rows = square(8, 0.1, hard());
    rows["horizon_ratio"] = json!(1);
    assert!(refusal(&rows).contains("the diagonal ones are missing"), "{}", refusal(&rows));
    let tells = |case: &Value, text: &str| {
        let warnings = solved(case).summary.warnings;
        assert!(warnings.iter().any(|warning| warning.contains(text)), "{text}: {warnings:?}");
    };
    let mut published = square(8, 0.1, clamped());
    published["model"]["plate_bending"]["shear_law"] = json!("published");
    tells(&published, "as published it locks");
    let mut point = square(8, 0.1, clamped());
    point["horizon_ratio"] = json!(3);
    point["loads"] = json!([ { "point": { "at": { "x": 0.5, "y": 0.5 }, "force": 1 } } ]);
    tells(&point, "bonds pass over the point that is loaded");
    tells(
        &square(8, 1e-3, json!([ { "at": { "region": "all" }, "w": 0 } ])),
        "which this spacing does not resolve",
    );
    assert!(solved(&square(8, 0.1, hard())).summary.warnings.is_empty());
}

#[test]
fn cycles_on_coarser_plates_are_few_at_every_thickness_and_agree_with_a_factor() {
    let cantilever = json!([ { "at": { "region": "left" }, "w": 0, "phi_n": 0, "phi_t": 0 } ]);
    // Powers of two, a plate whose coarser ones reach beyond its edges, and one whose first coarser one has an odd number of cells, and a
    // factor.
    for (cells, most) in [(64, 16), (128, 16), (125, 24), (250, 18)] {
        for t in [0.2, 0.01, 1e-4] {
            for supports in [clamped(), hard(), cantilever.clone()] {
                let mut case = square(cells, t, supports);
                // 125 cells have no point in the middle.
                case["probes"] = json!([]);
                case["solver"] = json!("sparse");
                let factored = solved(&case);
                case["solver"] = json!("multigrid");
                let cycled = solved(&case);
                let solver = &cycled.summary.solver;
                assert_eq!(solver.method, "multigrid");
                let cycles: usize = solver.iterations.iter().sum();
                assert!(cycles <= most, "{cells} cells, t = {t}: {cycles} cycles");
                let [a, b] = [&cycled, &factored].map(|found| found.field(0, "w").expect("a field"));
                let largest = b.iter().fold(0.0, |most: f64, w| most.max(w.abs()));
                let off = a.iter().zip(&b[..]).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
                assert!(off < 1e-8 * largest, "{cells} cells, t = {t}: {:.1e}", off / largest);
            }
        }
    }
}
