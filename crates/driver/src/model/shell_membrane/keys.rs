//! The model `shell_membrane` of a case.

use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::shell_membrane::{ShellEnds, ShellKinematics};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The membrane of a cylindrical shell of central bonds. Its body is the developed cylinder: x along the axis, y the arc
/// along the circumference, whose sides `periodic` joins. Displacements are `ux`, `uy` along the circumference, `w` outwards.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Shell {
    /// Young's modulus E, > 0.
    pub youngs_modulus: f64,
    /// Thickness, > 0.
    pub thickness: f64,
    /// Radius of the middle surface, > 0.
    pub radius: f64,
    /// Poisson's ratio ν: 1/3. Central bonds have no other; it need not be given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub poisson_ratio: Option<f64>,
    /// The elongation of a bond on a cylinder; `chord` if not given.
    #[serde(default)]
    pub kinematics: ShellKinematics,
    /// Where the stiffness of bonds comes from; `matched` if not given.
    #[serde(default)]
    pub calibration: Calibration,
    /// What is done about the bonds that leave the shell at its ends; `border` if not given.
    #[serde(default)]
    pub ends: ShellEnds,
    /// Whether bending resists changes of the curvature of the circumference, as ovalling needs.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub bending: bool,
}
