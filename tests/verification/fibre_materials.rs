//! Plates of beam bonds whose regions are stiffer or softer: layers, discs, and heat that leaves no stress.

use crate::support::breaking;
use crate::support::plane::refusal;
use serde_json::{Value, json};

/// A rectangle of graphite and epoxy around the middle of its sides, mm-N-MPa.
fn plate([width, height]: [f64; 2], fibre_angle: f64, poisson_ratio_12: f64) -> Value {
    json!({
        "title": "fibres", "units": "mm-N-MPa",
        "model": { "beam_bond_orthotropic": {
            "youngs_modulus_1": 181000, "youngs_modulus_2": 10300, "poisson_ratio_12": poisson_ratio_12,
            "shear_modulus_12": 7170, "fibre_angle": fibre_angle
        } },
        "body": { "rectangle": {
            "from": [-0.5 * width, -0.5 * height], "size": [width, height], "spacing": 1
        } },
        "supports": [
            { "at": { "x": 0.5 - 0.5 * width, "y": 0.5 - 0.5 * height }, "ux": 0, "uy": 0 },
            { "at": { "x": 0.5 * width - 0.5, "y": 0.5 - 0.5 * height }, "uy": 0 }
        ]
    })
}

/// Stretches it by a stress of 100 on both sides.
fn pull(case: &mut Value) {
    let [right, left] = [("right", 100), ("left", -100)]
        .map(|(edge, x)| json!({ "traction": { "edge": edge, "uniform": [x, 0] } }));
    case["loads"] = json!([right, left]);
}

fn probes<const N: usize>(case: &Value) -> [f64; N] {
    let summary = peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|e| panic!("{e}")).summary;
    let values: Vec<f64> = summary.probes.iter().map(|probe| probe.value).collect();
    values.try_into().expect("as many probes")
}

#[test]
fn a_plate_all_of_which_is_stiffer_moves_less() {
    for (angle, edges) in [(0.0, "border"), (15.0, "border"), (45.0, "overlay")] {
        let of = |factor: Option<f64>| {
            let mut case = plate([24.0, 12.0], angle, 0.28);
            case["model"]["beam_bond_orthotropic"]["edges"] = json!(edges);
            if let Some(factor) = factor {
                case["materials"] = json!({ "all": { "stiffness_factor": factor } });
            }
            pull(&mut case);
            case["probes"] = json!([
                { "name": "u", "at": { "x": 11.5, "y": 5.5 }, "field": "ux" },
                { "name": "strain", "at": { "x": 4.5, "y": 1.5 }, "field": "strain_xx" },
                { "name": "stress", "at": { "x": 4.5, "y": 1.5 }, "field": "stress_xx" },
                { "name": "energy", "at": { "x": 4.5, "y": 1.5 }, "field": "energy_density" }
            ]);
            probes::<4>(&case)
        };
        let [plain, one, stiff] = [None, Some(1.0), Some(3.0)].map(of);
        for (k, ratio) in [3.0, 3.0, 1.0, 3.0].into_iter().enumerate() {
            let off = one[k] / stiff[k] / ratio - 1.0;
            assert!(off.abs() < 1e-11, "{angle} {k}: {off:e}"); // 2e-15
            let off = one[k] / plain[k] - 1.0;
            assert!(off.abs() < 1e-9, "{angle} {k}: {off:e}"); // 0
        }
    }
}

/// Two halves, without contraction: the elongation is that of springs in series.
#[test]
fn layers_in_series_lose_no_twentieth_of_a_spacing() {
    for (angle, modulus) in [(0.0, 181_000.0), (90.0, 10_300.0)] {
        for factor in [2.0, 10.0, 100.0, 1e-3] {
            let mut case = plate([40.0, 20.0], angle, 0.0);
            case["regions"] = json!({ "second": { "box": { "from": [0, -10], "to": [20, 10] } } });
            case["materials"] = json!({ "other": { "at": "second", "stiffness_factor": factor } });
            pull(&mut case);
            case["probes"] = json!([
                { "name": "right", "at": { "x": 18.5, "y": 0.5 }, "field": "ux" },
                { "name": "left", "at": { "x": -18.5, "y": 0.5 }, "field": "ux" }
            ]);
            let [right, left] = probes::<2>(&case);
            let strain = 100.0 / modulus;
            let jump = right - left - strain * 18.5 * (1.0 + 1.0 / factor);
            let spacings = jump / (strain * f64::max(1.0, 1.0 / factor));
            assert!(spacings.abs() < 0.06, "{angle} {factor}: {spacings}"); // 0.040 and 0.051 at a factor of 10
        }
    }
}

