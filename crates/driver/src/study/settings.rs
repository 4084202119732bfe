//! Settings of a study by their paths.

use serde_json::{Map, Value};

/// Whether settings have all of some values.
pub(super) fn includes(settings: &Map<String, Value>, values: &Map<String, Value>) -> bool {
    let same = |a: &Value, b: &Value| a == b || a.as_f64().is_some_and(|a| b.as_f64() == Some(a));
    values.iter().all(|(path, value)| settings.get(path).is_some_and(|setting| same(setting, value)))
}
