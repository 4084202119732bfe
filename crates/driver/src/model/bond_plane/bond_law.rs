//! What bonds do beyond their elastic range, as cases write it.

use super::super::CriticalFormula;
use peristat_assembly::law::{Compression, Unloading};
use peristat_assembly::stiffness::Kinematics;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What bonds do beyond their elastic range.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PlaneBondLaw {
    /// Elastic to a yield stretch, softening linearly to nothing at a failure stretch.
    Bilinear(BilinearLaw),
}

/// The bilinear law. Of each pair `yield_stress` and `yield_stretch`, `energy_release_rate` and `failure_stretch`, one is
/// given.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BilinearLaw {
    /// Yield stress σ_y, > 0: all bonds that cross a plane yield at it, `s_y = 5σ_y/(8E)` in plane strain and `2σ_y/(3E)` in
    /// plane stress. A body in uniaxial stress yields at two thirds of it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yield_stress: Option<f64>,
    /// Multiplies the yield stretch that follows from `yield_stress`, > 0; 1, the published formula, if not given. 1.27
    /// makes up for the strength in a tensile test where s_f/s_y is 10.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yield_scale: Option<f64>,
    /// Stretch s_y at which a bond yields, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yield_stretch: Option<f64>,
    /// Energy per area of a crack G_c, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy_release_rate: Option<f64>,
    /// How the failure stretch follows from the energy release rate; `published` with the influence `constant`, else
    /// `energy`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub formula: Option<CriticalFormula>,
    /// Stretch s_f at which a bond fails, > s_y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub failure_stretch: Option<f64>,
    /// How a bond unloads; `plastic` if not given.
    #[serde(default)]
    pub unloading: Unloading,
    /// How a bond answers compression; `elastic` if not given.
    #[serde(default)]
    pub compression: Compression,
    /// Which elongation a displacement gives a bond; `linear` if not given.
    #[serde(default)]
    pub kinematics: Kinematics,
}