/// A core between faces under a uniform strain: the force is that of springs side by side, and stresses know no interface.
#[test]
fn layers_side_by_side_share_a_force_by_their_moduli() {
    for (angle, modulus) in [(0.0, 181_000.0), (90.0, 10_300.0)] {
        for factor in [2.0, 10.0, 100.0] {
            let mut case = plate([40.0, 20.0], angle, 0.0);
            case["regions"] = json!({ "core": { "box": { "from": [-20, -5], "to": [20, 5] } } });
            case["materials"] = json!({ "other": { "at": "core", "stiffness_factor": factor } });
            case["supports"] = json!([
                { "at": { "region": "left" }, "ux": 0 }, { "at": { "region": "right" }, "ux": 0.04 },
                { "at": { "x": -19.5, "y": 0.5 }, "uy": 0 }
            ]);
            case["probes"] = json!([
                { "name": "force", "at": { "region": "right" }, "field": "reaction_x" },
                { "name": "inside", "at": { "x": 0.5, "y": 4.5 }, "field": "stress_xx" },
                { "name": "outside", "at": { "x": 0.5, "y": 5.5 }, "field": "stress_xx" }
            ]);
            let [force, inside, outside] = probes::<3>(&case);
            let stress = 1e-3 * modulus;
            let off =
                [force / (10.0 * stress * (1.0 + factor)), inside / (stress * factor), outside / stress];
            // Measured 7e-5, at 90 degrees and a factor of 100.
            assert!(off.iter().all(|off| (off - 1.0).abs() < 2e-4), "{angle} {factor}: {off:?}");
        }
    }
}

#[test]
fn heat_alone_leaves_no_stress_whatever_is_stiffer() {
    for angle in [0.0, 15.0, 30.0, 45.0] {
        let mut case = plate([30.0, 20.0], angle, 0.28);
        case["thermal_expansion"] = json!([2e-8, 2.25e-5]);
        case["regions"] = json!({ "disc": { "disc": { "centre": [3, -2], "radius": 5 } } });
        case["materials"] = json!({ "other": { "at": "disc", "stiffness_factor": 10 } });
        case["loads"] = json!([{ "temperature": { "change": -100 } }]);
        case["probes"] = json!([{ "name": "stress", "field": "von_mises", "of": "largest" }]);
        let [stress] = probes::<1>(&case);
        // E α ΔT of the disc is 2300.
        assert!(stress < 1e-9, "{angle}: {stress:e}"); // 3e-12
    }
}

/// Stresses of a disc of eight points per radius against finite elements of second order, 0.5 mm wide, whose nodes lie on its
/// border, on the same square of 80 mm.
#[test]
fn a_disc_among_slanted_fibres_has_the_stress_of_finite_elements() {
    // Contrast, σxx, σyy and σxy at (2.5, 2.5), and by how much they may be off; beside these what is found.
    let elements = [
        (10.0, [137.4425, 4.0, -5.131], [2.6, 0.7, 1.3]), // 134.982, 4.588, -6.298
        (0.1, [33.9737, 1.753, 5.9068], [0.6, 0.2, 0.1]), // 34.484, 1.649, 5.874
    ];
    for (factor, expected, most) in elements {
        let mut case = plate([80.0, 80.0], 30.0, 0.28);
        case["regions"] = json!({ "disc": { "disc": { "centre": [0, 0], "radius": 8 } } });
        case["materials"] = json!({ "other": { "at": "disc", "stiffness_factor": factor } });
        pull(&mut case);
        let probe = |field: &str| json!({ "name": field, "at": { "x": 2.5, "y": 2.5 }, "field": field });
        case["probes"] = json!(["stress_xx", "stress_yy", "stress_xy"].map(probe));
        let found = probes::<3>(&case);
        for ((found, exact), most) in found.iter().zip(expected).zip(most) {
            assert!((found - exact).abs() < most, "{factor}: {found} for {exact}");
        }
    }
}

/// Materials have expansions of their own, one or two, whatever that of the case is.
#[test]
fn a_material_expands_by_its_own_numbers() {
    for (given, expected) in [(json!([1e-6, 3e-5]), [1e-6, 3e-5]), (json!(2e-5), [2e-5, 2e-5])] {
        for base in [json!([2e-8, 2.25e-5]), json!(1.2e-5)] {
            let mut case = plate([20.0, 10.0], 30.0, 0.28);
            case["thermal_expansion"] = base;
            case["materials"] = json!({ "all": { "stiffness_factor": 2, "thermal_expansion": given } });
            case["loads"] = json!([{ "temperature": { "change": 100 } }]);
            case["probes"] = json!([
                { "name": "along", "at": { "x": 0.5, "y": 0.5 }, "field": "strain_11" },
                { "name": "across", "at": { "x": 0.5, "y": 0.5 }, "field": "strain_22" }
            ]);
            let found = probes::<2>(&case);
            for (found, alpha) in found.iter().zip(expected) {
                assert!((found - 100.0 * alpha).abs() < 1e-14, "{given}: {found:e}"); // 4e-18
            }
        }
    }
}

