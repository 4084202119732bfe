//! Plates in bending with regions of other thicknesses and materials, their weight, soil, and elastic restraints.

use crate::support::bending::{clamped, hard, probe, refusal, solved, square};
use serde_json::{Value, json};

/// A square with a round cap and a rib that are so many times as thick as the rest.
fn ribbed(cells: usize, ratio: f64, supports: Value) -> Value {
    let mut case = square(cells, 0.01, supports);
    case["regions"] = json!({ "cap": { "disc": { "centre": [0.5, 0.5], "radius": 0.22 } },
        "rib": { "box": { "from": [0.2, 0], "to": [0.25, 1] } } });
    case["materials"] = json!({ "cap": { "at": "cap", "thickness": 0.01 * ratio },
        "rib": { "at": "rib", "thickness": 0.015 * ratio } });
    case["probes"] = json!([]);
    case
}

#[test]
fn regions_of_the_material_of_the_plate_change_nothing() {
    let plain = solved(&square(16, 0.05, hard()));
    let mut case = square(16, 0.05, hard());
    case["regions"] = json!({ "some": { "disc": { "centre": [0.4, 0.6], "radius": 0.3 } } });
    case["materials"] = json!({ "alike": { "at": "some", "thickness": 0.05 } });
    let found = solved(&case);
    for name in ["middle", "moment"] {
        let error = probe(&found, name) / probe(&plain, name) - 1.0;
        assert!(error.abs() < 1e-12, "{name}: {error:.1e}");
    }
}

#[test]
fn a_round_plate_that_is_thicker_inside_tends_to_kirchhoffs() {
    // Radius 1, simply supported, twice as thick within 1/2 and ν = 0.3: solved as two plates, joined by w, w', M_r and V_r.
    let exact = 0.024239392344301836;
    let mut errors = Vec::new();
    // The region ends on steps: -6.1e-2, -3.1e-2, -1.9e-2 and -0.9e-2 at 10, 20, 40 and 80 cells.
    for cells in [20, 80] {
        let mut case = square(1, 1e-3, json!([ { "at": { "region": "all" }, "w": 0 } ]));
        case["body"] = json!({ "outline": { "spacing": 1.0 / f64::from(cells),
            "vertices": [ { "arc_to": [1, 0], "through": [0, -1] }, { "arc_to": [-1, 0], "through": [0, 1] } ] } });
        case["regions"] = json!({ "inner": { "disc": { "centre": [0, 0], "radius": 0.5 } } });
        case["materials"] = json!({ "thick": { "at": "inner", "thickness": 2e-3 } });
        case["probes"] = json!([ { "name": "middle", "at": { "x": 0, "y": 0 }, "field": "w" } ]);
        errors.push(probe(&solved(&case), "middle") / exact - 1.0);
    }
    assert!(errors[0].abs() < 4e-2 && errors[1].abs() < 1.2e-2, "{errors:?}");
}

#[test]
fn cycles_on_plates_with_ribs_agree_with_a_factor() {
    for (ratio, most) in [(2.0, 30), (0.5, 30), (5.0, 60)] {
        for supports in [hard(), clamped()] {
            let mut case = ribbed(64, ratio, supports);
            case["solver"] = json!("sparse");
            let factored = solved(&case);
            case["solver"] = json!("multigrid");
            let cycled = solved(&case);
            let cycles: usize = cycled.summary.solver.iterations.iter().sum();
            assert!(cycles <= most, "{ratio}: {cycles} cycles");
            let [a, b] = [&cycled, &factored].map(|found| found.field(0, "w").expect("a field"));
            let largest = b.iter().fold(0.0, |most: f64, w| most.max(w.abs()));
            let off = a.iter().zip(&b[..]).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
            assert!(off < 1e-8 * largest, "{ratio}: {:.1e}", off / largest);
        }
    }
}

