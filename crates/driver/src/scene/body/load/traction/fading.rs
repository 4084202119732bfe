//! A stress that has the traction of an edge and fades inwards.

use super::lump;
use super::on_border::{OnBorder, may_be_consistent};
use super::profile::Profile;
use crate::diagnostic::Faults;
use crate::scene::Resultant;
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::load::stress_field::{Stress, StressField, traction_of};
use crate::scene::body::load::sums::Forces;
use crate::scene::body::site::boundary::{self, Border, is_aligned};
use crate::scene::body::site::resultants;
use peristat_assembly::body::{Edge, Outline, Region, Regions};
use std::collections::BTreeMap;

/// `S = w(d) (t⊗n + n⊗t − (t·n) n⊗n)` at a distance d from an edge, w a cubic from 1 to 0 with flat ends.
#[derive(Clone, Debug)]
pub(crate) struct Fading {
    from: [f64; 2],
    /// Unit vector from start to end.
    tangent: [f64; 2],
    length: f64,
    normal: [f64; 2],
    profile: Profile,
    /// Where it has faded, m.
    depth: f64,
    spacing: f64,
}

/// Step of differences along an edge, of its length.
const STEP: f64 = 1e-4;

impl Fading {
    /// Distance from the edge and place along it, if it is in the strip.
    fn place(&self, position: [f64; 2]) -> Option<(f64, f64)> {
        let r = [0, 1].map(|k| position[k] - self.from[k]);
        let along = |n: [f64; 2]| r[0] * n[0] + r[1] * n[1];
        let (depth, s) = (-along(self.normal), along(self.tangent));
        let slack = 1e-6 * self.spacing;
        let inside = |v: f64, end: f64| -slack <= v && v <= end + slack;
        (inside(depth, self.depth) && inside(s, self.length)).then_some((depth, s / self.length))
    }

    fn weight(&self, depth: f64) -> f64 {
        weight(depth / self.depth)
    }

    /// The traction at a place of the edge.
    fn on_edge(&self, place: f64) -> [f64; 3] {
        let at = [0, 1].map(|k| self.from[k] + place * self.length * self.tangent[k]);
        self.profile.at(place, at, self.normal)
    }

    /// Its derivative by the place; of a formula by a difference.
    fn slope(&self, place: f64) -> [f64; 2] {
        if !self.profile.is_formula() {
            return self.profile.slope(place);
        }
        let [before, behind] = [(place - STEP).max(0.0), (place + STEP).min(1.0)];
        let [start, end] = [before, behind].map(|place| self.on_edge(place));
        [0, 1].map(|k| (end[k] - start[k]) / (behind - before))
    }

    /// `div S` as a mean over a cell, N/m³: `−w' t + w n (dt/ds·τ)`, with a difference of w whose sum over cells is exact.
    fn divergence(&self, position: [f64; 2]) -> [f64; 2] {
        let Some((depth, place)) = self.place(position) else { return [0.0; 2] };
        let half = 0.5 * self.spacing;
        let fall = (self.weight(depth - half) - self.weight(depth + half)) / self.spacing;
        let (t, slope) = (self.on_edge(place), self.slope(place));
        let shear = (slope[0] * self.tangent[0] + slope[1] * self.tangent[1]) / self.length;
        [0, 1].map(|k| fall * t[k] + self.weight(depth) * shear * self.normal[k])
    }
}

impl Stress for Fading {
    fn at(&self, position: [f64; 2]) -> [f64; 3] {
        let Some((depth, place)) = self.place(position) else { return [0.0; 3] };
        let (w, [x, y]) = (self.weight(depth), self.normal);
        let [a, b, _] = self.on_edge(place);
        let along = a * x + b * y;
        [
            w * (2.0 * a * x - along * x * x),
            w * (2.0 * b * y - along * y * y),
            w * (a * y + b * x - along * x * y),
        ]
    }
}

/// A cubic from 1 at 0 to 0 at 1 with flat ends.
pub(crate) fn weight(depth: f64) -> f64 {
    let q = depth.clamp(0.0, 1.0);
    1.0 + q * q * (2.0 * q - 3.0)
}

/// The border that a stress belongs to.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Own<'a> {
    /// A straight edge.
    Edge(&'a Edge),
    /// A hole, by its number.
    Hole(usize),
}

