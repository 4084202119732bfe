//! What the record of a run says of the material of a body in the plane: every model in a file of its own.

mod beams;
mod central;
mod families;
mod shell;

use super::words::{Fact, number};
use crate::case::Units;
use crate::scene::plane::{PlaneBonds, PlaneScene};
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::plane::Calibration;
use serde::{Serialize, Serializer};
use serde_json::Value;

/// The material and the bonds of a body, by numbers and in words.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialSummary {
    /// Keys and values of `summary.json`, in their order.
    pub entries: Vec<(&'static str, Value)>,
    /// The same in words, by name: `model`, `material` and whatever else the model has.
    pub(super) facts: Vec<Fact>,
    /// How the stiffness of bonds depends on their length, to follow the horizon.
    pub(super) influence: &'static str,
    /// What is done about edges, where the model does that by itself.
    pub(super) edges: Option<String>,
}

impl Serialize for MaterialSummary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.entries.iter().map(|(key, value)| (key, value)))
    }
}

/// The material of a scene.
pub(super) fn of(scene: &PlaneScene) -> MaterialSummary {
    let words = Words { units: scene.units, name: scene.bonds().name() };
    match scene.bonds() {
        PlaneBonds::Central(parameters) => central::summary(parameters, &words),
        PlaneBonds::Beams(parameters) => beams::summary(parameters, &words),
        PlaneBonds::State(parameters) => families::summary(parameters, scene, &words),
        PlaneBonds::Shell(parameters) => shell::summary(parameters, &words),
    }
}

/// What the words of all models have in common.
struct Words {
    units: Units,
    /// Name of the model.
    name: &'static str,
}

impl Words {
    fn length(&self, value: f64) -> String {
        self.units.quantity(&number(value), self.units.length())
    }

    fn stress(&self, value: f64) -> String {
        self.units.quantity(&number(value), self.units.stress())
    }

    fn thickness(&self, value: f64) -> String {
        format!("thickness {}", self.length(value))
    }
}

fn fact(key: &str, text: String) -> Fact {
    (key.to_string(), text)
}

fn of_calibration(calibration: Calibration) -> &'static str {
    match calibration {
        Calibration::Published => "bonds with the published constant",
        Calibration::Matched => "bonds with the exact moduli of the material",
    }
}

fn of_influence(influence: Influence) -> &'static str {
    match influence {
        Influence::Constant => "",
        Influence::Inverse => ", influence δ/ξ",
        Influence::Linear => ", influence 1 − ξ/δ",
    }
}