#[test]
fn regions_of_very_different_stiffness_take_a_factor() {
    // 66 049 points, which cycles would solve; with regions 30 times as thick they are 87, and 400 with 150 times.
    let method = |ratio: f64| {
        let mut case = ribbed(256, ratio, hard());
        case["probes"] = json!([ { "name": "middle", "at": { "x": 0.5, "y": 0.5 }, "field": "w" } ]);
        solved(&case).summary.solver
    };
    assert_eq!(method(2.0).method, "multigrid");
    let stiff = method(20.0);
    assert_eq!(stiff.method, "sparse_cholesky");
    assert!(stiff.reason.contains("differ"), "{}", stiff.reason);
}

#[test]
fn a_plate_is_as_heavy_as_its_regions_are_thick() {
    let mut case = ribbed(40, 3.0, hard());
    case["density"] = json!(2.0);
    case["loads"] = json!([ { "gravity": { "along": [0, 0, -1], "acceleration": 10 } } ]);
    case["probes"] = json!([ { "name": "all", "at": { "region": "all" }, "field": "reaction_force" } ]);
    let found = solved(&case);
    // 2 columns of 40 cells of the rib; of the disc the cells with their middles in it.
    let middle = |k: i32| (f64::from(k) + 0.5) / 40.0 - 0.5;
    let inside = |i: i32, j: i32| middle(i).hypot(middle(j)) <= 0.22;
    let cap =
        (0..40).flat_map(|i| (0..40).map(move |j| (i, j))).filter(|&(i, j)| inside(i, j)).count() as f64;
    let volume = (0.045 * 80.0 + 0.03 * cap + 0.01 * (1520.0 - cap)) / 1600.0;
    let error = probe(&found, "all") / (20.0 * volume) - 1.0;
    assert!(error.abs() < 1e-12, "{error:.1e}");
    // Twice the acceleration on the cap, as a load of its own.
    case["loads"] = json!([ { "gravity": { "along": [0, 0, -1], "acceleration": 10, "region": "cap" } } ]);
    let error = probe(&solved(&case), "all") / (20.0 * 0.03 * cap / 1600.0) - 1.0;
    assert!(error.abs() < 1e-12, "{error:.1e}");
}

#[test]
fn an_elastic_restraint_lies_between_a_simple_support_and_a_clamp() {
    // A cantilever of unit length under a unit force per length at its tip, held by w and a spring: 1/3 + 1/S + 1/k.
    for (t, k) in [(0.1, 2.0), (1e-3, 50.0)] {
        let mut case = square(
            8,
            t,
            json!([ { "at": { "region": "left" }, "w": 0, "phi_n_spring": k },
            { "at": { "region": "plate" }, "phi_y": 0 } ]),
        );
        case["regions"] = json!({ "plate": { "box": { "from": [0, 0], "to": [1, 1] } } });
        case["loads"] = json!([ { "line": { "edge": "right", "force": 1 } } ]);
        case["probes"] = json!([ { "name": "tip", "at": { "x": 1, "y": 0.5 }, "field": "w" },
            { "name": "moment", "at": { "region": "left" }, "field": "reaction_moment_x" } ]);
        let found = solved(&case);
        let error = probe(&found, "tip") / (1.0 / 3.0 + t * t / 3.5 + 1.0 / k) - 1.0;
        assert!(error.abs() < 1e-12, "{error:.1e}");
        assert!((probe(&found, "moment").abs() - 1.0).abs() < 1e-12);
    }
    // Along two edges that meet, and with cycles on coarser plates.
    let springs = |k: f64| json!([ { "at": { "region": "all" }, "w": 0, "phi_t": 0, "phi_n_spring": k } ]);
    let middle = |supports: Value, solver: &str| {
        let mut case = square(64, 0.05, supports);
        case["solver"] = json!(solver);
        probe(&solved(&case), "middle")
    };
    let [soft, stiff] = [1e-9, 1e12].map(|k| middle(springs(k), "sparse"));
    assert!((soft / middle(hard(), "sparse") - 1.0).abs() < 1e-8);
    assert!((stiff / middle(clamped(), "sparse") - 1.0).abs() < 1e-8);
    let cycled = middle(springs(10.0), "multigrid") / middle(springs(10.0), "sparse") - 1.0;
    assert!(cycled.abs() < 1e-8, "{cycled:.1e}");
}

