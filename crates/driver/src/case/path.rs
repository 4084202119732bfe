//! How the path of a body of bonds that soften is followed.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
