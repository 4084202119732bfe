//! Contact pressures.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserializer, Error, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;

/// The contact pressure `p₀ √(1 − r²/a²)` of Hertz at distances r within a of its middle: along an edge, or on a flat face of a solid,
/// where the contact is a circle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Hertz {
    /// Its middle: on an edge x or y as the edge runs, 0, the axis of a body of revolution, if not given; on a face a point of it,
    /// `[x, y, z]`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub centre: Option<ContactCentre>,
    /// The contact radius, > 0: half the width on an edge.
    pub radius: f64,
    /// Largest pressure p₀.
    pub peak: f64,
}

/// The middle of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ContactCentre {
    /// Along an edge, x or y as it runs.
    Along(f64),
    /// A point of a face.
    At([f64; 3]),
}

impl<'de> Deserialize<'de> for ContactCentre {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct CentreVisitor;

        impl<'de> Visitor<'de> for CentreVisitor {
            type Value = ContactCentre;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, on a face of a solid a list of three numbers")
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<ContactCentre, E> {
                Ok(ContactCentre::Along(value))
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<ContactCentre, E> {
                Ok(ContactCentre::Along(value as f64))
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<ContactCentre, E> {
                Ok(ContactCentre::Along(value as f64))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<ContactCentre, A::Error> {
                let mut at = Vec::new();
                while let Some(value) = seq.next_element::<f64>()? {
                    at.push(value);
                }
                let count = at.len();
                at.try_into().map(ContactCentre::At).map_err(|_| A::Error::invalid_length(count, &"three"))
            }
        }

        deserializer.deserialize_any(CentreVisitor)
    }
}

impl JsonSchema for ContactCentre {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "ContactCentre".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": ["number", "array"], "format": "double",
            "items": { "type": "number", "format": "double" }, "minItems": 3, "maxItems": 3
        })
    }
}
