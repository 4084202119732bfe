//! Tractions that act through the border: where bonds end on it, every place of it moves with known points, so that a
//! traction does its own work, with the force and the moment that it has.

use super::on_border::{OnBorder, may_be_consistent};
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::load::sums::Forces;
use peristat_assembly::body::in_space;

/// Forces of a traction on points of the model, images among them: what acts there by a sign that is turned goes into the line
/// of symmetry ([`BodyScene::into_mirrors`](super::BodyScene::into_mirrors)). None where it acts otherwise.
pub(crate) fn forces(traction: &OnBorder, context: &LoadContext) -> Option<Forces> {
    let model = context.model?;
    if !may_be_consistent(traction, context) {
        return None;
    }
    let (shares, (lattice, _)) = (model.border_shares()?, model.lattice()?);
    let mut forces = vec![[0.0; 3]; model.points()];
    let stretches = traction.stretches(context.ground);
    for stretch in stretches.iter().flat_map(|stretch| stretch.between_lines(lattice)) {
        for (at, along) in traction.profile.on(&stretch) {
            let force = along.map(|t| context.material.across(at) * t);
            for (point, share) in shares(in_space(at), in_space(stretch.normal))? {
                (0..3).for_each(|k| forces[point][k] += share * force[k]);
            }
        }
    }
    let acting = (0..).zip(forces).filter(|(_, force)| *force != [0.0; 3]);
    Some(acting.collect())
}
