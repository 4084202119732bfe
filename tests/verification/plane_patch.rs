//! Patch tests of bodies in the plane through the whole program: uniform strains and rigid motions are exact at every point,
//! at edges, around holes and in sharp corners, for every horizon and in any units.

use crate::support::largest;
use crate::support::plane::{PlaneRun, solve};
use peristat::case::FieldName;
use serde_json::{Value, json};

/// Horizons over spacing.
pub(crate) const RATIOS: [f64; 5] = [2.0, 3.0, 3.015, 4.0, 6.0];
/// Units of length, m, and of stress, Pa: mm and MPa as numbers, m and Pa as numbers of a body of the same size.
pub(crate) const UNITS: [[f64; 2]; 2] = [[1.0, 1.0], [1e-3, 1e6]];
/// What rounding may do; 3e-14 is found at most.
pub(crate) const EXACT: f64 = 1e-12;
/// Relative stresses `[σ_xx, σ_yy, σ_xy]`.
pub(crate) const STRESSES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// MPa.
pub(crate) const MODULUS: f64 = 70_000.0;

/// Outlines, mm: a rectangle, an angle with a re-entrant corner, a wedge with a sharp tip.
const OUTLINES: [&[[f64; 2]]; 3] = [
    &[[0.0, 0.0], [24.0, 0.0], [24.0, 16.0], [0.0, 16.0]],
    &[[0.0, 0.0], [26.0, 0.0], [26.0, 10.0], [11.0, 10.0], [11.0, 22.0], [0.0, 22.0]],
    &[[0.0, 0.0], [36.0, 0.0], [30.0, 14.0], [7.0, 19.0]],
];

fn body(vertices: &[[f64; 2]], state: &str, ratio: f64, [length, stress]: [f64; 2]) -> Value {
    let vertices: Vec<[f64; 2]> = vertices.iter().map(|v| v.map(|x| x * length)).collect();
    json!({
        "title": "patch",
        "model": { "bond_plane": { "youngs_modulus": MODULUS * stress, "state": state } },
        "body": { "outline": { "vertices": vertices, "spacing": length } },
        "horizon_ratio": ratio, "solver": "sparse"
    })
}

fn poisson_ratio(state: &str) -> f64 {
    if state == "plane_stress" { 1.0 / 3.0 } else { 0.25 }
}

/// Displacement gradient of a stress over E without rotation.
pub(crate) fn gradient(state: &str, [x, y, shear]: [f64; 3]) -> [[f64; 2]; 2] {
    let nu = poisson_ratio(state);
    // Plane strain is plane stress with other constants.
    let (e, nu) = if state == "plane_stress" { (1.0, nu) } else { (1.0 / (1.0 - nu * nu), nu / (1.0 - nu)) };
    let half = (1.0 + nu) / e * shear;
    [[(x - nu * y) / e, half], [half, (y - nu * x) / e]]
}

pub(crate) fn linear(g: [[f64; 2]; 2], origin: [f64; 2]) -> impl Fn([f64; 2]) -> [f64; 2] {
    move |at| g.map(|row| row[0] * (at[0] - origin[0]) + row[1] * (at[1] - origin[1]))
}

/// Tractions of a stress on all edges of a polygon in counter-clockwise order.
fn tractions(vertices: &[[f64; 2]], [x, y, shear]: [f64; 3]) -> Value {
    let on = |k: usize| {
        let (a, b) = (vertices[k], vertices[(k + 1) % vertices.len()]);
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let n = [(b[1] - a[1]) / length, (a[0] - b[0]) / length];
        let t = [x * n[0] + shear * n[1], shear * n[0] + y * n[1]];
        let load = json!({ "traction": { "edge": format!("edge_{}", k + 1), "uniform": t } });
        (t != [0.0; 2]).then_some(load)
    };
    (0..vertices.len()).filter_map(on).collect()
}

/// Holds what is left of a plate, three components of two points, at this displacement.
pub(crate) fn held(places: [[f64; 2]; 2], u: impl Fn([f64; 2]) -> [f64; 2]) -> Value {
    let [first, second] = places.map(&u);
    json!([
        { "at": { "x": places[0][0], "y": places[0][1] }, "ux": first[0], "uy": first[1] },
        { "at": { "x": places[1][0], "y": places[1][1] }, "uy": second[1] }
    ])
}

/// Stresses and energy densities of a uniform stress at every point, relative to their sizes.
pub(crate) fn check_fields(run: &PlaneRun, state: usize, expected: [f64; 3], tolerance: f64, name: &str) {
    let fields = [FieldName::StressXx, FieldName::StressYy, FieldName::StressXy];
    let size = largest(&expected);
    for (field, expected) in fields.into_iter().zip(expected) {
        for (p, found) in run.field(state, field).into_iter().enumerate() {
            let at = run.scene.body().position(p);
            assert!((found - expected).abs() <= tolerance * size, "{name}: {field:?} at {at:?} is {found}");
        }
    }
    let energy = run.field(state, FieldName::EnergyDensity);
    let strains =
        [FieldName::StrainXx, FieldName::StrainYy, FieldName::StrainXy].map(|f| run.field(state, f)[0]);
    let whole = 0.5 * (strains[0] * expected[0] + strains[1] * expected[1]) + strains[2] * expected[2];
    let worst = energy.iter().map(|e| (e - whole).abs()).fold(0.0, f64::max);
    assert!(worst <= tolerance * whole, "{name}: energy density off by {worst} of {whole}");
}

