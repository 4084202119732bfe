//! Cases of plates in bending.

use peristat::Solved;
use serde_json::{Value, json};

pub(crate) fn solved(case: &Value) -> Solved {
    peristat::solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error}"))
}

pub(crate) fn refusal(case: &Value) -> String {
    peristat::solve_text(&case.to_string()).err().map(|error| error.to_string()).unwrap_or_default()
}

/// E for a bending stiffness of one, ν = 0.3; the shear stiffness is then 3.5/t².
pub(crate) fn youngs_modulus(t: f64) -> f64 {
    12.0 * 0.91 / t.powi(3)
}

pub(crate) fn model(t: f64) -> Value {
    json!({ "plate_bending": { "youngs_modulus": youngs_modulus(t), "poisson_ratio": 0.3, "thickness": t } })
}

/// A unit square under a unit pressure.
pub(crate) fn square(cells: usize, t: f64, supports: Value) -> Value {
    json!({
        "title": "square", "units": "none", "model": model(t),
        "body": { "rectangle": { "size": [1, 1], "spacing": 1.0 / cells as f64 } },
        "supports": supports,
        "loads": [ { "pressure": { "value": 1 } } ],
        "probes": [ { "name": "middle", "at": { "x": 0.5, "y": 0.5 }, "field": "w" },
            { "name": "moment", "at": { "x": 0.5, "y": 0.5 }, "field": "M_xx" } ]
    })
}

pub(crate) fn clamped() -> Value {
    json!([ { "at": { "region": "all" }, "w": 0, "phi_n": 0, "phi_t": 0 } ])
}

pub(crate) fn hard() -> Value {
    json!([ { "at": { "region": "all" }, "w": 0, "phi_t": 0 } ])
}

pub(crate) fn probe(found: &Solved, name: &str) -> f64 {
    found.summary.probes.iter().find(|probe| probe.name == name).expect("a probe").value
}
