//! Holes of bodies whose displacements are corrected: the worst stress along them against closed forms, not the peak alone.

use peristat::Solved;
use serde_json::{Value, json};
use std::f64::consts::TAU;

const MODULUS: f64 = 70_000.0;

fn solve(case: &Value) -> Solved {
    let solved = peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|error| panic!("{error}: {case}"));
    assert!(solved.summary.states.iter().all(|state| state.certificate.converged));
    solved
}

/// Stresses at places in the order σ_xx, σ_yy, σ_xy.
fn stresses(mut case: Value, places: &[[f64; 2]]) -> Vec<[f64; 3]> {
    const FIELDS: [&str; 3] = ["stress_xx", "stress_yy", "stress_xy"];
    let probe = |(k, [x, y]): (usize, &[f64; 2])| {
        FIELDS.map(|field| json!({ "name": format!("{field}{k}"), "at": { "x": x, "y": y }, "field": field }))
    };
    case["probes"] = json!(places.iter().enumerate().flat_map(probe).collect::<Vec<Value>>());
    let solved = solve(&case);
    let values: Vec<f64> = solved.summary.probes.iter().map(|probe| probe.value).collect();
    values.chunks_exact(3).map(|own| [own[0], own[1], own[2]]).collect()
}

/// Places on a circle, with their angles, between two angles.
fn around(centre: [f64; 2], radius: f64, [from, to]: [f64; 2], count: u32) -> Vec<(f64, [f64; 2])> {
    let angle = |k: u32| from + (to - from) * f64::from(k) / f64::from(count);
    (0..=count)
        .map(angle)
        .map(|a| (a, [centre[0] + radius * a.cos(), centre[1] + radius * a.sin()]))
        .collect()
}

fn along_the_border([xx, yy, xy]: [f64; 3], angle: f64) -> f64 {
    let (s, c) = angle.sin_cos();
    xx * s * s + yy * c * c - 2.0 * xy * s * c
}

/// Kirsch's plate: a quarter of 60 around a hole of radius 20 under the tractions of its field at a pull of 100.
#[test]
fn the_stress_along_a_hole_is_that_of_kirsch() {
    let (r2, q) = ("(x^2+y^2)", "(400/(x^2+y^2))");
    let (c2, s2) = (format!("((x^2-y^2)/{r2})"), format!("(2*x*y/{r2})"));
    let (c4, s4) = (format!("(2*{c2}^2-1)"), format!("(2*{s2}*{c2})"));
    let xx = format!("100*(1-{q}*(1.5*{c2}+{c4})+1.5*{q}^2*{c4})");
    let yy = format!("100*(-{q}*(0.5*{c2}-{c4})-1.5*{q}^2*{c4})");
    let xy = format!("100*(-{q}*(0.5*{s2}+{s4})+1.5*{q}^2*{s4})");
    let on_hole = around([0.0; 2], 20.0, [0.0, 0.25 * TAU], 18);
    let places: Vec<[f64; 2]> = on_hole.iter().map(|place| place.1).collect();
    // Found: 4.0e-5, 1.6e-5 and 3.2e-6 of the peak at 5, 10 and 20 points per radius.
    for (spacing, most) in [(4.0, 8e-5), (2.0, 3e-5), (1.0, 7e-6)] {
        let case = json!({
            "title": "Kirsch", "units": "mm-N-MPa", "limit": "local", "corrections": 2,
            "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [60, 60], "spacing": spacing,
                "holes": [{ "circle": { "name": "hole", "centre": [0, 0], "radius": 20 } }] } },
            "symmetry": ["left", "bottom"],
            "loads": [
                { "traction": { "edge": "right", "formula": [xx, xy] } },
                { "traction": { "edge": "top", "formula": [xy, yy] } }]
        });
        let off = |(stress, (angle, _)): (&[f64; 3], &(f64, [f64; 2]))| {
            (along_the_border(*stress, *angle) - 100.0 * (1.0 - 2.0 * (2.0 * angle).cos())).abs() / 300.0
        };
        let worst = stresses(case, &places).iter().zip(&on_hole).map(off).fold(0.0_f64, f64::max);
        assert!(worst < most, "{spacing}: {worst:e}");
    }
}

