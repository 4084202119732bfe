//! The model `bond_antiplane` of a case.

use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::plane::Edges;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A plate of isotropic bonds in antiplane shear: points move across the plane alone, by `w`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Antiplane {
    /// Shear modulus G, > 0.
    pub shear_modulus: f64,
    /// Thickness, > 0; 1 if not given.
    #[serde(default = "one")]
    pub thickness: f64,
    /// How the stiffness of bonds depends on their length; `constant` if not given.
    #[serde(default)]
    pub influence: Influence,
    /// What is done about the bonds that points near edges lack; `border` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<Edges>,
}

fn one() -> f64 {
    1.0
}
