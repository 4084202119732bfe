//! The model `bond_solid` of a case.

use peristat_assembly::model::bond_plane::{Influence, VolumeFactor, Weights};
use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::solid::SolidEdges;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An isotropic solid of central bonds; Poisson's ratio is 1/4.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BondSolidKeys {
    /// Young's modulus, > 0.
    pub youngs_modulus: f64,
    /// Poisson's ratio; central bonds have 1/4, and nothing else is taken.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub poisson_ratio: Option<f64>,
    /// How the stiffness of bonds depends on their length; `constant` if not given.
    #[serde(default)]
    pub influence: Influence,
    /// Where the stiffness of bonds comes from; `matched` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub calibration: Option<Calibration>,
    /// Which of all exact bonds are taken, with the calibration `matched`; `nearest` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weights: Option<Weights>,
    /// Parts of neighbours inside the horizon, of the calibration `published`; `ramp` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub volume_factor: Option<VolumeFactor>,
    /// What is done about the bonds that points near faces lack; `border` if not given, `none` with the calibration `published`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<SolidEdges>,
}