/// The stress of a traction and the forces that belong to it, by numbers of the body.
///
/// # Errors
/// Why it must be lumped.
pub(crate) fn fade(
    traction: &OnBorder,
    context: &LoadContext,
) -> Result<(StressField, Forces), &'static str> {
    let (Some(outline), Border::Edge(edge)) = (context.ground.outline, &traction.border) else {
        return Err("it is no straight edge");
    };
    if !is_aligned(edge, context.ground.body) {
        return Err("the edge does not run along the lattice");
    }
    if !may_be_consistent(traction, context) {
        return Err("the calibration is `published`");
    }
    let length = (edge.to[0] - edge.from[0]).hypot(edge.to[1] - edge.from[1]);
    let tangent = [0, 1].map(|k| (edge.to[k] - edge.from[k]) / length);
    // Where the body goes on beyond an end of the edge, shear would jump there.
    let shears = |q: &f64| {
        let t = traction.profile.at(
            *q,
            [0, 1].map(|k| edge.from[k] + q * (edge.to[k] - edge.from[k])),
            edge.normal,
        );
        t[0] * tangent[0] + t[1] * tangent[1] != 0.0
    };
    let [low, high] = outline.bounds();
    let axis = usize::from(edge.normal[0] == 0.0);
    let spacing = context.ground.body.spacing();
    let deep = traction.depth.unwrap_or(2.0 * context.horizon);
    let cells = (deep / spacing - 1e-6).ceil();
    let depth = (cells * spacing).min(high[axis] - low[axis]);
    let slack = 1e-9 * spacing;
    if [0.0, 0.25, 0.5, 1.0].iter().any(shears) && !goes_straight_back(edge, depth - slack, outline) {
        return Err(
            "a shear needs an edge whose neighbours run straight back from it, for two horizons at least",
        );
    }
    let fading = Fading {
        from: edge.from,
        tangent,
        length,
        normal: edge.normal,
        profile: traction.profile.clone(),
        depth,
        spacing,
    };
    let inner = [0, 1].map(|k| edge.to[k] - depth * edge.normal[k]);
    if context.cracks.iter().any(|c| in_box(c.crack.vertices(), edge.from, inner)) {
        return Err("a crack is within two horizons of the edge");
    }
    let regions =
        Regions { body: context.ground.body, outline: None, walls: &[], parts: &[], named: &BTreeMap::new() };
    let points = regions.select(&Region::Box { from: edge.from, to: inner }).unwrap_or_default();
    let mut forces: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
    for &p in &points {
        let position = context.ground.body.place(p as usize);
        let mut divergence = fading.divergence(position);
        divergence[1] += context.around_axis(fading.at(position), position);
        if divergence != [0.0; 2] {
            let [x, y] = divergence.map(|b| b * context.volume(p));
            forces.insert(p, [x, y, 0.0]);
        }
    }
    add_rest(&mut forces, &|position| fading.at(position), Own::Edge(edge), context);
    let mut forces: Forces = forces.into_iter().collect();
    let field = StressField::at_points(points.into_iter().map(|p| p as usize).collect(), fading);
    forces.extend(missing((&forces, &field), traction, context));
    Ok((field, forces))
}

/// Whether at both ends of an edge another one goes on against its normal, for this length at least (m).
fn goes_straight_back(edge: &Edge, length: f64, outline: &Outline) -> bool {
    let back = |end: [f64; 2]| {
        outline.edges().iter().filter(|e| e.name != edge.name).any(|e| {
            let other = match (e.from == end, e.to == end) {
                (true, _) => e.to,
                (_, true) => e.from,
                _ => return false,
            };
            let d = [other[0] - end[0], other[1] - end[1]];
            let along = d[0] * edge.normal[1] - d[1] * edge.normal[0];
            along == 0.0 && -(d[0] * edge.normal[0] + d[1] * edge.normal[1]) >= length
        })
    };
    back(edge.from) && back(edge.to)
}

/// Whether a polyline comes into the box of two corners.
fn in_box(vertices: &[[f64; 2]], a: [f64; 2], b: [f64; 2]) -> bool {
    let apart = |p: &[f64; 2], q: &[f64; 2]| {
        (0..2).any(|k| p[k].max(q[k]) < a[k].min(b[k]) || p[k].min(q[k]) > a[k].max(b[k]))
    };
    vertices.windows(2).any(|w| !apart(&w[0], &w[1]))
}

/// Adds what a stress does on other borders, taken back there.
pub(crate) fn add_rest(
    forces: &mut BTreeMap<u32, [f64; 3]>,
    stress: &dyn Fn([f64; 2]) -> [f64; 3],
    own: Own,
    context: &LoadContext,
) {
    for (point, force) in elsewhere(stress, own, context) {
        let sum = forces.entry(point).or_default();
        (0..3).for_each(|k| sum[k] += force[k]);
    }
}

