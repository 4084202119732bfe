//! Reactions along the edges of plates in bending, and at their corners.

use crate::support::bending::{clamped, hard, probe, refusal, solved, square};
use serde_json::{Value, json};
use std::f64::consts::PI;

/// Kirchhoff's reaction per length and force at a corner of a simply supported unit square under a unit pressure, ν = 0.3, of
/// Lévy's series: S. Timoshenko and S. Woinowsky-Krieger, Theory of plates and shells, article 30, table 8: 0.420 and 0.065.
struct Levy;

impl Levy {
    const NU: f64 = 0.3;

    /// `[w', w''']` along the outward normal of an edge by the terms of the series, `(w', w''', m π)` each.
    fn terms() -> impl Iterator<Item = [f64; 3]> {
        (1..200).step_by(2).map(|m| {
            let (alpha, factor) = (PI * f64::from(m), 4.0 / (PI * f64::from(m)).powi(5));
            let u = 0.5 * alpha;
            let (sinh, cosh) = (u.sinh(), u.cosh());
            let (a, b) = (-(u * u.tanh() + 2.0) / (2.0 * cosh), 0.5 / cosh);
            let first = alpha * (a * sinh + b * (sinh + u * cosh));
            let third = alpha.powi(3) * (a * sinh + b * (3.0 * sinh + u * cosh));
            [factor * first, factor * third, alpha]
        })
    }

    fn per_length(s: f64) -> f64 {
        let term = |[first, third, alpha]: [f64; 3]| {
            -(third - (2.0 - Self::NU) * alpha * alpha * first) * (alpha * s).sin()
        };
        Self::terms().map(term).sum()
    }

    fn corner() -> f64 {
        -Self::terms().map(|[first, _, alpha]| 2.0 * (1.0 - Self::NU) * alpha * first).sum::<f64>()
    }
}

fn on(name: &str, at: Value, field: &str) -> Value {
    json!({ "name": name, "at": at, "field": field })
}

fn sum_of(name: &str, region: &str, field: &str) -> Value {
    json!({ "name": name, "at": { "region": region }, "field": field, "of": "integral" })
}

/// The sum of what is along all lines and at their ends.
fn all() -> [Value; 2] {
    [
        json!({ "name": "lines", "at": {}, "field": "reaction_per_length", "of": "integral" }),
        on("corners", json!({ "region": "all" }), "corner_force"),
    ]
}

#[test]
fn a_simple_support_has_the_reactions_of_kirchhoff_and_his_forces_at_corners() {
    assert!((Levy::per_length(0.5) + 0.420).abs() < 5e-4 && (Levy::corner() - 0.065).abs() < 5e-5);
    for t in [0.1, 1e-3] {
        let mut case = square(64, t, hard());
        let places = [0.125, 0.25, 0.375, 0.5];
        let mut probes = all().to_vec();
        probes.extend(places.map(|s| on(&format!("{s}"), json!({ "x": 0, "y": s }), "reaction_per_length")));
        probes.push(on("corner", json!({ "x": 1, "y": 0 }), "corner_force"));
        case["probes"] = json!(probes);
        let found = solved(&case);
        for s in places {
            // 7e-4 at an eighth of the side, 1e-5 in the middle.
            let error = probe(&found, &format!("{s}")) / Levy::per_length(s) - 1.0;
            assert!(error.abs() < 1.5e-3, "t = {t}, s = {s}: {error:.1e}");
        }
        // 5e-4 is found, and 1.1e-2 with 16 cells.
        let error = probe(&found, "corner") / Levy::corner() - 1.0;
        assert!(error.abs() < 1e-3, "t = {t}: {error:.1e}");
        let sum = probe(&found, "lines") + probe(&found, "corners");
        assert!((sum + 1.0).abs() < 1e-12, "{sum}");
    }
}

