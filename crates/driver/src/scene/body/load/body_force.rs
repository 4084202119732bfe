//! Forces on the volume of a body in the plane.

use super::asked;
use super::context::LoadContext;
use super::sums::{BodyLoads, Forces};
use super::traction::lump;
use crate::case::BodyForce;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::site::resultants;
use crate::scene::prescribed::{Along, along, numbers};
use std::array::from_fn;

/// Forces per volume, or altogether, on a body or a region.
pub(crate) fn resolve(
    load: &BodyForce,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    let (value, is_total) = match (&load.density, load.total) {
        (Some(density), None) => {
            let Some(density) = context.along(density, "density", &path.key("density"), faults) else {
                return;
            };
            match numbers(&density) {
                Some(value) => (Some(value), false),
                None => return by_formula(&density, load.region.as_ref(), context, path, to, faults),
            }
        }
        (None, Some(total)) => (context.force(total, "total", &path.key("total"), faults), true),
        (None, None) => {
            faults.error(path.clone(), "neither `density` nor `total` is given").hint(
                "`density` is a force per volume, `total` the force on all points together; weight is the load `gravity`",
            );
            return;
        }
        (Some(_), Some(_)) => {
            faults
                .error(path.key("total"), "`density` and `total` are both given")
                .hint("remove one of them");
            return;
        }
    };
    let Some(value) = value else { return };
    if value == [0.0; 3] && context.factor.is_none() {
        faults.error(path.clone(), "this load is zero");
    }
    act(value, is_total, load.region.as_ref(), context, path, to, faults);
}

/// Forces per volume by formulas, on the body or a region: of every point that at its place.
fn by_formula(
    density: &Along,
    region: Option<&String>,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    let body = context.ground.body;
    let points = match region {
        Some(name) => context.ground.region(name, &path.key("region"), faults),
        None => Some((0..body.points() as u32).collect()),
    };
    let points = points.unwrap_or_default();
    // Cells that do not fill the body have its forces all the same.
    let share = match region {
        None => {
            let volume: f64 = points.iter().map(|&p| context.volume(p)).sum();
            whole(context) / volume
        }
        Some(_) => 1.0,
    };
    to.by_formula = true;
    for p in points {
        let (at, volume) = (body.position(p as usize), share * context.volume(p));
        let spacing = if body.cells().is_some() { body.spacing() } else { 0.0 };
        let axes = if spacing > 0.0 { body.axes() } else { 0 };
        let over = |rule: &[(f64, f64)]| {
            let mut force = [0.0; 3];
            let mut add = |away: [f64; 3], weight: f64| {
                let density = along(density, from_fn(|k| at[k] + spacing * away[k]))?;
                (0..3).for_each(|k| force[k] += weight * volume * density[k]);
                Ok(())
            };
            over_cell(rule, axes, &mut add).map(|()| force)
        };
        // As it is asked for, by a rule that sees more of it.
        let found = over(&TWO).and_then(|force| Ok((force, over(&THREE)?)));
        match found {
            Ok((force, asked)) => {
                resultants::add_force(context.material, &mut to.asked, asked, at);
                to.forces.push((p, force));
            }
            Err(reason) => {
                faults.error(path.key("density"), reason);
                return;
            }
        }
    }
}

/// Places and weights of rules of Gauss over a unit of length around zero, exact for degrees three and five.
const TWO: [(f64, f64); 2] = [(-0.288_675_134_594_812_9, 0.5), (0.288_675_134_594_812_9, 0.5)];
const THREE: [(f64, f64); 3] =
    [(-0.387_298_334_620_741_7, 5.0 / 18.0), (0.0, 4.0 / 9.0), (0.387_298_334_620_741_7, 5.0 / 18.0)];

/// Calls `add` with the places and weights of a rule along some axes of a unit cell.
fn over_cell(
    rule: &[(f64, f64)],
    axes: usize,
    add: &mut dyn FnMut([f64; 3], f64) -> Result<(), String>,
) -> Result<(), String> {
    for k in 0..rule.len().pow(axes as u32) {
        let (mut away, mut weight, mut digits) = ([0.0; 3], 1.0, k);
        for own in away.iter_mut().take(axes) {
            let (place, share) = rule[digits % rule.len()];
            (*own, weight, digits) = (place, weight * share, digits / rule.len());
        }
        add(away, weight)?;
    }
    Ok(())
}

/// A force on the body or a region, per volume or in all.
pub(super) fn act(
    value: [f64; 3],
    is_total: bool,
    region: Option<&String>,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    let points = match region {
        Some(name) => match context.ground.region(name, &path.key("region"), faults) {
            Some(points) => Some(points),
            None => return,
        },
        None => None,
    };
    let Some(points) = points else { return on_body(value, is_total, context, to) };
    let volume: f64 = points.iter().map(|&p| context.volume(p)).sum();
    let density = if is_total { value.map(|f| f / volume) } else { value };
    on_points(density, &points, context, to);
}

/// A force per volume on some points.
pub(super) fn on_points(density: [f64; 3], points: &[u32], context: &LoadContext, to: &mut BodyLoads) {
    for &p in points {
        let force = density.map(|b| b * context.volume(p));
        resultants::add_force(
            context.material,
            &mut to.asked,
            force,
            context.ground.body.position(p as usize),
        );
        to.forces.push((p, force));
    }
}

/// Volume of the body, as its border tells it.
fn whole(context: &LoadContext) -> f64 {
    let unit = if context.material.has("ux") { [1.0, 0.0, 0.0] } else { [0.0, 0.0, 1.0] };
    asked::of_body(unit, context).sizes()[0]
}

/// A force on the whole body, per volume or in all. Where cells do not fill the body their forces are those of what they have,
/// with what they lack of force and moment shared by all.
fn on_body(value: [f64; 3], is_total: bool, context: &LoadContext, to: &mut BodyLoads) {
    let body = context.ground.body;
    let unit = whole(context);
    let density = if is_total { value.map(|f| f / unit) } else { value };
    let asked = asked::of_body(density, context);
    (0..3).for_each(|k| to.weight[k] += density[k]);
    to.asked.add_multiple(1.0, &asked);
    let force = |p: u32| (p, density.map(|b| b * context.volume(p)));
    let mut forces: Forces = (0..body.points() as u32).map(force).collect();
    let mut missing = asked;
    let at = |p: u32| body.position(p as usize);
    forces
        .iter()
        .for_each(|&(p, f)| resultants::add_force(context.material, &mut missing, f.map(|f| -f), at(p)));
    let is_whole = body.cells().is_some_and(|lattice| lattice.cut_cells().is_empty());
    let lacks =
        missing.force().into_iter().chain([missing.moment()[2] * asked.sizes()[0] / asked.sizes()[1]]);
    if is_whole && lacks.fold(0.0, |a: f64, f| a.max(f.abs())) <= 1e-12 * asked.sizes()[0] {
        (0..3).for_each(|k| to.density[k] += density[k]);
        return;
    }
    if context.symmetry.mirrors.is_none() && context.material.surface().resultant() == [true; 3] {
        lump::add_resultant(&mut forces, &missing, context);
    } else {
        // A mirror takes moments, and rings have none.
        let found: f64 = forces.iter().map(|&(p, _)| context.volume(p)).sum();
        forces.iter_mut().for_each(|f| f.1 = f.1.map(|f| unit / found * f));
    }
    to.forces.extend(forces);
}
