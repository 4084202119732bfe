//! Numbers of a case that cannot be: not positive, or beyond double precision when they are multiplied.

use crate::case::Case;
use crate::diagnostic::{Faults, JsonPath};
use serde::Serialize;
use serde_json::Value;
use serde_json::ser::{Formatter, Serializer};
use std::io;

/// Magnitudes that a model may be written in; nobody's units are beyond.
const RANGE: std::ops::RangeInclusive<f64> = 1e-60..=1e60;

/// Whether two stiffnesses and their product keep all digits.
pub(super) fn fit(bending: f64, shear: f64) -> bool {
    (bending * shear).is_normal() && bending.is_normal()
}

/// Adds a fault for every number beyond the range; zero is fine, and checks may compare with anything.
pub(super) fn check(case: &Case, faults: &mut Faults) {
    // To find none, as nearly always, takes no tree of values.
    let mut doubts = Doubts(false);
    let _ = case.serialize(&mut Serializer::with_formatter(io::sink(), &mut doubts));
    if !doubts.0 {
        return;
    }
    if let Ok(Value::Object(keys)) = serde_json::to_value(case) {
        for (key, value) in keys.iter().filter(|(key, _)| *key != "checks") {
            walk(value, &super::root(key), faults);
        }
    }
}

/// Whether any number is beyond the range.
struct Doubts(bool);

impl Formatter for &mut Doubts {
    fn write_f64<W: ?Sized + io::Write>(&mut self, _: &mut W, value: f64) -> io::Result<()> {
        self.0 |= is_beyond(value);
        Ok(())
    }
}

/// Whether a number, not zero, is beyond the range.
fn is_beyond(value: f64) -> bool {
    value != 0.0 && !RANGE.contains(&value.abs())
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
            let value = number.as_f64().unwrap_or(0.0);
            if is_beyond(value) {
                let how = if value.abs() > 1.0 { "large" } else { "small" };
                faults
                    .error(path.clone(), format!("this number is too {how} to calculate with"))
                    .hint("choose units in which all numbers are moderate");
            }
        }
        _ => {}
    }
}
