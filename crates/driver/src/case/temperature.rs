//! Changes of temperature, and what they stretch.

use super::Amount;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserializer, Error, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;

/// A change of temperature against the state without stress, of a material with a `thermal_expansion`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Temperature {
    /// Kelvin, positive where it becomes warmer, or on bodies a formula of x, y and, in a solid, z, such as `"100*(1 - y/20)"`. On a
    /// beam that of the axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub change: Option<Amount>,
    /// Kelvin by which the top of a beam or of a plate in bending, the side of +w, becomes warmer than the bottom, straight over the
    /// height; on a plate a number or a formula of x and y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub difference: Option<Amount>,
    /// Member of a frame that changes its temperature.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
    /// Name of the region of a body that changes its temperature; the whole body if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
}

/// Strain per kelvin: the same in all directions, or along and across the fibres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Expansion {
    /// In all directions.
    Alike(f64),
    /// Along and across the fibres.
    Fibres([f64; 2]),
}

impl Expansion {
    /// What a material stretches by along and across fibres; without fibres both are the same.
    pub fn along_and_across(self) -> [f64; 2] {
        match self {
            Self::Alike(alpha) => [alpha; 2],
            Self::Fibres(both) => both,
        }
    }
}

impl<'de> Deserialize<'de> for Expansion {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct TemperatureVisitor;

        impl<'de> Visitor<'de> for TemperatureVisitor {
            type Value = Expansion;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, or [along, across] the fibres")
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<Expansion, E> {
                Ok(Expansion::Alike(value))
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<Expansion, E> {
                Ok(Expansion::Alike(value as f64))
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<Expansion, E> {
                Ok(Expansion::Alike(value as f64))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Expansion, A::Error> {
                let mut next =
                    |k: usize| seq.next_element::<f64>()?.ok_or_else(|| A::Error::invalid_length(k, &"2"));
                let values = [next(0)?, next(1)?];
                match seq.next_element::<f64>()? {
                    None => Ok(Expansion::Fibres(values)),
                    Some(_) => Err(A::Error::invalid_length(3, &"2")),
                }
            }
        }

        deserializer.deserialize_any(TemperatureVisitor)
    }
}

impl JsonSchema for Expansion {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Expansion".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": ["number", "array"], "format": "double",
            "items": { "type": "number", "format": "double" }, "minItems": 2, "maxItems": 2
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Expansion;

    #[test]
    fn one_number_and_two_are_read() {
        let of = |text: &str| serde_json::from_str::<Expansion>(text);
        assert_eq!(of("1e-5").unwrap(), Expansion::Alike(1e-5));
        assert_eq!(of("[-1e-6, 3e-5]").unwrap(), Expansion::Fibres([-1e-6, 3e-5]));
        assert!(["[1]", "[1, 2, 3]", "\"x\""].into_iter().all(|text| of(text).is_err()));
    }
}
