//! Moduli of materials: the same everywhere, by a formula of the position, or as a table.

use super::Amount;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error, MapAccess, Visitor};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;

/// A number, a formula of x, y and, in a solid, z, or a table of them.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Modulus {
    /// The same everywhere, or a formula.
    Amount(Amount),
    /// Values on a grid.
    Table(Table),
}

/// Values at the places of a rectangular grid, linear between them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Path of a CSV file, relative to the case. Its first line names the columns: `value`, and those of `x`, `y` and `z` along which
    /// values vary. Its rows, in any order, are all places of a grid, whose lines need not be equally far from each other; it must
    /// reach all points.
    pub file: String,
}

impl Modulus {
    /// The number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Amount(amount) => amount.number(),
            Self::Table(_) => None,
        }
    }
}

impl<'de> Deserialize<'de> for Modulus {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ModulusVisitor;

        impl<'de> Visitor<'de> for ModulusVisitor {
            type Value = Modulus;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, a formula such as \"2000*exp(x/10)\", or { \"file\": … }")
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<Modulus, E> {
                Ok(Modulus::Amount(Amount::Number(value)))
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<Modulus, E> {
                self.visit_f64(value as f64)
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<Modulus, E> {
                self.visit_f64(value as f64)
            }

            fn visit_str<E: Error>(self, formula: &str) -> Result<Modulus, E> {
                Ok(Modulus::Amount(Amount::Formula(formula.into())))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Modulus, A::Error> {
                Table::deserialize(MapAccessDeserializer::new(map)).map(Modulus::Table)
            }
        }

        deserializer.deserialize_any(ModulusVisitor)
    }
}

impl JsonSchema for Modulus {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Modulus".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let table = generator.subschema_for::<Table>();
        json_schema!({ "anyOf": [{ "type": ["number", "string"], "format": "double" }, table] })
    }
}

#[cfg(test)]
mod tests {
    use super::Modulus;

    #[test]
    fn numbers_formulas_and_tables_are_read_and_written_alike() {
        for (text, number) in [("1.5", Some(1.5)), (r#""2*x""#, None), (r#"{"file":"e.csv"}"#, None)] {
            let modulus: Modulus = serde_json::from_str(text).unwrap();
            assert_eq!((serde_json::to_string(&modulus).unwrap().as_str(), modulus.number()), (text, number));
        }
        let error = |text: &str| serde_json::from_str::<Modulus>(text).unwrap_err().to_string();
        assert!(error("[1]").contains("a number, a formula"), "{}", error("[1]"));
        assert!(error(r#"{"path":"e.csv"}"#).contains("unknown field `path`"));
    }
}