#[test]
fn reactions_of_a_part_beside_lines_of_symmetry_are_those_of_the_whole() {
    let place = json!({ "x": 0, "y": 0.25 });
    let probes = |middle: f64| {
        json!([
            on("quarter", place.clone(), "reaction_per_length"),
            on("middle", json!({ "x": middle, "y": 0 }), "reaction_per_length"),
            on("moment", json!({ "x": middle, "y": 0 }), "reaction_moment_per_length"),
            on("corner", json!({ "x": 0, "y": 0 }), "corner_force")
        ])
    };
    for held in [json!({ "w": 0, "phi_t": 0 }), json!({ "w": 0, "phi_t": 0, "phi_n": 0 })] {
        let support = |region: Value| {
            let mut support = held.clone();
            support["at"] = json!({ "region": region });
            json!([support])
        };
        let mut case = square(32, 0.05, support(json!("all")));
        case["probes"] = probes(0.5);
        let whole = solved(&case);
        let mut case = square(32, 0.05, support(json!(["left", "bottom"])));
        case["body"]["rectangle"]["size"] = json!([0.5, 0.5]);
        case["symmetry"] = json!(["right", "top"]);
        case["probes"] = probes(0.5);
        let part = solved(&case);
        for name in ["quarter", "middle", "moment", "corner"] {
            let [a, b] = [&part, &whole].map(|found| probe(found, name));
            assert!((a - b).abs() < 1e-10, "{held}, {name}: {a} {b}");
        }
    }
}

#[test]
fn a_clamp_has_the_moments_of_its_edge_and_no_forces_at_corners() {
    let mut case = square(64, 1e-3, clamped());
    case["probes"] = json!([
        on("force", json!({ "x": 0.5, "y": 0 }), "reaction_per_length"),
        on("moment", json!({ "x": 0.5, "y": 0 }), "reaction_moment_per_length"),
        on("corner", json!({ "x": 0, "y": 0 }), "corner_force")
    ]);
    let found = solved(&case);
    // Timoshenko and Woinowsky-Krieger, table 35: 0.0513 q a²; 4e-4 is found.
    let error = probe(&found, "moment") / 0.05133 - 1.0;
    assert!(error.abs() < 1e-3, "{error:.1e}");
    // Legendre-Ritz: 0.4413 q a at this thickness; 1e-4 is found.
    assert!((probe(&found, "force") / -0.4413 - 1.0).abs() < 1e-3, "{}", probe(&found, "force"));
    // 3e-4 is found, what is left of the continuation.
    assert!(probe(&found, "corner").abs() < 1e-3, "{}", probe(&found, "corner"));
}

#[test]
fn a_strip_over_a_wall_has_the_reactions_of_a_beam_of_two_spans() {
    // Two equal spans under a uniform load: 3/8, 10/8 and 3/8 of the load of one; a part of the wall and an edge of two supports.
    let wall = json!({ "wall": { "box": { "from": [1, 0], "to": [1, 0.25] } },
        "all": { "box": { "from": [0, 0], "to": [2, 0.25] } } });
    let mut case = square(16, 1e-3, json!([]));
    case["body"]["rectangle"]["size"] = json!([2, 0.25]);
    let name = "strip";
    case["regions"] = json!({ "wall": wall["wall"], name: wall["all"] });
    case["supports"] = json!([ { "at": { "region": ["left", "right"] }, "w": 0 }, { "at": { "region": "wall" }, "w": 0 },
        { "at": { "region": name }, "phi_y": 0 } ]);
    case["probes"] = json!([
        on("end", json!({ "x": 0, "y": 0.125 }), "reaction_per_length"),
        on("wall", json!({ "x": 1, "y": 0.125 }), "reaction_per_length"),
        sum_of("sum", "wall", "reaction_per_length")
    ]);
    let found = solved(&case);
    for (name, expected) in [("end", -0.375), ("wall", -1.25), ("sum", -0.25 * 1.25)] {
        // Shear: 1e-7 at this thickness.
        let error = probe(&found, name) / expected - 1.0;
        assert!(error.abs() < 1e-5, "{name}: {error:.1e}");
    }
}

