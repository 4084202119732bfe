//! Displacements that are corrected until they are those of local elasticity: against closed forms that no fit knows.

use peristat::Solved;
use peristat::run::StateResult;
use serde_json::{Value, json};
use std::f64::consts::FRAC_PI_2;

const MODULUS: f64 = 70_000.0;

fn solve(case: &Value) -> Solved {
    let solved = peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|error| panic!("{error}: {case}"));
    assert!(solved.summary.states.iter().all(|state| state.certificate.converged));
    solved
}

fn probe(solved: &Solved, name: &str) -> f64 {
    solved.summary.probes.iter().find(|probe| probe.name == name).map_or(f64::NAN, |probe| probe.value)
}

/// The same with corrections.
fn corrected(case: &Value, corrections: usize) -> Value {
    let mut case = case.clone();
    (case["limit"], case["corrections"]) = (json!("local"), json!(corrections));
    case
}

/// A strip of 81 × 21 with so many rows that points hold, ν = 1/3.
fn strip(rows: u32, loads: &Value) -> Value {
    json!({
        "title": "strip", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [81, 21], "spacing": 21.0 / f64::from(rows) } },
        "supports": [
            { "at": { "x": 40.5, "y": 10.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 67.5, "y": 10.5 }, "uy": 0 }],
        "loads": loads
    })
}

/// A cantilever under a shear force of 1000 at the right end, whose stresses are those of the beam.
fn cantilever(rows: u32) -> Value {
    let inertia = 21_f64.powi(3) / 12.0;
    let (shear, moment) = (1000.0 / (2.0 * inertia) * 10.5 * 10.5, 1000.0 * 81.0 * 10.5 / inertia);
    strip(
        rows,
        &json!([
            { "traction": { "edge": "right", "parabolic": [0, shear] } },
            { "traction": { "edge": "left", "parabolic": [0, -shear] } },
            { "traction": { "edge": "left", "linear": [[-moment, 0], [moment, 0]] } }]),
    )
}

/// Its displacement, zero where the strip is held.
fn bent([x, y]: [f64; 2], nu: f64) -> [f64; 2] {
    let [first, second] = [40.5, 67.5].map(|x| free([x, 10.5], nu));
    let turn = (second[1] - first[1]) / 27.0;
    let [u, v] = free([x, y], nu);
    [u - first[0] + turn * (y - 10.5), v - first[1] - turn * (x - 40.5)]
}

/// The same but for a rigid motion.
fn free([x, y]: [f64; 2], nu: f64) -> [f64; 2] {
    let (y, rest, c, inertia) = (y - 10.5, 81.0 - x, 10.5, 21_f64.powi(3) / 12.0);
    let (bending, shear) = (1000.0 / (MODULUS * inertia), 1000.0 * (1.0 + nu) / (MODULUS * inertia));
    let u = -bending * (x * (81.0 - 0.5 * x) * y - nu * y.powi(3) / 6.0) - shear * y.powi(3) / 3.0;
    let v = bending * (0.5 * nu * rest * y * y + x * x * (40.5 - x / 6.0)) + shear * c * c * x;
    [u, v]
}

/// φ = e^z, ψ = sin(2z + 0.3) with z = s (x + i (y − 10.5)), as displacement and as formulas of σ_xx, σ_yy, σ_xy.
fn transcendental([x, y]: [f64; 2]) -> [f64; 2] {
    let s = 3.0 / 81.0;
    let (a, b) = (s * x, s * (y - 10.5));
    // conj(sin(2z + 0.3)) and e^z.
    let sine = [(2.0 * a + 0.3).sin() * (2.0 * b).cosh(), -(2.0 * a + 0.3).cos() * (2.0 * b).sinh()];
    let (e, f) = (a.exp() * b.cos(), a.exp() * b.sin());
    // 2G u = κ φ − z conj(φ') − conj(ψ) with κ = 2.
    let unit = 1.0 / (0.75 * MODULUS * s);
    [unit * (2.0 * e - (a * e + b * f) - sine[0]), unit * (2.0 * f - (b * e - a * f) - sine[1])]
}

