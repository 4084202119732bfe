//! What the record of a run says of a material.

use crate::units::{Units, number};
use peristat_assembly::model::bond_plane::{Influence, Weights};
use peristat_assembly::model::plane::Calibration;
use serde::{Serialize, Serializer};
use serde_json::Value;

/// A name and what it is.
pub type Fact = (String, String);

/// The material and the bonds of a body, by numbers and in words.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialSummary {
    /// Keys and values of `summary.json`, in their order.
    pub entries: Vec<(&'static str, Value)>,
    /// The same in words, by name: `model`, `material` and whatever else the model has.
    pub facts: Vec<Fact>,
    /// How the stiffness of bonds depends on their length, to follow the horizon.
    pub influence: &'static str,
    /// What is done about edges, where the model does that by itself.
    pub edges: Option<String>,
}

impl Serialize for MaterialSummary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.entries.iter().map(|(key, value)| (key, value)))
    }
}

/// What the words of all models have in common.
pub(super) struct Words {
    /// Units of the case.
    pub(super) units: Units,
    /// Name of the model.
    pub(super) name: &'static str,
}

impl Words {
    pub(super) fn length(&self, value: f64) -> String {
        self.units.quantity(&number(value), self.units.length())
    }

    pub(super) fn stress(&self, value: f64) -> String {
        self.units.quantity(&number(value), self.units.stress())
    }

    pub(super) fn thickness(&self, value: f64) -> String {
        format!("thickness {}", self.length(value))
    }
}

pub(super) fn fact(key: &str, text: String) -> Fact {
    (key.to_string(), text)
}

pub(super) fn of_calibration(calibration: Calibration) -> &'static str {
    match calibration {
        Calibration::Published => "bonds with the published constant",
        Calibration::Matched => "bonds with the exact moduli of the material",
    }
}

/// The same with the choice among exact bonds.
pub(super) fn of_bonds(calibration: Calibration, weights: Weights) -> String {
    let isotropic = match weights {
        Weights::Nearest => "",
        Weights::Isotropic => ", isotropic in the sixth order",
    };
    format!("{}{isotropic}", of_calibration(calibration))
}

pub(super) fn of_influence(influence: Influence) -> &'static str {
    match influence {
        Influence::Constant => "",
        Influence::Inverse => ", influence δ/ξ",
        Influence::Linear => ", influence 1 − ξ/δ",
    }
}
