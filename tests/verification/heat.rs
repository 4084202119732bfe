//! Changes of temperature: strains without stress in free bodies, and stresses that closed forms know.

use crate::support::notched_block::hold_freely;
use peristat::Solved;
use serde_json::{Value, json};

const E: f64 = 2e5;
const ALPHA: f64 = 1.2e-5;
const CHANGE: f64 = 100.0;

/// Every model with what it is made of, by name.
fn models() -> Vec<(&'static str, Value)> {
    let plane = |state: &str| json!({ "youngs_modulus": E, "poisson_ratio": 0.3, "state": state });
    let central = |state: &str| json!({ "youngs_modulus": E, "state": state });
    let fibres = json!({
        "youngs_modulus_1": E, "youngs_modulus_2": E / 10.0, "poisson_ratio_12": 0.3, "shear_modulus_12": E / 20.0, "fibre_angle": 20
    });
    vec![
        ("bond_plane", json!({ "bond_plane": central("plane_stress") })),
        ("bond_plane, strain", json!({ "bond_plane": central("plane_strain") })),
        ("state_plane", json!({ "state_plane": plane("plane_stress") })),
        ("state_plane, strain", json!({ "state_plane": plane("plane_strain") })),
        ("axisymmetric", json!({ "axisymmetric": { "youngs_modulus": E, "poisson_ratio": 0.3 } })),
        ("beam_bond_orthotropic", json!({ "beam_bond_orthotropic": fibres })),
        ("bond_solid", json!({ "bond_solid": { "youngs_modulus": E } })),
        ("state_solid", json!({ "state_solid": { "youngs_modulus": E, "poisson_ratio": 0.3 } })),
    ]
}

/// A ragged body of a model, held so that nothing strains it, warmer everywhere.
fn free(name: &str, model: &Value) -> Value {
    let mut case = json!({
        "title": "free", "units": "mm-N-MPa", "model": model, "thermal_expansion": ALPHA,
        "loads": [ { "temperature": { "change": CHANGE } } ]
    });
    if name.contains("solid") {
        hold_freely(&mut case);
        return case;
    }
    // A section begins off its axis.
    let hole = json!({ "circle": { "name": "hole", "centre": [15, 5], "radius": 2.2 } });
    case["body"] =
        json!({ "rectangle": { "from": [5, 0], "size": [20, 10], "spacing": 1, "holes": [hole] } });
    case["supports"] = match name {
        "axisymmetric" => json!([ { "at": { "x": 5.5, "y": 0.5 }, "uy": 0 } ]),
        _ => {
            json!([ { "at": { "x": 5.5, "y": 0.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 24.5, "y": 0.5 }, "uy": 0 } ])
        }
    };
    case
}

/// The largest of some numbers that are not negative.
fn worst(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, f64::max)
}

fn solve(case: &Value) -> Solved {
    let solved = peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|error| panic!("{error}"));
    assert!(solved.summary.states.iter().all(|state| state.certificate.converged));
    solved
}

/// Largest magnitude of the fields whose names begin so, of the first state.
fn largest(solved: &Solved, of: &str) -> f64 {
    let fields = solved.fields(0).expect("a first state");
    worst(fields.iter().filter(|field| field.starts_with(of)).flat_map(|field| {
        solved
            .field(0, field)
            .expect("a field of this name")
            .iter()
            .map(|value| value.abs())
            .collect::<Vec<_>>()
    }))
}

/// Differences of the displacements along the first axis from those of a free body.
fn off(solved: &Solved, strain: f64) -> f64 {
    let (points, ux) = (solved.points(), solved.field(0, "ux").expect("a field of this name"));
    let straight = |k: usize| ux[k] - ux[0] - strain * (points[k][0] - points[0][0]);
    worst((0..ux.len()).filter(|&k| points[k][1] == points[0][1]).map(|k| straight(k).abs()))
}

#[test]
fn free_bodies_of_all_models_expand_without_stress() {
    for (name, model) in models() {
        let mut case = free(name, &model);
        // What is held across the plane has a stress there, and strains the plane.
        let strain = match name {
            "bond_plane, strain" => 1.25 * ALPHA * CHANGE,
            "state_plane, strain" => 1.3 * ALPHA * CHANGE,
            _ => ALPHA * CHANGE,
        };
        let solved = solve(&case);
        let unit = E * ALPHA * CHANGE;
        let stress = worst(["stress_xx", "stress_yy", "stress_xy"].map(|field| largest(&solved, field)));
        // 3e-15, of axisymmetric 1.6e-14 are found.
        assert!(stress < 5e-14 * unit, "{name}: {:e}", stress / unit);
        let across = if name.ends_with("strain") { unit } else { 0.0 };
        let found = match name.contains("plane") {
            true => largest(&solved, "stress_zz"),
            false => worst([largest(&solved, "stress_zz"), largest(&solved, "energy_density")]),
        };
        assert!((found - across).abs() < 5e-14 * unit, "{name}: {found:e}");
        // 3e-15 is found.
        assert!(off(&solved, strain) < 1e-13 * strain * 20.0, "{name}: {:e}", off(&solved, strain));
        assert_eq!(largest(&solved, "temperature"), CHANGE);
        // Along the fibres and across them, whatever the edges.
        if name == "beam_bond_orthotropic" {
            case["thermal_expansion"] = json!([-1e-6, 3e-5]);
            let stress = largest(&solve(&case), "stress");
            assert!(stress < 5e-14 * unit, "{name}, fibres: {:e}", stress / unit);
        }
    }
}

