//! Resultants of loads as a case asks for them: integrals over the true border of the body. Nothing here knows of points.

use super::context::LoadContext;
use super::traction::on_border::OnBorder;
use super::traction::profile::Profile;
use crate::scene::Resultant;
use crate::scene::body::site::boundary::{self, Border};
use crate::scene::body::site::resultants;
use peristat_assembly::body::{BorderPart, Edge, Outline, in_space};
use peristat_assembly::quadrature::GAUSS;
use std::f64::consts::TAU;

/// Pieces into which an arc is divided: Gauss' rule is exact to rounding on each.
const PIECES: usize = 16;
/// Times as many for what follows a formula.
const FINER: usize = 64;

/// Resultant of a traction.
pub(crate) fn of_traction(on: &OnBorder, context: &LoadContext) -> Resultant {
    if let (&Profile::Hertz { centre, radius, peak }, Border::Edge(edge)) = (&on.profile, &on.border) {
        return of_contact(edge, (centre, radius, peak), context);
    }
    let mut sum = Resultant::default();
    for (part, [start, end]) in on.parts(context.ground) {
        let finer = if on.profile.is_formula() { FINER } else { 1 };
        integrate(&part, finer, |share, at, length| {
            let t = on.profile.at(start + share * (end - start), at, part.normal(share));
            let force = t.map(|t| length * context.material.across(at) * t);
            resultants::add_force(context.material, &mut sum, force, in_space(at));
        });
    }
    sum
}

/// Calls `add` with share, position and length at the points of a rule that integrates over a part of a border, `finer`
/// times as fine as smooth functions need.
fn integrate(part: &BorderPart, finer: usize, mut add: impl FnMut(f64, [f64; 2], f64)) {
    let pieces = finer * if matches!(part, BorderPart::Round { .. }) { PIECES } else { 1 };
    let width = 1.0 / pieces as f64;
    for piece in 0..pieces {
        for (z, weight) in GAUSS {
            let share = (piece as f64 + z) * width;
            add(share, part.at(share), weight * width * part.length());
        }
    }
}

/// Resultant of a contact pressure on an edge, `p√(1 − q²)` with places q in the contact: by integrals in closed form.
fn of_contact(edge: &Edge, (centre, radius, peak): (f64, f64, f64), context: &LoadContext) -> Resultant {
    let d = [0, 1].map(|k| edge.to[k] - edge.from[k]);
    let length = d[0].hypot(d[1]);
    let (a, tangent) = (radius * length, d.map(|x| x / length));
    let middle = [0, 1].map(|k| edge.from[k] + centre * d[k]);
    // ∫√(1 − q²) and ∫q√(1 − q²).
    let primitive = |q: f64| {
        let root = (1.0 - q * q).max(0.0).sqrt();
        [0.5 * (q * root + q.asin()), -root * root * root / 3.0]
    };
    let mut sum = Resultant::default();
    for part in boundary::parts_of_edge(edge, context.ground) {
        let place = |share: f64| boundary::place_on(edge, part.at(share));
        let [start, end] = [0.0, 1.0].map(|share| ((place(share) - centre) / radius).clamp(-1.0, 1.0));
        let ([a0, a1], [b0, b1]) = (primitive(start), primitive(end));
        let (whole, first) = (b0 - a0, b1 - a1);
        let across = context.material.across(middle);
        // A ring is the wider the farther from its axis.
        let width = match context.material.surface().axis() {
            Some(_) => TAU * (middle[0] * whole + a * tangent[0] * first),
            None => across * whole,
        };
        let [x, y] = edge.normal.map(|n| -peak * a * width * n);
        resultants::add_force(context.material, &mut sum, [x, y, 0.0], in_space(middle));
        let turn = tangent[0] * edge.normal[1] - tangent[1] * edge.normal[0];
        sum.add_moment(2, -peak * a * a * across * first * turn);
    }
    sum
}

/// Resultant of a force per volume, N/m³, on the whole body.
pub(crate) fn of_body(density: [f64; 3], context: &LoadContext) -> Resultant {
    let mut sum = Resultant::default();
    match context.ground.outline {
        Some(outline) => {
            let (volume, centroid) = volume(outline, context);
            resultants::add_force(
                context.material,
                &mut sum,
                density.map(|b| b * volume),
                in_space(centroid),
            );
        }
        // Listed points are the body.
        None => {
            for p in 0..context.ground.body.points() as u32 {
                let force = density.map(|b| b * context.volume(p));
                resultants::add_force(
                    context.material,
                    &mut sum,
                    force,
                    context.ground.body.position(p as usize),
                );
            }
        }
    }
    sum
}

/// Volume, m³, and centroid of the area of a body, by integrals over its border (Gauss).
fn volume(outline: &Outline, context: &LoadContext) -> (f64, [f64; 2]) {
    let edges = outline.edges().iter().flat_map(|edge| outline.edge_parts(edge));
    let holes = (0..outline.holes().len()).flat_map(|hole| outline.hole_parts(hole));
    let [low, _] = outline.bounds();
    let (mut area, mut first) = (0.0, [0.0; 2]);
    for part in edges.chain(holes) {
        integrate(&part, 1, |share, at, length| {
            let (r, n) = ([0, 1].map(|k| at[k] - low[k]), part.normal(share));
            area += length * r[0] * n[0];
            (0..2).for_each(|k| first[k] += 0.5 * length * r[k] * r[k] * n[k]);
        });
    }
    let centroid = [0, 1].map(|k| low[k] + first[k] / area);
    (area * context.material.across(centroid), centroid)
}
