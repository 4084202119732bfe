//! Smallest and largest values of fields, and where they are.

use serde::{Deserialize, Serialize};

/// A value and where it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Located {
    /// Value.
    pub value: f64,
    /// Position on its line, or the first coordinate.
    pub x: f64,
    /// The second coordinate of a point of a body.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y: Option<f64>,
    /// The third coordinate of a point of a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z: Option<f64>,
    /// Member of a frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
}

/// Smallest and largest value of a field.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Extremes {
    /// Smallest.
    pub smallest: Located,
    /// Largest.
    pub largest: Located,
    /// Unit of both, and of the columns of the field in tables.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub unit: String,
}
