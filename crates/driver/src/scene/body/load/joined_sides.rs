//! Forces through joined sides.

use super::context::LoadContext;
use super::sums::Forces;
use crate::case::{Case, Periodic};
use crate::scene::body::site::boundary;
use crate::scene::body::site::symmetry::edge_on;
use peristat_assembly::model::BodyModel;
use std::array::from_fn;

/// Forces of the case on the unknowns by which a body stretches, by numbers of the model.
pub(crate) fn forces(case: &Case, model: &dyn BodyModel) -> Forces {
    let Some((lattice, mirrors)) = model.lattice() else { return Vec::new() };
    let of = |given: &Periodic| {
        let (force, axis) = (given.force?, given.along.number());
        let [first, copy] = mirrors.stretch_points(lattice, axis)?;
        let along = |f: f64| from_fn::<f64, 3, _>(|k| if k == axis { f } else { 0.0 });
        Some([(copy as u32, along(force)), (first as u32, along(-force))])
    };
    case.periodic.iter().filter_map(of).flatten().collect()
}

/// The stress of the force of the case through joined sides along an axis, Pa.
pub(crate) fn stress(axis: usize, context: &LoadContext) -> Option<f64> {
    let is_along = |given: &&Periodic| given.along.number() == axis;
    let force = context.ground.case.periodic.iter().find(is_along)?.force?;
    let outline = context.ground.outline?;
    let (edge, _) = edge_on(outline, 2 * axis)?;
    let stretches = boundary::of_edge(outline.edge(&edge)?, context.ground);
    let area = context.area(&stretches);
    (area > 0.0).then(|| force / area)
}
