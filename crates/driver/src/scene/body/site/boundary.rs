//! The border of a body in the plane as stretches that tractions act on.

use super::border_names;
use super::ground::Ground;
use super::symmetry::Symmetry;
use crate::case::Names;
use crate::diagnostic::{Faults, JsonPath, suggest};
use crate::input::gmsh::Curve;
use crate::memory;
use peristat_assembly::body::{BorderMember, BorderPart, Edge, Outline, PointBody, SquareLattice};
use peristat_assembly::quadrature::GAUSS;
use std::collections::BTreeSet;

/// A short part of a border.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stretch {
    /// What it is.
    pub(crate) part: BorderPart,
    /// Its middle.
    pub(crate) middle: [f64; 2],
    /// Its length, m.
    pub(crate) length: f64,
    /// Unit normal that points out of the body, in its middle.
    pub(crate) normal: [f64; 2],
    /// Place of the middle along the whole border, 0 to 1.
    pub(crate) place: f64,
    /// Half its own share of the whole border.
    pub(crate) half: f64,
    /// The point that takes its force, where it is known.
    pub(crate) point: Option<u32>,
}

/// A position on a border with the length that it stands for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    /// Position, m.
    pub(crate) at: [f64; 2],
    /// Unit normal that points out of the body.
    pub(crate) normal: [f64; 2],
    /// Place along the whole border, 0 to 1.
    pub(crate) place: f64,
    /// Length, m.
    pub(crate) length: f64,
}

impl Stretch {
    /// A part between two places of the whole border.
    fn new(part: BorderPart, [start, end]: [f64; 2]) -> Self {
        Self {
            part,
            middle: part.at(0.5),
            length: part.length(),
            normal: part.normal(0.5),
            place: 0.5 * (start + end),
            half: 0.5 * (end - start),
            point: None,
        }
    }

    /// Its parts between the rows, columns and diagonals of points that a straight one crosses: between them places on the border
    /// move linearly. Arcs are short already.
    pub(crate) fn between_lines(&self, lattice: &SquareLattice) -> Vec<Self> {
        let BorderPart::Straight { from, to, .. } = self.part else { return vec![*self] };
        let place = |share: f64| self.place + (2.0 * share - 1.0) * self.half;
        let part =
            |ends: &[f64]| Self::new(self.part.between(ends[0], ends[1]), [place(ends[0]), place(ends[1])]);
        lattice.crossings(from, to).windows(2).map(part).collect()
    }

    /// At a share of its length, 0 to 1, for some of it.
    pub(crate) fn sample(&self, share: f64, length: f64) -> Sample {
        Sample {
            at: self.part.at(share),
            normal: self.part.normal(share),
            place: self.place + (2.0 * share - 1.0) * self.half,
            length,
        }
    }

    /// Positions that integrate along it by Gauss' rule.
    pub(crate) fn samples(&self) -> impl Iterator<Item = Sample> + '_ {
        GAUSS.iter().map(|&(share, weight)| self.sample(share, weight * self.length))
    }
}

/// What a traction acts on.
#[derive(Clone, Debug)]
pub(crate) enum Border {
    /// A straight edge of an outline.
    Edge(Edge),
    /// A hole, or the sides of elements on a curve of a mesh.
    Curved {
        /// Its stretches.
        stretches: Vec<Stretch>,
        /// Whether it is a single hole of this index.
        hole: Option<usize>,
    },
}

/// Stretches per spacing of curved borders, at least.
const PER_SPACING: f64 = 8.0;

/// Whether the borders of an outline fit into memory: a hole may be much larger than what it leaves of a body.
pub(crate) fn fits(
    outline: &Outline,
    spacing: f64,
    max_memory: Option<u64>,
    (path, drawn): (&JsonPath, usize),
    faults: &mut Faults,
) -> bool {
    let bytes = |length: f64| length / spacing * PER_SPACING * size_of::<Stretch>() as f64;
    let holes: Vec<f64> = outline.holes().iter().map(|h| h.shape.perimeter()).collect();
    let all = bytes(outline.border().perimeter() + holes.iter().sum::<f64>());
    let longest = (0..holes.len()).max_by(|&a, &b| holes[a].total_cmp(&holes[b]));
    let place = match longest.filter(|&k| bytes(holes[k]) > 0.5 * all) {
        Some(k) if k >= drawn => path.key("holes").index(k - drawn),
        _ => path.key("spacing"),
    };
    memory::fits(all, ("borders", "use a larger spacing, or smaller holes"), max_memory, place, faults)
}

