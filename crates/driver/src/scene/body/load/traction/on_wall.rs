//! Tractions on faces of solids and on the borders of what is cut out of them.
//!
//! A traction does its work on the displacement of the border. Where bonds end there, each place of it moves with known points.
//! Elsewhere the border moves with the two points behind it, continued linearly. Both follow every linear motion, so that force
//! and moment are exact. On stairs, as round cuts have them, a pressure acts on the sides of the cells: its forces are those on the
//! round border, as far as cells tell, because their shadows along every axis are the same. Where a surface says what its area and its
//! shadows are, the forces have their sums.

use super::wall_value::{self, WallValue};
use crate::case::Traction;
use crate::diagnostic::{Faults, JsonPath, suggest, tidy};
use crate::scene::body::hold::supports;
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::load::sums::BodyLoads;
use crate::scene::body::site::resultants;
use nalgebra::Vector3;
use peristat_assembly::body::{Cell, Patch, PointBody, Side, SquareLattice, WallSide, minus, plus};

/// Arms over spacings that are rounding.
const ROUNDING: f64 = 1e-9;
/// Part of a contact by which its face may miss it.
const PARTLY: f64 = 1e-6;

/// Adds a traction on a wall.
pub(crate) fn resolve(
    load: &Traction,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    let PointBody::Solid(lattice) = context.ground.body else {
        faults
            .error(path.clone(), "listed points have no faces on which a traction could act")
            .hint("use a `point` load on a region, which its points share, or a `body_force`");
        return;
    };
    let place = path.key("face");
    if load.edge.is_some() {
        faults
            .error(path.key("edge"), "edges are those of bodies in the plane")
            .hint("give the `face` on which it acts");
        return;
    }
    let Some(name) = &load.face else {
        faults.error(path.clone(), "`face` is missing").hint("give the name of a face, such as `right`");
        return;
    };
    supports::not_mirrored(Some(name), &place, context.symmetry, faults);
    let walls = context.ground.walls;
    let Some(wall) = walls.iter().find(|wall| wall.name == *name) else {
        let known = walls.iter().map(|wall| wall.name.as_str());
        faults.error(place, format!("there is no face `{name}`")).hint(suggest(name, known));
        return;
    };
    let sides = wall.areas(lattice);
    if sides.is_empty() {
        faults.error(place, format!("nothing is left of the face `{name}`"));
        return;
    }
    let Some(value) = wall_value::value(load, (wall, lattice), context, path, faults) else { return };
    if let Some(contact) = value.contact() {
        let part = contact.part_on(&sides, lattice, &context.symmetry.goes_on);
        tell_of_part(part, name, path.key("hertz").key("centre"), faults);
    }
    if wall.patch().is_some_and(Patch::is_slanted) {
        warn_of_slanted(name, place.clone(), faults);
    }
    if let Some(radius) = wall.radius() {
        warn_of_stairs(name, radius / lattice.spacing(), place, faults);
    }
    if act(&value, &sides, lattice, context, to) {
        warn_of_arms(name, path.key("face"), faults);
    }
}

/// Adds what acts on sides of cells; whether some of it lost its arm.
fn act(
    value: &WallValue,
    sides: &[WallSide],
    lattice: &SquareLattice,
    context: &LoadContext,
    to: &mut BodyLoads,
) -> bool {
    let whole: f64 = sides.iter().map(|own| own.area).sum();
    let shares = context.model.and_then(|model| model.border_shares());
    let mut has_lost_arm = false;
    for own in sides {
        let side = &own.side;
        for (at, force) in value.on(own, lattice, whole) {
            let part = |(point, share): (usize, f64)| (point as u32, force.map(|f| share * f));
            // Where the body is too thin for bonds that end on it, the border moves as elsewhere.
            let acts_at = match shares.as_ref().and_then(|shares| shares(at, side.normal())) {
                Some(shares) => {
                    to.through_border.extend(shares.into_iter().map(part));
                    at
                }
                None => {
                    let shares = behind(side, at, lattice);
                    let acts_at = middle_of(&shares, lattice);
                    to.forces.extend(shares.into_iter().map(part));
                    acts_at
                }
            };
            let arm = Vector3::from(acts_at) - Vector3::from(at);
            has_lost_arm |= arm.cross(&Vector3::from(force)).norm()
                > ROUNDING * lattice.spacing() * Vector3::from(force).norm();
            resultants::add_force(context.material, &mut to.asked, force, acts_at);
        }
    }
    has_lost_arm
}

