//! Numbers and texts for the scripts of a page.

use serde_json::{Value, json};

/// JSON as the content of a script element, which nothing in it can end.
pub(super) fn inline(value: &Value) -> String {
    value.to_string().replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026")
}

/// A number with seven digits, more than a picture shows; `null` if it is none.
pub(super) fn rounded(value: f64) -> Value {
    match format!("{value:.6e}").parse::<f64>() {
        // Without the point that floating-point numbers end with.
        Ok(value) if value.abs() < 1e7 && value.fract() == 0.0 => json!(value as i64),
        Ok(value) => json!(value),
        Err(_) => Value::Null,
    }
}

/// Numbers with seven digits.
pub(super) fn all(values: impl Iterator<Item = f64>) -> Value {
    values.map(rounded).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_cannot_leave_its_script() {
        let text = inline(&json!({ "a": "</script><!-- & \u{2028}" }));
        assert!(!text.contains(['<', '>', '&']), "{text}");
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap()["a"], "</script><!-- & \u{2028}");
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(rounded(1.0 / 3.0).to_string(), "0.3333333");
        assert_eq!(
            [rounded(3e5), rounded(1e-9), rounded(f64::NAN)].map(|v| v.to_string()),
            ["300000", "1e-9", "null"]
        );
    }
}
