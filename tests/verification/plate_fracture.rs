//! Plates in bending that break.

use crate::support::bending::{hard, model, refusal, solved, square};
use peristat::Solved;
use serde_json::{Value, json};
use std::f64::consts::PI;

fn fact(found: &Solved, name: &str) -> f64 {
    let facts = found.states.last().and_then(|state| state.record().facts.as_ref());
    facts.and_then(|facts| facts.value(name)).expect("a fact")
}

/// A strip between guides, clamped on the left, with D = 1.
fn strip(nu: f64, t: f64, right: Value) -> Value {
    let mut model = model(t);
    model["plate_bending"]["poisson_ratio"] = json!(nu);
    let e = 12.0 * (1.0 - nu * nu) / t.powi(3);
    model["plate_bending"]["youngs_modulus"] = json!(e);
    let mut held = json!({ "at": { "region": "right" } });
    held.as_object_mut().expect("a support").extend(right.as_object().cloned().expect("keys"));
    json!({ "title": "strip", "units": "none", "model": model,
        "body": { "rectangle": { "size": [1, 0.5], "spacing": 0.125 } },
        "regions": { "strip": { "box": { "from": [0, 0], "to": [1, 0.5] } } },
        "supports": [ { "at": { "region": "left" }, "w": 0, "phi_n": 0, "phi_t": 0 },
            { "at": { "region": "strip" }, "phi_y": 0 }, held ],
        "probes": [ { "name": "moment", "at": { "region": "right" }, "field": "reaction_moment_x" } ] })
}

#[test]
fn a_strip_that_is_bent_evenly_breaks_at_its_curvature() {
    for (nu, t) in [-0.3, 0.0, 0.3, 1.0 / 3.0, 0.45].into_iter().flat_map(|nu| [0.2, 1e-3].map(|t| (nu, t))) {
        let mut case = strip(nu, t, json!({ "phi_n": 1 }));
        case["fracture"] = json!({ "critical": { "curvature": 0.4, "shear_strain": 0.1 }, "load": "moment" });
        let found = solved(&case);
        // The turn of the end is κ L, the moment D κ_c over the width; a bond breaks 1e-7 beyond.
        let errors = [fact(&found, "first_break_load_factor") / 0.4, fact(&found, "first_break_load") / 0.2];
        assert!(errors.iter().all(|ratio| (ratio - 1.0).abs() < 2e-7), "{nu}, {t}: {errors:?}");
    }
}

#[test]
fn a_strip_that_is_sheared_breaks_at_its_shear_strain() {
    for t in [0.2, 0.02] {
        // Nothing turns: V = S w/L over the width, S = 3.5/t².
        let mut case = strip(0.3, t, json!({ "phi_n": 0, "w": 1 }));
        case["supports"][1]["phi_x"] = json!(0);
        case["probes"] =
            json!([ { "name": "force", "at": { "region": "right" }, "field": "reaction_force" } ]);
        case["fracture"] = json!({ "critical": { "shear_strain": 0.02 }, "load": "force" });
        let found = solved(&case);
        // Bonds across, and the diagonals with a half: γ_b n, so that those along break first, with what the law as corrected
        // has of bending: s/(2 S ω) of γ_b.
        let x = 3.5 / (t * t) * 0.125 * 0.125 / 16.0;
        let expected = 0.02 * (1.0 + x);
        let error = fact(&found, "first_break_load_factor") / expected - 1.0;
        assert!(error.abs() < 2e-7, "{t}: {error:.1e}");
    }
}