/// The borders of names: edges, holes, and named curves of a mesh, each with what its points are called; every part once.
pub(crate) fn find(
    names: &Names,
    ground: &Ground,
    (curves, symmetry): (&[Curve], &Symmetry),
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Vec<(String, Border)>> {
    let (mut members, mut found, mut is_fine) = (BTreeSet::new(), Vec::new(), true);
    for (k, name) in names.each().iter().enumerate() {
        if let Some(parts) = ground.outline.and_then(|outline| outline.members(name)) {
            members.extend(parts.into_iter().filter(|part| !is_left_out(name, *part, ground, symmetry)));
        } else if let Some(curve) = curves.iter().find(|c| c.name == *name) {
            found.push((name.clone(), Border::Curved { stretches: of_curve(curve), hole: None }));
        } else {
            let path = if names.is_list() { path.index(k) } else { path.clone() };
            unknown(name, ground, curves, path, faults);
            is_fine = false;
        }
    }
    let spacing = ground.body.spacing();
    let mut of_holes = Vec::new();
    for member in members {
        let Some(outline) = ground.outline else { continue };
        match member {
            BorderMember::Edge(k) => {
                let edge = outline.edges()[k].clone();
                found.push((edge.name.clone(), Border::Edge(directed(edge, outline))));
            }
            BorderMember::Hole(k) => {
                let name = outline.holes()[k].name.clone().unwrap_or_default();
                found.push((name, Border::Curved { stretches: of_hole(k, outline, spacing), hole: Some(k) }));
            }
            BorderMember::HoleEdge { .. } => of_holes.extend(stretches_of(member, ground)),
        }
    }
    if !of_holes.is_empty() {
        place_along(&mut of_holes);
        found.push((String::new(), Border::Curved { stretches: of_holes, hole: None }));
    }
    is_fine.then_some(found)
}

/// Whether a part of the whole border is none: a mirror, an axis or a side that is joined.
pub(crate) fn is_left_out(name: &str, part: BorderMember, ground: &Ground, symmetry: &Symmetry) -> bool {
    let Some(outline) = ground.outline.filter(|outline| border_names::is_whole(name, outline)) else {
        return false;
    };
    let edge = matches!(part, BorderMember::Edge(_)).then(|| outline.straight(part)).flatten();
    edge.is_some_and(|edge| symmetry.replaces(&edge.name) || symmetry.joins(&edge.name))
}

fn unknown(name: &str, ground: &Ground, curves: &[Curve], path: JsonPath, faults: &mut Faults) {
    let own = ground.outline.into_iter().flat_map(Outline::border_names);
    let known: Vec<&str> = own.chain(curves.iter().map(|c| c.name.as_str())).collect();
    let hint = match known.is_empty() {
        true => "tractions act on edges of outlines and on named curves of meshes; listed points have neither: use `body_force` or `point`".into(),
        false => suggest(name, known.into_iter()),
    };
    faults.error(path, format!("there is no edge or hole `{name}`")).hint(hint);
}

/// Stretches of a part of the border of an outline.
pub(crate) fn stretches_of(member: BorderMember, ground: &Ground) -> Vec<Stretch> {
    let Some(outline) = ground.outline else { return Vec::new() };
    let spacing = ground.body.spacing();
    match member {
        BorderMember::Edge(k) => of_edge(&outline.edges()[k], ground),
        BorderMember::Hole(k) => of_hole(k, outline, spacing),
        BorderMember::HoleEdge { hole, edge } => {
            let parts = outline.hole_edge_parts(hole, edge);
            parts.iter().flat_map(|part| divided(part, spacing / PER_SPACING)).collect()
        }
    }
}

/// Edges of rectangles run to the right or upwards.
fn directed(edge: Edge, outline: &Outline) -> Edge {
    let backwards = edge.from[0] + edge.from[1] > edge.to[0] + edge.to[1];
    match outline.is_rectangle() && backwards {
        true => Edge { from: edge.to, to: edge.from, ..edge },
        false => edge,
    }
}

/// Stretches of a hole that border on the body: a hole may cross the outline or another hole.
pub(crate) fn of_hole(hole: usize, outline: &Outline, spacing: f64) -> Vec<Stretch> {
    let most = spacing / PER_SPACING;
    let mut stretches: Vec<Stretch> =
        outline.hole_parts(hole).iter().flat_map(|part| divided(part, most)).collect();
    place_along(&mut stretches);
    stretches
}

/// Equal stretches of a part of a hole, not longer than `most`. The number of those of an arc is a multiple of eight, so that
/// they lie symmetrically about the axes and diagonals of a circle.
fn divided(part: &BorderPart, most: f64) -> impl Iterator<Item = Stretch> + '_ {
    let count = match part {
        BorderPart::Straight { .. } => (part.length() / most - 1e-6).ceil().max(1.0),
        BorderPart::Round { .. } => 8.0 * (part.length() / (8.0 * most)).ceil().max(2.0),
    };
    let share = move |k: usize| k as f64 / count;
    (0..count as usize).map(move |k| Stretch::new(part.between(share(k), share(k + 1)), [0.0; 2]))
}

