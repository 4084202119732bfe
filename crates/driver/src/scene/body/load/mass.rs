//! Weight of a body and the inertia of one that turns.

use super::asked;
use super::body_force;
use super::context::LoadContext;
use super::sums::BodyLoads;
use crate::case::{Gravity, SpaceAxis, Spin};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::site::resultants;
use crate::scene::mass;
use peristat_assembly::body::SIDES;

/// The weight of the body or a region of it.
pub(crate) fn gravity(
    load: &Gravity,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    let Some(along) = context.force(load.along, "along", &path.key("along"), faults) else { return };
    let is_shell = context.material.has("w") && context.material.has("ux");
    let counts = context.material.surface().resultant();
    if (0..3).any(|k| !counts[k] && along[k] != 0.0) || (is_shell && along[1..] != [0.0; 2]) {
        let axis = if is_shell { "x, [1, 0, 0] or [-1, 0, 0]" } else { "y, [0, 1] or [0, -1]" };
        faults
            .error(path.key("along"), "weight across the axis is not the same all around it")
            .hint(format!("the axis of this body is along {axis}"));
        return;
    }
    for (axis, side, _) in mirrors(context).filter(|&(axis, ..)| along[axis] != 0.0) {
        let key = ["ux", "uy", "uz"][axis];
        faults
            .warning(
                path.key("along"),
                format!("the mirror `{side}` stands across the weight: behind it things fall the other way"),
            )
            .hint(format!("where a body rests on its side, hold it: {{ \"at\": {{ \"region\": \"{side}\" }}, \"{key}\": 0 }}"));
    }
    let Some(weight) = mass::weight(context.ground.case, load, along, path, faults) else { return };
    body_force::act(weight, false, load.region.as_ref(), context, path, to, faults);
    for (points, more) in of_others(load.region.as_ref(), context, path, faults) {
        body_force::on_points(weight.map(|w| more * w), &points, context, to);
    }
}

/// Points of a region, or of the body, whose materials have densities of their own, with what these have beyond that of the case over
/// it.
fn of_others(
    region: Option<&String>,
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) -> Vec<(Vec<u32>, f64)> {
    let (case, materials) = (context.ground.case, &context.inputs.materials);
    let own = |p: u32| materials.of(p as usize)?.density;
    let points: Vec<u32> = match region {
        Some(name) => context.ground.region(name, &path.key("region"), faults).unwrap_or_default(),
        None => (0..context.ground.body.points() as u32).collect(),
    };
    let of = |density: f64| {
        let alike = points.iter().copied().filter(|&p| own(p) == Some(density));
        Some((alike.collect(), density / case.density? - 1.0))
    };
    let mut densities: Vec<f64> = materials.others.iter().filter_map(|other| other.density).collect();
    densities.sort_by(f64::total_cmp);
    densities.dedup();
    densities.into_iter().filter_map(of).collect()
}

/// The inertia of a body that turns.
pub(crate) fn spin(
    load: &Spin,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    let value = mass::spin(context.ground.case, load, path, faults);
    let Some((centre, across)) = axis(load, context, path, faults) else { return };
    if !fits(centre, across, context, path, faults) {
        return;
    }
    let Some(value) = value else { return };
    for (points, more) in of_others(load.region.as_ref(), context, path, faults) {
        turn(&points, more * value, (centre, across), context, to);
    }
    let points = match &load.region {
        Some(name) => match context.ground.region(name, &path.key("region"), faults) {
            Some(points) => points,
            None => return,
        },
        None if context.material.surface().axis().is_some() => {
            to.spin += value;
            return;
        }
        None => (0..context.ground.body.points() as u32).collect(),
    };
    // Cells that do not fill the body have its mass all the same.
    let share = match &load.region {
        None => {
            let volume: f64 = points.iter().map(|&p| context.volume(p)).sum();
            asked::of_body([1.0, 0.0, 0.0], context).sizes()[0] / volume
        }
        Some(_) => 1.0,
    };
    turn(&points, value * share, (centre, across), context, to);
}

