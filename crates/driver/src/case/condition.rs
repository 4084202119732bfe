//! Supports, links and loads of a case.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A position.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct At {
    /// Position along the beam.
    pub x: f64,
}

/// What holds a point: prescribed values, springs to the ground, or one of each.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Where; a point of the grid, or the end of a line.
    pub at: At,
    /// Prescribed deflection.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub w: Option<f64>,
    /// Prescribed rotation, rad.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi: Option<f64>,
    /// Stiffness of a spring against deflection, force per length, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub w_spring: Option<f64>,
    /// Stiffness of a spring against rotation, moment per radian, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_spring: Option<f64>,
}

/// A relation between two points.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Link {
    /// A rigid bar: the second point moves as if it were part of the first.
    Rigid(RigidLink),
}

/// A rigid bar between two points.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RigidLink {
    /// One end.
    pub from: At,
    /// The other end.
    pub to: At,
}

/// A load.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Load {
    /// A concentrated force and moment.
    Point(PointLoad),
    /// A force or moment per length.
    Distributed(Distributed),
}

/// A concentrated force and moment.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointLoad {
    /// Where.
    pub at: At,
    /// Force along w.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub force: f64,
    /// Moment along phi.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub moment: f64,
    /// Shared by the bonds that span it. Otherwise the chain is split at the load, which needs a point there; a load
    /// between points is always shared.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub spread: bool,
}

fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

/// A load spread over a part of a line.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Distributed {
    /// Start; the left end of the body if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<f64>,
    /// End; the right end of the body if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<f64>,
    /// Force per length along w.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<DistributedForce>,
    /// Moment per length along phi (b̃ of Eq. (12a) times the area).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment: Option<DistributedForce>,
}

/// How a distributed load varies.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DistributedForce {
    /// The same everywhere.
    Uniform(f64),
    /// Straight from the first value at the start to the second at the end.
    Linear([f64; 2]),
    /// A sine wave over the loaded length.
    Sine(Sine),
}

/// A sine wave.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sine {
    /// Largest value.
    pub amplitude: f64,
    /// Half waves over the loaded length, >= 1.
    #[serde(default = "one")]
    pub half_waves: u32,
}

fn one() -> u32 {
    1
}

/// A named set of loads.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LoadCase {
    /// Name, unique among load cases and combinations.
    pub name: String,
    /// Its loads.
    #[serde(default)]
    pub loads: Vec<Load>,
}

/// A sum of load cases.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Combination {
    /// Name, unique among load cases and combinations.
    pub name: String,
    /// Factor per load case; others do not act.
    pub factors: BTreeMap<String, f64>,
}

/// Load steps.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Steps {
    /// Factor on all loads and prescribed motions, one per step.
    pub load_factors: Vec<f64>,
}
