//! A study as its author wrote it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// A base case, and what is varied of it.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// Location of the JSON Schema, for editors; ignored.
    #[serde(rename = "$schema", default, skip_serializing_if = "Option::is_none")]
    pub schema: Option<String>,
    /// What is studied, in a few words.
    pub title: String,
    /// One or two sentences on what it shows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<String>,
    /// The base case, a file relative to the study, in its folder or below.
    pub case: String,
    /// Values of the base case that are replaced, by their paths, such as `"body.line.cells": 24`.
    #[serde(default, skip_serializing_if = "Map::is_empty")]
    pub set: Map<String, Value>,
    /// What is varied beside the refinement: every object is an axis, a list of values for each of its paths, which move
    /// together. Axes are combined with each other.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub vary: Vec<Map<String, Value>>,
    /// How the discretisation is refined; without it there are no orders.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub refine: Option<Refine>,
    /// Exact values of probes, and of `energy`, where they are known.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub exact: Vec<Exact>,
    /// What the study must find.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub expect: Vec<Expect>,
}

/// How the discretisation is refined.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Refine {
    /// Spacing and horizon go to zero together, their ratio stays: the local solution.
    DeltaConvergence(DeltaConvergence),
    /// The spacing goes to zero, the horizon stays: the nonlocal solution.
    MConvergence(MConvergence),
    /// The horizon goes to zero, and the spacing faster.
    JointConvergence(JointConvergence),
    /// Values of any paths, where none of the others fits.
    Values(Values),
}

/// Spacing and horizon are those of the base case over factors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DeltaConvergence {
    /// Factors, > 0, each larger than the one before.
    pub factors: Vec<f64>,
}

/// The horizon is that of the base case, the spacing is the horizon over ratios.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MConvergence {
    /// Horizon ratios, each larger than the one before.
    pub ratios: Vec<f64>,
}

/// The horizon is that of the base case over factors, the spacing is the horizon over ratios.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointConvergence {
    /// Factors, each larger than the one before.
    pub factors: Vec<f64>,
    /// Horizon ratios, as many as there are factors.
    pub ratios: Vec<f64>,
}

/// Any paths take one value after the other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Values {
    /// Sizes that orders are of, such as spacings, each smaller than the one before.
    pub sizes: Vec<f64>,
    /// A list of values for every path, as many as there are sizes.
    pub set: Map<String, Value>,
}

/// The exact value of a quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Exact {
    /// Name of the quantity: that of a probe, or `energy`.
    pub quantity: String,
    /// The value.
    pub value: f64,
    /// Where it comes from.
    pub source: String,
    /// The series that is meant, by values of its paths; all of them if not given.
    #[serde(default, skip_serializing_if = "Map::is_empty")]
    pub r#where: Map<String, Value>,
}

/// What a quantity must do as the discretisation is refined.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Expect {
    /// Name of the quantity, as tables show it.
    pub quantity: String,
    /// The series that is meant, by values of its paths; all of them if not given.
    #[serde(default, skip_serializing_if = "Map::is_empty")]
    pub r#where: Map<String, Value>,
    /// Order over the last refinement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub order: Option<f64>,
    /// How far the order may be from the expected one.
    #[serde(default = "tenth")]
    pub within: f64,
    /// Largest error of the finest discretisation, relative.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error_at_most: Option<f64>,
    /// Largest error of the extrapolated value over that of the finest discretisation, where the exact value is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extrapolated_over_finest: Option<f64>,
}

fn tenth() -> f64 {
    0.1
}
