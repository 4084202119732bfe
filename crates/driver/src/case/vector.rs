//! Vectors as cases write them: two numbers in the plane, three in space.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;
use std::fmt;

/// Numbers along x, y and z. How many there must be depends on the body, so that any count is read and checked in its scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector {
    values: [f64; 3],
    count: usize,
}

impl Vector {
    /// The numbers along x, y and z, zeros where there are none, and how many are given.
    pub fn parts(&self) -> ([f64; 3], usize) {
        (self.values, self.count)
    }
}

impl From<[f64; 2]> for Vector {
    fn from([x, y]: [f64; 2]) -> Self {
        Self { values: [x, y, 0.0], count: 2 }
    }
}

impl From<[f64; 3]> for Vector {
    fn from(values: [f64; 3]) -> Self {
        Self { values, count: 3 }
    }
}

impl From<&[f64]> for Vector {
    fn from(given: &[f64]) -> Self {
        let mut values = [0.0; 3];
        values.iter_mut().zip(given).for_each(|(value, given)| *value = *given);
        Self { values, count: given.len() }
    }
}

impl Serialize for Vector {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.values[..self.count.min(3)].serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Vector {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Numbers;
        impl<'de> Visitor<'de> for Numbers {
            type Value = Vector;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a list of two or three numbers")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Vector, A::Error> {
                let mut vector = Vector { values: [0.0; 3], count: 0 };
                while let Some(value) = seq.next_element()? {
                    if let Some(place) = vector.values.get_mut(vector.count) {
                        *place = value;
                    }
                    vector.count += 1;
                }
                Ok(vector)
            }
        }
        deserializer.deserialize_seq(Numbers)
    }
}

impl JsonSchema for Vector {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Vector".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "array", "items": { "type": "number", "format": "double" }, "minItems": 2, "maxItems": 3
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Vector;

    #[test]
    fn any_count_is_read_and_the_first_three_are_kept() {
        let of = |text: &str| serde_json::from_str::<Vector>(text).map(|v| v.parts());
        assert_eq!(of("[1, 2]").unwrap(), ([1.0, 2.0, 0.0], 2));
        assert_eq!(of("[1, 2, 3]").unwrap(), ([1.0, 2.0, 3.0], 3));
        assert_eq!(of("[1, 2, 3, 4]").unwrap(), ([1.0, 2.0, 3.0], 4));
        assert_eq!(of("[]").unwrap(), ([0.0; 3], 0));
        assert!(of("[1, true]").is_err() && of("1").is_err());
        assert_eq!(serde_json::to_string(&Vector::from([1.5, 2.0])).unwrap(), "[1.5,2.0]");
    }
}