/// A cylinder widens with its bonds as chords, however coarse it is.
#[test]
fn a_quarter_of_a_tube_widens_without_stress() {
    let radius = 10.0;
    for cells in [4, 10] {
        let arc = 0.5 * std::f64::consts::PI * radius;
        let spacing = arc / f64::from(cells);
        let case = json!({
            "title": "tube", "units": "mm-N-MPa", "thermal_expansion": ALPHA,
            "model": { "shell_membrane": { "youngs_modulus": E, "thickness": 0.1, "radius": radius } },
            "body": { "rectangle": { "size": [8.0 * spacing, arc], "spacing": spacing } }, "symmetry": ["bottom", "top"],
            "supports": [ { "at": { "x": 0.5 * spacing, "y": 0.5 * spacing }, "ux": 0 } ],
            "loads": [ { "temperature": { "change": CHANGE } } ]
        });
        let solved = solve(&case);
        let stress = largest(&solved, "stress") / (E * ALPHA * CHANGE);
        // 3e-15 is found.
        assert!(stress < 5e-14, "{cells}: {stress:e}");
        let widening = solved.field(0, "w").expect("a field of this name");
        let error = worst(widening.iter().map(|w| (w / (radius * ALPHA * CHANGE) - 1.0).abs()));
        // 1.6e-12 is found.
        assert!(error < 5e-12, "{cells}: {error:e}");
    }
}

/// Bonds that edges lack have no share in the heat either.
#[test]
fn free_bodies_expand_without_stress_whatever_their_edges() {
    for (edges, calibration) in [
        ("none", "matched"),
        ("overlay", "matched"),
        ("volume", "published"),
        ("energy", "published"),
        ("none", "published"),
    ] {
        let model = json!({ "bond_plane": {
            "youngs_modulus": E, "state": "plane_stress", "edges": edges, "calibration": calibration } });
        let mut case = free("bond_plane", &model);
        case["cracks"] = json!([ { "name": "crack", "path": [[5, 5.2], [9, 5.8]] } ]);
        let solved = solve(&case);
        let stress = largest(&solved, "stress") / (E * ALPHA * CHANGE);
        // 2e-15 is found.
        assert!(stress < 2e-14, "{edges}, {calibration}: {stress:e}");
        let energy = solved.summary.states[0].certificate.energy;
        assert!(energy.abs() < 1e-11, "{edges}, {calibration}: {energy:e}");
    }
}

#[test]
fn bars_between_rigid_walls_are_pressed_by_what_they_cannot_expand() {
    for (name, model) in models() {
        let mut case = free(name, &model);
        // Fibres at an angle shear, and a section that is held along its radius is no bar.
        let (first, last) = match name {
            "beam_bond_orthotropic" => continue,
            "axisymmetric" => ("bottom", "top"),
            _ => ("left", "right"),
        };
        let mut supports = vec![];
        let (key, field) = if name == "axisymmetric" { ("uy", "stress_yy") } else { ("ux", "stress_xx") };
        for side in [first, last] {
            supports.push(json!({ "at": { "region": side }, key: 0 }));
        }
        match name {
            "axisymmetric" => {}
            _ if name.contains("solid") => {
                case["body"] = json!({ "block": { "size": [8, 5, 4], "spacing": 1 } });
                supports.push(json!({ "at": { "x": 0.5, "y": 0.5, "z": 0.5 }, "uy": 0, "uz": 0 }));
                supports.push(json!({ "at": { "x": 0.5, "y": 4.5, "z": 0.5 }, "uz": 0 }));
            }
            _ => supports.push(json!({ "at": { "x": 5.5, "y": 4.5 }, "uy": 0 })),
        }
        if !name.contains("solid") {
            case["body"] = json!({ "rectangle": { "from": [5, 0], "size": [20, 10], "spacing": 1 } });
        }
        for (key, edges) in [("state_plane", "border"), ("axisymmetric", "border")] {
            if name.starts_with(key) {
                case["model"][key]["edges"] = json!(edges);
            }
        }
        case["supports"] = json!(supports);
        let solved = solve(&case);
        let strain = match name {
            "bond_plane, strain" => ALPHA * CHANGE / 0.75,
            "state_plane, strain" => ALPHA * CHANGE / 0.7,
            _ => ALPHA * CHANGE,
        };
        let error = worst(
            solved
                .field(0, field)
                .expect("a field of this name")
                .iter()
                .map(|s| (s / (-E * strain) - 1.0).abs()),
        );
        // 3e-15 is found. Families of solids have no border, and sections of rings feel their corners: they do when they are pulled, too.
        let least = match name {
            "state_solid" => 6e-3,
            "axisymmetric" => 2e-3,
            _ => 1e-13,
        };
        assert!(error < least, "{name}: {error:e}");
    }
}