fn elsewhere(stress: &dyn Fn([f64; 2]) -> [f64; 3], own: Own, context: &LoadContext) -> Forces {
    let Some(outline) = context.ground.outline else { return Vec::new() };
    let spacing = context.ground.body.spacing();
    let region = |name: &str| context.ground.region(name, &Default::default(), &mut Faults::default());
    let mut forces = Vec::new();
    // On joined edges what it does cancels.
    let is_own = |e: &Edge| matches!(own, Own::Edge(edge) if edge.name == e.name);
    let edges = outline.edges().iter().filter(|e| !is_own(e) && !context.symmetry.joins(&e.name));
    let borders = edges
        .map(|e| (boundary::of_edge(e, context.ground), region(&e.name), context.symmetry.replaces(&e.name)));
    let others = (0..outline.holes().len()).filter(|k| !matches!(own, Own::Hole(hole) if hole == *k));
    let holes = others.map(|k| (boundary::of_hole(k, outline, spacing), None, false));
    for (stretches, points, is_mirror) in borders.chain(holes) {
        let back = |stretch: &boundary::Stretch| {
            let t = traction_of(stress(stretch.middle), stretch.normal).map(|t| -t);
            let [x, y] = stretch.normal;
            // A mirror takes what is normal to it.
            let along = if is_mirror { t[0] * x + t[1] * y } else { 0.0 };
            [t[0] - along * x, t[1] - along * y, 0.0]
        };
        let met: Vec<boundary::Stretch> = stretches.into_iter().filter(|s| back(s) != [0.0; 3]).collect();
        if !met.is_empty() {
            let points = points.as_deref().unwrap_or(&[]);
            forces.extend(lump::on_points(&met, &|s| lump::constant(back(s), s), points, context));
        }
    }
    forces
}

/// Small forces along the border of a traction that make force and moment of these forces and a stress exact.
pub(crate) fn missing(
    (forces, stress): (&Forces, &StressField),
    traction: &OnBorder,
    context: &LoadContext,
) -> Forces {
    let at = |p: u32| context.ground.body.position(p as usize);
    let mut rest = Resultant::default();
    let lumped = lump::forces(&[traction], context);
    lumped.iter().for_each(|&(p, f)| resultants::add_force(context.material, &mut rest, f, at(p)));
    forces
        .iter()
        .for_each(|&(p, f)| resultants::add_force(context.material, &mut rest, f.map(|f| -f), at(p)));
    let mut small: Forces = lumped.iter().map(|f| (f.0, [0.0; 3])).collect();
    let Some(model) = context.model else { return small };
    let counts = context.material.surface().resultant();
    let is_flat = counts == [true; 3] && context.material.cylinder_radius().is_none();
    if context.symmetry.mirrors.is_none() && is_flat {
        // A stress that goes through no mirror has no resultant.
        lump::add_resultant(&mut small, &rest, context);
        return small;
    }
    let mut through = vec![0.0; model.components().len() * model.points()];
    stress.numbered(&|p| context.inputs.number(model, p)).add_to(model, 1.0, &mut through);
    rest.add_multiple(-1.0, &resultants::resultant(model, context.material, &through));
    let mut rest = match context.material.cylinder_radius() {
        Some(radius) => [rest.force()[0], rest.moment()[2] / radius, 0.0],
        None => rest.force(),
    };
    let (sum, size) = sums(&lumped);
    let inside = inside(traction, context);
    (0..3).filter(|&k| inside[k] || !counts[k]).for_each(|k| rest[k] = 0.0);
    if matches!(traction.border, Border::Edge(_)) {
        return lumped.iter().map(|f| (f.0, rest.map(|r| r / lumped.len() as f64))).collect();
    }
    let is_one_way = sum[1].abs() > ONE_WAY * size[1];
    if matches!(traction.profile, Profile::Pressure(_)) && !counts[0] && is_one_way {
        // A pressure is off by the same part all around.
        rest[0] = rest[1] * sum[0] / sum[1];
    }
    shared(rest, &lumped)
}

/// Axes with a mirror across them along which a traction asks for nothing: what its stress does through the mirror is inside
/// the body, and stays.
pub(crate) fn inside(traction: &OnBorder, context: &LoadContext) -> [bool; 3] {
    let mirrors = context.symmetry.mirrors;
    let (sum, size) = sums(&lump::forces(&[traction], context));
    [0, 1, 2].map(|axis| {
        let is_mirrored = mirrors.lines[axis] != [None; 2] && !mirrors.joined[axis];
        is_mirrored && sum[axis].abs() <= 1e-10 * size[0].max(size[1]).max(size[2])
    })
}

/// Part of the magnitudes that the sum of forces has at least, to be a measure of them.
const ONE_WAY: f64 = 0.1;

/// Sums of forces along x and y, and of their magnitudes.
fn sums(forces: &Forces) -> ([f64; 3], [f64; 3]) {
    let sum = [0, 1, 2].map(|k| forces.iter().map(|f| f.1[k]).sum());
    (sum, [0, 1, 2].map(|k| forces.iter().map(|f| f.1[k].abs()).sum()))
}

/// A force shared as others are, along each axis; alike where those have next to no sum.
fn shared(force: [f64; 3], like: &Forces) -> Forces {
    let (sum, size) = sums(like);
    let share = |k: usize, f: f64| match sum[k].abs() > ONE_WAY * size[k] {
        true => force[k] * f / sum[k],
        false => force[k] / like.len() as f64,
    };
    like.iter().map(|&(p, f)| (p, [share(0, f[0]), share(1, f[1]), share(2, f[2])])).collect()
}
