//! How the path of a body of bonds that soften is followed.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How to follow a body whose bonds soften: `loads` and prescribed motions are proportional to a load factor, which goes
/// from zero to one turn after the other.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Path {
    /// What controls the path; default: `auto`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub control: Option<PathControl>,
    /// Largest increment of the load factor in a step, between 0 and 1; default: 0.02.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub increment: Option<f64>,
    /// Where the path turns, in this order; default: one path to the load factor 1.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub turns: Vec<Turn>,
    /// Regions in which no bond yields, such as those around pins: bonds with an end there stay elastic. So do those of edges that supports hold.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub no_damage: Vec<String>,
    /// Name of the probe that stands for the load, such as a reaction.
    pub load: String,
    /// Name of the probe on the horizontal axis of the load curve; the load factor if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub opening: Option<String>,
    /// The run ends when the load falls below this fraction of its peak, between 0 and 1; no limit if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stop_below: Option<f64>,
    /// Largest energy dissipated in a step of `dissipation`, over that of a crack one spacing long; default: 0.25.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy_increment: Option<f64>,
    /// Largest number of steps, >= 1; the run ends there. Default: 10000.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_steps: Option<usize>,
    /// Writes all fields at every n-th step, where the path turns and at its end; n >= 1, default: 50.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub record_every: Option<usize>,
}

/// What controls a path.
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
    /// The path turns at this load factor.
    LoadFactor(f64),
    /// The load factor falls until the load has this value, where the path turns: 0 to unload.
    Load(f64),
}