#[test]
fn reactions_of_all_supports_are_the_load_where_a_wall_meets_an_edge() {
    // Whichever of them comes first holds the point in common; edges and wall counted it twice.
    let wall = json!({ "at": { "region": "wall" }, "w": 0, "phi_x": 0 });
    let edges = json!({ "at": { "region": ["left", "bottom"] }, "w": 0 });
    let [left, bottom] = ["left", "bottom"].map(|name| json!({ "at": { "region": name }, "w": 0 }));
    for supports in
        [json!([wall, left, bottom]), json!([left, bottom, wall]), json!([wall, edges]), json!([edges, wall])]
    {
        let mut case = square(16, 0.05, supports.clone());
        case["regions"] = json!({ "wall": { "box": { "from": [0.5, 0], "to": [0.5, 1] } } });
        case["probes"] = ["left", "bottom", "wall"]
            .map(|name| on(name, json!({ "region": name }), "reaction_force"))
            .into_iter()
            .collect();
        let found = solved(&case);
        let sum: f64 = ["left", "bottom", "wall"].iter().map(|name| probe(&found, name)).sum();
        assert!((sum + 1.0).abs() < 1e-12, "{supports}: {sum}");
    }
}

#[test]
fn places_without_one_reaction_per_length_are_refused() {
    let mut case = square(8, 0.1, hard());
    let mut refuses = |probe: Value, text: &str| {
        case["probes"] = json!([probe]);
        assert!(refusal(&case).contains(text), "{text}: {}", refusal(&case));
    };
    refuses(on("p", json!({ "x": 0, "y": 0 }), "reaction_per_length"), "no straight line of points along");
    refuses(
        on("p", json!({ "region": "left" }), "reaction_per_length"),
        "is different along the region `left`",
    );
    refuses(on("p", json!({ "x": 0, "y": 0.5 }), "corner_force"), "no line that a support holds ends at");
}

/// Force at corners and force and moment of the left edge.
fn at_corners() -> Value {
    json!([ on("corners", json!({ "region": "all" }), "corner_force"),
        { "name": "left", "at": { "region": "left" }, "field": "reaction_per_length", "of": "integral" },
        on("middle of left", json!({ "x": 0, "y": 0.5 }), "reaction_per_length") ])
}

#[test]
fn a_clamp_across_the_end_of_a_line_bends_the_plate_and_does_not_twist_it() {
    let guided = [
        json!({ "at": { "region": "top" }, "phi_n": 0 }),
        json!({ "at": { "region": "bottom" }, "phi_n": 0 }),
    ];
    let strip = |left: Value, right: Option<Value>| {
        let mut case = square(10, 0.02, json!(guided));
        let supports = case["supports"].as_array_mut().expect("supports");
        supports.push(left);
        supports.extend(right);
        case["thermal_expansion"] = json!(1e-5);
        case["probes"] = at_corners();
        case
    };
    let found = |case: &Value| {
        let found = solved(case);
        ["corners", "left", "middle of left"].map(|name| probe(&found, name))
    };
    // A cantilever in cylindrical bending: its pressure, and no force in the corners.
    let clamp = json!({ "at": { "region": "left" }, "w": 0, "phi_n": 0, "phi_t": 0 });
    let [corners, left, middle] = found(&strip(clamp, None));
    assert!(
        corners.abs() < 1e-11 && (left + 1.0).abs() < 1e-11 && (middle + 1.0).abs() < 1e-11,
        "{corners:.1e}, {left}, {middle}"
    );
    // Warm on two supports: the guides bend it, and nothing presses.
    let simple = |edge: &str| json!({ "at": { "region": edge }, "w": 0, "phi_t": 0 });
    let mut warm = strip(simple("left"), Some(simple("right")));
    warm["loads"] = json!([ { "temperature": { "difference": 1e5 } } ]);
    // Of moments of 50 along the guides.
    assert!(found(&warm).iter().all(|force| force.abs() < 1e-9), "{:?}", found(&warm));
    // A clamped plate that is warm has moments alone.
    let mut case = square(10, 0.02, clamped());
    case["thermal_expansion"] = json!(1e-5);
    case["loads"] = json!([ { "temperature": { "difference": 1e5 } } ]);
    case["probes"] = at_corners();
    assert_eq!(found(&case), [0.0; 3]);
}
