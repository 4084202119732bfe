//! What the record of a run says of state-based families.

use super::super::material_summary::{Words, fact, of_influence};
use super::super::{MaterialSummary, Resolved};
use crate::units::{Units, number};
use peristat_assembly::model::state_based::{
    Axis, Dilatation, Geometry, Measure, StateEdges, StateParameters,
};
use serde_json::json;

/// An isotropic material and its families.
pub(super) fn summary(
    of: &StateParameters,
    name: &'static str,
    on: &Resolved,
    ghosts: usize,
    units: Units,
) -> MaterialSummary {
    let words = Words { units, name };
    let (state, plain) = match of.geometry {
        Geometry::PlaneStress(_) => ("plane_stress", ", plane stress"),
        Geometry::PlaneStrain(_) => ("plane_strain", ", plane strain"),
        Geometry::Axisymmetric => ("axisymmetric", ""),
    };
    let axis = axis(of, on);
    let mut entries = vec![
        ("state", json!(state)),
        ("youngs_modulus", json!(of.youngs_modulus)),
        ("poisson_ratio", json!(of.poisson_ratio)),
        ("influence", json!(of.influence)),
        ("edges", json!(of.edges)),
        ("measure", json!(of.measure)),
    ];
    entries.extend(axis.map(|axis| ("axis", json!(axis))));
    entries.extend([
        ("dilatation", json!(of.dilatation)),
        ("ghosts", json!(ghosts)),
        ("families", json!(of.has_families())),
    ]);
    let across = match of.geometry {
        Geometry::PlaneStress(thickness) | Geometry::PlaneStrain(thickness) => {
            format!(", {}", words.thickness(thickness))
        }
        Geometry::Axisymmetric => String::new(),
    };
    let (e, nu) = (words.stress(of.youngs_modulus), number(of.poisson_ratio));
    let facts = vec![
        fact("model", format!("{}{plain}, {}", words.name, measures(of, axis))),
        fact("material", format!("E = {e}, ν = {nu}{across}")),
    ];
    let edges = Some(edges(of.edges, ghosts));
    MaterialSummary { entries, facts, influence: of_influence(of.influence), edges }
}

/// What points next to the axis have, where the body touches it.
fn axis(of: &StateParameters, on: &Resolved) -> Option<Axis> {
    let touches = on.model.lattice().is_some_and(|(_, mirrors)| mirrors.lines[0][0].is_some());
    (of.is_axisymmetric() && touches && of.edges != StateEdges::Border).then_some(of.axis)
}

/// What families measure, in a few words.
fn measures(of: &StateParameters, axis: Option<Axis>) -> String {
    let measure = match (of.has_families(), of.dilatation) {
        (false, _) => "bonds alone: λ = μ",
        (true, Dilatation::Points) => "state-based families",
        (true, Dilatation::Blocks) => "state-based families, dilatation by blocks",
    };
    let rings =
        if of.measure == Measure::Published { ", neighbours by the volumes of their rings" } else { "" };
    let axis = match axis {
        None => "",
        Some(Axis::Table) => ", corrected at the axis",
        Some(Axis::Images) => ", images across the axis",
        Some(Axis::Truncated) => ", cut off at the axis",
    };
    format!("{measure}{rings}{axis}")
}

fn edges(edges: StateEdges, ghosts: usize) -> String {
    match edges {
        StateEdges::Border => "families are completed along the border".into(),
        StateEdges::Ghosts => format!("{ghosts} ghosts complete the families"),
        StateEdges::Moment | StateEdges::MomentPlus => "weights of what is left are exact".into(),
        StateEdges::Calibrated => "families are weighed by what is left of them".into(),
        StateEdges::None => "missing neighbours are not replaced".into(),
    }
}
