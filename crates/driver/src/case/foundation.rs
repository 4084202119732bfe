//! Winkler foundations of a case.

use super::Sign;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A Winkler foundation: it pushes back with `stiffness` times the deflection per length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Foundation {
    /// Member of a frame that it is under.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
    /// Start; the left end of the body, or the joint `from` of the member, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<f64>,
    /// End; the right end of the body, or the joint `to` of the member, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<f64>,
    /// Force per length and deflection, >= 0, by the distance s from the start of the foundation; under a plate force per area and
    /// deflection.
    pub stiffness: BedStiffness,
    /// The only sign of the force with which it pushes: `positive` along w, as ground beneath a beam that is loaded downwards does.
    /// The beam lifts off it elsewhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub only: Option<Sign>,
}

/// How stiff a foundation is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BedStiffness {
    /// The same everywhere.
    Uniform(f64),
    /// `c₀ + c₁ s + c₂ s² + …`, under a beam.
    Polynomial(Vec<f64>),
    /// Straight between pairs `[s, value]` with growing s, under a beam; constant before the first and after the last. Two pairs with
    /// the same s are a jump.
    Table(Vec<[f64; 2]>),
    /// A formula of x and y, under a plate.
    Formula(String),
}
