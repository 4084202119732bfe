//! Slots narrower than bonds are long: their sides part, whatever their width and wherever they lie between points.

use crate::support::plane::{displacements, probe, scene, solve};
use peristat::case::FieldName;
use peristat::run::Resultants;
use serde_json::{Value, json};

/// Opening in the middle of a slot of 21 spacings in a plate of 85 × 85 over `4 a σ/E`, that of a crack of the half length a in
/// an infinite plate. In a long plate of this width it is 1.04 (Tada), in a square one more: 1.07 in the note of the rule.
const FINITE: f64 = 1.07;

/// A plate with a slot of some width, whose lower side is some cells above that of its middle row.
fn plate(model: Value, ratio: f64, [below, width]: [f64; 2]) -> Value {
    let [low, high] = [42.0 + below, 42.0 + below + width];
    json!({
        "title": "slot", "model": model, "horizon_ratio": ratio,
        "body": { "rectangle": { "size": [85, 85], "spacing": 1, "holes": [
            { "polygon": { "name": "slot", "vertices": [[32, low], [53, low], [53, high], [32, high]] } } ] } },
        "supports": [{ "at": { "x": 0.5, "y": 0.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 84.5, "y": 0.5 }, "uy": 0 }],
        "loads": [{ "traction": { "edge": "top", "uniform": [0, 1] } },
                  { "traction": { "edge": "bottom", "uniform": [0, -1] } }]
    })
}

fn opening(case: &Value) -> f64 {
    let run = displacements(case);
    let at = |y: f64| {
        let points = run.positions();
        let near = |p: &[f64; 2]| (p[0] - 42.5).abs() < 1e-6 && (p[1] - y).abs() < 1e-6;
        run.field(0, FieldName::Uy)[points.iter().position(near).expect("a point beside the slot")]
    };
    (at(43.5) - at(41.5)) / (4.0 * 10.5)
}

fn bonds(edges: &str) -> Value {
    json!({ "bond_plane": { "youngs_modulus": 1, "state": "plane_stress", "edges": edges } })
}

/// One cell wide, on the lattice.
const ROW: [f64; 2] = [0.0, 1.0];

#[test]
fn a_slot_of_one_cell_opens_as_a_crack() {
    // The prototypes of the rule have 1.11, 1.0665 and 1.05; without it 0.187, 0.099 and 0.083.
    for (ratio, expected) in [(2.0, 1.112), (3.0, 1.0665), (4.0, 1.0487)] {
        let found = opening(&plate(bonds("overlay"), ratio, ROW));
        assert!((found - expected).abs() < 1e-3, "{ratio}: {found}");
        assert!((found / FINITE - 1.0).abs() < 0.1, "{ratio}: {found}");
    }
}

#[test]
fn every_model_parts_it() {
    let state = |edges: &str| json!({ "state_plane": { "youngs_modulus": 1, "poisson_ratio": 0.3333333333333333, "state": "plane_stress", "edges": edges } });
    let fibres = |edges: &str| {
        json!({ "beam_bond_orthotropic": { "youngs_modulus_1": 1, "youngs_modulus_2": 1, "poisson_ratio_12": 0.3,
            "shear_modulus_12": 0.3846153846153846, "fibre_angle": 0, "edges": edges } })
    };
    // Measured from 1.016 to 1.166; 0.06 to 0.19 where bonds reach across.
    let models = [
        bonds("none"),
        bonds("volume"),
        bonds("border"),
        state("ghosts"),
        state("border"),
        fibres("overlay"),
    ];
    for (model, ratio) in models.iter().flat_map(|m| [2.0, 3.0, 4.0].map(|r| (m, r))) {
        let found = opening(&plate(model.clone(), ratio, ROW));
        assert!((found / FINITE - 1.0).abs() < 0.1, "{model} {ratio}: {found}");
    }
}

#[test]
fn slots_between_points_part_them_too() {
    // Wider and thinner than a cell, with and without points that they remove; in parts of a spacing.
    let places = [[0.3, 1.0], [-0.25, 1.5], [0.35, 0.3], [-0.15, 0.3], [-0.0005, 0.001]];
    for (place, ratio) in places.iter().flat_map(|p| [2.0, 3.0].map(|r| (*p, r))) {
        for edges in ["border", "overlay", "none"] {
            let found = opening(&plate(bonds(edges), ratio, place));
            // Measured from 0.969 to 1.134. Today's default, `border`, had 0.09 where the sides cut cells.
            assert!((found / FINITE - 1.0).abs() < 0.1, "{edges} {place:?} {ratio}: {found}");
        }
    }
}

