//! How a body breaks.

use crate::model::Critical;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Brittle fracture: the loads and prescribed motions grow from zero, and a bond that is strained to
/// its critical strain is gone for good. Every equilibrium is found anew with the bonds that are left.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fracture {
    /// At what strain bonds break.
    pub critical: Critical,
    /// Which of the bonds that are strained beyond their critical strain break before the next equilibrium is found;
    /// `batch` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strategy: Option<Strategy>,
    /// With `batch`, the ratio of strain to critical strain over the largest such ratio from which a bond breaks together
    /// with the worst, between 0 and 1; 0.9 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub batch_threshold: Option<f64>,
    /// Growth of the load factor from step to step, > 0; 0.02 if not given. The first step is the load factor at which the
    /// first bond breaks, and the last is 1, the loads and motions as written. Not with `worst`, which goes from break to
    /// break.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub increment: Option<f64>,
    /// Regions of a body in the plane in which no bond breaks, such as those around supports and loads: bonds with an end
    /// there. Bonds of points that are held or belong to rigid regions never break; those of a beam do, at clamps above all.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub no_fail: Vec<String>,
    /// Name of the probe that stands for the load in `curve.csv`, such as a reaction.
    pub load: String,
    /// The run ends where the load falls below this part of its largest value so far, between 0 and 1; 0.1 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stop_below: Option<f64>,
    /// The run ends after so many equilibria, >= 1; 5000 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_solves: Option<usize>,
    /// Parts of the body in which the direction of the crack is found; in the plane.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub directions: Vec<CrackDirection>,
    /// All fields are written at every equilibrium of this number, and at the last one, >= 1; 10 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub record_every: Option<usize>,
}

/// A part of a body in which the direction of a crack is found, as that in which the middles of the broken bonds spread most.
/// Checks know it as `<name>_direction`, degrees from x, -45 to 135, and the number of these bonds as `<name>_bonds`.
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
    /// Those strained nearly as much as the worst.
    #[default]
    Batch,
    /// The worst, with those that equal it by symmetry.
    Worst,
    /// All that are strained beyond their critical strain.
    All,
}
