//! Faults that many keys share.

use super::{Faults, JsonPath};

/// A number that must be finite and greater than zero.
pub(crate) fn positive(value: f64, name: &str, path: JsonPath, faults: &mut Faults) -> bool {
    let fine = value > 0.0 && value.is_finite();
    if !fine {
        faults.error(path, format!("`{name}` must be greater than zero, found {value}"));
    }
    fine
}

/// The path of a key at the root of a case.
pub(crate) fn root(key: &str) -> JsonPath {
    JsonPath::default().key(key)
}

/// Whether `fibre_angle` is one, degrees; a fault if it is more than a turn.
pub(crate) fn fibre_angle(value: f64, path: JsonPath, faults: &mut Faults) -> bool {
    let fine = value.abs() <= 360.0;
    if !fine {
        let message = format!("`fibre_angle` must be between -360 and 360, found {value}");
        faults.error(path, message).hint("it is in degrees, counter-clockwise from x");
    }
    fine
}
