//! Rigid regions as cases give them.

use super::rigid::{MOTIONS, RigidPoints, key};
use super::supports::not_mirrored;
use crate::case::{Amount, Rigid, Steps};
use crate::diagnostic::{Faults, JsonPath, root};
use crate::scene::body::site::ground::Ground;
use crate::scene::body::site::symmetry::Symmetry;
use crate::scene::prescribed::Motion;
use peristat_assembly::body::PointBody;
use std::array::from_fn;

/// Rigid regions of the case, by numbers of the body.
pub(crate) fn rigid(ground: &Ground, symmetry: &Symmetry, faults: &mut Faults) -> Vec<RigidPoints> {
    let mut rigid: Vec<RigidPoints> = Vec::new();
    for (k, given) in ground.case.rigid.iter().enumerate() {
        let path = root("rigid").index(k);
        let place = path.key("region");
        not_mirrored(Some(&given.region), &place, symmetry, faults);
        let Some(points) = ground.region(&given.region, &place, faults) else { continue };
        if points.len() < 2 {
            faults
                .error(
                    place.clone(),
                    format!("the region `{}` is one point, which is rigid by itself", given.region),
                )
                .hint("hold a point by `supports`, or make the region larger than the spacing");
            continue;
        }
        if ground.body.axes() > 2 && is_straight(&points, ground.body) {
            faults
                .error(place, format!("the points of the region `{}` are on one line, which does not tell how they turn about it", given.region))
                .hint("make the region wider than the spacing in two directions");
            continue;
        }
        let shared = |r: &&RigidPoints| points.iter().any(|p| r.points.binary_search(p).is_ok());
        if let Some(other) = rigid.iter().find(shared) {
            faults
                .error(
                    place,
                    format!("the region `{}` shares points with that of `{}`", given.region, other.origin),
                )
                .hint("two rigid bodies that share points are one: take the union of both regions");
            continue;
        }
        rigid.push(resolve(given, points, ground, &path, faults));
    }
    rigid
}

/// Whether all points of a solid are on one straight line.
fn is_straight(points: &[u32], body: &PointBody) -> bool {
    let Some(&first) = points.first() else { return true };
    let origin = body.position(first as usize);
    let arms =
        points.iter().map(|&p| body.position(p as usize)).map(|at| [0, 1, 2].map(|k| at[k] - origin[k]));
    let squared = |v: &[f64; 3]| v.iter().map(|v| v * v).sum::<f64>();
    let Some(longest) = arms.clone().max_by(|a, b| squared(a).total_cmp(&squared(b))) else { return true };
    let across = |arm: [f64; 3]| {
        let cross = [0, 1, 2].map(|k| {
            let [next, last] = [(k + 1) % 3, (k + 2) % 3];
            longest[next] * arm[last] - longest[last] * arm[next]
        });
        (squared(&cross) / squared(&longest)).sqrt()
    };
    arms.map(across).all(|width| width < 0.5 * body.spacing())
}

fn resolve(
    given: &Rigid,
    points: Vec<u32>,
    ground: &Ground,
    path: &JsonPath,
    faults: &mut Faults,
) -> RigidPoints {
    let axes = ground.body.axes();
    let centre = given.centre.map_or_else(
        || centroid(&points, ground.body),
        |centre| {
            let (at, count) = centre.parts();
            if count != axes {
                let there =
                    if axes > 2 { "positions in a solid have 3" } else { "positions in the plane have 2" };
                let s = if count == 1 { "" } else { "s" };
                faults.error(path.key("centre"), format!("`centre` has {count} number{s}, and {there}"));
            }
            at
        },
    );
    let turn_about_z = if axes > 2 { &given.phi_z } else { &given.phi };
    if axes > 2 && given.phi.is_some() {
        faults
            .error(path.key("phi"), "a rigid region of a solid turns about three axes")
            .hint("give `phi_x`, `phi_y` or `phi_z`");
    }
    let keys = [&given.ux, &given.uy, &given.uz, &given.phi_x, &given.phi_y, turn_about_z];
    let (prescribed, by_step) = motions(keys, (ground.case.steps.as_ref(), axes), path, faults);
    RigidPoints { points, centre, prescribed, by_step, origin: path.to_string() }
}

/// The motions of a rigid region, and what they are in every step, where formulas of the load factor give one of them. Of what a
/// formula gives the largest value of all steps stands for it: it is zero only if all are.
fn motions(
    keys: [&Option<Amount>; MOTIONS],
    (steps, axes): (Option<&Steps>, usize),
    path: &JsonPath,
    faults: &mut Faults,
) -> ([Option<f64>; MOTIONS], Vec<[Option<f64>; MOTIONS]>) {
    let mut value = |motion: usize| {
        let (given, key) = (keys[motion].as_ref()?, key(motion, axes).unwrap_or("phi"));
        let given = Motion::new(given, 0, steps, &path.key(key), faults)?;
        Some((given.values([0.0; 3], None).unwrap_or_default(), given))
    };
    let all: [Option<(Vec<f64>, Motion)>; MOTIONS] = from_fn(&mut value);
    let largest = |values: &Vec<f64>| values.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()));
    let prescribed = from_fn(|k| all[k].as_ref().and_then(|(values, _)| largest(values)));
    let varies = all.iter().flatten().any(|(_, motion)| matches!(motion, Motion::BySteps(_)));
    let factors = steps.filter(|_| varies).map_or(&[][..], |steps| &steps.load_factors);
    let in_step = |(step, factor): (usize, &f64)| {
        from_fn(|k| match all[k].as_ref()? {
            (values, Motion::Proportional(_)) => values.first().map(|value| factor * value),
            (values, Motion::BySteps(_)) => values.get(step).copied(),
        })
    };
    (prescribed, factors.iter().enumerate().map(in_step).collect())
}

/// Centroid of points of a body.
pub(crate) fn centroid(points: &[u32], body: &PointBody) -> [f64; 3] {
    let size = |p: &u32| body.measure(*p as usize);
    let whole: f64 = points.iter().map(size).sum();
    let moment = |k: usize| points.iter().map(|p| size(p) * body.position(*p as usize)[k]).sum::<f64>();
    [0, 1, 2].map(|k| moment(k) / whole)
}
