//! Vertices of outlines: the ends of straight edges and of arcs.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;

/// A vertex with what leads to it from the one before.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Vertex {
    /// A straight edge.
    Straight([f64; 2]),
    /// An arc.
    Arc(ArcTo),
}

/// An arc of a circle from the vertex before; `through` or `centre` says which.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ArcTo {
    /// The vertex at its end. As the first vertex it ends an arc from the last one.
    pub arc_to: [f64; 2],
    /// A position on the arc between its ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub through: Option<[f64; 2]>,
    /// Its middle, as far from one end as from the other.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub centre: Option<[f64; 2]>,
    /// With `centre`: the arc runs clockwise around it, not counter-clockwise.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub clockwise: bool,
}

impl Vertex {
    /// Where it is.
    pub fn at(&self) -> [f64; 2] {
        match self {
            Self::Straight(at) => *at,
            Self::Arc(arc) => arc.arc_to,
        }
    }
}

impl<'de> Deserialize<'de> for Vertex {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;

        impl<'de> Visitor<'de> for Either {
            type Value = Vertex;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a position [x, y], or an arc { \"arc_to\": [x, y], \"through\": [x, y] }")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Vertex, A::Error> {
                Deserialize::deserialize(SeqAccessDeserializer::new(seq)).map(Vertex::Straight)
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Vertex, A::Error> {
                ArcTo::deserialize(MapAccessDeserializer::new(map)).map(Vertex::Arc)
            }
        }

        deserializer.deserialize_any(Either)
    }
}

impl JsonSchema for Vertex {
    fn schema_name() -> Cow<'static, str> {
        "Vertex".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let position = <[f64; 2]>::json_schema(generator);
        let arc = generator.subschema_for::<ArcTo>();
        json_schema!({
            "description": "A vertex: a position at the end of a straight edge, or the end of an arc.",
            "anyOf": [position, arc]
        })
    }
}
