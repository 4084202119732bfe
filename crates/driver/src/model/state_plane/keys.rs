//! The model `state_plane` of a case.

use super::super::PlaneState;
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::state_based::{Dilatation, StateEdges};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An isotropic body in the plane of state-based families, of any Poisson's ratio.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StatePlane {
    /// Young's modulus E, > 0.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν, between −1 and 1/2.
    pub poisson_ratio: f64,
    /// Plane stress or plane strain.
    pub state: PlaneState,
    /// Thickness, > 0; 1 if not given.
    #[serde(default = "one")]
    pub thickness: f64,
    /// How the weight of neighbours depends on their distance; `linear` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub influence: Option<Influence>,
    /// What is done about the neighbours that points near edges lack; `border` where the border cuts cells and no crack or
    /// `fracture` is given, else `ghosts`, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<StateEdges>,
    /// How changes of volume are measured; in plane strain `blocks` for ν > 0.45, else `points`, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dilatation: Option<Dilatation>,
}

fn one() -> f64 {
    1.0
}
