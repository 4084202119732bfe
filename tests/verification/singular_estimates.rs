//! Estimated errors beside places where stresses are infinite: the leading terms of Williams (J. Appl. Mech. 19 (1952) 526-528) at the tip
//! of a crack and in a corner that turns into the body, prescribed on the border around.

use peristat::Loaded;
use peristat::case::from_text;
use peristat::input::Folder;
use peristat::run::{RunOptions, taking};
use peristat::summary::Estimate;
use serde_json::{Value, json};
use std::path::Path;

/// Half the side of the body.
const HALF: f64 = 10.0;
/// The strength of the field.
const STRENGTH: f64 = 100.0;
const YOUNGS_MODULUS: f64 = 2e5;
/// Where fields are asked for.
const PLACES: [[f64; 2]; 5] = [[0.5, 0.5], [1.5, 0.5], [4.5, 0.5], [-4.5, 2.5], [0.5, 4.5]];
const FIELDS: [&str; 4] = ["ux", "uy", "stress_xx", "stress_yy"];

/// A symmetric field of the displacement `r^λ`, beside a notch along the negative axis that is turned by an angle.
struct Field {
    lambda: f64,
    /// Share of the second term, by which the faces of the notch are free.
    share: f64,
    /// cos and sin of the angle by which it is turned.
    turn: [f64; 2],
    kolosov: f64,
    shear_modulus: f64,
}

impl Field {
    /// At the tip of a crack, or in a corner of 270°.
    fn new(is_crack: bool, poisson_ratio: f64, is_plane_stress: bool) -> Self {
        let (lambda, share) =
            if is_crack { (0.5, 1.0 / 3.0) } else { (0.544_483_736_782_464, 0.543_075_578_836_737) };
        let nu = poisson_ratio;
        let half = std::f64::consts::FRAC_1_SQRT_2;
        Self {
            lambda,
            share,
            turn: if is_crack { [1.0, 0.0] } else { [half, half] },
            kolosov: if is_plane_stress { (3.0 - nu) / (1.0 + nu) } else { 3.0 - 4.0 * nu },
            shear_modulus: 0.5 * YOUNGS_MODULUS / (1.0 + nu),
        }
    }

    /// `[u_x, u_y, S_xx, S_yy]`.
    fn at(&self, [x, y]: [f64; 2]) -> [f64; 4] {
        let (l, q, k) = (self.lambda, self.share * (self.lambda + 1.0), self.kolosov);
        let [c, s] = self.turn;
        let [x, y] = [c * x + s * y, c * y - s * x];
        let (r, t) = (x.hypot(y), y.atan2(x));
        let size = STRENGTH * r.powf(l) / (2.0 * self.shear_modulus);
        let cos = |times: f64| (times * t).cos();
        let sin = |times: f64| (times * t).sin();
        let u = size * ((k - q) * cos(l) - l * cos(l - 2.0));
        let v = size * ((k + q) * sin(l) + l * sin(l - 2.0));
        let size = STRENGTH * l * r.powf(l - 1.0);
        let xx = size * ((2.0 - q) * cos(l - 1.0) - (l - 1.0) * cos(l - 3.0));
        let yy = size * ((2.0 + q) * cos(l - 1.0) + (l - 1.0) * cos(l - 3.0));
        let xy = size * ((l - 1.0) * sin(l - 3.0) + q * sin(l - 1.0));
        let shear = 2.0 * c * s * xy;
        [c * u - s * v, s * u + c * v, c * c * xx + s * s * yy - shear, s * s * xx + c * c * yy + shear]
    }

    /// Its displacements as formulas.
    fn formulas(&self) -> [String; 2] {
        let (l, q, k) = (self.lambda, self.share * (self.lambda + 1.0), self.kolosov);
        let [c, s] = self.turn;
        let (x, y) = (format!("({c}*x + {s}*y)"), format!("({c}*y - {s}*x)"));
        let size = format!("{}*(x^2 + y^2)^{}", STRENGTH / (2.0 * self.shear_modulus), 0.5 * l);
        let t = format!("atan2({y}, {x})");
        let u = format!("({}*cos({l}*{t}) - {l}*cos({}*{t}))", k - q, l - 2.0);
        let v = format!("({}*sin({l}*{t}) + {l}*sin({}*{t}))", k + q, l - 2.0);
        [format!("{size}*({c}*{u} - {s}*{v})"), format!("{size}*({s}*{u} + {c}*{v})")]
    }
}