/// Stretches of a straight edge that border on the body: cells of the lattice where it runs along that.
pub(crate) fn of_edge(edge: &Edge, ground: &Ground) -> Vec<Stretch> {
    let spacing = ground.body.spacing();
    let most = if is_aligned(edge, ground.body) { spacing } else { spacing / PER_SPACING };
    let whole = BorderPart::Straight { from: edge.from, to: edge.to, normal: edge.normal };
    let length = whole.length();
    let count = (length / most - 1e-6).ceil().max(1.0);
    let mut stretches = Vec::new();
    for part in parts_of_edge(edge, ground) {
        let [start, end] = [0.0, 1.0].map(|share| place_on(edge, part.at(share)));
        // Cells that a hole cuts end there.
        let mut places = vec![start];
        places.extend((0..=count as usize).map(|k| k as f64 / count).filter(|p| start < *p && *p < end));
        places.push(end);
        places.dedup_by(|a, b| (*a - *b).abs() * count < 1e-9);
        let stretch = |ends: &[f64]| Stretch::new(whole.between(ends[0], ends[1]), [ends[0], ends[1]]);
        stretches.extend(places.windows(2).map(stretch));
    }
    stretches
}

/// The parts of an edge that border on the body.
pub(crate) fn parts_of_edge(edge: &Edge, ground: &Ground) -> Vec<BorderPart> {
    match ground.outline {
        Some(outline) => outline.edge_parts(edge),
        None => vec![BorderPart::Straight { from: edge.from, to: edge.to, normal: edge.normal }],
    }
}

/// Place of a position along an edge, 0 to 1.
pub(crate) fn place_on(edge: &Edge, at: [f64; 2]) -> f64 {
    let d = [0, 1].map(|k| edge.to[k] - edge.from[k]);
    let along = (at[0] - edge.from[0]) * d[0] + (at[1] - edge.from[1]) * d[1];
    (along / (d[0] * d[0] + d[1] * d[1])).clamp(0.0, 1.0)
}

/// Whether an edge runs along x or y as the lattice does.
pub(crate) fn is_aligned(edge: &Edge, body: &PointBody) -> bool {
    let turned = matches!(body, PointBody::Lattice(lattice) if lattice.is_turned());
    !turned && (edge.from[0] == edge.to[0] || edge.from[1] == edge.to[1])
}

/// Sides of elements on a curve; the body is on their left.
fn of_curve(curve: &Curve) -> Vec<Stretch> {
    let side = |s: &crate::input::gmsh::Side| {
        let d = [s.to[0] - s.from[0], s.to[1] - s.from[1]];
        let length = d[0].hypot(d[1]);
        let normal = [d[1] / length, -d[0] / length];
        let part = BorderPart::Straight { from: s.from, to: s.to, normal };
        Stretch { point: Some(s.point), ..Stretch::new(part, [0.0; 2]) }
    };
    let mut stretches: Vec<Stretch> = curve.sides.iter().map(side).collect();
    place_along(&mut stretches);
    stretches
}

fn place_along(stretches: &mut [Stretch]) {
    let whole: f64 = stretches.iter().map(|s| s.length).sum();
    let mut before = 0.0;
    for stretch in stretches {
        stretch.place = (before + 0.5 * stretch.length) / whole;
        stretch.half = 0.5 * stretch.length / whole;
        before += stretch.length;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use peristat_assembly::body::{Hole, Shape};

    #[test]
    fn no_edge_is_along_turned_rows() {
        let outline = Outline::rectangle([0.0; 2], [2.0, 1.0]).unwrap();
        let body = |angle: f64| PointBody::Lattice(outline.fill_turned(0.1, angle).unwrap());
        for edge in outline.edges() {
            assert!(is_aligned(edge, &body(0.0)) && !is_aligned(edge, &body(0.5)));
        }
    }

    #[test]
    fn samples_of_arcs_integrate_pressure_over_a_notch() {
        // ∫ n ds over an arc is its chord, turned: 2√(4 − 1) along y, none along x.
        let mut outline = Outline::rectangle([0.0; 2], [10.0, 6.0]).unwrap();
        let shape = Shape::Circle { centre: [4.0, 1.0], radius: 2.0 };
        outline.cut(Hole { name: None, shape }).unwrap();
        let stretches = of_hole(0, &outline, 0.5);
        let sum = |k: usize| -> f64 {
            stretches.iter().flat_map(Stretch::samples).map(|s| s.length * s.normal[k]).sum()
        };
        assert!(sum(0).abs() < 1e-14 && (sum(1) + 2.0 * 3.0_f64.sqrt()).abs() < 1e-13, "{}", sum(1));
    }
}