/// The right half of a plate of 84 columns with a slot of 22 is the whole one.
#[test]
fn a_slot_across_a_mirror_is_the_whole_one() {
    let case = |model: &Value, whole: bool, [low, high]: [f64; 2]| {
        let from = if whole { -42 } else { 0 };
        let slot = [
            [if whole { -11.0 } else { -3.0 }, low],
            [11.0, low],
            [11.0, high],
            [if whole { -11.0 } else { -3.0 }, high],
        ];
        let mut case = plate(model.clone(), 3.0, ROW);
        case["body"] = json!({ "rectangle": { "from": [from, 0], "size": [42 - from, 85], "spacing": 1,
            "holes": [ { "polygon": { "vertices": slot } } ] } });
        if whole {
            case["supports"] = json!([{ "at": { "x": -41.5, "y": 0.5 }, "uy": 0 }, { "at": { "x": 41.5, "y": 0.5 }, "uy": 0 }, { "at": { "x": -41.5, "y": 0.5 }, "ux": 0 }]);
        } else {
            case["symmetry"] = json!(["left"]);
            case["supports"] = json!([{ "at": { "x": 41.5, "y": 0.5 }, "uy": 0 }]);
        }
        case["probes"] = json!([{ "name": "up", "at": { "x": 0.5, "y": 43.5 }, "field": "uy" },
                                { "name": "low", "at": { "x": 0.5, "y": 41.5 }, "field": "uy" }]);
        case
    };
    let state = json!({ "state_plane": { "youngs_modulus": 1, "poisson_ratio": 0.3, "state": "plane_stress", "edges": "ghosts" } });
    for (model, sides) in [bonds("overlay"), bonds("border"), state]
        .iter()
        .flat_map(|m| [[42.0, 43.0], [41.85, 42.15]].map(|s| (m, s)))
    {
        let [whole, half] = [true, false].map(|w| {
            let case = case(model, w, sides);
            probe(&case, "up") - probe(&case, "low")
        });
        // Fits of ghosts take real points alone: measured 8e-4.
        let tolerance = if model["state_plane"].is_null() { 1e-6 } else { 2e-3 };
        assert!(whole > 40.0 && (half / whole - 1.0).abs() < tolerance, "{model} {sides:?}: {whole} {half}");
    }
}

#[test]
fn multigrid_takes_about_as_many_cycles_as_without() {
    let cycles = |case: &mut Value| {
        case["solver"] = json!("multigrid");
        solve(case).iterations()
    };
    let mut without = plate(bonds("overlay"), 3.0, ROW);
    without["body"]["rectangle"]["holes"] = json!([]);
    let counts = [cycles(&mut plate(bonds("overlay"), 3.0, ROW)), cycles(&mut without)];
    assert!(counts[0] <= 2 * counts[1] + 10, "{counts:?}");
}

#[test]
fn a_narrow_bridge_is_reported_by_name() {
    let slot = |name: &str, low: f64| json!({ "polygon": { "name": name, "vertices": [[8, low], [20, low], [20, low + 1.0], [8, low + 1.0]] } });
    let case = |gap: f64| {
        let mut case = plate(bonds("overlay"), 3.0, ROW);
        case["body"] = json!({ "rectangle": { "size": [28, 24], "spacing": 1, "holes": [slot("lower", 10.0), slot("upper", 11.0 + gap)] } });
        case["supports"][1]["at"] = json!({ "x": 27.5, "y": 0.5 });
        case
    };
    let said = |case: &Value| scene(case).unwrap().warnings.into_report("case", "").to_string();
    let narrow = said(&case(1.0));
    assert!(narrow.contains("one cell wide between `lower` and `upper`"), "{narrow}");
    assert!(!said(&case(2.0)).contains("one cell wide"));
}

fn resultants(case: &Value) -> Resultants {
    solve(case).states[0].record.certificate.resultants.clone().expect("resultants")
}

/// A ligament of 0.3 spacings between a hole and an edge: what completes it turns with the body, so that supports bear the moment
/// that is asked for. They had 3210.56 of 3200.
#[test]
fn a_thin_ligament_resists_no_turn() {
    for hole in [[10.3, 40.3], [10.3, 40.0], [40.0, 69.7]] {
        let case = json!({
            "title": "ligament",
            "model": { "state_plane": { "youngs_modulus": 1e5, "poisson_ratio": 0.3, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [80, 80], "spacing": 1, "holes": [{ "circle": { "centre": hole, "radius": 10 } }] } },
            "supports": [{ "at": { "region": "right" }, "ux": 0, "uy": 0 }],
            "loads": [{ "traction": { "edge": "left", "uniform": [1, 0] } }]
        });
        let resultants = resultants(&case);
        let moments = [resultants.asked.moment, resultants.reactions.moment].map(|m| m.expect("a moment"));
        assert!(
            (moments[0] + 3200.0).abs() < 1e-9 && (moments[1] - 3200.0).abs() < 1e-6,
            "{hole:?} {moments:?}"
        );
    }
}