/// A traction of 10 along x on a hole of radius 10, and on a square of 80 around it the tractions of `φ = A ln z`,
/// `ψ = −κ A ln z − A a²/z²` with `A = −10 a/(1 + κ)`, κ = 2: along the hole the stress is −10/3 cos θ.
#[test]
fn a_hole_may_carry_a_resultant() {
    // A cos θ/r and the like from the middle of the square.
    let (x, y, r2) = ("(x-40)", "(y-40)", "((x-40)^2+(y-40)^2)");
    let (c3, s3) = (format!("({x}^3-3*{x}*{y}^2)"), format!("(3*{x}^2*{y}-{y}^3)"));
    let third = format!("(400*(100/{r2}-0.5)/{r2}^2/3)");
    // S = 4 A cos θ/r and D = −2A/r (e^(−3iθ) + 2 e^(−iθ)) + 4A a² e^(−3iθ)/r³.
    let sum = format!("(-400/3*{x}/{r2})");
    let real = format!("(-{third}*{c3}+400/3*{x}/{r2})");
    let imaginary = format!("({third}*{s3}-400/3*{y}/{r2})");
    let (xx, yy, xy) = (format!("({sum}-{real})/2"), format!("({sum}+{real})/2"), format!("{imaginary}/2"));
    let minus = |text: &str| format!("-({text})");
    let on_hole = around([40.0; 2], 10.0, [0.0, TAU], 24);
    let places: Vec<[f64; 2]> = on_hole.iter().map(|place| place.1).collect();
    // Found at 5 and 10 points per radius; polynomials alone are 4e-2 and 2e-3 off.
    for (spacing, most) in [(2.0, 1e-3), (1.0, 2e-4)] {
        let [near, far] = [20.0, 60.0].map(|x| x + 0.5 * spacing);
        let case = json!({
            "title": "pulled hole", "units": "mm-N-MPa", "limit": "local", "corrections": 2,
            "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [80, 80], "spacing": spacing,
                "holes": [{ "circle": { "name": "hole", "centre": [40, 40], "radius": 10 } }] } },
            "supports": [{ "at": { "x": near, "y": near }, "ux": 0, "uy": 0 }, { "at": { "x": far, "y": near }, "uy": 0 }],
            "loads": [
                { "traction": { "edge": "hole", "uniform": [10, 0] } },
                { "traction": { "edge": "right", "formula": [xx, xy] } },
                { "traction": { "edge": "left", "formula": [minus(&xx), minus(&xy)] } },
                { "traction": { "edge": "top", "formula": [xy, yy] } },
                { "traction": { "edge": "bottom", "formula": [minus(&xy), minus(&yy)] } }]
        });
        let off = |(stress, (angle, _)): (&[f64; 3], &(f64, [f64; 2]))| {
            (along_the_border(*stress, *angle) + 10.0 / 3.0 * angle.cos()).abs() / 10.0
        };
        let worst = stresses(case, &places).iter().zip(&on_hole).map(off).fold(0.0_f64, f64::max);
        assert!(worst < most, "{spacing}: {worst:e}");
    }
}

/// A quarter of a plate of 160 × 160 with a hole of radius 20 and fibres along the pull, E₁/E₂ = 14; curved biquadratic elements
/// find 12.652, and Lekhnitskii's wide plate has 8.40.
#[test]
fn the_peak_across_fibres_is_that_of_finite_elements() {
    for (spacing, corrections, most) in [(2.0, 1, 1.5e-2), (2.0, 2, 1.5e-2)] {
        let case = json!({
            "title": "fibres", "units": "mm-N-MPa", "limit": "local", "corrections": corrections,
            "model": { "beam_bond_orthotropic": {
                "youngs_modulus_1": 140_000, "youngs_modulus_2": 10_000, "poisson_ratio_12": 0.25, "shear_modulus_12": 2930, "fibre_angle": 0 } },
            "body": { "rectangle": { "size": [80, 80], "spacing": spacing,
                "holes": [{ "circle": { "name": "hole", "centre": [0, 0], "radius": 20 } }] } },
            "symmetry": ["left", "bottom"],
            "loads": [{ "traction": { "edge": "right", "uniform": [100, 0] } }]
        });
        let [xx, ..] = stresses(case, &[[0.0, 20.0]])[0];
        let found = xx / 1265.2 - 1.0;
        assert!(found.abs() < most, "{spacing} {corrections}: {found}");
    }
}