/// A ribbon whose edges are turned by a multiple of the turn at which a long crack grows.
fn ribbon(cells: i32, t: f64, critical: Value) -> Value {
    let (h, width, energy) = (0.4 / f64::from(cells), 0.4, 1.0);
    let (low, high) = (0.5 * (width - h), 0.5 * (width + h));
    let slot = (0.5 / h).round() * h;
    // G_c t = ½ D κ² B far ahead of the crack, D = 1.
    let turn = (2.0_f64 * energy * t / width).sqrt() * 0.5 * width;
    json!({ "title": "ribbon", "units": "none", "model": model(t),
        "body": { "outline": { "spacing": h, "vertices": [[0, 0], [1.2, 0], [1.2, width], [0, width], [0, high],
            [slot, high], [slot, low], [0, low]], "edges": { "bottom": "edge_1", "top": "edge_3" } } },
        "regions": { "above": { "box": { "from": [-1, high + 0.9 * h], "to": [2, 1] } },
            "below": { "box": { "from": [-1, -1], "to": [2, low - 0.9 * h] } } },
        "supports": [ { "at": { "region": "top" }, "w": 0, "phi_y": 4.0 * turn },
            { "at": { "region": "bottom" }, "w": 0, "phi_y": -4.0 * turn } ],
        "probes": [ { "name": "lips", "at": { "x": 0, "y": high }, "field": "w" } ],
        "fracture": { "critical": critical, "load": "lips", "strategy": "worst", "no_fail": ["above", "below"],
            "max_solves": 40 } })
}

#[test]
fn a_long_crack_that_opens_by_bending_grows_at_griffiths_load() {
    let h = 0.4 / 21.0;
    // Of slender cells and of cells that are shorter than the plate is thick.
    for (ratio, energy) in [(0.25, 1.33), (1.0, 1.36), (3.0, 1.56)] {
        let load =
            |critical: Value| 4.0 * fact(&solved(&ribbon(21, ratio * h, critical)), "peak_load_factor");
        let growth = load(json!({ "energy_release_rate": 1 }));
        let held = load(json!({ "energy_release_rate": 1, "formula": "energy" }));
        assert!(
            (growth - 1.0).abs() < 0.03 && (held / energy - 1.0).abs() < 0.03,
            "{ratio}: {growth}, {held}"
        );
    }
}

#[test]
fn what_breaks_is_symmetric() {
    let mut case = square(16, 0.02, hard());
    case["loads"] = json!([ { "pressure": { "value": 100 } } ]);
    case["probes"] = json!([ { "name": "walls", "at": { "region": "all" }, "field": "reaction_force" },
        { "name": "middle", "at": { "x": 0.5, "y": 0.5 }, "field": "damage" } ]);
    case["fracture"] = json!({ "critical": { "curvature": 1.0 }, "load": "walls" });
    let found = solved(&case);
    let last = found.states.len() - 1;
    let damage = found.field(last, "damage").expect("a field").to_vec();
    assert_eq!(damage.len(), 17 * 17);
    let at = |i: usize, j: usize| damage[17 * j + i];
    for (i, j) in (0..17).flat_map(|i| (0..17).map(move |j| (i, j))) {
        assert_eq!([at(i, j); 3], [at(16 - i, j), at(i, 16 - j), at(j, i)], "({i}, {j})");
    }
    assert!(at(1, 1) > 0.5, "{}", at(1, 1));
    let report = found.summary.fracture.as_ref().expect("a report");
    assert!(report.broken_bonds > 100, "{report:?}");
    // The twist in the corners of Navier's series, 16/π⁴ Σ 1/(m² + n²)² q a²/D over odd m and n, is larger than what bends the middle.
    let odd = || (1..400).step_by(2).map(f64::from);
    let twist =
        16.0 / PI.powi(4) * odd().flat_map(|m| odd().map(move |n| (m * m + n * n).powi(-2))).sum::<f64>();
    let first = fact(&found, "first_break_load_factor") * 100.0 * twist;
    assert!((first - 1.0).abs() < 0.02, "{first}");
}

/// κ_c of G_c = 1 in strips of cells of 1/8, whose base of the thickness 0.1 has D = 1: `G_c t/(h D (2 · 0.65 · 0.75 + 0.05/4))` over the
/// trapping of cells that are longer than the plate is thick.
fn strip_critical(t: f64) -> f64 {
    let stiffness = (t / 0.1_f64).powi(3);
    (t / (0.125 * stiffness * (2.0 * 0.65 * 0.75 + 0.0125))).sqrt() / 1.33
}