/// A hot disc in a cold ring: inside both stresses are −EαT/2 (1 − a²/b²) (Timoshenko and Goodier, Theory of Elasticity).
#[test]
fn a_hot_region_is_pressed_by_what_is_around_it() {
    let case = json!({
        "title": "hot core", "units": "mm-N-MPa", "thermal_expansion": ALPHA,
        "model": { "bond_plane": { "youngs_modulus": E, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [40, 40], "spacing": 0.5, "holes": [] } },
        "regions": { "core": { "disc": { "centre": [0, 0], "radius": 8 } } },
        "symmetry": ["left", "bottom"],
        "loads": [ { "temperature": { "change": CHANGE, "region": "core" } } ],
        "probes": [
            { "name": "core", "at": { "x": 0.25, "y": 0.25 }, "field": "stress_xx" },
            { "name": "temperature outside", "at": { "x": 20.25, "y": 0.25 }, "field": "temperature" }
        ]
    });
    let solved = solve(&case);
    let core = solved.summary.probes[0].value;
    // A square of half sides b has the stiffness of a round plate of 1.13 b nearly.
    let expected = -0.5 * E * ALPHA * CHANGE * (1.0 - 64.0 / (1600.0 * 4.0 / std::f64::consts::PI));
    assert!((core / expected - 1.0).abs() < 0.01, "{core} {expected}");
    assert_eq!(solved.summary.probes[1].value, 0.0);
}

/// What acts at once adds up, and steps and combinations scale heat as they scale loads.
#[test]
fn heat_adds_up_with_loads_by_states() {
    let (_, model) = models().swap_remove(0);
    let mut case = free("bond_plane", &model);
    case["regions"]["upper half"] = json!({ "half_plane": { "point": [0, 1], "normal": [0, 1] } });
    let heat = json!({ "temperature": { "change": "10*y", "region": "upper half" } });
    let weight = json!({ "body_force": { "density": [0, -1] } });
    let of = |case: &Value| {
        let solved = solve(case);
        (0..solved.states.len())
            .map(|state| solved.field(state, "stress_yy").expect("a field of this name").to_vec())
            .collect::<Vec<_>>()
    };
    case["loads"] = json!([heat, heat, weight]);
    let together = of(&case).remove(0);
    case["steps"] = json!({ "load_factors": [0.5] });
    let half = of(&case).remove(0);
    case.as_object_mut().unwrap().remove("steps");
    case.as_object_mut().unwrap().remove("loads");
    case["load_cases"] =
        json!([ { "name": "heat", "loads": [heat] }, { "name": "weight", "loads": [weight] } ]);
    case["combinations"] = json!([ { "name": "both", "factors": { "heat": 2, "weight": 1 } } ]);
    let both = of(&case).remove(2);
    let size = worst(together.iter().map(|s| s.abs()));
    let error = worst(
        together.iter().zip(&both).zip(&half).map(|((t, b), h)| (t - b).abs().max((t - 2.0 * h).abs())),
    );
    assert!(size > 1.0 && error < 1e-12 * size, "{error:e} of {size}");
}

