//! What the record of a run says of beam bonds.

use super::super::MaterialSummary;
use super::super::material_summary::{Words, fact, of_calibration};
use super::NAME;
use crate::units::{Units, number};
use peristat_assembly::model::beam_bond_orthotropic::{BeamNeighbourhood, OrthotropicParameters, Start};
use serde_json::json;

/// An orthotropic material and its fibres.
pub(super) fn summary(of: &OrthotropicParameters, units: Units) -> MaterialSummary {
    let words = Words { units, name: NAME };
    // The bonds of a scene exist.
    let neighbourhood = BeamNeighbourhood::new(of).ok();
    let material = of.material;
    let effective = neighbourhood.as_ref().map_or(f64::NAN, BeamNeighbourhood::effective_shear_modulus);
    let consistent = neighbourhood.as_ref().is_some_and(BeamNeighbourhood::is_consistent);
    let start = neighbourhood.and_then(|neighbourhood| neighbourhood.start());
    let (fibres, rows) = (of.fibre_angle.to_degrees(), of.lattice_angle.to_degrees());
    let mut entries = vec![
        ("youngs_modulus_1", json!(material.youngs_modulus_1)),
        ("youngs_modulus_2", json!(material.youngs_modulus_2)),
        ("poisson_ratio_12", json!(material.poisson_ratio_12)),
        ("shear_modulus_12", json!(material.shear_modulus_12)),
        ("effective_shear_modulus_12", json!(effective)),
        ("consistent", json!(consistent)),
        ("fibre_angle", json!(fibres)),
        ("lattice_angle", json!(rows)),
    ];
    entries.extend(start.map(|start| ("start", json!(start))));
    let calibration = match start {
        Some(Start::Aligned) => "bonds with the exact moduli of the material, fibres along bonds",
        Some(Start::Oblique) => "bonds with the exact moduli of the material, fibres between bonds",
        None => of_calibration(of.calibration),
    };
    let moduli = [material.youngs_modulus_1, material.youngs_modulus_2, material.shear_modulus_12];
    let [e1, e2, g] = moduli.map(|modulus| words.stress(modulus));
    let (nu, thickness) = (number(material.poisson_ratio_12), words.thickness(material.thickness));
    let rows = match rows {
        0.0 => "rows of the lattice along x".into(),
        angle => format!("rows of the lattice at {}°", number(angle)),
    };
    let mut facts = vec![
        fact("model", format!("{}, plane stress, {calibration}", words.name)),
        fact("material", format!("E1 = {e1}, E2 = {e2}, ν12 = {nu}, G12 = {g}, {thickness}")),
        fact("fibres", format!("at {}° from x, {rows}", number(fibres))),
    ];
    if !consistent {
        let effective = words.stress(effective);
        let text = format!("strain and rotation are coupled: a body acts as if G12 = {effective}");
        facts.push(fact("shear", text));
    }
    MaterialSummary { entries, facts, influence: "", edges: None }
}
