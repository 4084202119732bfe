//! The border of a body in the plane as stretches that tractions act on.

use super::super::words::suggest;
use super::ground::Ground;
use crate::diagnostic::{Faults, JsonPath};
use crate::input::gmsh::Curve;
use crate::memory;
use peristat_assembly::body::{Edge, Outline, PlaneBody, Shape};
use std::f64::consts::TAU;

/// A short straight part of a border.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stretch {
    /// Its middle.
    pub(super) middle: [f64; 2],
    /// Its length, m.
    pub(super) length: f64,
    /// Unit normal that points out of the body.
    pub(super) normal: [f64; 2],
    /// Place of the middle along the whole border, 0 to 1.
    pub(super) place: f64,
    /// Half its own share of the whole border.
    pub(super) half: f64,
    /// The point that takes its force, where it is known.
    pub(super) point: Option<u32>,
}

/// What a traction acts on.
#[derive(Clone, Debug)]
pub(super) enum Border {
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
pub(super) fn fits(
    outline: &Outline,
    spacing: f64,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> bool {
    let bytes = |length: f64| length / spacing * PER_SPACING * size_of::<Stretch>() as f64;
    let holes: Vec<f64> = outline.holes().iter().map(|h| h.shape.perimeter()).collect();
    let all = bytes(outline.border().perimeter() + holes.iter().sum::<f64>());
    let longest = (0..holes.len()).max_by(|&a, &b| holes[a].total_cmp(&holes[b]));
    let place = match longest.filter(|&k| bytes(holes[k]) > 0.5 * all) {
        Some(k) => path.key("holes").index(k),
        None => path.key("spacing"),
    };
    memory::fits(all, ("borders", "use a larger spacing, or smaller holes"), max_memory, place, faults)
}

/// The border of a name: an edge, a hole, or a named curve of a mesh.
pub(super) fn find(
    name: &str,
    ground: &Ground,
    curves: &[Curve],
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Border> {
    let spacing = ground.body.spacing();
    if let Some(outline) = ground.outline {
        if let Some(edge) = outline.edge(name) {
            return Some(Border::Edge(directed(edge.clone(), outline)));
        }
        let hole = outline.holes().iter().position(|h| h.name.as_deref() == Some(name));
        if let Some(k) = hole {
            let mut stretches = of_hole(k, outline, spacing);
            place_along(&mut stretches);
            return Some(Border::Curved { stretches, hole: Some(k) });
        }
    }
    if let Some(curve) = curves.iter().find(|c| c.name == name) {
        return Some(Border::Curved { stretches: of_curve(curve), hole: None });
    }
    let edges = ground.outline.map_or(&[][..], Outline::edges).iter().map(|e| e.name.as_str());
    let holes = ground.outline.map_or(&[][..], Outline::holes).iter().filter_map(|h| h.name.as_deref());
    let known: Vec<&str> = edges.chain(holes).chain(curves.iter().map(|c| c.name.as_str())).collect();
    let hint = match known.is_empty() {
        true => "tractions act on edges of outlines and on named curves of meshes; listed points have neither: use `body_force` or `point`".into(),
        false => suggest(name, known.into_iter()),
    };
    faults.error(path.clone(), format!("there is no edge or hole `{name}`")).hint(hint);
    None
}

/// Edges of rectangles run to the right or upwards.
fn directed(edge: Edge, outline: &Outline) -> Edge {
    let backwards = edge.from[0] + edge.from[1] > edge.to[0] + edge.to[1];
    match outline.is_rectangle() && backwards {
        true => Edge { from: edge.to, to: edge.from, ..edge },
        false => edge,
    }
}

/// Equal stretches of a segment, not longer than `most`.
fn along(from: [f64; 2], to: [f64; 2], normal: [f64; 2], most: f64) -> Vec<Stretch> {
    let length = (to[0] - from[0]).hypot(to[1] - from[1]);
    let count = (length / most - 1e-6).ceil().max(1.0);
    let stretch = |k: usize| {
        let place = (k as f64 + 0.5) / count;
        let middle = [0, 1].map(|c| from[c] + place * (to[c] - from[c]));
        Stretch { middle, length: length / count, normal, place, half: 0.5 / count, point: None }
    };
    (0..count as usize).map(stretch).collect()
}

/// Stretches of a hole that border on the body: a hole may cross the outline or another hole.
pub(super) fn of_hole(hole: usize, outline: &Outline, spacing: f64) -> Vec<Stretch> {
    let mut stretches = around(&outline.holes()[hole].shape, spacing / PER_SPACING);
    keep_borders(&mut stretches, outline, spacing);
    stretches
}

/// Stretches of a straight edge that border on the body: cells of the lattice where it runs along that.
pub(super) fn of_edge(edge: &Edge, ground: &Ground) -> Vec<Stretch> {
    let spacing = ground.body.spacing();
    let most = if is_aligned(edge, ground.body) { spacing } else { spacing / PER_SPACING };
    let mut stretches = along(edge.from, edge.to, edge.normal, most);
    if let Some(outline) = ground.outline.filter(|o| !o.holes().is_empty()) {
        keep_borders(&mut stretches, outline, spacing);
    }
    stretches
}

/// Whether an edge runs along x or y as the lattice does.
pub(super) fn is_aligned(edge: &Edge, body: &PlaneBody) -> bool {
    let turned = matches!(body, PlaneBody::Lattice(lattice) if lattice.is_turned());
    !turned && (edge.from[0] == edge.to[0] || edge.from[1] == edge.to[1])
}

/// Leaves out the stretches behind which there is no body.
fn keep_borders(stretches: &mut Vec<Stretch>, outline: &Outline, spacing: f64) {
    let behind = |s: &Stretch| [0, 1].map(|k| s.middle[k] - 1e-6 * spacing * s.normal[k]);
    stretches.retain(|s| outline.contains(behind(s)));
}

/// Stretches around a hole; normals point into the hole.
fn around(shape: &Shape, most: f64) -> Vec<Stretch> {
    let mut stretches = match shape {
        Shape::Circle { centre, radius } => arc(*centre, *radius, 0.0, TAU, most),
        Shape::Slot { from, to, radius } => {
            let turn = (to[1] - from[1]).atan2(to[0] - from[0]);
            let (across, quarter) = ([-turn.sin(), turn.cos()], TAU / 4.0);
            let side = |sign: f64| {
                let moved = |p: &[f64; 2]| [0, 1].map(|k| p[k] + sign * radius * across[k]);
                along(moved(from), moved(to), across.map(|n| -sign * n), most)
            };
            let mut all = arc(*to, *radius, turn - quarter, turn + quarter, most);
            if from != to {
                all.extend(side(1.0));
                all.extend(side(-1.0));
            }
            all.extend(arc(*from, *radius, turn + quarter, turn + 3.0 * quarter, most));
            all
        }
        Shape::Polygon(polygon) => {
            let edge = |k: usize| {
                let ([from, to], normal) = (polygon.edge(k), polygon.normal(k));
                along(from, to, normal.map(|n| -n), most)
            };
            (0..polygon.vertices().len()).flat_map(edge).collect()
        }
    };
    place_along(&mut stretches);
    stretches
}

/// Stretches of an arc around a hole, with its true length. Their number is a multiple of eight, so that they lie
/// symmetrically about the axes and diagonals of a circle.
fn arc(centre: [f64; 2], radius: f64, from: f64, to: f64, most: f64) -> Vec<Stretch> {
    let count = 8.0 * (radius * (to - from) / (8.0 * most)).ceil().max(2.0);
    let step = (to - from) / count;
    let stretch = |k: usize| {
        let (sin, cos) = (from + (k as f64 + 0.5) * step).sin_cos();
        Stretch {
            middle: [centre[0] + radius * cos, centre[1] + radius * sin],
            length: radius * step,
            normal: [-cos, -sin],
            place: 0.0,
            half: 0.0,
            point: None,
        }
    };
    (0..count as usize).map(stretch).collect()
}

/// Sides of elements on a curve; the body is on their left.
fn of_curve(curve: &Curve) -> Vec<Stretch> {
    let side = |s: &crate::input::gmsh::Side| {
        let d = [s.to[0] - s.from[0], s.to[1] - s.from[1]];
        let length = d[0].hypot(d[1]);
        Stretch {
            middle: [0, 1].map(|k| 0.5 * (s.from[k] + s.to[k])),
            length,
            normal: [d[1] / length, -d[0] / length],
            place: 0.0,
            half: 0.0,
            point: Some(s.point),
        }
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
    use std::f64::consts::PI;

    fn moments(stretches: &[Stretch]) -> (f64, [f64; 2], f64) {
        let length = stretches.iter().map(|s| s.length).sum();
        let normal = [0, 1].map(|k| stretches.iter().map(|s| s.length * s.normal[k]).sum());
        // By Gauss ∮ x·n ds = 2 A of the body, so minus that of the hole.
        let flux =
            stretches.iter().map(|s| s.length * (s.middle[0] * s.normal[0] + s.middle[1] * s.normal[1]));
        (length, normal, -0.5 * flux.sum::<f64>())
    }

    #[test]
    fn no_edge_is_along_turned_rows() {
        let outline = Outline::rectangle([0.0; 2], [2.0, 1.0]).unwrap();
        let body = |angle: f64| PlaneBody::Lattice(outline.fill_turned(0.1, angle).unwrap());
        for edge in outline.edges() {
            assert!(is_aligned(edge, &body(0.0)) && !is_aligned(edge, &body(0.5)));
        }
    }

    #[test]
    fn borders_of_holes_are_closed_and_look_inwards() {
        let circle = Shape::Circle { centre: [3.0, -1.0], radius: 0.5 };
        let slot = Shape::Slot { from: [0.0, 0.0], to: [3.0, 4.0], radius: 0.5 };
        let shapes = [(circle, PI, PI / 4.0), (slot, 10.0 + PI, 5.0 + PI / 4.0)];
        for (shape, length, area) in shapes {
            let (found, normal, flux) = moments(&around(&shape, 0.01));
            assert!((found - length).abs() < 1e-12, "{found} {length}");
            assert!(normal.iter().all(|n| n.abs() < 1e-12), "{normal:?}");
            assert!((flux - area).abs() < 1e-4 * area, "{flux} {area}");
        }
    }
}
