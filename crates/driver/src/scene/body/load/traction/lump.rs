//! Tractions as forces on the nearest points.

use super::on_border::OnBorder;
use crate::scene::Resultant;
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::load::sums::Forces;
use crate::scene::body::site::boundary::{Border, Stretch};
use peristat_assembly::body::{PointBody, Region, Regions};
use std::collections::BTreeMap;

/// Positions on a stretch, m, and tractions there times the lengths that they stand for, N/m.
type OnStretch = Vec<([f64; 2], [f64; 3])>;

/// Forces of a traction on points of the body, each stretch of its borders on the nearest point, with the exact force and
/// moment. Chords of a curve act together: their own moments would be those of a point or two.
pub(crate) fn forces(borders: &[&OnBorder], context: &LoadContext) -> Forces {
    let Some(profile) = borders.first().map(|border| &border.profile) else { return Vec::new() };
    let stretches: Vec<Stretch> =
        borders.iter().flat_map(|border| border.stretches(context.ground)).collect();
    let candidates: Vec<u32> = borders.iter().flat_map(|border| candidates(border, context)).collect();
    on_points(&stretches, &|stretch| profile.on(stretch), &candidates, context)
}

/// Points that a border can act on.
fn candidates(traction: &OnBorder, context: &LoadContext) -> Vec<u32> {
    let unfound = &mut crate::diagnostic::Faults::default();
    match &traction.border {
        Border::Curved { hole: None, .. } => Vec::new(),
        _ => context.ground.region(&traction.name, &Default::default(), unfound).unwrap_or_default(),
    }
}

/// Positions on a stretch with a traction that is the same all along it, Pa.
pub(crate) fn constant(traction: [f64; 3], stretch: &Stretch) -> OnStretch {
    stretch.samples().map(|s| (s.at, traction.map(|t| s.length * t))).collect()
}

/// The same for any stretches and any traction on them; curves of meshes know their points, other stretches take the nearest
/// of the candidates.
pub(crate) fn on_points(
    stretches: &[Stretch],
    traction: &dyn Fn(&Stretch) -> OnStretch,
    candidates: &[u32],
    context: &LoadContext,
) -> Forces {
    let mut forces: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
    let mut wanted = Resultant::default();
    for stretch in stretches {
        let points = nearest(stretch, candidates, context);
        let mut force = [0.0; 3];
        for (at, along) in traction(stretch) {
            let share = along.map(|t| context.material.across(at) * t);
            (0..3).for_each(|k| force[k] += share[k]);
            if !points.is_empty() {
                wanted.add(share, [at[0], at[1], 0.0]);
            }
        }
        for &point in &points {
            let sum = forces.entry(point).or_default();
            (0..3).for_each(|k| sum[k] += force[k] / points.len() as f64);
        }
    }
    let mut forces = on_held_lines(forces, context);
    settle(&mut forces, wanted, is_halved(stretches, context), context);
    forces
}

/// Forces where an edge is held on its line, shared by the points whose displacements make that of the edge: the support
/// takes them whole.
fn on_held_lines(forces: BTreeMap<u32, [f64; 3]>, context: &LoadContext) -> Forces {
    let mut shared: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
    for (point, force) in forces {
        for (component, f) in force.into_iter().enumerate() {
            let mut add = |point: u32, share: f64| shared.entry(point).or_default()[component] += share * f;
            match context.held.iter().find_map(|h| h.sharing(point, component)) {
                Some(shares) => shares.for_each(|(point, share)| add(point, share)),
                None => add(point, 1.0),
            }
        }
    }
    shared.into_iter().collect()
}

/// Positions this close to each other, in spacings, are as near.
const TIE: f64 = 1e-6;

