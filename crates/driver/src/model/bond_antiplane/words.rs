//! What the record of a run says of bonds in antiplane shear.

use super::super::MaterialSummary;
use super::super::material_summary::{Words, fact, of_influence};
use super::NAME;
use crate::units::Units;
use peristat_assembly::model::bond_antiplane::AntiplaneParameters;
use serde_json::json;

/// An isotropic material that is sheared across the plane.
pub(super) fn summary(of: &AntiplaneParameters, units: Units) -> MaterialSummary {
    let words = Words { units, name: NAME };
    let entries = vec![("shear_modulus", json!(of.shear_modulus)), ("influence", json!(of.influence))];
    let (g, thickness) = (words.stress(of.shear_modulus), words.thickness(of.thickness));
    let facts = vec![
        fact("model", format!("{NAME}, antiplane shear, bonds with the exact shear modulus of the material")),
        fact("material", format!("G = {g}, {thickness}")),
    ];
    MaterialSummary { entries, facts, influence: of_influence(of.influence), edges: None }
}