#[test]
fn thinner_regions_break_first_by_energy() {
    let mut case = strip(0.3, 0.1, json!({ "phi_n": 1 }));
    case["regions"]["outer"] = json!({ "box": { "from": [0.5, 0], "to": [1, 0.5] } });
    case["materials"] = json!({ "thin": { "at": "outer", "thickness": 0.05 } });
    case["fracture"] = json!({ "critical": { "energy_release_rate": 1.0 }, "load": "moment" });
    let found = solved(&case);
    // G_c t of the thin half holds κ_c² D: a half over an eighth, so that κ_c is twice that of the thick half, over its trapping. There the
    // strip is bent eight times as much: κ (1/2 + 8/2) L is the turn of the end, 1.
    let expected = strip_critical(0.05) * (0.5 + 0.5 / 8.0);
    let error = fact(&found, "first_break_load_factor") / expected - 1.0;
    assert!(error.abs() < 2e-7, "{error:.1e}");
    let damage = found.field(found.states.len() - 1, "damage").expect("a field").to_vec();
    // Five rows of nine points: half of the strip is as it was.
    let worst = |range: std::ops::Range<usize>| {
        (0..5).flat_map(|j| range.clone().map(move |i| 9 * j + i)).map(|p| damage[p]).fold(0.0, f64::max)
    };
    assert!(worst(0..4) == 0.0 && worst(5..9) > 0.2, "{damage:?}");
}

#[test]
fn pieces_that_hang_in_hinges_carry_nothing() {
    // The last breaks leave pieces that turn about the walls without strain: their factor is that of a mechanism.
    for (n, edges) in [(20, 4), (9, 3)] {
        let walls = ["left", "bottom", "right", "top"].into_iter().take(edges);
        let walls: Vec<Value> =
            walls.map(|edge| json!({ "at": { "region": edge }, "w": 0, "phi_t": 0 })).collect();
        let mut case = square(n, 0.05, json!(walls));
        case["probes"] =
            json!([ { "name": "wall", "at": { "region": "bottom" }, "field": "reaction_force" } ]);
        case["loads"] = json!([ { "pressure": { "value": 100 } } ]);
        case["fracture"] = json!({ "critical": { "curvature": 0.5 }, "load": "wall" });
        let found = solved(&case);
        let [first, peak] = ["first_break_load", "peak_load"].map(|name| fact(&found, name).abs());
        // One, and 1.6 with three walls: rounding had made it 1e4 times as large.
        assert!(peak < 1.7 * first && first < 100.0, "{first}, {peak}");
    }
}

#[test]
fn what_does_not_break_a_plate_is_refused() {
    let with = |change: &dyn Fn(&mut Value)| {
        let mut case = square(8, 0.1, hard());
        case["thermal_expansion"] = json!(1e-5);
        case["probes"] = json!([ { "name": "walls", "at": { "region": "all" }, "field": "reaction_force" },
            { "name": "moment", "at": { "x": 0.5, "y": 0.5 }, "field": "M_xx" } ]);
        case["fracture"] = json!({ "critical": { "curvature": 1.0 }, "load": "walls", "max_solves": 2 });
        change(&mut case);
        refusal(&case)
    };
    type Change = fn(&mut Value);
    let faults: [(Change, &str); 11] = [
        (|case| case["horizon_ratio"] = json!(3), "the eight next points alone"),
        (|case| case["loads"] = json!([ { "temperature": { "difference": 5 } } ]), "have no heat"),
        (|case| case["symmetry"] = json!(["left"]), "do not go together"),
        (
            |case| case["fracture"]["directions"] = json!([ { "name": "a", "from": [0, 0], "to": [1, 1] } ]),
            "`directions` is for",
        ),
        (|case| case["fracture"]["load"] = json!("moment"), "does not stand for the load"),
        (|case| case["fracture"]["load"] = json!("wall"), "there is no probe `wall`"),
        (|case| case["fracture"]["critical"] = json!({ "stretch": 1 }), "`stretch`"),
        (
            |case| case["fracture"]["critical"] = json!({ "curvature": 1, "energy_release_rate": 1 }),
            "are both given",
        ),
        (
            |case| case["fracture"]["critical"] = json!({ "curvature": 1, "formula": "energy" }),
            "`formula` says what follows",
        ),
        (
            |case| case["fracture"]["critical"] = json!({ "energy_release_rate": 1, "formula": "published" }),
            "no `published` formula",
        ),
        (|case| case["solver"] = json!("multigrid"), "keeps a sparse factor"),
    ];
    for (change, words) in faults {
        let found = with(&change);
        assert!(found.contains(words), "{words}: {found}");
    }
    assert_eq!(with(&|_| {}), "");
}
