//! What the record of a run says of state-based families of solids.

use super::super::MaterialSummary;
use super::super::material_summary::{Words, fact, of_calibration, of_influence};
use super::NAME;
use crate::units::{Units, number};

use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::state_solid::StateSolidParameters;
use serde_json::json;

/// An isotropic material.
pub(super) fn summary(of: &StateSolidParameters, units: Units) -> MaterialSummary {
    let words = Words { units, name: NAME };
    let mut entries = vec![
        ("youngs_modulus", json!(of.youngs_modulus)),
        ("poisson_ratio", json!(of.poisson_ratio)),
        ("influence", json!(of.influence)),
    ];
    if of.calibration == Calibration::Published {
        entries.push(("volume_factor", json!(of.volume_factor)));
    }
    let e = words.stress(of.youngs_modulus);
    let facts = vec![
        fact("model", format!("{NAME}, {}", of_calibration(of.calibration))),
        fact("material", format!("E = {e}, ν = {}", number(of.poisson_ratio))),
    ];
    MaterialSummary { entries, facts, influence: of_influence(of.influence), edges: None }
}