fn tractions_of_transcendental() -> Value {
    let (x, y) = ("(x*3/81)", "((y-10.5)*3/81)");
    let sum = format!("4*exp({x})*cos({y})");
    let cosh = format!("(exp(2*{y})+exp(-2*{y}))/2");
    let sinh = format!("(exp(2*{y})-exp(-2*{y}))/2");
    let real = format!("2*(exp({x})*({x}*cos({y})+{y}*sin({y}))+2*cos(2*{x}+0.3)*{cosh})");
    let imaginary = format!("2*(exp({x})*({x}*sin({y})-{y}*cos({y}))-2*sin(2*{x}+0.3)*{sinh})");
    let xx = format!("({sum}-({real}))/2");
    let yy = format!("({sum}+({real}))/2");
    let xy = format!("({imaginary})/2");
    let minus = |text: &str| format!("-({text})");
    json!([
        { "traction": { "edge": "left", "formula": [minus(&xx), minus(&xy)] } },
        { "traction": { "edge": "right", "formula": [xx, xy] } },
        { "traction": { "edge": "bottom", "formula": [minus(&xy), minus(&yy)] } },
        { "traction": { "edge": "top", "formula": [xy, yy] } }])
}

/// The largest difference of the displacements from exact ones, rigid motions aside, over the largest of these.
fn error(solved: &Solved, exact: &dyn Fn([f64; 2]) -> [f64; 2]) -> f64 {
    let points = solved.points();
    let planes = ["ux", "uy"].map(|name| solved.field(0, name).expect("displacements").into_owned());
    let held = [[40.5, 10.5], [67.5, 10.5]].map(|[x, y]| {
        let far = |p: &[f64; 3]| (p[0] - x).hypot(p[1] - y);
        (0..points.len()).min_by(|a, b| far(&points[*a]).total_cmp(&far(&points[*b]))).expect("points")
    });
    let off = |p: usize| {
        let u = exact([points[p][0], points[p][1]]);
        [planes[0][p] - u[0], planes[1][p] - u[1]]
    };
    // The rigid motion that takes the held points back.
    let [first, second] = held.map(off);
    let turn = (second[1] - first[1]) / (points[held[1]][0] - points[held[0]][0]);
    let centre = points[held[0]];
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    for (p, at) in points.iter().enumerate() {
        let ([x, y], u) = (off(p), exact([at[0], at[1]]));
        let moved = [first[0] - turn * (at[1] - centre[1]), first[1] + turn * (at[0] - centre[0])];
        worst = worst.max((x - moved[0]).abs()).max((y - moved[1]).abs());
        largest = largest.max(u[0].abs()).max(u[1].abs());
    }
    worst / largest
}

fn sizes(solved: &Solved) -> Vec<f64> {
    match solved.states.first() {
        Some(StateResult::Body(result)) => result.corrections.clone().map_or(Vec::new(), |done| done.sizes),
        _ => Vec::new(),
    }
}

#[test]
fn corrections_lead_to_the_cantilever_of_local_elasticity() {
    // Found: 1.34e-3 without, then 1.13e-4, 1.72e-5, 3.3e-6 and 9.0e-7.
    for (corrections, most) in [(1, 1.4e-4), (2, 2.1e-5), (3, 4e-6), (4, 1.1e-6)] {
        let solved = solve(&corrected(&cantilever(21), corrections));
        let found = error(&solved, &|at| bent(at, 1.0 / 3.0));
        assert!(found < most, "{corrections}: {found:e}");
        let last = sizes(&solved).pop().unwrap();
        assert!(found < last, "the last correction, {last:e}, is larger than the error, {found:e}");
    }
    let without = error(&solve(&cantilever(21)), &|at| bent(at, 1.0 / 3.0));
    assert!((1.2e-3..1.5e-3).contains(&without), "{without:e}");
}

#[test]
fn corrections_lead_to_a_field_that_no_polynomial_is() {
    let case = strip(21, &tractions_of_transcendental());
    // Found: 2.0e-4, 3.9e-5, 9.6e-6.
    for (corrections, most) in [(1, 2.4e-4), (2, 4.8e-5), (3, 1.2e-5)] {
        let found = error(&solve(&corrected(&case, corrections)), &transcendental);
        assert!(found < most, "{corrections}: {found:e}");
    }
}