/// A contact that reaches beyond its face, over a hole in it, or over a plane behind which the body goes on.
fn tell_of_part(part: f64, name: &str, place: JsonPath, faults: &mut Faults) {
    if part == 0.0 {
        faults.error(place, format!("the contact is beside the face `{name}`"));
    } else if (part - 1.0).abs() > PARTLY {
        let message = format!(
            "of the contact {} % lies on the face `{name}`: what is beside it does not act",
            tidy((1000.0 * part).round() / 10.0)
        );
        faults.warning(place, message).hint("where the body goes on behind a plane of symmetry, the middle of a contact belongs on that plane");
    }
}

/// Stairs give way more than a round border does. At two spacings a thick tube of 5, 10, 20 cells per radius widens by 7, 3, 2.4 % too
/// much, a hollow ball of 4, 6, 8, 12 by 7, 4, 4, 1.4 % in the mean.
fn warn_of_stairs(name: &str, cells: f64, place: JsonPath, faults: &mut Faults) {
    let short = |value: f64| tidy((10.0 * value).round() / 10.0);
    let message = format!(
        "cells make stairs of the round face `{name}`: with {} of them per radius displacements are up to about {} % too large, and stresses beside it are those of stairs",
        short(cells),
        short(40.0 / cells)
    );
    faults.warning(place, message).hint(
        "use a smaller spacing, or a body of revolution or a slice in the plane, whose borders are round",
    );
}

/// Stairs of a slanted face have its force, and the stresses of stairs.
fn warn_of_slanted(name: &str, place: JsonPath, faults: &mut Faults) {
    let message = format!(
        "cells make stairs of the face `{name}`: the force on it is that of the surface, and stresses beside it are those of stairs"
    );
    faults.warning(place, message).hint(
        "read stresses two spacings from it, or turn the part so that its loaded faces are across axes",
    );
}

/// Where forces act that points share.
fn middle_of(shares: &[(usize, f64)], lattice: &SquareLattice) -> [f64; 3] {
    let mut middle = [0.0; 3];
    for &(point, share) in shares {
        let at = lattice.position(point);
        (0..3).for_each(|k| middle[k] += share * at[k]);
    }
    middle
}

/// A part one cell thick has no points on both sides of its middle, so that what acts along its border has no arm.
fn warn_of_arms(name: &str, place: JsonPath, faults: &mut Faults) {
    let message = format!(
        "parts of the body behind `{name}` are one cell thick: what acts along their border acts in their middle, half a cell away"
    );
    faults.warning(place, message).hint("use a smaller spacing, so that they are at least two cells thick");
}

/// The points that move a place of a side where no bond ends on it, and their shares.
fn behind(side: &Side, at: [f64; 3], lattice: &SquareLattice) -> Vec<(usize, f64)> {
    let from = lattice.position(side.point);
    let mut shares = vec![(lattice.cell(side.point), 1.0)];
    for axis in 0..3 {
        let away = (at[axis] - from[axis]) / lattice.spacing();
        if away.abs() > 1e-9 {
            shares = shares
                .into_iter()
                .flat_map(|(cell, share)| moved(cell, axis, away, share, lattice))
                .collect();
        }
    }
    shares.into_iter().filter_map(|(cell, share)| Some((lattice.number(cell)?, share))).collect()
}

/// A place away from the middle of a cell, by so many spacings along an axis, moves linearly with the cells on both sides, or with those
/// on one side where the body ends.
fn moved(cell: Cell, axis: usize, away: f64, share: f64, lattice: &SquareLattice) -> Vec<(Cell, f64)> {
    let mut step = [0; 3];
    step[axis] = 1;
    let next = [plus(cell, step), minus(cell, step)].map(|cell| lattice.number(cell).map(|_| cell));
    let parts = match next {
        [Some(above), Some(below)] => vec![(cell, 1.0), (above, 0.5 * away), (below, -0.5 * away)],
        [Some(above), None] => vec![(cell, 1.0 - away), (above, away)],
        [None, Some(below)] => vec![(cell, 1.0 + away), (below, -away)],
        [None, None] => vec![(cell, 1.0)],
    };
    parts.into_iter().map(|(cell, part)| (cell, share * part)).collect()
}
