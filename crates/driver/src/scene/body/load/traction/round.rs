//! A pressure on a round hole or a slot as a stress that fades into the body.

use super::fading;
use super::on_border::{OnBorder, may_be_consistent};
use super::profile::Profile;
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::load::stress_field::{Stress, StressField};
use crate::scene::body::load::sums::Forces;
use crate::scene::body::site::boundary::Border;
use peristat_assembly::body::{Crack, Shape};
use std::collections::BTreeMap;

/// `S = −p w(d) I` at a distance d from the hole, w as of straight edges; `div S = −p w' n` with n the direction away from it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Round {
    /// The middles of the round ends; of a circle they are one.
    ends: [[f64; 2]; 2],
    radius: f64,
    pressure: f64,
    /// Where it has faded, m.
    depth: f64,
    spacing: f64,
}

impl Round {
    /// Distance from the hole, negative inside it.
    fn distance(&self, [x, y]: [f64; 2]) -> f64 {
        let [[ax, ay], [bx, by]] = self.ends;
        let (dx, dy) = (bx - ax, by - ay);
        let square = dx * dx + dy * dy;
        let share = if square > 0.0 { ((x - ax) * dx + (y - ay) * dy) / square } else { 0.0 };
        let share = share.clamp(0.0, 1.0);
        (x - ax - share * dx).hypot(y - ay - share * dy) - self.radius
    }

    /// Whether a segment comes near the hole, looked at every half spacing.
    fn meets(&self, [from, to]: [[f64; 2]; 2]) -> bool {
        let d = [to[0] - from[0], to[1] - from[1]];
        let steps = (2.0 * d[0].hypot(d[1]) / self.spacing).ceil().max(1.0);
        let at = |k: usize| [0, 1].map(|c| from[c] + k as f64 / steps * d[c]);
        (0..=steps as usize).any(|k| self.distance(at(k)) < self.depth)
    }

    fn weight(&self, position: [f64; 2]) -> f64 {
        fading::weight(self.distance(position) / self.depth)
    }

    /// `div S` as a mean over a cell, N/m³.
    fn divergence(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let h = 0.5 * self.spacing;
        let slope =
            |a: [f64; 2], b: [f64; 2]| -self.pressure * (self.weight(b) - self.weight(a)) / self.spacing;
        [slope([x - h, y], [x + h, y]), slope([x, y - h], [x, y + h])]
    }
}

impl Stress for Round {
    fn at(&self, position: [f64; 2]) -> [f64; 3] {
        let s = -self.pressure * self.weight(position);
        [s, s, 0.0]
    }
}

/// The stress of a pressure on a hole and the forces that belong to it, by numbers of the body.
///
/// # Errors
/// Why it must be lumped.
pub(crate) fn fade(
    traction: &OnBorder,
    context: &LoadContext,
) -> Result<(StressField, Forces), &'static str> {
    let (Some(outline), Border::Curved { hole: Some(hole), .. }) = (context.ground.outline, &traction.border)
    else {
        return Err("it is no straight edge and no hole");
    };
    let Profile::Pressure(pressure) = traction.profile else {
        return Err("on a hole only a pressure can be");
    };
    let (ends, radius) = match &outline.holes()[*hole].shape {
        Shape::Circle { centre, radius } => ([*centre; 2], *radius),
        Shape::Slot { from, to, radius } => ([*from, *to], *radius),
        Shape::Ellipse { .. } => return Err("the hole is an ellipse"),
        Shape::Polygon(_) => return Err("the hole has corners"),
    };
    if !may_be_consistent(traction, context) {
        return Err("the calibration is `published`");
    }
    let body = context.ground.body;
    let depth = traction.depth.unwrap_or(2.0 * context.horizon);
    let round = Round { ends, radius, pressure, depth, spacing: body.spacing() };
    let reached = |p: &u32| round.distance(body.place(*p as usize)) < depth + body.spacing();
    let points: Vec<u32> = (0..body.points() as u32).filter(reached).collect();
    let is_near = |crack: &Crack| crack.vertices().windows(2).any(|ends| round.meets([ends[0], ends[1]]));
    if context.cracks.iter().any(|c| is_near(&c.crack)) {
        return Err("a crack is near the hole");
    }
    let force = |p: &u32| {
        let [x, y] = round.divergence(body.place(*p as usize)).map(|b| b * context.volume(*p));
        (*p, [x, y, 0.0])
    };
    let mut forces: BTreeMap<u32, [f64; 3]> =
        points.iter().map(force).filter(|(_, f)| *f != [0.0; 3]).collect();
    let own = fading::Own::Hole(*hole);
    fading::add_rest(&mut forces, &|position| round.at(position), own, context);
    let mut forces: Forces = forces.into_iter().collect();
    let field = StressField::at_points(points.into_iter().map(|p| p as usize).collect(), round);
    forces.extend(fading::missing((&forces, &field), traction, context));
    Ok((field, forces))
}
