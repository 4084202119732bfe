//! Tractions on faces of solids and on the borders of what is cut out of them.
//!
//! A traction does its work on the displacement of the border. Where bonds end there, each place of it moves with known points.
//! Elsewhere the border moves with the two points behind it, continued linearly. Both follow every linear motion, so that force
//! and moment are exact. On stairs, as round cuts have them, a pressure acts on the sides of the cells: its forces are those on the
//! round border, as far as cells tell, because their shadows along every axis are the same.

use super::profile::Profile;
use crate::case::{SpaceAxis, Traction};
use crate::diagnostic::{Faults, JsonPath, suggest, tidy};
use crate::scene::body::hold::supports;
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::load::sums::BodyLoads;
use crate::scene::body::site::resultants;
use peristat_assembly::body::{Cell, PointBody, Side, SquareLattice, Wall, minus, plus};

/// Places of a side on both halves of an axis, in spacings from its middle: with them cubic functions are integrated exactly.
const GAUSS: f64 = 0.288_675_134_594_812_9;

/// What a traction is on a side of a cell.
#[derive(Clone, Copy, Debug)]
enum Value {
    /// The same force per area everywhere.
    Uniform([f64; 3]),
    /// Against the normal, per area.
    Pressure(f64),
    /// A force, shared by area.
    Total([f64; 3]),
    /// It varies along an axis, from the first number of metres to the second.
    Along(usize, [f64; 2], Profile),
}

/// Adds a traction on a wall.
pub(crate) fn resolve(
    load: &Traction,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
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
    let PointBody::Solid(lattice) = context.ground.body else { return };
    let sides = wall.sides(lattice);
    if sides.is_empty() {
        faults.error(place, format!("nothing is left of the face `{name}`"));
        return;
    }
    let Some(value) = value(load, wall, context, path, faults) else { return };
    if let Some(radius) = wall.radius() {
        warn_of_stairs(name, radius / lattice.spacing(), place, faults);
    }
    let area = lattice.spacing().powi(2);
    let shares = context.model.and_then(|model| model.border_shares());
    for side in &sides {
        for (at, traction) in value.on(side, lattice, sides.len() as f64 * area) {
            let force = traction.map(|t| t * area);
            resultants::add_force(context.material, &mut to.asked, force, at);
            let part = |(point, share): (usize, f64)| (point as u32, force.map(|f| share * f));
            // Where the body is too thin for bonds that end on it, the border moves as elsewhere.
            match shares.as_ref().and_then(|shares| shares(at, side.normal())) {
                Some(shares) => to.through_border.extend(shares.into_iter().map(part)),
                None => to.forces.extend(behind(side, at, lattice).into_iter().map(part)),
            }
        }
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

impl Value {
    /// Places of a side with the force that acts there per area of the side, N/m²; `area` is that of all sides.
    fn on(&self, side: &Side, lattice: &SquareLattice, area: f64) -> Vec<([f64; 3], [f64; 3])> {
        let middle = side.middle(lattice);
        match *self {
            Self::Uniform(traction) => vec![(middle, traction)],
            Self::Pressure(pressure) => vec![(middle, side.normal().map(|n| -n * pressure))],
            Self::Total(total) => vec![(middle, total.map(|f| f / area))],
            Self::Along(axis, [from, to], profile) => [-GAUSS, GAUSS]
                .map(|part| {
                    let mut at = middle;
                    at[axis] += part * lattice.spacing();
                    let value = profile.at((at[axis] - from) / (to - from), [0.0; 2]);
                    (at, value.map(|t| 0.5 * t))
                })
                .to_vec(),
        }
    }
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

/// What acts, from the one key that says it.
fn value(
    load: &Traction,
    wall: &Wall,
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Value> {
    let values = match wall.radius().is_some() {
        true => "give one of `pressure` and `total`",
        false => "give one of `uniform`, `pressure`, `total`, `linear` and `parabolic`",
    };
    let of_edges = [
        ("hertz", load.hertz.is_some()),
        ("depth", load.depth.is_some()),
        ("sharing", load.sharing.is_some()),
    ];
    if let Some((key, _)) = of_edges.iter().find(|key| key.1) {
        faults.error(path.key(*key), format!("`{key}` is for edges in the plane")).hint(values);
        return None;
    }
    let given = [
        ("uniform", load.uniform.is_some()),
        ("pressure", load.pressure.is_some()),
        ("total", load.total.is_some()),
        ("linear", load.linear.is_some()),
        ("parabolic", load.parabolic.is_some()),
    ];
    let keys: Vec<&str> = given.iter().filter(|g| g.1).map(|g| g.0).collect();
    let key = match keys[..] {
        [] => {
            faults.error(path.clone(), "the value of this traction is missing").hint(values);
            return None;
        }
        [_, second, ..] => {
            let message = format!("`{}` and `{second}` are both given", keys[0]);
            faults.error(path.key(second), message).hint(values);
            return None;
        }
        [key] => key,
    };
    if wall.face().is_none() && ["linear", "parabolic"].contains(&key)
        || wall.radius().is_some() && key == "uniform"
    {
        faults.error(path.key(key), format!("`{key}` is for flat faces of the block")).hint(values);
        return None;
    }
    if load.along.is_some() && !["linear", "parabolic"].contains(&key) {
        faults.error(path.key("along"), format!("`{key}` does not vary along an axis")).hint("leave it out");
        return None;
    }
    let at = path.key(key);
    let value = match load {
        Traction { uniform: Some(t), .. } => Value::Uniform(context.force(*t, key, &at, faults)?),
        Traction { total: Some(total), .. } => Value::Total(context.force(*total, key, &at, faults)?),
        Traction { linear: Some(ends), .. } => {
            let [from, to] = [0, 1].map(|k| context.force(ends[k], key, &at.index(k), faults));
            along(load.along, wall, Profile::Linear([from?, to?]), context, path, faults)?
        }
        Traction { parabolic: Some(middle), .. } => {
            let middle = context.force(*middle, key, &at, faults)?;
            along(load.along, wall, Profile::Parabolic(middle), context, path, faults)?
        }
        _ => Value::Pressure(load.pressure.unwrap_or(0.0)),
    };
    if value.is_zero() {
        faults.error(path.clone(), "this traction is zero");
    }
    Some(value)
}

impl Value {
    fn is_zero(&self) -> bool {
        match *self {
            Self::Uniform(t) | Self::Total(t) => t == [0.0; 3],
            Self::Pressure(pressure) => pressure == 0.0,
            Self::Along(.., profile) => {
                [0.0, 0.5, 1.0].iter().all(|&place| profile.at(place, [0.0; 2]) == [0.0; 3])
            }
        }
    }
}

/// What varies along an axis of a face, from one of its sides to the other.
fn along(
    axis: Option<SpaceAxis>,
    wall: &Wall,
    profile: Profile,
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Value> {
    let across = wall.face().map(|face| face.axis)?;
    let in_it: Vec<&str> = (0..3).filter(|&k| k != across).map(|k| ["x", "y", "z"][k]).collect();
    let hint = format!("take `{}` or `{}`, which lie in the face `{}`", in_it[0], in_it[1], wall.name);
    let Some(axis) = axis.map(SpaceAxis::number) else {
        faults.error(path.clone(), "`along` is missing: the axis along which the traction varies").hint(hint);
        return None;
    };
    if axis == across {
        faults.error(path.key("along"), "this axis is across the face").hint(hint);
        return None;
    }
    let ends = [2 * axis, 2 * axis + 1].map(|side| context.ground.walls[side].face().map(|face| face.at));
    Some(Value::Along(axis, [ends[0]?, ends[1]?], profile))
}
