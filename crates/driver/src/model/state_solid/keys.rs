//! The model `state_solid` of a case.

use peristat_assembly::model::bond_plane::{Influence, VolumeFactor};
use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::solid::SolidEdges;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An isotropic solid of state-based families, any Poisson's ratio.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StateSolidKeys {
    /// Young's modulus, > 0.
    pub youngs_modulus: f64,
    /// Poisson's ratio, above -1 and below 1/2.
    pub poisson_ratio: f64,
    /// How the weights of neighbours depend on their distance; `constant` if not given.
    #[serde(default)]
    pub influence: Influence,
    /// Where the stiffness of bonds comes from; `matched` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub calibration: Option<Calibration>,
    /// Parts of neighbours inside the horizon, of the calibration `published`; `ramp` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub volume_factor: Option<VolumeFactor>,
    /// What is done about the bonds that points near faces lack; `border` if not given, `none` with the calibration `published`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<SolidEdges>,
}
