//! The model `plate_bending` of a case.

use peristat_assembly::model::plate_bending::ShearLaw;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An isotropic plate of Mindlin and Reissner in bending: points on its cells' corners, so on its edges, deflect by `w` and turn by
/// `phi_x` and `phi_y`, which are the slopes of `w` along x and y where shear is rigid. The usual horizon ratio is 1.5.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bending {
    /// Young's modulus E, > 0.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν, −1 < ν < 1/2.
    pub poisson_ratio: f64,
    /// Thickness t, > 0.
    pub thickness: f64,
    /// Shear correction factor κ, 0 < κ <= 1; 5/6 if not given.
    #[serde(default = "five_sixths")]
    pub shear_correction: f64,
    /// Shear stiffness of bonds; `corrected` if not given. `published` locks where the horizon is longer than the plate is thick.
    #[serde(default)]
    pub shear_law: ShearLaw,
}

fn five_sixths() -> f64 {
    5.0 / 6.0
}
