//! What models are given of a case.

use super::{body, specimen};
use crate::case::{Body, Case, RectangleBody};
use crate::diagnostic::{Faults, root};
use crate::model::{Asked, BodyKind, JoinedSides, Keys};

/// What a case asks of its model.
pub(crate) fn asked(case: &Case) -> Asked<'_> {
    let body = match &case.body {
        Body::Points(_) | Body::Mesh(_) => BodyKind::Points,
        Body::Rectangle(RectangleBody { size, spacing, holes, .. }) => {
            BodyKind::Rectangle { size: *size, spacing: *spacing, has_holes: !holes.is_empty() }
        }
        _ => BodyKind::Other,
    };
    let joined = |p: &crate::case::Periodic| JoinedSides { axis: p.along.number(), stretches: p.stretches };
    let poisson_ratios = case.materials.values().filter_map(|material| material.poisson_ratio).collect();
    Asked {
        body,
        body_path: body::path(case),
        breaks: case.fracture.is_some(),
        softens: case.path.is_some(),
        has_cracks: !case.cracks.is_empty() || specimen::kind(&case.body).is_some(),
        materials: (!case.materials.is_empty()).then_some(poisson_ratios),
        fibre_angles: case.materials.values().filter_map(|material| material.fibre_angle).collect(),
        symmetry: &case.symmetry,
        joined: case.periodic.iter().map(joined).collect(),
    }
}

/// The key that gives the horizon of a case.
pub(crate) fn horizon_key(case: &Case) -> &'static str {
    if case.horizon.is_some() { "horizon" } else { "horizon_ratio" }
}

/// Adds a fault for every key of a case that has no meaning for its model.
pub(crate) fn check_refused(case: &Case, keys: &dyn Keys, faults: &mut Faults) {
    let bearing = case.rigid.iter().position(|r| r.bearing.is_some());
    for refused in keys.refuses() {
        let is_given = match refused.key {
            "cracks" => !case.cracks.is_empty(),
            "fracture" => case.fracture.is_some(),
            "path" => case.path.is_some(),
            "periodic" => !case.periodic.is_empty(),
            "rigid" => !case.rigid.is_empty(),
            "rigid.bearing" => bearing.is_some(),
            "stress_intensity" => !case.stress_intensity.is_empty(),
            key => unreachable!("no model refuses `{key}`"),
        };
        let place = match (refused.key, bearing) {
            ("rigid.bearing", Some(k)) => root("rigid").index(k).key("bearing"),
            (key, _) => root(key),
        };
        if is_given {
            faults.error(place, refused.message).hint(refused.hint);
        }
    }
}
