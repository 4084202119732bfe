//! Resultants of forces on a body.

use crate::model::Material;
use crate::scene::Resultant;
use peristat_assembly::body::in_space;
use peristat_assembly::model::BodyModel;

/// Adds a force, N, at a position to a resultant: what a shell has along its circumference turns it about its axis, and what it
/// has outwards is not counted.
pub(crate) fn add_force(material: &dyn Material, to: &mut Resultant, force: [f64; 3], at: [f64; 3]) {
    match material.cylinder_radius() {
        Some(radius) => {
            to.add([force[0], 0.0, 0.0], [0.0; 3]);
            to.add_moment(2, radius * force[1]);
        }
        None => to.add(force, at),
    }
}

/// Resultant of forces on the unknowns of a model, component by component. What acts on an image acts on its point, in its
/// mirror.
pub(crate) fn resultant(model: &dyn BodyModel, material: &dyn Material, forces: &[f64]) -> Resultant {
    let n = model.points();
    let (components, turning) = ([0, 1, 2].map(|axis| model.along(axis)), model.turning());
    let lattice = model.lattice().filter(|(_, mirrors)| !mirrors.is_none());
    let mut sum = Resultant::default();
    for point in 0..n {
        let mut force = components.map(|component| component.map_or(0.0, |c| forces[c * n + point]));
        let turn = turning.map_or(0.0, |(component, length)| length * forces[component * n + point]);
        if force == [0.0; 3] && turn == 0.0 {
            continue;
        }
        let mut at = model.position(point);
        if let Some((lattice, mirrors)) = lattice {
            let (cell, signs) = mirrors.image(lattice.cell(point));
            (0..3).for_each(|k| force[k] *= signs[k]);
            at = if lattice.is_plane() { in_space(lattice.place_of(cell)) } else { lattice.centre(cell) };
        }
        add_force(material, &mut sum, force, at);
        if turn != 0.0 {
            sum.add_moment(2, turn);
        }
    }
    sum
}