#[test]
fn a_heated_part_between_walls_has_the_stress_of_its_own_modulus() {
    let mut case = plate([30.0, 10.0], 0.0, 0.28);
    case["thermal_expansion"] = json!([2e-8, 2.25e-5]);
    case["materials"] = json!({ "all": { "stiffness_factor": 4, "thermal_expansion": [1e-6, 3e-5] } });
    case["supports"] = json!([
        { "at": { "region": "left" }, "ux": 0 }, { "at": { "region": "right" }, "ux": 0 },
        { "at": { "x": 0.5, "y": 0.5 }, "uy": 0 }
    ]);
    case["loads"] = json!([{ "temperature": { "change": 100 } }]);
    case["probes"] = json!([{ "name": "stress", "at": { "x": 0.5, "y": 0.5 }, "field": "stress_xx" }]);
    let [stress] = probes::<1>(&case);
    let expected = -4.0 * 181_000.0 * 1e-6 * 100.0;
    assert!((stress / expected - 1.0).abs() < 5e-6, "{stress} for {expected}"); // 1.1e-6
}

/// A strip of two halves that is torn apart along their interface, which takes a tenth of the energy of the halves: bonds that broke,
/// their energy over that of a crack, and by how much energies are out of balance.
fn torn(fibre_angle: f64, factor: f64, strategy: &str) -> (usize, f64, f64) {
    let rates = |part: f64| json!({ "fibre_energy_release_rate": 30.0 * part, "matrix_energy_release_rate": 3.0 * part });
    let mut case = json!({
        "title": "torn", "units": "mm-N-MPa",
        "model": { "beam_bond_orthotropic": {
            "youngs_modulus_1": 40000, "youngs_modulus_2": 10000, "poisson_ratio_12": 0.25, "shear_modulus_12": 4000,
            "fibre_angle": fibre_angle
        } },
        "body": { "rectangle": { "size": [24, 16], "spacing": 1 } },
        "regions": { "upper": { "box": { "from": [0, 8], "to": [24, 16] } } },
        "supports": [
            { "at": { "region": "bottom" }, "ux": 0, "uy": 0 }, { "at": { "region": "top" }, "ux": 0, "uy": 1 }
        ],
        "probes": [{ "name": "pull", "at": { "region": "top" }, "field": "reaction_y" }],
        "fracture": { "critical": rates(1.0), "strategy": strategy, "load": "pull", "stop_below": 1e-6 }
    });
    case["materials"] =
        json!({ "other": { "at": "upper", "stiffness_factor": factor, "interface": rates(0.1) } });
    let (events, report) = breaking::solve(&case);
    let rate = if fibre_angle == 0.0 { 0.3 } else { 3.0 };
    let energy = events.last().expect("it breaks").bond_energy / (24.0 * rate);
    (breaking::broke(&report).broken_bonds, energy, breaking::imbalance(&events))
}

#[test]
fn an_interface_of_fibres_takes_its_energy_whatever_is_stiffer() {
    // Bonds take a little more than stretch alone: they shear and bend.
    for (angle, factor, expected) in [(0.0, 1.001, 1.120), (0.0, 10.0, 1.076), (90.0, 10.0, 1.048)] {
        let (broken, energy, imbalance) = torn(angle, factor, "worst");
        // Bonds across a row are 17 per column.
        assert!((400..=420).contains(&broken), "{angle} {factor}: {broken}");
        assert!((energy - expected).abs() < 5e-3, "{angle} {factor}: {energy}");
        assert!(imbalance < 1e-10, "{angle} {factor}: {imbalance:e}");
    }
    let (_, _, imbalance) = torn(0.0, 10.0, "batch");
    assert!(imbalance < 1e-7, "{imbalance:e}");
}