/// Between two mirrors a body is a bar between rigid walls; a mirror through the middle of a free one takes nothing.
#[test]
fn mirrors_take_what_presses_them_and_nothing_of_the_heat_itself() {
    for (name, model) in models() {
        if name == "beam_bond_orthotropic" || name == "axisymmetric" {
            continue;
        }
        let is_solid = name.contains("solid");
        let mut case = free(name, &model);
        case["body"] = match is_solid {
            true => json!({ "block": { "size": [8, 5, 4], "spacing": 1 } }),
            false => json!({ "rectangle": { "size": [20, 10], "spacing": 1 } }),
        };
        case["symmetry"] =
            if is_solid { json!(["left", "bottom", "front"]) } else { json!(["left", "bottom"]) };
        case["supports"] = json!([]);
        let area = if is_solid { 20.0 } else { 10.0 };
        let of = |case: &Value| {
            let solved = solve(case);
            let resultants = solved.summary.states[0].certificate.resultants.clone().unwrap();
            assert!(resultants.difference < 1e-10, "{name}: {:e}", resultants.difference);
            match solved.states.into_iter().next() {
                Some(peristat::run::StateResult::Body(result)) => {
                    result.mirrors.iter().map(|m| m.force).collect::<Vec<_>>()
                }
                _ => panic!("a body"),
            }
        };
        let unit = E * ALPHA * CHANGE * area;
        let forces = of(&case);
        // 1e-13 is found.
        assert!(forces.iter().all(|f| f.abs() < 1e-11 * unit), "{name}: {forces:?}");
        case["symmetry"] = if is_solid {
            json!(["left", "right", "bottom", "front"])
        } else {
            json!(["left", "right", "bottom"])
        };
        let strain = match name {
            "bond_plane, strain" => 1.0 / 0.75,
            "state_plane, strain" => 1.0 / 0.7,
            _ => 1.0,
        };
        let forces = of(&case);
        // 2e-15 is found; families beside mirrors and free faces are 3e-5 off.
        let least = if name.starts_with("state") { 1e-4 } else { 1e-12 };
        assert!(
            (forces[0] / (strain * unit) - 1.0).abs() < least
                && (forces[1] / (strain * unit) + 1.0).abs() < least,
            "{name}: {forces:?} of {unit}"
        );
    }
}

/// A strip of two layers, heated: the curvature over that of Timoshenko (Analysis of bi-metal thermostats, 1925), less one.
fn bimetal(ratio: f64, rows: u32) -> f64 {
    let (h, length) = (1.0 / f64::from(rows), 4.0);
    let (alpha, other) = (1e-5, 3e-5);
    let probe = |name: &str, x: f64| json!({ "name": name, "at": { "x": x, "y": 0.5 * h }, "field": "uy" });
    let x = [0.5 * h, 0.5 + 0.5 * h];
    let case = json!({
        "title": "bimetal", "units": "none", "thermal_expansion": alpha,
        "model": { "bond_plane": { "youngs_modulus": 1.0, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [length, 1], "spacing": h } }, "symmetry": ["left"],
        "regions": { "upper": { "box": { "from": [0, 0.5], "to": [length, 1] } } },
        "materials": { "upper": { "at": "upper", "youngs_modulus": ratio, "thermal_expansion": other } },
        "supports": [ { "at": { "x": x[0], "y": 0.5 * h }, "uy": 0 } ],
        "loads": [ { "temperature": { "change": CHANGE } } ], "probes": [probe("from", x[0]), probe("to", x[1])]
    });
    let solved = solve(&case);
    let drop = solved.summary.probes[0].value - solved.summary.probes[1].value;
    let curvature = 2.0 * drop / (x[1] * x[1] - x[0] * x[0]);
    let n = 1.0 / ratio;
    let expected = 6.0 * (other - alpha) * CHANGE * 4.0 / (12.0 + (1.0 + n) * (1.0 + 1.0 / n));
    curvature / expected - 1.0
}

#[test]
fn a_bimetal_strip_bends_as_timoshenko_says() {
    for (ratio, found, order) in [(2.0, 4.6e-4, 1.8), (10.0, 2.2e-3, 1.6), (100.0, 5.2e-3, 1.6)] {
        let errors = [8, 16, 32].map(|rows| bimetal(ratio, rows));
        // 4.5e-4, 2.1e-3, 5.1e-3 are found at 32 rows, with the orders 1.84, 1.68, 1.71 before.
        assert!(errors[2].abs() < found, "{ratio}: {errors:?}");
        let seen = (errors[0] / errors[1].abs()).log2();
        assert!(seen > order, "{ratio}: {errors:?}, order {seen}");
    }
}

/// Materials of one expansion stay free of stress together, whatever their moduli and whatever crosses between them.
#[test]
fn two_materials_of_one_expansion_expand_without_stress() {
    for name in [
        "bond_plane",
        "bond_plane, strain",
        "bond_solid",
        "state_solid",
        "state_plane",
        "state_plane, strain",
        "axisymmetric",
    ] {
        let (_, model) = models().into_iter().find(|(own, _)| *own == name).unwrap();
        let mut case = free(name, &model);
        case["regions"] = match name.contains("solid") {
            true => json!({ "stiff": { "box": { "from": [0, 0, 0], "to": [4, 5, 4] } } }),
            false => json!({ "stiff": { "box": { "from": [5, 0], "to": [13, 10] } } }),
        };
        case["materials"] = json!({ "stiff": { "at": "stiff", "youngs_modulus": 10.0 * E } });
        let solved = solve(&case);
        let unit = 10.0 * E * ALPHA * CHANGE;
        let stress = worst(["stress_xx", "stress_yy", "stress_xy"].map(|field| largest(&solved, field)));
        // 3e-15 is found.
        assert!(stress < 5e-14 * unit, "{name}: {:e}", stress / unit);
    }
}