/// In plane strain E and ν are E/(1 − ν²) = 16/15 E and ν/(1 − ν) = 1/3, and horizons of three spacings change nothing.
#[test]
fn corrections_know_plane_strain_and_longer_bonds() {
    // Found: 1.7e-5 and 1.2e-5.
    for (state, unit, ratio) in [("plane_strain", 15.0 / 16.0, 2), ("plane_stress", 1.0, 3)] {
        let mut case = corrected(&cantilever(21), 2);
        case["model"]["bond_plane"]["state"] = json!(state);
        case["horizon_ratio"] = json!(ratio);
        let found = error(&solve(&case), &|at| bent(at, 1.0 / 3.0).map(|u| unit * u));
        assert!(found < 2.1e-5, "{state} {ratio}: {found:e}");
    }
}

/// What solves does not matter: a factor, or cycles that are exact to ten digits at the start and six of every correction.
#[test]
fn a_factor_and_cycles_find_the_same() {
    let fields = ["sparse", "multigrid"].map(|solver| {
        let mut case = corrected(&cantilever(42), 2);
        case["solver"] = json!(solver);
        solve(&case).field(0, "uy").expect("displacements").into_owned()
    });
    // Found: 7e-11.
    let size = fields[0].iter().fold(0.0_f64, |most, u| most.max(u.abs()));
    let worst = fields[0].iter().zip(&fields[1]).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    assert!(worst < 1e-8 * size, "{:e}", worst / size);
}

/// σ_xx = 12 at the lower edge of a strip that hangs from its upper one under its weight: polynomials of the second degree.
#[test]
fn weight_is_balanced() {
    let case = json!({
        "title": "strip", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [12, 30], "spacing": 1, "holes": [] } },
        "supports": [{ "at": { "x": 5.5, "y": 0.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 5.5, "y": 29.5 }, "ux": 0 }],
        "loads": [
            { "body_force": { "density": [0, -2] } },
            { "traction": { "edge": "top", "uniform": [0, 60] } }],
        "probes": [
            { "name": "top", "at": { "x": 3, "y": 30 }, "field": "stress_yy" },
            { "name": "bottom", "at": { "x": 3, "y": 0 }, "field": "stress_yy" },
            { "name": "longer", "at": { "x": 6, "y": 30 }, "field": "uy" },
            { "name": "start", "at": { "x": 6, "y": 0 }, "field": "uy" }]
    });
    let solved = solve(&corrected(&case, 3));
    let longer = probe(&solved, "longer") - probe(&solved, "start");
    // Found: 1.3e-6.
    assert!((probe(&solved, "top") / 60.0 - 1.0).abs() < 5e-6);
    assert!(probe(&solved, "bottom").abs() < 1e-5 * 60.0);
    // ∫ 2 y/E dy.
    assert!((longer / (900.0 / MODULUS) - 1.0).abs() < 1e-6);
}

/// A quarter of a strip of half width 80 with a hole of radius 20, by points per radius; Howland has 3.2481.
#[test]
fn the_peak_at_a_hole_is_that_of_howland() {
    // Found: −6e-5 and −1.2e-5 after one correction, −3.0e-3 and −6e-4 without.
    for (spacing, most) in [(2.0, 2e-4), (1.0, 1e-4)] {
        let case = json!({
            "title": "hole", "units": "mm-N-MPa",
            "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [200, 80], "spacing": spacing,
                "holes": [{ "circle": { "name": "hole", "centre": [0, 0], "radius": 20 } }] } },
            "symmetry": ["left", "bottom"],
            "loads": [{ "traction": { "edge": "right", "uniform": [100, 0] } }],
            "probes": [{ "name": "peak", "at": { "x": 0, "y": 20 }, "field": "stress_xx" }]
        });
        let found = probe(&solve(&corrected(&case, 1)), "peak") / 324.81 - 1.0;
        assert!(found.abs() < most, "{spacing}: {found}");
    }
}