#[test]
fn weight_along_the_plane_and_regions_that_overlap_are_refused() {
    let mut case = ribbed(16, 2.0, hard());
    case["density"] = json!(1.0);
    case["loads"] = json!([ { "gravity": { "along": [0, -1], "acceleration": 1 } } ]);
    assert!(refusal(&case).contains("stretches it, and does not bend it"), "{}", refusal(&case));
    let mut case = ribbed(16, 2.0, hard());
    case["regions"]["rib"]["box"]["to"] = json!([0.4, 1]);
    assert!(refusal(&case).contains("are of `cap` already"), "{}", refusal(&case));
    let mut case = ribbed(16, 2.0, hard());
    case["materials"]["rib"]["shear_modulus"] = json!(1.0);
    assert!(
        refusal(&case).contains("nothing that regions of a plate in bending differ in"),
        "{}",
        refusal(&case)
    );
    let mut case =
        square(8, 0.1, json!([ { "at": { "region": "all" }, "w": 0, "phi_n": 0, "phi_n_spring": 1 } ]));
    assert!(refusal(&case).contains("`phi_n` is prescribed"), "{}", refusal(&case));
    case["supports"] = json!([ { "at": { "x": 0.5, "y": 0.5 }, "w": 0, "phi_n_spring": 1 } ]);
    assert!(refusal(&case).contains("across an edge, and here is none"), "{}", refusal(&case));
}

/// An angle of free plate on soil, under a uniform pressure, and one half of a plate that is loaded in a corner beside the whole.
#[test]
fn soil_pushes_back_as_a_pressure_presses() {
    let mut case = square(16, 0.05, json!([]));
    case["body"] = json!({ "outline": { "spacing": 0.0625, "vertices": [[0, 0], [2, 0], [2, 1], [1, 1], [1, 3], [0, 3]] } });
    case["supports"] = json!([]);
    case["foundation"] = json!([ { "stiffness": { "uniform": 40 } } ]);
    case["loads"] = json!([ { "pressure": { "value": 1 } } ]);
    case["probes"] = json!([ { "name": "moment", "field": "M_1", "of": "largest_magnitude" } ]);
    let found = solved(&case);
    let w = found.field(0, "w").expect("a field");
    let off = w.iter().fold(0.0, |most: f64, w| most.max((w * 40.0 - 1.0).abs()));
    // 2e-15 is found, and 3e-3 where the bed has no couples at its edges.
    assert!(off < 1e-12 && probe(&found, "moment") < 1e-12, "{off:e}");

    let mut whole = square(1, 0.05, json!([]));
    whole["body"] = json!({ "rectangle": { "size": [2, 1], "spacing": 0.125 } });
    whole["supports"] = json!([]);
    whole["foundation"] = json!([ { "stiffness": { "formula": "40*(1 + y)" } } ]);
    whole["loads"] = json!([ { "point": { "at": { "x": 0, "y": 1 }, "force": 1 } }, { "point": { "at": { "x": 2, "y": 1 }, "force": 1 } } ]);
    whole["probes"] = json!([ { "name": "corner", "at": { "x": 2, "y": 1 }, "field": "w" } ]);
    let mut half = whole.clone();
    half["body"] = json!({ "rectangle": { "from": [1, 0], "size": [1, 1], "spacing": 0.125 } });
    half["symmetry"] = json!(["left"]);
    half["loads"] = json!([ { "point": { "at": { "x": 2, "y": 1 }, "force": 1 } } ]);
    let [whole, half] = [whole, half].map(|case| probe(&solved(&case), "corner"));
    assert!((half / whole - 1.0).abs() < 1e-11, "{half} {whole}");
}