/// Adds the inertia of some points that turn about a centre, across some axes; `value` is that per volume and distance.
fn turn(
    points: &[u32],
    value: f64,
    (centre, across): ([f64; 3], [bool; 3]),
    context: &LoadContext,
    to: &mut BodyLoads,
) {
    for &p in points {
        let at = context.ground.body.position(p as usize);
        let scale = value * context.volume(p);
        let force = std::array::from_fn(|k| if across[k] { scale * (at[k] - centre[k]) } else { 0.0 });
        if context.material.surface().resultant() == [true; 3] {
            resultants::add_force(context.material, &mut to.asked, force, at);
        }
        to.forces.push((p, force));
    }
}

/// Mirrors: the axis across them, their names and their positions. The axis of a body of revolution is none.
fn mirrors(context: &LoadContext) -> impl Iterator<Item = (usize, &'static str, f64)> {
    let is_axis = move |side: usize| context.material.surface().axis() == Some(side);
    let at = context.symmetry.at.iter().enumerate().filter(move |(side, _)| !is_axis(*side));
    at.filter_map(|(side, at)| Some((side / 2, SIDES[side], (*at)?)))
}

/// Whether joined sides fit to a spin; mirrors beside its axis get a warning.
fn fits(
    centre: [f64; 3],
    across: [bool; 3],
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) -> bool {
    let beside = |&(axis, _, at): &(usize, &str, f64)| {
        across[axis] && (centre[axis] - at).abs() > 1e-6 * context.horizon
    };
    for (_, side, _) in mirrors(context).filter(beside) {
        faults
            .warning(
                path.clone(),
                format!(
                    "the axis does not lie in the mirror `{side}`: behind it the body turns about another one"
                ),
            )
            .hint("leave the mirror out, or put it on the axis");
    }
    let joined = (0..3).find(|&axis| across[axis] && context.symmetry.mirrors.joined[axis]);
    if let Some(axis) = joined {
        faults
            .error(
                path.clone(),
                format!("sides joined along {} have no distance from the axis", ["x", "y", "z"][axis]),
            )
            .hint("a body that repeats itself can turn about an axis along that direction only");
    }
    joined.is_none()
}

/// A point of the axis, and whether distances from it are along x, y and z.
fn axis(
    load: &Spin,
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<([f64; 3], [bool; 3])> {
    let material = context.material;
    let [is_plane, is_solid] = [material.has("uy"), material.has("uz")];
    if material.surface().axis().is_some() {
        for (key, _) in
            [("about", load.about.is_some()), ("axis", load.axis.is_some())].iter().filter(|k| k.1)
        {
            faults.error(
                path.key(*key),
                format!("`{key}` is not needed: a body of revolution turns about its own axis"),
            );
        }
        return Some(([0.0; 3], [true, false, false]));
    }
    if !is_plane || material.has("w") {
        faults
            .error(path.clone(), "`spin` is for bodies of revolution, bodies in the plane and solids")
            .hint("of a shell that turns about its axis it is a `pressure`: density times thickness times ω² times radius");
        return None;
    }
    let Some((about, count)) = load.about.map(|about| about.parts()) else {
        faults.error(path.clone(), "`about`, a position on the axis, is missing").hint(if is_solid {
            "such as `\"about\": [0, 0, 0], \"axis\": \"z\"`"
        } else {
            "such as `\"about\": [0, 0]`; the axis stands on the plane"
        });
        return None;
    };
    if count != if is_solid { 3 } else { 2 } {
        let s = if count == 1 { "" } else { "s" };
        let here = if is_solid {
            "in a solid have 3, along x, y and z"
        } else {
            "in the plane have 2, along x and y"
        };
        faults.error(path.key("about"), format!("`about` has {count} number{s}, and positions {here}"));
        return None;
    }
    let along = match (is_solid, load.axis) {
        (true, Some(axis)) => match axis {
            SpaceAxis::X => 0,
            SpaceAxis::Y => 1,
            SpaceAxis::Z => 2,
        },
        (false, None) => 2,
        (true, None) => {
            faults.error(path.clone(), "`axis` is missing").hint("\"x\", \"y\" or \"z\"");
            return None;
        }
        (false, Some(_)) => {
            faults.error(path.key("axis"), "`axis` is for solids").hint("in the plane the axis stands on it");
            return None;
        }
    };
    Some((about, std::array::from_fn(|k| k != along)))
}