/// A semicircular notch of radius 20 in the edge of a strip of 120 × 60; curved biquadratic elements find 5.473 at its root.
#[test]
fn the_peak_at_a_notch_is_that_of_finite_elements() {
    // Found: −9e-4 and −5e-6; the finite elements are known to 3e-4.
    for (spacing, most) in [(2.0, 2e-3), (1.0, 4e-4)] {
        let case = json!({
            "title": "notch", "units": "mm-N-MPa",
            "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [120, 60], "spacing": spacing,
                "holes": [{ "circle": { "name": "notch", "centre": [60, 0], "radius": 20 } }] } },
            "supports": [
                { "at": { "x": 0.5 * spacing, "y": 30.0 + 0.5 * spacing }, "ux": 0, "uy": 0 },
                { "at": { "x": 120.0 - 0.5 * spacing, "y": 30.0 + 0.5 * spacing }, "uy": 0 }],
            "loads": [
                { "traction": { "edge": "right", "uniform": [100, 0] } },
                { "traction": { "edge": "left", "uniform": [-100, 0] } }],
            "probes": [{ "name": "peak", "at": { "x": 60, "y": 20 }, "field": "stress_xx" }]
        });
        let found = probe(&solve(&corrected(&case, 2)), "peak") / 547.3 - 1.0;
        assert!(found.abs() < most, "{spacing}: {found}");
    }
}

/// A quarter of a ring with a pressure inside, whose outer border are chords: Lamé's displacement and stress.
#[test]
fn a_ring_under_pressure_is_that_of_lame() {
    let turn = |k: i32| (f64::from(k) * FRAC_PI_2 / 360.0).sin_cos();
    let arc = (0..=360).map(|k| [20.0 * turn(k).1, 20.0 * turn(k).0].map(|x| (1e9 * x).round() / 1e9));
    let vertices: Vec<[f64; 2]> = [[0.0; 2]].into_iter().chain(arc).collect();
    let case = json!({
        "title": "ring", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
        "body": { "outline": { "vertices": vertices, "spacing": 0.625,
            "holes": [{ "circle": { "name": "bore", "centre": [0, 0], "radius": 10 } }] } },
        "symmetry": ["left", "bottom"],
        "loads": [{ "traction": { "edge": "bore", "pressure": 100 } }],
        "probes": [
            { "name": "hoop", "at": { "x": 0, "y": 10 }, "field": "stress_xx" },
            { "name": "outer", "at": { "x": 0, "y": 20 }, "field": "stress_xx" },
            { "name": "wider", "at": { "x": 6, "y": 8 }, "field": "uy" }]
    });
    let solved = solve(&corrected(&case, 2));
    // A = p a²/(b² − a²), B = A b²; u_r = ((1 − ν) A r + (1 + ν) B/r)/E.
    let (a, b) = (100.0 / 3.0, 400.0 * 100.0 / 3.0);
    let wider = 0.8 * (2.0 / 3.0 * a * 10.0 + 4.0 / 3.0 * b / 10.0) / MODULUS;
    for (name, expected, most) in
        [("hoop", a + b / 100.0, 3e-3), ("outer", 2.0 * a, 3e-3), ("wider", wider, 1e-3)]
    {
        let found = probe(&solved, name) / expected - 1.0;
        assert!(found.abs() < most, "{name}: {found}");
    }
}

/// An edge that is held takes what statics asks, and leaves the stress of a strip that is free to contract.
#[test]
fn held_edges_take_the_loads_alone() {
    let case = json!({
        "title": "strip", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [40, 20], "spacing": 1 } },
        "supports": [{ "at": { "region": "left" }, "ux": 0 }, { "at": { "x": 0.5, "y": 10.5 }, "uy": 0 }],
        "loads": [{ "traction": { "edge": "right", "linear": [[0, 0], [100, 0]] } }],
        "probes": [
            { "name": "reaction", "at": { "region": "left" }, "field": "reaction_x" },
            { "name": "top", "at": { "x": 0, "y": 20 }, "field": "stress_xx" },
            { "name": "middle", "at": { "x": 20, "y": 20 }, "field": "stress_xx" }]
    });
    let solved = solve(&corrected(&case, 3));
    assert!((probe(&solved, "reaction") / -1000.0 - 1.0).abs() < 1e-9);
    // The stress of the traction is that of the whole strip.
    // Found: −2.5e-5 in the corner, 3e-7.
    assert!((probe(&solved, "top") / 100.0 - 1.0).abs() < 1e-4, "{}", probe(&solved, "top"));
    assert!((probe(&solved, "middle") / 100.0 - 1.0).abs() < 2e-6);
}