/// A square with a crack from the left, or without its lower left quarter.
fn plane(is_crack: bool, model: Value, field: &Field) -> Value {
    let [ux, uy] = field.formulas();
    let (body, held) = match is_crack {
        true => (
            json!({ "rectangle": { "from": [-HALF, -HALF], "size": [2.0 * HALF, 2.0 * HALF], "spacing": 0.5 } }),
            json!(["left", "right", "bottom", "top"]),
        ),
        false => (
            json!({ "outline": { "spacing": 0.5, "vertices":
                [[-HALF, 0], [0, 0], [0, -HALF], [HALF, -HALF], [HALF, HALF], [-HALF, HALF]] } }),
            json!(["edge_3", "edge_4", "edge_5", "edge_6"]),
        ),
    };
    let cracks = if is_crack { json!([{ "path": [[-HALF - 1.0, 0], [0, 0]] }]) } else { json!([]) };
    json!({
        "title": "singular", "units": "mm-N-MPa", "model": model, "body": body, "cracks": cracks,
        "supports": [{ "at": { "region": held }, "ux": ux, "uy": uy }]
    })
}

/// A cracked block in plane strain.
fn solid(field: &Field) -> Value {
    let [ux, uy] = field.formulas();
    let [far, deep] = [-HALF - 1.0, 7.0];
    json!({
        "title": "singular", "units": "mm-N-MPa", "symmetry": ["back", "front"],
        "model": { "state_solid": { "youngs_modulus": YOUNGS_MODULUS, "poisson_ratio": 0.3 } },
        "body": { "block": { "from": [-HALF, -HALF, 0], "size": [2.0 * HALF, 2.0 * HALF, 6], "spacing": 1 } },
        "cracks": [{ "polygon": [[far, 0, -1], [0, 0, -1], [0, 0, deep], [far, 0, deep]] }],
        "supports": [{ "at": { "region": ["left", "right", "bottom", "top"] }, "ux": ux, "uy": uy }]
    })
}

/// Estimates of the fields at all places, with the true values.
fn estimated(mut case: Value, field: &Field) -> Vec<(Estimate, f64)> {
    let is_solid = case["body"].get("block").is_some();
    let mut truth = Vec::new();
    let mut probes = Vec::new();
    for place in PLACES {
        for (name, value) in FIELDS.into_iter().zip(field.at(place)) {
            let mut at = json!({ "x": place[0], "y": place[1] });
            if is_solid {
                at["z"] = json!(3);
            }
            truth.push(value);
            probes.push(json!({ "name": format!("{name} at {place:?}"), "at": at, "field": name }));
        }
    }
    case["probes"] = Value::Array(probes);
    let source =
        from_text("case", format!("{case:#}"), &[], &Folder::default()).unwrap_or_else(|e| panic!("{e}"));
    let loaded = Loaded::from_source(source, Path::new(".").into(), None).unwrap_or_else(|e| panic!("{e}"));
    let options = RunOptions { recover: true, max_memory: None, compare: true };
    let summary = loaded.run(&options, None, &mut taking(|_| Ok(()))).unwrap_or_else(|e| panic!("{e}"));
    let found = loaded.estimate_cheaply(&summary, None).unwrap_or_else(|reason| panic!("{reason}"));
    found.quantities.into_iter().zip(truth).collect()
}

#[test]
fn estimates_beside_tips_and_corners_cover_a_fifth_of_the_error() {
    let plate = |nu: Option<f64>, model: &str| {
        let mut keys = json!({ "youngs_modulus": YOUNGS_MODULUS, "state": "plane_stress" });
        if let Some(nu) = nu {
            keys["poisson_ratio"] = json!(nu);
        }
        json!({ model: keys })
    };
    let mut all: Vec<(String, Value, Field)> = Vec::new();
    for (model, given, nu) in [("bond_plane", None, 1.0 / 3.0), ("state_plane", Some(0.3), 0.3)] {
        for is_crack in [true, false] {
            let field = Field::new(is_crack, nu, true);
            all.push((format!("{model} {is_crack}"), plane(is_crack, plate(given, model), &field), field));
        }
    }
    let field = Field::new(true, 0.3, false);
    all.push(("state_solid".into(), solid(&field), field));
    for (name, case, field) in all {
        let found = estimated(case, &field);
        let largest = |kind: &str| {
            let own = found.iter().filter(|(own, _)| own.name.starts_with(kind));
            own.map(|(_, truth)| truth.abs()).fold(0.0, f64::max)
        };
        let scales = [largest("u"), largest("stress")];
        for (own, truth) in &found {
            let scale = scales[usize::from(own.name.starts_with("stress"))];
            let error = (own.value - truth).abs();
            // An error of a thousandth of the largest value is none.
            assert!(error < 5.0 * own.error || error < 1e-3 * scale, "{name}: {error:e} {own:?}");
            assert!(!own.settled, "{name}: {own:?}");
        }
    }
}