/// The points that take the force of a stretch: the one in whose cell it is, half a spacing inwards, else the nearest; all
/// of those that are as near share it, so that symmetric borders have symmetric forces.
fn nearest(stretch: &Stretch, candidates: &[u32], context: &LoadContext) -> Vec<u32> {
    if let Some(point) = stretch.point {
        return vec![point];
    }
    let body = context.ground.body;
    let tie = TIE * body.spacing();
    if let PointBody::Lattice(lattice) = body {
        let inside = [0, 1].map(|k| stretch.middle[k] - 0.5 * lattice.spacing() * stretch.normal[k]);
        let corners = [[-tie, -tie], [tie, -tie], [-tie, tie], [tie, tie]];
        let cells = corners.map(|d| lattice.cell_at([0, 1].map(|k| inside[k] + d[k])));
        let mut points: Vec<u32> = cells.iter().filter_map(|c| Some(lattice.number(*c)? as u32)).collect();
        points.sort_unstable();
        points.dedup();
        if !points.is_empty() {
            return points;
        }
    }
    let distance = |p: u32| {
        let [x, y] = body.place(p as usize);
        (x - stretch.middle[0]).hypot(y - stretch.middle[1])
    };
    let least = candidates.iter().map(|&p| distance(p)).fold(f64::INFINITY, f64::min);
    if candidates.is_empty() {
        // What holes leave of an edge may have no point of its own.
        let regions = Regions { body, outline: None, walls: &[], parts: &[], named: &BTreeMap::new() };
        return regions.select(&Region::Corner { at: stretch.middle }).unwrap_or_default();
    }
    candidates.iter().copied().filter(|&p| distance(p) <= least + tie).collect()
}

/// Whether a border reaches a mirror: then its image continues it, and both together have no moment.
fn is_halved(stretches: &[Stretch], context: &LoadContext) -> bool {
    let slack = 1e-6 * context.ground.body.spacing();
    let [left, right, below, above, ..] = context.symmetry.at;
    [(0, left), (0, right), (1, below), (1, above)].into_iter().any(|(axis, at)| {
        let reaches = |at: f64| {
            let half = |s: &Stretch| 0.5 * s.length * s.normal[1 - axis].abs() + slack;
            // An arc bends away from its stretch by less than a tenth of its length.
            stretches.iter().any(|s| (s.middle[axis] - at).abs() <= half(s) + 0.1 * s.length)
        };
        at.is_some_and(reaches)
    })
}

/// Adds small forces to those of some points so that force and moment are the wanted ones; none where a mirror
/// halves the border: forces are exact without, and the image has the opposite moment.
fn settle(forces: &mut Forces, mut wanted: Resultant, is_halved: bool, context: &LoadContext) {
    let at = |p: u32| context.ground.body.position(p as usize);
    let mut found = Resultant::default();
    forces.iter().for_each(|&(p, f)| found.add(f, at(p)));
    if is_halved || context.material.surface().resultant() != [true; 3] {
        return;
    }
    wanted.add_multiple(-1.0, &found);
    add_resultant(forces, &wanted, context);
}

/// Adds a resultant to forces on points: a uniform part, and one that turns about the middle of the points. A single point
/// takes a moment together with those around it.
pub(crate) fn add_resultant(forces: &mut Forces, missing: &Resultant, context: &LoadContext) {
    let body = context.ground.body;
    let at = |p: u32| body.place(p as usize);
    if let [(only, _)] = forces[..] {
        let regions = Regions { body, outline: None, walls: &[], parts: &[], named: &BTreeMap::new() };
        let near = Region::Disc { centre: at(only), radius: 1.5 * body.spacing() };
        let near = regions.select(&near).unwrap_or_default();
        forces.extend(near.into_iter().filter(|&p| p != only).map(|p| (p, [0.0; 3])));
    }
    let (force, count) = (missing.force(), forces.len() as f64);
    let middle = [0, 1].map(|k| forces.iter().map(|f| at(f.0)[k] / count).sum::<f64>());
    let arm = |p: u32| [0, 1].map(|k| at(p)[k] - middle[k]);
    let inertia: f64 = forces.iter().map(|f| arm(f.0)[0].powi(2) + arm(f.0)[1].powi(2)).sum();
    let about_middle = missing.moment()[2] - (middle[0] * force[1] - middle[1] * force[0]);
    let turn = if inertia > 0.0 { about_middle / inertia } else { 0.0 };
    for (point, own) in forces.iter_mut() {
        let [x, y] = arm(*point);
        own[0] += force[0] / count - turn * y;
        own[1] += force[1] / count + turn * x;
        own[2] += force[2] / count;
    }
}
