//! The body of a case in the plane, its material, mirrors and cracks.

use super::super::{horizon, root, words::tidy};
use super::bonds::PlaneBonds;
use super::model::Recipe;
use super::{NamedCrack, body, cracks, material, symmetry};
use crate::case::{Case, Plane};
use crate::diagnostic::Faults;
use crate::input::gmsh::Curve;
use peristat_assembly::body::{Outline, PlaneBody};
use peristat_assembly::model::plane::Edges;
use std::path::Path;

/// The largest horizon ratio: the bonds of a point grow with its square, and what finds their moduli with its fourth power.
const MOST_RATIO: f64 = 100.0;

/// What a case says of its body, before it has points in a model.
pub(super) struct Parts {
    pub(super) recipe: Recipe,
    pub(super) outline: Option<Outline>,
    pub(super) curves: Vec<Curve>,
    pub(super) cracks: Vec<NamedCrack>,
}

/// The body of the case, its material and its cracks.
pub(super) fn parts(
    case: &Case,
    model: &mut Plane,
    folder: &Path,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<Parts> {
    let listed = matches!(case.body, crate::case::Body::Points(_) | crate::case::Body::Mesh(_));
    let parameters = material::parameters(model, [listed, case.fracture.is_some()], faults);
    let cracks = cracks::cracks(case, faults);
    let built = body::build(case, model.thickness, 0.0, folder, max_memory, faults);
    let spacing = built.as_ref().map(|b| b.body.spacing());
    let ratio = horizon::horizon_ratio(case, spacing.unwrap_or(1.0), faults);
    let body::Built { body, outline, curves } = built?;
    let lattice = match &body {
        PlaneBody::Lattice(lattice) => Some(lattice),
        PlaneBody::Cloud(_) => None,
    };
    let symmetry = symmetry::symmetry(&case.symmetry, outline.as_ref(), lattice, faults);
    let (parameters, ratio) = (parameters?, ratio?);
    if ratio > MOST_RATIO {
        let key = if case.horizon.is_some() { "horizon" } else { "horizon_ratio" };
        faults
            .error(root(key), format!("a horizon of {} spacings has too many bonds per point", tidy(ratio)))
            .hint(format!(
                "the largest horizon ratio of bodies in the plane is {MOST_RATIO}; more than 12 never pays"
            ));
        return None;
    }
    let bonds = PlaneBonds::Central(parameters).with_horizon_ratio(ratio);
    let horizon = ratio * body.spacing();
    // The other treatments of edges know whole cells only, and loads have the volumes of the model.
    let body = match body {
        PlaneBody::Lattice(lattice) if bonds.edges() != Edges::Overlay => {
            PlaneBody::Lattice(lattice.with_whole_cells())
        }
        body => body,
    };
    let recipe = Recipe { body, symmetry, bonds, horizon };
    Some(Parts { recipe, outline, curves, cracks: cracks? })
}