/// A quarter of a strip with a hole of radius 20, so many points high.
fn beside_an_edge(model: Value, height: u32, spacing: f64, limit: Option<&str>) -> Value {
    let mut case = json!({
        "title": "Hole beside an edge", "units": "mm-N-MPa", "model": model,
        "body": { "rectangle": { "size": [200, height], "spacing": spacing,
            "holes": [{ "circle": { "name": "hole", "centre": [0, 0], "radius": 20 } }] } },
        "symmetry": ["left", "bottom"],
        "loads": [{ "traction": { "edge": "right", "uniform": [100, 0] } }],
        "probes": [{ "name": "top", "at": { "x": 0, "y": 20, "inward": [0, 1] }, "field": "stress_xx" }]
    });
    limit.into_iter().for_each(|limit| case["limit"] = json!(limit));
    case
}

fn metal() -> Value {
    json!({ "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } })
}

fn laminate() -> Value {
    json!({ "beam_bond_orthotropic": { "youngs_modulus_1": 140e3, "youngs_modulus_2": 10e3, "poisson_ratio_12": 0.25,
        "shear_modulus_12": 2930, "fibre_angle": 0 } })
}

/// References: biquadratic elements of scikit-fem that follow the hole, 96 along it and 96 away from it, extrapolated.
#[test]
fn the_stress_at_a_hole_beside_an_edge_has_an_error_that_falls_with_the_spacing() {
    // Found: -3.7e-2, -8.1e-3, -1.8e-3; then -6.1e-3, 1.7e-5, -2.8e-6; fields of six powers stay at -8e-3 and -7e-3.
    let cases = [
        (None, 4.0, 4.5e-2),
        (None, 2.0, 1e-2),
        (None, 1.0, 2.2e-3),
        (Some("local"), 4.0, 7e-3),
        (Some("local"), 2.0, 3e-5),
        (Some("local"), 1.0, 1e-5),
    ];
    for (limit, spacing, most) in cases {
        let solved = solve(&beside_an_edge(metal(), 40, spacing, limit));
        let off = solved.summary.probes[0].value / 434.761 - 1.0;
        assert!(off.abs() < most, "{limit:?} {spacing}: {off:e}");
    }
}

/// A quarter, two halves and the whole of a plate have the same stress at the hole, with images or without.
#[test]
fn parts_beside_lines_of_symmetry_are_the_whole() {
    let pulled = |symmetry: &[&str], limit: Option<&str>| {
        let [low, left] = ["bottom", "left"].map(|line| symmetry.contains(&line));
        let (x, y) = (if left { 0.0 } else { -60.0 }, if low { 0.0 } else { -40.0 });
        let mut loads = vec![json!({ "traction": { "edge": "right", "uniform": [100, 0] } })];
        loads.extend((!left).then(|| json!({ "traction": { "edge": "left", "uniform": [-100, 0] } })));
        let corner = |x: f64| json!({ "x": x, "y": y + 1.0 });
        let supports = match (left, low) {
            (true, true) => json!([]),
            (true, false) => json!([{ "at": corner(1.0), "uy": 0 }]),
            (false, true) => json!([{ "at": corner(-59.0), "ux": 0 }]),
            (false, false) => {
                json!([{ "at": corner(-59.0), "ux": 0, "uy": 0 }, { "at": corner(59.0), "uy": 0 }])
            }
        };
        let mut case = json!({
            "title": "Parts", "units": "mm-N-MPa", "model": metal(),
            "body": { "rectangle": { "from": [x, y], "size": [60.0 - x, 40.0 - y], "spacing": 2,
                "holes": [{ "circle": { "name": "hole", "centre": [0, 0], "radius": 20 } }] } },
            "symmetry": symmetry, "supports": supports, "loads": loads,
            "probes": [
                { "name": "top", "at": { "x": 0, "y": 20, "inward": [0, 1] }, "field": "stress_xx" },
                { "name": "side", "at": { "x": 20, "y": 0, "inward": [1, 0] }, "field": "stress_yy" }]
        });
        limit.into_iter().for_each(|limit| case["limit"] = json!(limit));
        solve(&case).summary.probes.iter().map(|probe| probe.value).collect::<Vec<f64>>()
    };
    // Found: 1.5e-12; 4.2e-7 of corrected displacements, which iterations end.
    for (limit, most) in [(None, 1e-11), (Some("local"), 2e-6)] {
        let whole = pulled(&[], limit);
        for symmetry in [&["left", "bottom"][..], &["left"], &["bottom"]] {
            let part = pulled(symmetry, limit);
            let off = whole.iter().zip(&part).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / whole[0];
            assert!(off < most, "{limit:?} {symmetry:?}: {off:e}");
        }
    }
}

/// Ten points per radius and 0.4 radii between hole and edge leave a ring for six powers, which miss 2 to 5 %.
#[test]
fn a_narrow_ring_of_few_points_gives_way_to_polynomials() {
    // Laurent series at the hole and at its images beyond the edges, of least squares of the tractions, have
    // 732.24 at the top and -207.52 at the side.
    let mut case = beside_an_edge(metal(), 14, 1.0, Some("local"));
    case["body"]["rectangle"]["size"] = json!([40, 14]);
    case["body"]["rectangle"]["holes"][0]["circle"]["radius"] = json!(10);
    case["probes"] = json!([
        { "name": "top", "at": { "x": 0, "y": 10, "inward": [0, 1] }, "field": "stress_xx" },
        { "name": "side", "at": { "x": 10, "y": 0, "inward": [1, 0] }, "field": "stress_yy" }
    ]);
    let solved = solve(&case);
    for (probe, expected) in solved.summary.probes.iter().zip([732.24, -207.52]) {
        // Found: -5.2e-3 and -1e-4; by six powers -1.9e-2 and 3.2e-2.
        assert!((probe.value / expected - 1.0).abs() < 8e-3, "{}: {}", probe.name, probe.value);
    }
    assert!(solved.summary.warnings.iter().any(|words| words.contains("probe `top` is uncertain")));
}

/// Half a radius beside a hole of six points per radius is too little for its fields and much for polynomials, which say so.
#[test]
fn polynomials_say_what_they_miss() {
    // Fields of the hole at a quarter of the spacing have 541.82 at the top and 62.02 on the edge.
    let solved = |spacing: f64| {
        let corner = |x: f64| json!({ "x": x, "y": -30.0 + 0.5 * spacing });
        solve(&json!({
            "title": "Half a radius", "units": "mm-N-MPa", "limit": "local", "model": metal(),
            "body": { "rectangle": { "from": [-40, -30], "size": [80, 50], "spacing": spacing,
                "holes": [{ "circle": { "name": "hole", "centre": [5, 11], "radius": 6 } }] } },
            "supports": [
                { "at": corner(-40.0 + 0.5 * spacing), "ux": 0, "uy": 0 },
                { "at": corner(40.0 - 0.5 * spacing), "uy": 0 }],
            "loads": [
                { "traction": { "edge": "right", "uniform": [100, 0] } },
                { "traction": { "edge": "left", "uniform": [-100, 0] } }],
            "probes": [
                { "name": "top", "at": { "x": 5, "y": 17 }, "field": "stress_xx" },
                { "name": "edge", "at": { "x": 5, "y": 20 }, "field": "stress_xx" },
                { "name": "corner", "at": { "x": -39.9, "y": -29.9 }, "field": "stress_yy" }]
        }))
    };
    let doubted = |solved: &Solved, probe: &str| {
        let words = format!("the stress at the probe `{probe}` is uncertain");
        solved.summary.warnings.iter().any(|warning| warning.contains(&words))
    };
    let misfits = |solved: &Solved| {
        solved.summary.probes.iter().map(|probe| probe.misfit.unwrap()).collect::<Vec<f64>>()
    };
    // Found: -8.8 and -1.9 %, with misfits of 12 and 2.3 %; where there is next to no stress no misfit is one to warn of.
    let coarse = solved(1.0);
    assert!((coarse.summary.probes[0].value / 541.82 - 1.0).abs() < 0.1);
    assert!(doubted(&coarse, "top") && !doubted(&coarse, "edge") && !doubted(&coarse, "corner"));
    assert!((0.1..0.15).contains(&misfits(&coarse)[0]), "{:?}", misfits(&coarse));
    assert!((0.015..0.03).contains(&misfits(&coarse)[1]), "{:?}", misfits(&coarse));
    // Found: 4e-5 by fields that miss 3e-5, and 0.3 % by polynomials that miss 0.2 %.
    let fine = solved(0.5);
    assert!((fine.summary.probes[0].value / 541.82 - 1.0).abs() < 1e-4);
    assert!((fine.summary.probes[1].value / 62.02 - 1.0).abs() < 5e-3);
    assert!(!doubted(&fine, "top") && misfits(&fine)[0] < 1e-4 && misfits(&fine)[1] < 5e-3);
}

/// Fields of a slot are not known; polynomials see a layer of 2.8 spacings nearly as well as the rest.
#[test]
fn a_layer_of_some_spacings_at_a_slot_has_a_doubt() {
    let solved = solve(&json!({
        "title": "Slot", "units": "mm-N-MPa", "limit": "local",
        "model": { "beam_bond_orthotropic": { "youngs_modulus_1": 20e3, "youngs_modulus_2": 10e3, "poisson_ratio_12": 0.3,
            "shear_modulus_12": 5e3, "fibre_angle": 0 } },
        "body": { "rectangle": { "from": [-40, -20], "size": [80, 40], "spacing": 1,
            "holes": [{ "slot": { "name": "slot", "from": [-6, 0], "to": [6, 0], "radius": 7.5 } }] } },
        "supports": [{ "at": { "x": -39.5, "y": -19.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 39.5, "y": -19.5 }, "uy": 0 }],
        "loads": [
            { "traction": { "edge": "right", "uniform": [100, 0] } },
            { "traction": { "edge": "left", "uniform": [-100, 0] } }],
        "probes": [{ "name": "top", "at": { "x": 0, "y": 7.5 }, "field": "stress_xx" }]
    }));
    let doubt = "the stress at the hole `slot` falls within 2.8 of its border, and the spacing is 1";
    assert!(solved.summary.warnings.iter().any(|words| words.contains(doubt)));
    // Half the spacing has 239.29; found 238.99.
    assert!((solved.summary.probes[0].value / 239.29 - 1.0).abs() < 2e-3);
}

/// Stiff fibres have a layer at a hole that no polynomial sees.
#[test]
fn a_layer_at_a_hole_without_fields_of_its_own_is_refused() {
    let error = peristat::solve_text(&beside_an_edge(laminate(), 28, 2.0, Some("local")).to_string());
    let error = error.err().map(|error| error.to_string()).expect("a refusal");
    assert!(error.contains("`local` does not see the stress at the hole `hole`"), "{error}");
    // Nobody asks for what is beside it.
    let mut far = beside_an_edge(laminate(), 28, 2.0, Some("local"));
    far["probes"][0] = json!({ "name": "end", "at": { "x": 199, "y": 1 }, "field": "ux" });
    let warned = solve(&far).summary.warnings;
    assert!(warned.iter().any(|words| words.contains("without fields around the hole it is off")));
    // Half the spacing leaves room for enough points: found -9e-4 of the 1415.0 of elements as above.
    let solved = solve(&beside_an_edge(laminate(), 28, 1.0, Some("local")));
    let off = solved.summary.probes[0].value / 1415.0 - 1.0;
    assert!(off.abs() < 2e-3, "{off:e}");
}