/// Half of a square on its corner under pressure: its border meets the line of symmetry at a slant, and its strain is uniform.
#[test]
fn a_border_meets_a_mirror_at_a_slant() {
    let case = json!({
        "title": "slant",
        "model": { "beam_bond_orthotropic": { "youngs_modulus_1": 1e5, "youngs_modulus_2": 1e5, "poisson_ratio_12": 0.3,
            "shear_modulus_12": 1e5 / 2.6, "fibre_angle": 0 } },
        "body": { "outline": { "vertices": [[0, -40], [40, 0], [0, 40]], "spacing": 2 } },
        "symmetry": ["left"], "supports": [{ "at": { "x": 1, "y": 1 }, "uy": 0 }],
        "loads": [{ "traction": { "edge": ["edge_1", "edge_2"], "pressure": 1 } }]
    });
    // `solve` asserts that the certificate holds.
    let run = solve(&case);
    let error = run.error(0, |[x, y]| [-0.7e-5 * x, -0.7e-5 * (y - 1.0)]);
    assert!(error < 1e-9, "{error}");
    let force = resultants(&case).reactions.force_x.expect("a force");
    assert!((force - 80.0).abs() < 1e-9, "{force}");
}

/// A hole that touches an edge in its middle leaves the edge its load: the edge lost all of it, and had no area.
#[test]
fn a_hole_that_touches_an_edge_leaves_it_its_load() {
    let case = json!({
        "title": "touching",
        "model": { "bond_plane": { "youngs_modulus": 1e5, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [40, 20], "spacing": 1, "holes": [{ "circle": { "centre": [20, 15], "radius": 5 } }] } },
        "supports": [{ "at": { "region": "bottom" }, "uy": 0 }, { "at": { "x": 0.5, "y": 0.5 }, "ux": 0 }],
        "loads": [{ "traction": { "edge": "top", "uniform": [0, 1] } }]
    });
    let found = resultants(&case);
    let forces = [found.asked.force_y, found.reactions.force_y].map(|f| f.expect("a force"));
    assert!((forces[0] - 40.0).abs() < 1e-9 && (forces[1] + 40.0).abs() < 1e-9, "{forces:?}");
}

/// Probes of two edges with a common corner sum to the whole, as the rows of their supports do.
#[test]
fn a_corner_counts_for_one_of_its_edges() {
    let case = json!({
        "title": "corner",
        "model": { "bond_plane": { "youngs_modulus": 1e5, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [20, 10], "spacing": 1 } },
        "supports": [{ "at": { "region": "left" }, "ux": 0, "uy": 0 }, { "at": { "region": "bottom" }, "ux": 0, "uy": 0 }],
        "loads": [{ "traction": { "edge": "right", "uniform": [3, 1] } }],
        "probes": [{ "name": "left", "at": { "region": "left" }, "field": "reaction_x" },
                   { "name": "bottom", "at": { "region": "bottom" }, "field": "reaction_x" }]
    });
    let [left, bottom] = ["left", "bottom"].map(|name| probe(&case, name));
    assert!((left + bottom + 30.0).abs() < 1e-9, "{left} {bottom}");
}

/// Pressure in a slot opens it as far as the same tension on the plate does a free one: each side has its own.
#[test]
fn pressure_in_a_slot_acts_on_either_side() {
    for place in [ROW, [0.3, 1.0], [-0.15, 0.3]] {
        for edges in ["border", "overlay"] {
            let mut case = plate(bonds(edges), 3.0, place);
            case["loads"] = json!([{ "traction": { "edge": "slot", "pressure": 1 } }]);
            let found = opening(&case);
            // 0.31 where points across the slot had a part of what acts on it.
            assert!((found / FINITE - 1.0).abs() < 0.12, "{edges} {place:?}: {found}");
        }
    }
}

