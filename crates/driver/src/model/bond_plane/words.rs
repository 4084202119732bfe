//! What the record of a run says of central bonds.

use super::super::MaterialSummary;
use super::super::material_summary::{Words, fact, of_bonds, of_influence};
use crate::units::Units;
use peristat_assembly::model::bond_plane::{PlaneParameters, PlaneState};
use peristat_assembly::model::plane::Calibration;
use serde_json::json;

/// An isotropic material of central bonds.
pub(super) fn summary(of: &PlaneParameters, units: Units) -> MaterialSummary {
    let words = Words { units, name: "bond_plane" };
    let material = of.material;
    let (state, plain, nu) = match material.state {
        PlaneState::Stress => ("plane_stress", "plane stress", "1/3"),
        PlaneState::Strain => ("plane_strain", "plane strain", "1/4"),
    };
    let mut entries = vec![
        ("state", json!(state)),
        ("youngs_modulus", json!(material.youngs_modulus)),
        ("poisson_ratio", json!(material.state.poisson_ratio())),
        ("influence", json!(of.influence)),
    ];
    match of.calibration {
        Calibration::Published => entries.push(("volume_factor", json!(of.volume_factor))),
        Calibration::Matched => entries.push(("weights", json!(of.weights))),
    }
    let (e, thickness) = (words.stress(material.youngs_modulus), words.thickness(material.thickness));
    let facts = vec![
        fact("model", format!("{}, {plain}, {}", words.name, of_bonds(of.calibration, of.weights))),
        fact("material", format!("E = {e}, ν = {nu}, {thickness}")),
    ];
    MaterialSummary { entries, facts, influence: of_influence(of.influence), edges: None }
}
