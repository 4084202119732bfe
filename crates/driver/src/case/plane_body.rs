//! Bodies in the plane, their holes and their cracks.

use super::{Names, Vertex};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserializer, Error, Visitor};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

/// A rectangle of square cells with a point in the middle of each. Its edges are `left`, `right`, `bottom` and `top`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RectangleBody {
    /// Lower left corner; the origin if not given.
    #[serde(default)]
    pub from: [f64; 2],
    /// Width and height, whole multiples of the spacing.
    pub size: [f64; 2],
    /// Side of a cell, > 0.
    pub spacing: f64,
    /// Holes, and notches where they cross the outline.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub holes: Vec<Hole>,
}

/// What lines and arcs bound, filled with square cells with a point in the middle of each: `vertices` of the case, or a `file` with a
/// drawing or a mesh. Its edges are `edge_1` from the first vertex to the second, `edge_2`, …. Those of a file count counter-clockwise
/// from the lowest of the leftmost vertices, and have the names that they have there: physical groups of Gmsh, layers of DXF, `id`s of
/// SVG. An arc is one edge, of chords that are a ten-thousandth of the spacing from it at most.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OutlineBody {
    /// Vertices in either direction, the first not repeated at the end; an arc leads to a vertex
    /// `{ "arc_to": [x, y], "through": [x, y] }`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub vertices: Vec<Vertex>,
    /// Gmsh file in two dimensions (MSH 4.1, ASCII), DXF file (ASCII) or SVG file whose lines are the border and the holes, relative to
    /// the case, in its folder or below.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// What lengths of the file are multiplied by, > 0; 1 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scale: Option<f64>,
    /// Side of a cell, > 0.
    pub spacing: f64,
    /// Holes, and notches where they cross the outline.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub holes: Vec<Hole>,
    /// Names for edges and holes, of several each.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub edges: BTreeMap<String, Names>,
}

/// Points that a file lists.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointsBody {
    /// CSV file with the columns `x`, `y` and `area` or `volume`, in space `x`, `y`, `z` and `volume`; relative to the case, in its
    /// folder or below.
    pub file: String,
}

/// The elements of a mesh, a point each; its named groups are regions.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshBody {
    /// Gmsh file (MSH 4.1, ASCII), relative to the case, in its folder or below.
    pub file: String,
}

/// A part of the outline where there is no body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Hole {
    /// A disc.
    Circle(CircleHole),
    /// An ellipse.
    Ellipse(EllipseHole),
    /// A straight slot with round ends.
    Slot(SlotHole),
    /// A polygon.
    Polygon(PolygonHole),
}

/// A round hole.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CircleHole {
    /// Name, for regions and tractions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Its middle.
    pub centre: [f64; 2],
    /// Its radius, > 0.
    pub radius: f64,
}

/// An elliptic hole. Stresses on it are those of the elastic fields around an ellipse, fitted to displacements beside it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EllipseHole {
    /// Name, for regions and tractions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Its middle.
    pub centre: [f64; 2],
    /// Half its axes, > 0: along x and y, unless it is turned.
    pub half_axes: [f64; 2],
    /// By how much it is turned counter-clockwise, degrees; 0 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle: Option<f64>,
}

/// A slot with round ends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SlotHole {
    /// Name, for regions and tractions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Centre of one round end.
    pub from: [f64; 2],
    /// Centre of the other.
    pub to: [f64; 2],
    /// Half its width, > 0.
    pub radius: f64,
}

/// A hole with straight edges.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PolygonHole {
    /// Name, for regions and tractions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Vertices in either direction, the first not repeated at the end.
    pub vertices: Vec<[f64; 2]>,
}

impl Hole {
    /// Its name.
    pub fn name(&self) -> Option<&str> {
        match self {
            Self::Circle(hole) => hole.name.as_deref(),
            Self::Ellipse(hole) => hole.name.as_deref(),
            Self::Slot(hole) => hole.name.as_deref(),
            Self::Polygon(hole) => hole.name.as_deref(),
        }
    }
}

/// Which crack: its name, or its number, the first is 1.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct CrackName(pub String);

impl<'de> Deserialize<'de> for CrackName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NameOrNumber;

        impl Visitor<'_> for NameOrNumber {
            type Value = CrackName;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a crack, or its number")
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<CrackName, E> {
                Ok(CrackName(name.into()))
            }

            fn visit_u64<E: Error>(self, number: u64) -> Result<CrackName, E> {
                Ok(CrackName(number.to_string()))
            }
        }

        deserializer.deserialize_any(NameOrNumber)
    }
}

impl JsonSchema for CrackName {
    fn schema_name() -> Cow<'static, str> {
        "CrackName".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": ["string", "integer"] })
    }
}