#[test]
fn tractions_of_a_uniform_stress_are_exact_at_every_point() {
    for (vertices, state) in OUTLINES.into_iter().zip(["plane_stress", "plane_strain", "plane_stress"]) {
        for (ratio, units) in RATIOS.iter().flat_map(|m| UNITS.map(|u| (*m, u))) {
            let [length, stress] = units;
            let mut case = body(vertices, state, ratio, units);
            let places = [[0.5, 0.5], [9.5, 0.5]].map(|p| p.map(|x| x * length));
            case["supports"] = held(places, |_| [0.0; 2]);
            let loads = |k: usize| {
                let s = STRESSES[k].map(|s| 100.0 * s * stress);
                json!({ "name": k.to_string(), "loads": tractions(vertices, s) })
            };
            case["load_cases"] = (0..3).map(loads).collect();
            let run = solve(&case);
            for (k, relative) in STRESSES.into_iter().enumerate() {
                let name = format!("{state}, m = {ratio}, {units:?}, {relative:?}");
                let s = relative.map(|s| 100.0 * s * stress);
                check_fields(&run, k, s, EXACT, &name);
                // The second place keeps its height: the body turns.
                let mut g = gradient(state, relative.map(|s| 100.0 / MODULUS * s));
                let turn = g[1][0];
                (g[1][0], g[0][1]) = (g[1][0] - turn, g[0][1] + turn);
                let error = run.error(k, linear(g, places[0]));
                assert!(error <= EXACT, "{name}: displacement {error}");
            }
        }
    }
}

#[test]
fn rigid_motions_strain_nothing() {
    let gradients = [[[0.0; 2]; 2], [[0.0; 2]; 2], [[0.0, -1e-3], [1e-3, 0.0]]];
    let moves = [[1e-3, 0.0], [0.0, -2e-3], [0.0, 0.0]];
    for (vertices, ratio) in OUTLINES.into_iter().flat_map(|v| RATIOS.map(|m| (v, m))) {
        for (units, (g, by)) in UNITS.iter().flat_map(|u| gradients.into_iter().zip(moves).map(|m| (*u, m))) {
            let [length, stress] = units;
            let mut case = body(vertices, "plane_stress", ratio, units);
            let exact = |at: [f64; 2]| {
                let u = linear(g, [0.0; 2])(at);
                [0, 1].map(|k| u[k] + by[k] * length)
            };
            case["supports"] = held([[0.5, 0.5], [9.5, 0.5]].map(|p| p.map(|x| x * length)), exact);
            let run = solve(&case);
            let error = run.error(0, exact);
            assert!(error <= EXACT, "m = {ratio}, {units:?}: {error}");
            // 1e-3 is the size of the motion over that of the body, or more.
            let largest_stress = 1e-3 * MODULUS * stress;
            for field in [FieldName::StressXx, FieldName::StressYy, FieldName::StressXy] {
                let found = largest(&run.field(0, field)) / largest_stress;
                assert!(found <= EXACT, "m = {ratio}, {units:?}: {field:?} {found}");
            }
        }
    }
}

#[test]
fn multigrid_passes_the_patch_test_to_its_tolerance() {
    for ratio in RATIOS {
        let vertices = [[0.0, 0.0], [60.0, 0.0], [60.0, 40.0], [0.0, 40.0]];
        let mut case = body(&vertices, "plane_stress", ratio, [1.0; 2]);
        case["solver"] = json!("multigrid");
        case["supports"] = held([[0.5, 0.5], [59.5, 0.5]], |_| [0.0; 2]);
        let loads = |k: usize| json!({ "name": k.to_string(), "loads": tractions(&vertices, STRESSES[k]) });
        case["load_cases"] = (0..3).map(loads).collect();
        let run = solve(&case);
        assert_eq!(run.report.solver.method, "multigrid");
        for (k, stress) in STRESSES.into_iter().enumerate() {
            check_fields(&run, k, stress, 1e-9, &format!("m = {ratio}"));
        }
    }
}

#[test]
fn a_pull_against_an_edge_that_is_held_is_exact() {
    for (ratio, state) in RATIOS.into_iter().zip(["plane_stress", "plane_strain"].into_iter().cycle()) {
        let vertices = [[0.0, 0.0], [24.0, 0.0], [24.0, 16.0], [0.0, 16.0]];
        let mut case = body(&vertices, state, ratio, [1.0; 2]);
        case["loads"] = json!([{ "traction": { "edge": "edge_2", "uniform": [100.0, 0.0] } }]);
        case["supports"] =
            json!([{ "at": { "region": "edge_4" }, "ux": 0.0 }, { "at": { "x": 0.5, "y": 0.5 }, "uy": 0.0 }]);
        let run = solve(&case);
        check_fields(&run, 0, [100.0, 0.0, 0.0], EXACT, &format!("m = {ratio}"));
        // The edge is at x = 0, half a spacing before its points.
        let error = run.error(0, linear(gradient(state, [100.0 / MODULUS, 0.0, 0.0]), [0.0, 0.5]));
        assert!(error <= EXACT, "m = {ratio}: {error}");
        let reaction = run.states[0].reactions[0].force_x;
        assert!((reaction + 1600.0).abs() <= EXACT * 1600.0, "m = {ratio}: {reaction}");
    }
}

#[test]
fn without_overlay_the_patch_test_fails() {
    let vertices = [[0.0, 0.0], [24.0, 0.0], [24.0, 16.0], [0.0, 16.0]];
    let mut case = body(&vertices, "plane_stress", 3.0, [1.0; 2]);
    case["model"]["bond_plane"]["edges"] = json!("none");
    case["supports"] = held([[0.5, 0.5], [9.5, 0.5]], |_| [0.0; 2]);
    case["loads"] = tractions(&vertices, STRESSES[0]);
    // Loads by the same rows hide it in the displacement; the stress of points at edges lacks that of half their bonds.
    let stress = solve(&case).field(0, FieldName::StressXx);
    let least = stress.iter().copied().fold(1.0, f64::min);
    assert!(least < 0.7, "{least}");
}