#[test]
fn a_material_is_as_much_tougher_along_the_fibres_as_across_them() {
    let with = |critical: Value| {
        let mut case = plate([20.0, 10.0], 0.0, 0.28);
        case["regions"] = json!({ "part": { "box": { "from": [0, -5], "to": [10, 5] } } });
        case["materials"] = json!({ "other": { "at": "part", "critical": critical } });
        pull(&mut case);
        case["probes"] = json!([{ "name": "u", "at": { "x": 9.5, "y": 0.5 }, "field": "ux" }]);
        let usual = json!({ "fibre_stretch": 0.02, "matrix_stretch": 0.01 });
        case["fracture"] = json!({ "critical": usual, "load": "u" });
        refusal(&case)
    };
    let message = with(json!({ "fibre_stretch": 0.02, "matrix_stretch": 0.02 }));
    assert!(message.contains("as many times tougher along the fibres as across them"), "{message}");
}

#[test]
fn a_region_is_judged_by_its_own_strengths() {
    let mut case = plate([20.0, 10.0], 0.0, 0.28);
    let strengths = |part: f64| {
        json!({ "fibre_tension": 1500.0 * part, "fibre_compression": 1500.0 * part,
        "matrix_tension": 40.0 * part, "matrix_compression": 246.0 * part, "shear": 68.0 * part })
    };
    case["strengths"] = strengths(1.0);
    case["regions"] = json!({ "right part": { "box": { "from": [0, -5], "to": [10, 5] } } });
    case["materials"] = json!({ "other": { "at": "right part", "strengths": strengths(0.5) } });
    pull(&mut case);
    let probe = |side: f64, field: &str| json!({ "name": format!("{field} {side}"), "at": { "x": 7.5 * side, "y": 0.5 }, "field": field });
    case["probes"] = json!([
        probe(-1.0, "utilisation"),
        probe(1.0, "utilisation"),
        probe(-1.0, "hashin_fibre"),
        probe(1.0, "hashin_fibre"),
        probe(-1.0, "tsai_wu"),
        probe(1.0, "tsai_wu")
    ]);
    let [plain, weak, fibre, weak_fibre, wu, weak_wu] = probes::<6>(&case);
    // Utilisation grows with the stress, and along the fibres, as strong in compression, both criteria with its square.
    for (ratio, expected) in [(weak / plain, 2.0), (weak_fibre / fibre, 4.0), (weak_wu / wu, 4.0)] {
        assert!((ratio / expected - 1.0).abs() < 1e-11, "{ratio} for {expected}"); // 1e-14
    }
}

/// The smallest and the largest stress, and the mean one, under a stress of 100 on both sides of a plate with fibres at 30 degrees.
fn stretched(edges: &str, rows: &str, materials: &Value) -> [f64; 3] {
    let mut case = plate([40.0, 20.0], 30.0, 0.28);
    case["model"]["beam_bond_orthotropic"]["edges"] = json!(edges);
    case["model"]["beam_bond_orthotropic"]["lattice"] = json!(rows);
    case["regions"] = json!({ "disc": { "disc": { "centre": [0, 0], "radius": 5 } } });
    case["materials"] = materials.clone();
    // Points of both lattices: the one in the middle, and one that keeps its height.
    let (c, s) = if rows == "fibre" { (0.75_f64.sqrt(), 0.5) } else { (1.0, 0.0) };
    let at = |x: f64, y: f64| json!({ "x": c * x - s * y, "y": s * x + c * y });
    case["supports"] = json!([{ "at": at(0.5, 0.5), "ux": 0, "uy": 0 }, { "at": at(8.5, 0.5), "uy": 0 }]);
    pull(&mut case);
    let probe = |of: &str| json!({ "name": of, "field": "stress_xx", "of": of });
    case["probes"] = json!(["smallest", "largest", "mean"].map(probe));
    probes::<3>(&case)
}

#[test]
fn one_stress_stays_one_whatever_a_material_says() {
    let materials = [
        json!({ "all": { "stiffness_factor": 3 } }),
        json!({ "part": { "at": "disc", "thermal_expansion": 1e-5 } }),
    ];
    for (edges, rows) in [("border", "axes"), ("border", "fibre"), ("overlay", "axes"), ("overlay", "fibre")]
    {
        for given in &materials {
            let found = stretched(edges, rows, given);
            let off = found.map(|stress| (stress / 100.0 - 1.0).abs()).into_iter().fold(0.0, f64::max);
            assert!(off < 1e-11, "{edges} {rows} {given}: {found:?}"); // 1e-14
        }
        // The mean of a stress follows from the tractions, whatever is stiffer.
        let [_, largest, mean] =
            stretched(edges, rows, &json!({ "part": { "at": "disc", "stiffness_factor": 3 } }));
        assert!(largest > 130.0 && (mean / 100.0 - 1.0).abs() < 1e-3, "{edges} {rows}: {mean}"); // 4e-4
    }
}