/// A ring that is cut open gives way as one whose ends a crack parts, however many rows the slot takes out: the border of one side does
/// not follow the points of the other.
#[test]
fn a_ring_is_open_however_wide_its_slot_is() {
    let deflection = |width: f64| {
        let [low, high] = [12.0 - 0.5 * width, 12.0 + 0.5 * width];
        let slot = json!({ "polygon": { "vertices": [[16, low], [25, low], [25, high], [16, high]] } });
        let case = json!({
            "title": "open ring", "units": "none", "model": { "bond_plane": { "youngs_modulus": 1000, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [24, 24], "spacing": 1, "holes": [{ "circle": { "centre": [12, 12], "radius": 5 } }, slot] } },
            "supports": [ { "at": { "region": "left" }, "ux": 0, "uy": 0 } ],
            "loads": [ { "traction": { "edge": "top", "uniform": [0, 1] } } ],
            "probes": [ { "name": "corner", "at": { "x": 23.5, "y": 23.5 }, "field": "uy" } ]
        });
        peristat::solve_text(&format!("{case:#}")).expect("a case that can be solved").summary.probes[0].value
    };
    // 0.53957 is found; closed it is 0.126, and welded it was 0.14 at a width of 1.2 and 0.27 at 2.
    let narrow = deflection(0.9);
    for width in [1.2, 2.0, 2.1, 3.0, 4.1, 5.0] {
        let wide = deflection(width);
        assert!((wide / narrow - 1.0).abs() < 2e-4, "{width}: {wide} of {narrow}");
    }
}

/// A slot that ends in the body is welded nowhere: what its end costs falls with the spacing.
#[test]
fn an_edge_slot_of_any_width_converges() {
    let deflection = |spacing: f64| {
        let slot = json!({ "polygon": { "vertices": [[-1, 7.4], [10, 7.4], [10, 8.6], [-1, 8.6]] } });
        let half = 0.5 * spacing;
        let case = json!({
            "title": "edge slot", "units": "none", "model": { "bond_plane": { "youngs_modulus": 1000, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [20, 16], "spacing": spacing, "holes": [slot] } },
            "supports": [ { "at": { "region": "bottom" }, "uy": 0 }, { "at": { "x": 10.0 + half, "y": half }, "ux": 0 } ],
            "loads": [ { "traction": { "edge": "top", "uniform": [0, 1] } } ],
            "probes": [ { "name": "corner", "at": { "x": half, "y": 16.0 - half }, "field": "uy" } ]
        });
        peristat::solve_text(&format!("{case:#}")).expect("a case that can be solved").summary.probes[0].value
    };
    let found = [1.0, 0.5, 0.25].map(deflection);
    // 0.187, 0.247, 0.270 are found, 0.277 with the edges `overlay` at the last spacing; welded it was 0.11 at the first.
    assert!(found[0] > 0.18 && found[1] > 0.24 && found[2] > 0.265 && found[2] < 0.28, "{found:?}");
}

/// A body whose sides are joined has no place where it begins: a slot opens as far across the seam as in the middle.
#[test]
fn a_slot_across_joined_sides_is_the_whole_one() {
    let deflection = |pieces: &[[f64; 2]]| {
        let slot = |[from, to]: &[f64; 2]| json!({ "polygon": { "vertices": [[from, 3.9], [to, 3.9], [to, 4.1], [from, 4.1]] } });
        let slots: Vec<Value> = pieces.iter().map(slot).collect();
        let probes: Vec<Value> = (0..12)
            .map(|k| json!({ "name": format!("{k}"), "at": { "x": 0.5 + f64::from(k), "y": 7.5 }, "field": "uy" }))
            .collect();
        let case = json!({
            "title": "joined", "units": "none", "model": { "bond_plane": { "youngs_modulus": 1000, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [12, 8], "spacing": 1, "holes": slots } }, "periodic": [ { "along": "x" } ],
            "supports": [ { "at": { "region": "bottom" }, "ux": 0, "uy": 0 } ],
            "loads": [ { "traction": { "edge": "top", "uniform": [0, 3] } } ], "probes": probes
        });
        let found = peristat::solve_text(&format!("{case:#}")).expect("a case that can be solved").summary;
        found.probes.iter().map(|probe| probe.value).sum::<f64>() / 12.0
    };
    let middle = deflection(&[[1.5, 10.5]]);
    for pieces in [&[[-1.0, 4.5], [7.5, 13.0]], &[[-1.0, 6.5], [9.5, 13.0]]] {
        let across = deflection(pieces);
        // 8e-6 is found, where a piece ends on a column of points; the mean is 0.048, of a body without a slot 0.02, and it was 0.029 across the seam.
        assert!((across / middle - 1.0).abs() < 2e-5, "{pieces:?}: {across} of {middle}");
    }
}
