//! Numbers as cases prescribe them: the same everywhere, or by a formula of the position.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserializer, Error, Visitor};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;

/// A number, or a formula of x, y and, in a solid, z, and of `load_factor` where there are steps.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Amount {
    /// The same everywhere.
    Number(f64),
    /// Such as `"100*(1 - y/20)"`.
    Formula(String),
}

impl Amount {
    /// The number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(value) => Some(*value),
            Self::Formula(_) => None,
        }
    }
}

/// What is given, where it is a number.
pub(crate) fn number(given: Option<&Amount>) -> Option<f64> {
    given.and_then(Amount::number)
}

impl<'de> Deserialize<'de> for Amount {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct AmountVisitor;

        impl Visitor<'_> for AmountVisitor {
            type Value = Amount;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, or a formula such as \"2*x\"")
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<Amount, E> {
                Ok(Amount::Number(value))
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<Amount, E> {
                Ok(Amount::Number(value as f64))
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<Amount, E> {
                Ok(Amount::Number(value as f64))
            }

            fn visit_str<E: Error>(self, formula: &str) -> Result<Amount, E> {
                Ok(Amount::Formula(formula.into()))
            }
        }

        deserializer.deserialize_any(AmountVisitor)
    }
}

impl JsonSchema for Amount {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Amount".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": ["number", "string"], "format": "double" })
    }
}

/// Numbers or formulas along x, y and z; how many there must be depends on the body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Amounts(pub Vec<Amount>);

impl JsonSchema for Amounts {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Amounts".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "array", "items": { "type": ["number", "string"], "format": "double" }, "minItems": 2, "maxItems": 3
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Amount;

    #[test]
    fn numbers_and_formulas_are_read_and_written_alike() {
        for (text, number) in [("1.5", Some(1.5)), ("-3.0", Some(-3.0)), (r#""2*x""#, None)] {
            let amount: Amount = serde_json::from_str(text).unwrap();
            assert_eq!((serde_json::to_string(&amount).unwrap().as_str(), amount.number()), (text, number));
        }
        assert_eq!(serde_json::from_str::<Amount>("-3").unwrap(), Amount::Number(-3.0));
        let error = serde_json::from_str::<Amount>("[1]").unwrap_err().to_string();
        assert!(error.contains("a number, or a formula"), "{error}");
    }
}
