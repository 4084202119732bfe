//! The true border of a plate and the sides of cells that stand for it.

use peristat_assembly::body::{BorderMember, BorderPart, Outline};
use peristat_assembly::model::plate_bending::{EdgeSegment, PlateNodes};
use std::f64::consts::TAU;

/// Distances below this, in spacings, are none.
const SAME: f64 = 1e-6;

/// A side of a cell on the edge of the body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    /// Its points, and its normal.
    pub(super) segment: EdgeSegment,
    /// Which of the parts of the true border it stands for.
    part: usize,
    /// Whether the true border runs along it; else it is a stair.
    pub(super) is_true: bool,
    /// Normal of the true border there.
    pub(super) normal: [f64; 2],
}

/// All sides of cells on edges.
pub(super) struct Border {
    sides: Vec<Side>,
    parts: Vec<(BorderMember, BorderPart)>,
}

impl Border {
    /// The sides of the cells with the parts of the outline that are nearest to them.
    pub(super) fn new(outline: &Outline, nodes: &PlateNodes) -> Self {
        let parts = parts(outline);
        let side = |segment: EdgeSegment| {
            let [a, b] = segment.points.map(|p| nodes.place(p as usize));
            let middle = [0, 1].map(|k| 0.5 * (a[k] + b[k]));
            let near = parts.iter().enumerate().map(|(k, (_, part))| (k, nearest(part, middle)));
            let (part, place) =
                near.min_by(|a, b| distance(a.1, middle).total_cmp(&distance(b.1, middle)))?;
            let normal = normal(&parts[part].1, place);
            let side = Side { segment, part, is_true: false, normal };
            let is_true = distance(place, middle) < SAME * nodes.spacing() && is_along(&side, normal);
            Some(Side { is_true, ..side })
        };
        let sides = nodes.edges().into_iter().filter_map(side).collect();
        Self { sides, parts }
    }

    /// All sides.
    pub(super) fn all(&self) -> &[Side] {
        &self.sides
    }

    /// The sides of parts of the border.
    pub(super) fn of(&self, members: &[BorderMember]) -> Vec<Side> {
        let is_wanted = |side: &&Side| {
            let own = self.parts[side.part].0;
            members.iter().any(|member| match (own, member) {
                (BorderMember::HoleEdge { hole, .. }, BorderMember::Hole(wanted)) => hole == *wanted,
                _ => own == *member,
            })
        };
        self.sides.iter().filter(is_wanted).copied().collect()
    }

    /// The way from a place to the nearest of the true border that some sides stand for, and the normal there.
    pub(super) fn way(&self, sides: &[Side], place: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let mut parts: Vec<usize> = sides.iter().map(|side| side.part).collect();
        parts.sort_unstable();
        parts.dedup();
        let ways = parts.into_iter().map(|part| {
            let there = nearest(&self.parts[part].1, place);
            ([0, 1].map(|k| there[k] - place[k]), normal(&self.parts[part].1, there))
        });
        let length = |(way, _): &([f64; 2], [f64; 2])| way[0].hypot(way[1]);
        ways.min_by(|a, b| length(a).total_cmp(&length(b))).unwrap_or_default()
    }

    /// What the part of the border is called that a side stands for.
    pub(super) fn name(&self, side: &Side, outline: &Outline) -> String {
        let of_hole = |hole: usize| match &outline.holes()[hole].name {
            Some(name) => name.clone(),
            None => format!("hole {}", hole + 1),
        };
        match self.parts[side.part].0 {
            BorderMember::Edge(edge) => outline.edges()[edge].name.clone(),
            BorderMember::Hole(hole) => of_hole(hole),
            BorderMember::HoleEdge { hole, edge } => format!("{} {}", of_hole(hole), edge + 1),
        }
    }

    /// Whether a hole has an edge.
    pub(super) fn has_hole(&self, number: usize) -> bool {
        self.sides.iter().any(|side| match self.parts[side.part].0 {
            BorderMember::Hole(hole) | BorderMember::HoleEdge { hole, .. } => hole == number,
            BorderMember::Edge(_) => false,
        })
    }

    /// Parts of the border along x or y that lie between rows of points: what each is, and how far beside it the sides of
    /// cells are that stand for it, m.
    pub(super) fn moved(&self, nodes: &PlateNodes) -> Vec<(BorderMember, f64)> {
        let mut moved: Vec<(BorderMember, f64)> = Vec::new();
        for (k, (member, part)) in self.parts.iter().enumerate() {
            let BorderPart::Straight { normal, .. } = part else { continue };
            if normal[0].abs().min(normal[1].abs()) > SAME {
                continue;
            }
            let off = |side: &&Side| {
                let [a, b] = side.segment.points.map(|p| nodes.place(p as usize));
                let middle = [0, 1].map(|k| 0.5 * (a[k] + b[k]));
                distance(nearest(part, middle), middle)
            };
            let own = self.sides.iter().filter(|side| side.part == k && is_along(side, *normal));
            let most = own.map(|side| off(&side)).fold(0.0, f64::max);
            if most > SAME * nodes.spacing() && moved.iter().all(|(known, _)| known != member) {
                moved.push((*member, most));
            }
        }
        moved
    }
}

/// Whether a side faces where a part of the border does.
fn is_along(side: &Side, normal: [f64; 2]) -> bool {
    let along = normal[0] * side.segment.outward[0] + normal[1] * side.segment.outward[1];
    (along - 1.0).abs() < SAME
}

/// The parts of all edges and holes behind which there is a body.
fn parts(outline: &Outline) -> Vec<(BorderMember, BorderPart)> {
    let edges = outline.edges().iter().enumerate();
    let mut parts: Vec<(BorderMember, BorderPart)> = edges
        .flat_map(|(k, edge)| {
            outline.edge_parts(edge).into_iter().map(move |part| (BorderMember::Edge(k), part))
        })
        .collect();
    for hole in 0..outline.holes().len() {
        let mut straight = 0;
        while outline.hole_edge(hole, straight).is_some() {
            let member = BorderMember::HoleEdge { hole, edge: straight };
            parts.extend(outline.hole_edge_parts(hole, straight).into_iter().map(|part| (member, part)));
            straight += 1;
        }
        if straight == 0 {
            parts.extend(outline.hole_parts(hole).into_iter().map(|part| (BorderMember::Hole(hole), part)));
        }
    }
    parts
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The place of a part that is nearest to another one.
fn nearest(part: &BorderPart, at: [f64; 2]) -> [f64; 2] {
    part.at(share(part, at))
}

/// Where on a part, as a share of its length, it is nearest to a place.
fn share(part: &BorderPart, at: [f64; 2]) -> f64 {
    match *part {
        BorderPart::Straight { from, to, .. } => {
            let d = [to[0] - from[0], to[1] - from[1]];
            let along = (at[0] - from[0]) * d[0] + (at[1] - from[1]) * d[1];
            (along / (d[0] * d[0] + d[1] * d[1])).clamp(0.0, 1.0)
        }
        BorderPart::Round { centre, angles: [start, end], .. } => {
            let angle = (at[1] - centre[1]).atan2(at[0] - centre[0]);
            let beyond = (angle - start).rem_euclid(TAU);
            let length = end - start;
            match beyond <= length {
                true => beyond / length,
                // The end that is nearer around the circle.
                false => f64::from(u8::from(beyond - length < TAU - beyond)),
            }
        }
    }
}

fn normal(part: &BorderPart, place: [f64; 2]) -> [f64; 2] {
    part.normal(share(part, place))
}
