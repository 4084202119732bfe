//! Bonds that yield and soften, and how the path of a body of them is followed.

use super::CriticalFormula;
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

/// How a body of bonds that soften is followed: `loads` and prescribed motions grow in proportion to a load factor, from
/// zero to one place after the other.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Path {
    /// What drives it; `auto` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub control: Option<PathControl>,
    /// Largest growth of the load factor in a step, between 0 and 1; 0.02 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub increment: Option<f64>,
    /// Where the path turns, in this order; to the load factor 1 if not given.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub turns: Vec<Turn>,
    /// Regions in which no bond yields, such as those around pins: bonds with an end there stay elastic. So do those of edges that supports hold.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub no_damage: Vec<String>,
    /// Name of the probe that stands for the load, such as a reaction.
    pub load: String,
    /// Name of the probe that the load is drawn over; the load factor if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub opening: Option<String>,
    /// The run ends where the load falls below this part of its largest value, between 0 and 1; it does not if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stop_below: Option<f64>,
    /// Largest energy that a step of `dissipation` takes, in energies of a crack as long as the spacing; 0.25 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy_increment: Option<f64>,
    /// The run ends after so many steps, >= 1; 10000 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_steps: Option<usize>,
    /// All fields are written at every step of this number, where the path turns and at its end, >= 1; 50 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub record_every: Option<usize>,
}

/// What drives a body along its path.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PathControl {
    /// `displacement`, unless bonds are so brittle that bodies snap back: then `event`, or `dissipation` with finite
    /// kinematics. It changes over where it gets stuck.
    #[default]
    Auto,
    /// Steps of the load factor: a body that would snap back jumps, and the energy of the jump is lost.
    Displacement,
    /// From one bond that yields or fails to the next, exactly; the load factor may fall. With linear kinematics.
    Event,
    /// Steps of dissipated energy; the load factor may fall.
    Dissipation,
}

/// Where a path turns.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Turn {
    /// At this load factor.
    LoadFactor(f64),
    /// Where the load has this value while the load factor falls: 0 to unload.
    Load(f64),
}
