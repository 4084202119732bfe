//! How a body breaks.

use crate::model::Critical;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Brittle fracture: loads and prescribed motions grow from zero, and a bond that reaches its critical strain breaks
/// for good. Each equilibrium is solved with the bonds that remain.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fracture {
    /// The strains at which bonds break.
    pub critical: Critical,
    /// Which of the bonds strained beyond their critical strain break before the next equilibrium is solved; default:
    /// `batch`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strategy: Option<Strategy>,
    /// With `batch`: a bond breaks together with the worst if its ratio of strain to critical strain is at least this
    /// fraction of the largest ratio; between 0 and 1, default: 0.9.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub batch_threshold: Option<f64>,
    /// Increment of the load factor per step, > 0; default: 0.02. The first step is the load factor at which the
    /// first bond breaks, and the last is 1, the loads and motions as written. Not with `worst`, which goes from break to
    /// break.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub increment: Option<f64>,
    /// Regions of a body in the plane, of a plate in bending or of a solid in which no bond breaks, such as those around supports and loads: bonds with an end
    /// there. Bonds of points that are held or belong to rigid regions never break; those of beams and of plates in bending do, at clamps above all.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub no_fail: Vec<String>,
    /// Name of the probe that stands for the load in `curve.csv`, such as a reaction.
    pub load: String,
    /// The run ends when the load falls below this fraction of its peak so far, between 0 and 1; default: 0.1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stop_below: Option<f64>,
    /// Largest number of equilibria, >= 1; the run ends there. Default: 5000.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_solves: Option<usize>,
    /// Parts of the body in which the direction of the crack is found; in the plane.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub directions: Vec<CrackDirection>,
    /// Writes all fields at every n-th equilibrium and at the last one; n >= 1, default: 10.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub record_every: Option<usize>,
}

/// A part of a body in which the direction of a crack is found, as that in which the middles of the broken bonds spread most.
/// Checks know it as `<name>_direction`, degrees from x, -45 to 135, and the number of these bonds as `<name>_bonds`.
/// Fewer than two bonds have no direction, and its check fails.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CrackDirection {
    /// Name, unique among them.
    pub name: String,
    /// Lower left corner of the part.
    pub from: [f64; 2],
    /// Upper right corner.
    pub to: [f64; 2],
}

impl CrackDirection {
    /// What checks know of it: the names of the direction and of the number of bonds.
    pub fn facts(&self) -> [String; 2] {
        [format!("{}_direction", self.name), format!("{}_bonds", self.name)]
    }
}

/// Which bonds break at an equilibrium.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Strategy {
    /// The worst bond and those strained nearly as much.
    #[default]
    Batch,
    /// The worst bond and those that equal it by symmetry.
    Worst,
    /// All bonds strained beyond their critical strain.
    All,
}