#[test]
fn combinations_are_the_sums_of_their_load_cases() {
    // On seven rows the tension, which is exact, goes on, and the other load stalls.
    let mut case = strip(7, &json!([]));
    let tension = json!([
        { "traction": { "edge": "right", "uniform": [100, 0] } }, { "traction": { "edge": "left", "uniform": [-100, 0] } }]);
    let bending = cantilever(7)["loads"].clone();
    let other = tractions_of_transcendental();
    case["load_cases"] = json!([
        { "name": "tension", "loads": tension }, { "name": "bending", "loads": bending },
        { "name": "other", "loads": other }]);
    case["combinations"] = json!([
        { "name": "all", "factors": { "tension": 1, "bending": -2, "other": 3 } }]);
    let solved = solve(&corrected(&case, 4));
    for field in ["ux", "uy", "stress_xx"] {
        let [a, b, c, all] =
            [0, 1, 2, 3].map(|state| solved.field(state, field).expect("a field").into_owned());
        let size = all.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        for p in 0..all.len() {
            let off = all[p] - (a[p] - 2.0 * b[p] + 3.0 * c[p]);
            assert!(off.abs() < 1e-8 * size, "{field}: {:e}", off / size);
        }
    }
}

#[test]
fn rollers_that_meet_free_edges_at_wide_angles_are_refused() {
    // The left edge moves along itself alone; the other one rises from its end.
    let refused = |height: f64| {
        let case = json!({
            "title": "wedge", "units": "mm-N-MPa",
            "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
            "body": { "outline": { "vertices": [[0, 0], [20, 0], [20, height], [0, 10]], "spacing": 1 } },
            "supports": [{ "at": { "region": "edge_4" }, "ux": 0 }, { "at": { "x": 0.5, "y": 0.5 }, "uy": 0 }],
            "loads": [{ "traction": { "edge": "edge_2", "uniform": [1, 0] } }],
            "limit": "local"
        });
        peristat::solve_text(&format!("{case:#}"))
            .is_err_and(|error| error.to_string().contains("stresses are infinite"))
    };
    // 90°, 79° and 117°.
    assert_eq!([10.0, 6.0, 20.0].map(refused), [false, false, true]);
}

/// A strip of fibres at 30 degrees between linear pulls: `φ = −S₁₁ k x − ½ S₁₆ k y` and a rotation of the whole, k the slope of the
/// stress. Without corrections φ half a spacing from the edge is 6 % off.
#[test]
fn rotations_are_those_of_local_elasticity() {
    let case = json!({
        "title": "bent fibres", "units": "mm-N-MPa", "limit": "local",
        "model": { "beam_bond_orthotropic": { "youngs_modulus_1": 140000, "youngs_modulus_2": 10000, "poisson_ratio_12": 0.25,
            "shear_modulus_12": 2930, "fibre_angle": 30 } },
        "body": { "rectangle": { "size": [60, 20], "spacing": 1 } },
        "supports": [ { "at": { "x": 30.5, "y": 10.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 29.5, "y": 10.5 }, "uy": 0 } ],
        "loads": [ { "traction": { "edge": "right", "linear": [[-10, 0], [10, 0]] } },
                   { "traction": { "edge": "left", "linear": [[10, 0], [-10, 0]] } } ],
        "probes": [ { "name": "middle", "at": { "x": 45.5, "y": 10.5 }, "field": "phi" },
                    { "name": "top", "at": { "x": 45.5, "y": 19.5 }, "field": "phi" },
                    { "name": "most", "field": "phi", "of": "largest" } ]
    });
    let (c, s) = (3.0_f64.sqrt() / 2.0, 0.5);
    let [s11, s22, s12, s66] = [1.0 / 140_000.0, 1e-4, -0.25 / 140_000.0, 1.0 / 2930.0];
    let s16 = (2.0 * (s11 - s12) - s66) * c * c * c * s - (2.0 * (s22 - s12) - s66) * c * s * s * s;
    let solved = solve(&case);
    let found = probe(&solved, "top") - probe(&solved, "middle");
    let expected = -0.5 * s16 * 9.0;
    // Found: 7e-4.
    assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
    // What points have is what probes find there: in the corner at (0.5, 19.5).
    let mut there = case.clone();
    there["probes"][0]["at"] = json!({ "x": 0.5, "y": 19.5 });
    let there = solve(&there);
    assert!((probe(&there, "middle") / probe(&there, "most") - 1.0).abs() < 1e-9);
}
