//! The model `bond_plane` of a case.

use super::super::PlaneState;
use super::PlaneBondLaw;
use peristat_assembly::model::bond_plane::{Influence, VolumeFactor, Weights};
use peristat_assembly::model::plane::{Calibration, Edges};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A body in the plane of isotropic central bonds.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    /// Young's modulus E, > 0.
    pub youngs_modulus: f64,
    /// Plane stress or plane strain.
    pub state: PlaneState,
    /// Thickness, > 0; default: 1.
    #[serde(default = "one")]
    pub thickness: f64,
    /// Poisson's ratio ν, which central bonds fix: 1/3 in plane stress, 1/4 in plane strain. Optional; any other value is an
    /// error.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub poisson_ratio: Option<f64>,
    /// How the stiffness of bonds depends on their length; default: `constant`.
    #[serde(default)]
    pub influence: Influence,
    /// Where the stiffness of bonds comes from; default: `published` where bonds break or soften and edges are not
    /// completed, else `matched`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub calibration: Option<Calibration>,
    /// Which of all exact bonds are taken, with the calibration `matched`; default: `nearest`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weights: Option<Weights>,
    /// Volume of points at the edge of the horizon, with the calibration `published`; default: `ramp`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub volume_factor: Option<VolumeFactor>,
    /// What makes up for the bonds that points near edges lack; default: `border` with the calibration `matched`, `none`
    /// with `published`. Where `border` does not exist the default is `overlay`, and `none` where bonds soften.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<Edges>,
    /// How bonds behave beyond their elastic range; they stay elastic if not given. It needs `path`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bond_law: Option<PlaneBondLaw>,
}

fn one() -> f64 {
    1.0
}
