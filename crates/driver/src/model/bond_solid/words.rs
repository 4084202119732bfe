//! What the record of a run says of central bonds of solids.

use super::super::MaterialSummary;
use super::super::material_summary::{Words, fact, of_bonds, of_influence};
use super::NAME;
use crate::units::Units;
use peristat_assembly::model::bond_solid::BondSolidParameters;
use peristat_assembly::model::bond_solid::POISSON_RATIO;
use peristat_assembly::model::plane::Calibration;
use serde_json::json;

/// An isotropic material.
pub(super) fn summary(of: &BondSolidParameters, units: Units) -> MaterialSummary {
    let words = Words { units, name: NAME };
    let mut entries = vec![
        ("youngs_modulus", json!(of.youngs_modulus)),
        ("poisson_ratio", json!(POISSON_RATIO)),
        ("influence", json!(of.influence)),
    ];
    match of.calibration {
        Calibration::Published => entries.push(("volume_factor", json!(of.volume_factor))),
        Calibration::Matched => entries.push(("weights", json!(of.weights))),
    }
    let e = words.stress(of.youngs_modulus);
    let facts = vec![
        fact("model", format!("{NAME}, {}", of_bonds(of.calibration, of.weights))),
        fact("material", format!("E = {e}, ν = 1/4")),
    ];
    MaterialSummary { entries, facts, influence: of_influence(of.influence), edges: None }
}
