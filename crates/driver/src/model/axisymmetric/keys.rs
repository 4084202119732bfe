//! The model `axisymmetric` of a case.

use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::state_based::{Axis, Dilatation, Measure, StateEdges};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An isotropic body of revolution of state-based families. The body is its section: x is the radius, y the axis.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Axisymmetric {
    /// Young's modulus E, > 0.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν, between −1 and 1/2.
    pub poisson_ratio: f64,
    /// How the weight of neighbours depends on their distance; `linear` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub influence: Option<Influence>,
    /// What is done about the neighbours that points near edges lack; `ghosts` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<StateEdges>,
    /// What neighbours count by.
    #[serde(default)]
    pub measure: Measure,
    /// What points next to the axis have, where the body touches it; `table` with the edges `ghosts` and the measure
    /// `section`, else `images`, if not given. With the edges `border` the body ends on its axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<Axis>,
    /// How changes of volume are measured; `blocks` for ν > 0.45, else `points`, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dilatation: Option<Dilatation>,
}
