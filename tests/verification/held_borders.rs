//! Borders that cut cells and are held: on their line, with the traction of the body.

use crate::support::plane::solve;
use peristat::case::FieldName;
use serde_json::{Value, json};

const MODULUS: f64 = 7e4;

fn plate(body: &Value, m: f64) -> Value {
    json!({
        "title": "plate", "units": "mm-N-MPa", "horizon_ratio": m,
        "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
        "body": { "outline": body }
    })
}

/// Stresses of all points with their positions.
fn stresses(case: &Value) -> Vec<([f64; 2], [f64; 3])> {
    let run = solve(case);
    let of = [FieldName::StressXx, FieldName::StressYy, FieldName::StressXy].map(|field| run.field(0, field));
    run.positions().into_iter().enumerate().map(|(p, at)| (at, [0, 1, 2].map(|q| of[q][p]))).collect()
}

/// Normal stress along a direction and across it.
fn along([c, s]: [f64; 2], [xx, yy, xy]: [f64; 3]) -> [f64; 2] {
    [xx * c * c + yy * s * s + 2.0 * xy * s * c, xx * s * s + yy * c * c - 2.0 * xy * s * c]
}

/// A strip 40 x 16 whose ends slide on their lines, moved apart by a hundredth of the length: one stress, also in the corners.
#[test]
fn strips_between_held_ends_have_one_stress_at_any_angle() {
    for (angle, m, height) in
        [(0.3, 2.0, 16.0), (0.3, 3.0, 16.0), (0.5, 4.0, 16.0), (0.78, 3.0, 16.0), (0.0, 3.0, 16.4)]
    {
        let (s, c) = f64::sin_cos(angle);
        let turned = |[x, y]: [f64; 2]| [c * x - s * y + 0.02, s * x + c * y + 0.05];
        let vertices = [[-20.0, -8.0], [20.0, -8.0], [20.0, height - 8.0], [-20.0, height - 8.0]].map(turned);
        let held = |edge: &str, moved: f64| {
            let inclined = json!({ "degrees": angle.to_degrees(), "displacement": moved });
            json!({ "at": { "region": edge }, "inclined": inclined })
        };
        let mut case = plate(&json!({ "vertices": vertices, "spacing": 1 }), m);
        let middle = json!({ "degrees": angle.to_degrees() + 90.0, "displacement": 0 });
        case["supports"] = json!([held("edge_4", 0.0), held("edge_2", 0.4),
            { "at": { "x": 0.02, "y": 0.05 }, "inclined": middle }]);
        let stress = MODULUS * 0.4 / 40.0;
        for (at, found) in stresses(&case) {
            let [found, across] = along([c, s], found);
            // 4e-14 is found; 3 to 10 with points that are held.
            let off = (found / stress - 1.0).abs().max((across / stress).abs());
            assert!(off < 1e-11, "{angle} {m} {at:?}: {off:e}");
        }
    }
}

/// A quarter of a ring, 10 to 25, whose bore is held and whose outer border is pulled by 100: errors of the displacement in the
/// mean and of the largest radial stress, per the largest.
fn held_bore(m: f64, spacing: f64) -> [f64; 2] {
    let (a, b, p, nu) = (10.0_f64, 25.0_f64, 100.0, 1.0 / 3.0);
    let turn = |k: i32| (f64::from(k) * std::f64::consts::PI / 360.0).sin_cos();
    let arc = (0..=180).map(turn).map(|(s, c)| [c, s].map(|x| (b * x * 1e12).round() / 1e12));
    let vertices: Vec<[f64; 2]> = std::iter::once([0.0; 2]).chain(arc).collect();
    let bore = json!([{ "circle": { "name": "bore", "centre": [0, 0], "radius": a } }]);
    let mut case = plate(&json!({ "vertices": vertices, "spacing": spacing, "holes": bore }), m);
    case["symmetry"] = json!(["left", "bottom"]);
    case["supports"] = json!([{ "at": { "region": "bore" }, "ux": 0, "uy": 0 }]);
    let pull = |k: i32| json!({ "traction": { "edge": format!("edge_{k}"), "pressure": -p } });
    case["loads"] = (2..=181).map(pull).collect();
    // u = A r + B/r with u(a) = 0 and σ_r(b) = p.
    let scale = p * (1.0 - nu * nu) / MODULUS / ((1.0 + nu) + (1.0 - nu) * a * a / (b * b));
    let radial = |r: f64| scale * (r - a * a / r);
    let stress = |r: f64| MODULUS / (1.0 - nu * nu) * scale * ((1.0 + nu) + (1.0 - nu) * a * a / (r * r));
    let run = solve(&case);
    let u = [FieldName::Ux, FieldName::Uy].map(|field| run.field(0, field));
    let (mut off, mut all) = (0.0, 0.0);
    for (p, [x, y]) in run.positions().into_iter().enumerate() {
        let r = x.hypot(y);
        off += (u[0][p] - radial(r) * x / r).powi(2) + (u[1][p] - radial(r) * y / r).powi(2);
        all += radial(r) * radial(r);
    }
    let of_stress = |([x, y], found): ([f64; 2], [f64; 3])| {
        let r = x.hypot(y);
        (along([x / r, y / r], found)[0] - stress(r)).abs() / stress(a)
    };
    [(off / all).sqrt(), stresses(&case).into_iter().map(of_stress).fold(0.0, f64::max)]
}

#[test]
fn a_ring_with_a_held_bore_is_that_of_lame() {
    let measured = [
        (2.0, 1.0, [9.6e-4, 0.0111]),
        (3.0, 1.0, [9.1e-4, 0.0105]),
        (2.0, 0.5, [1.30e-4, 0.0031]),
        (3.0, 0.5, [1.75e-4, 0.0055]),
    ];
    for (m, spacing, expected) in measured {
        for (found, expected) in held_bore(m, spacing).iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 0.05, "{m} {spacing}: {found} {expected}");
        }
    }
}
