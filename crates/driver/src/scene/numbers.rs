//! Numbers of a case that cannot be: not positive, or beyond double precision when they are multiplied.

use crate::case::Case;
use crate::diagnostic::{Faults, JsonPath};
use serde_json::Value;

/// Magnitudes that a model may be written in; nobody's units are beyond.
const RANGE: std::ops::RangeInclusive<f64> = 1e-60..=1e60;

/// Whether two stiffnesses and their product keep all digits.
pub(super) fn fit(bending: f64, shear: f64) -> bool {
    (bending * shear).is_normal() && bending.is_normal()
}

/// Adds a fault for every number beyond the range; zero is fine, and checks may compare with anything.
pub(super) fn check(case: &Case, faults: &mut Faults) {
    if let Ok(Value::Object(keys)) = serde_json::to_value(case) {
        for (key, value) in keys.iter().filter(|(key, _)| *key != "checks") {
            walk(value, &super::root(key), faults);
        }
    }
}

fn walk(value: &Value, path: &JsonPath, faults: &mut Faults) {
    match value {
        Value::Object(keys) => {
            for (key, value) in keys {
                walk(value, &path.key(key), faults);
            }
        }
        Value::Array(values) => {
            for (k, value) in values.iter().enumerate() {
                walk(value, &path.index(k), faults);
            }
        }
        Value::Number(number) => {
            let size = number.as_f64().unwrap_or(0.0).abs();
            if size != 0.0 && !RANGE.contains(&size) {
                let how = if size > 1.0 { "large" } else { "small" };
                faults
                    .error(path.clone(), format!("this number is too {how} to calculate with"))
                    .hint("choose units in which all numbers are moderate");
            }
        }
        _ => {}
    }
}
