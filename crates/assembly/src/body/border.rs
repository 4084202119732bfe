//! The border of a body as straight and round parts, without what other holes take of them.

use super::geometry::{Point, distance, dot, minus, moved};
use super::hole::Shape;
use super::outline::{Edge, Outline};
use std::f64::consts::TAU;

/// A part of the border of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BorderPart {
    /// A segment.
    Straight {
        /// Start, m.
        from: [f64; 2],
        /// End, m.
        to: [f64; 2],
        /// Unit normal that points out of the body.
        normal: [f64; 2],
    },
    /// An arc around a hole; normals point to its centre.
    Round {
        /// Centre, m.
        centre: [f64; 2],
        /// Radius, m.
        radius: f64,
        /// Angles of start and end from x, counter-clockwise, rad.
        angles: [f64; 2],
    },
}

/// Depth behind a border at which there is a body or not, relative to the size of the body.
const BEHIND: f64 = 1e-9;
/// Parts of parts that are shorter, relative to the whole, are rounding.
const LEAST: f64 = 1e-12;

impl BorderPart {
    /// Length, m.
    pub fn length(&self) -> f64 {
        match *self {
            Self::Straight { from, to, .. } => distance(from, to),
            Self::Round { radius, angles, .. } => radius * (angles[1] - angles[0]),
        }
    }

    /// Position at a share of the length, 0 to 1, m.
    pub fn at(&self, share: f64) -> [f64; 2] {
        match *self {
            Self::Straight { from, to, .. } => [0, 1].map(|k| from[k] + share * (to[k] - from[k])),
            Self::Round { centre, radius, angles } => {
                let (sin, cos) = (angles[0] + share * (angles[1] - angles[0])).sin_cos();
                [centre[0] + radius * cos, centre[1] + radius * sin]
            }
        }
    }

    /// Unit normal that points out of the body, at a share of the length.
    pub fn normal(&self, share: f64) -> [f64; 2] {
        match *self {
            Self::Straight { normal, .. } => normal,
            Self::Round { angles, .. } => {
                let (sin, cos) = (angles[0] + share * (angles[1] - angles[0])).sin_cos();
                [-cos, -sin]
            }
        }
    }

    /// The part between two shares of the length.
    pub fn between(&self, start: f64, end: f64) -> Self {
        match *self {
            Self::Straight { normal, .. } => {
                Self::Straight { from: self.at(start), to: self.at(end), normal }
            }
            Self::Round { centre, radius, angles: [a, b] } => {
                Self::Round { centre, radius, angles: [start, end].map(|share| a + share * (b - a)) }
            }
        }
    }

    /// Shares of the length at which the line or circle of another part crosses this one.
    pub(crate) fn crossings(&self, other: &Self) -> Vec<f64> {
        match (*self, *other) {
            (Self::Straight { from, to, .. }, Self::Straight { from: a, to: b, .. }) => {
                let (d, e, r) = (minus(to, from), minus(b, a), minus(a, from));
                let cross = |p: Point, q: Point| p[0] * q[1] - p[1] * q[0];
                let turn = cross(d, e);
                if turn == 0.0 { Vec::new() } else { vec![cross(r, e) / turn] }
            }
            (Self::Straight { from, to, .. }, Self::Round { centre, radius, .. }) => {
                let (d, r) = (minus(to, from), minus(from, centre));
                let (square, half) = (dot(d, d), dot(d, r));
                let root = half * half - square * (dot(r, r) - radius * radius);
                if root <= 0.0 {
                    // Where it is nearest: a circle that touches the line has nothing of it, but its middle.
                    return vec![-half / square];
                }
                [-1.0, 1.0].map(|sign| (sign * root.sqrt() - half) / square).to_vec()
            }
            (Self::Round { centre, radius, .. }, Self::Straight { from, to, .. }) => {
                let d = minus(to, from);
                let length = dot(d, d).sqrt();
                let normal = [-d[1] / length, d[0] / length];
                self.shares_beside(normal, dot(minus(from, centre), normal) / radius)
            }
            (Self::Round { centre, radius, .. }, Self::Round { centre: other, radius: second, .. }) => {
                let d = minus(other, centre);
                let apart = dot(d, d).sqrt();
                if apart == 0.0 {
                    return Vec::new();
                }
                let along = 0.5 * (apart * apart + radius * radius - second * second) / apart;
                self.shares_beside(d.map(|x| x / apart), along / radius)
            }
        }
    }

    /// Shares at which an arc has this cosine with a direction.
    fn shares_beside(&self, direction: Point, cosine: f64) -> Vec<f64> {
        let Self::Round { angles: [start, end], .. } = *self else { return Vec::new() };
        // What does not meet the circle is nearest to it at one place, which it may touch.
        let (middle, half) = (direction[1].atan2(direction[0]), cosine.clamp(-1.0, 1.0).acos());
        let share = |angle: f64| (angle - start).rem_euclid(TAU) / (end - start);
        vec![share(middle - half), share(middle + half)]
    }
}

impl Shape {
    /// Its border, as that of a body around it.
    fn parts(&self) -> Vec<BorderPart> {
        let straight = |from: Point, to: Point, normal: Point| BorderPart::Straight { from, to, normal };
        match self {
            Self::Circle { centre, radius } => {
                vec![BorderPart::Round { centre: *centre, radius: *radius, angles: [0.0, TAU] }]
            }
            Self::Slot { from, to, radius } if from == to => {
                vec![BorderPart::Round { centre: *from, radius: *radius, angles: [0.0, TAU] }]
            }
            Self::Slot { from, to, radius } => {
                let d = minus(*to, *from);
                let (turn, length, quarter) = (d[1].atan2(d[0]), dot(d, d).sqrt(), 0.25 * TAU);
                let across = [-d[1] / length, d[0] / length];
                let end = |centre: Point, start: f64| BorderPart::Round {
                    centre,
                    radius: *radius,
                    angles: [start, start + 2.0 * quarter],
                };
                let side = |sign: f64| {
                    let [a, b] = [from, to].map(|p| moved(*p, sign * radius, across));
                    straight(a, b, across.map(|n| -sign * n))
                };
                vec![end(*to, turn - quarter), side(1.0), end(*from, turn + quarter), side(-1.0)]
            }
            Self::Polygon(polygon) | Self::Ellipse { chords: polygon, .. } => {
                let edge = |k: usize| {
                    let [from, to] = polygon.edge(k);
                    straight(from, to, polygon.normal(k).map(|n| -n))
                };
                (0..polygon.vertices().len()).map(edge).collect()
            }
        }
    }
}

impl Outline {
    /// The parts of an edge, from its start to its end, that no hole takes.
    pub fn edge_parts(&self, edge: &Edge) -> Vec<BorderPart> {
        let whole = BorderPart::Straight { from: edge.from, to: edge.to, normal: edge.normal };
        let holes: Vec<BorderPart> = self.holes().iter().flat_map(|hole| hole.shape.parts()).collect();
        self.bordering(&[whole], &holes)
    }

    /// The parts of the border of a hole, by its number, behind which there is a body.
    pub fn hole_parts(&self, hole: usize) -> Vec<BorderPart> {
        self.bordering(&self.holes()[hole].shape.parts(), &self.others(hole))
    }

    /// All edges, and the borders of all holes but one.
    fn others(&self, hole: usize) -> Vec<BorderPart> {
        let edge = |e: &Edge| BorderPart::Straight { from: e.from, to: e.to, normal: e.normal };
        let holes = self.holes().iter().enumerate().filter(|(k, _)| *k != hole);
        let others = holes.flat_map(|(_, other)| other.shape.parts());
        self.edges().iter().map(edge).chain(others).collect()
    }

    /// The parts of the border of one edge of a hole that is a polygon, behind which there is a body.
    pub fn hole_edge_parts(&self, hole: usize, edge: usize) -> Vec<BorderPart> {
        let own = self.hole_edge(hole, edge).into_iter();
        let own: Vec<BorderPart> =
            own.map(|e| BorderPart::Straight { from: e.from, to: e.to, normal: e.normal }).collect();
        if own.is_empty() { own } else { self.bordering(&own, &self.others(hole)) }
    }

    /// What of some parts borders on the body.
    fn bordering(&self, parts: &[BorderPart], others: &[BorderPart]) -> Vec<BorderPart> {
        let [low, high] = self.bounds();
        let depth = BEHIND * distance(low, high);
        let behind = |part: &BorderPart| self.contains(moved(part.at(0.5), -depth, part.normal(0.5)));
        let own = around(parts, depth);
        let others: Vec<&BorderPart> =
            others.iter().filter(|other| meet(&own, &around(std::slice::from_ref(*other), depth))).collect();
        if others.is_empty() {
            // All of it borders on the same.
            return parts.first().filter(|part| behind(part)).map_or(Vec::new(), |_| parts.to_vec());
        }
        let mut found = Vec::new();
        for part in parts {
            let mut shares: Vec<f64> = others.iter().flat_map(|other| part.crossings(other)).collect();
            shares.retain(|share| (LEAST..=1.0 - LEAST).contains(share));
            shares.extend([0.0, 1.0]);
            shares.sort_by(f64::total_cmp);
            let pieces = shares.windows(2).filter(|ends| ends[1] - ends[0] > LEAST);
            let mut kept: Vec<[f64; 2]> = Vec::new();
            for ends in pieces.filter(|ends| behind(&part.between(ends[0], ends[1]))) {
                match kept.last_mut().filter(|last| last[1] == ends[0]) {
                    Some(last) => last[1] = ends[1],
                    None => kept.push([ends[0], ends[1]]),
                }
            }
            found.extend(kept.into_iter().map(|[start, end]| match start == 0.0 && end == 1.0 {
                true => *part,
                false => part.between(start, end),
            }));
        }
        found
    }
}

/// The box around some parts, of arcs around their circles, wider by a margin.
pub(crate) fn around(parts: &[BorderPart], margin: f64) -> [Point; 2] {
    let corners = parts.iter().flat_map(|part| match *part {
        BorderPart::Straight { from, to, .. } => [from, to],
        BorderPart::Round { centre, radius, .. } => [centre.map(|x| x - radius), centre.map(|x| x + radius)],
    });
    corners.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], at| {
        [[0, 1].map(|k| low[k].min(at[k] - margin)), [0, 1].map(|k| high[k].max(at[k] + margin))]
    })
}

/// Whether two boxes have something in common.
fn meet([low, high]: &[Point; 2], [other_low, other_high]: &[Point; 2]) -> bool {
    (0..2).all(|k| low[k] <= other_high[k] && other_low[k] <= high[k])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{Hole, Polygon};
    use std::f64::consts::PI;

    fn length(parts: &[BorderPart]) -> f64 {
        parts.iter().map(BorderPart::length).sum()
    }

    fn body(shapes: Vec<Shape>) -> Outline {
        let mut outline = Outline::rectangle([0.0; 2], [10.0, 6.0]).unwrap();
        shapes.into_iter().for_each(|shape| outline.cut(Hole { name: None, shape }).unwrap());
        outline
    }

    #[test]
    fn a_notch_takes_its_chord_of_the_edge_and_leaves_its_arc() {
        // Centre 1 above the edge: the chord is 2√(4 − 1), the arc that is inside 2π·2 − 2·2·acos(1/2).
        let outline = body(vec![Shape::Circle { centre: [4.0, 1.0], radius: 2.0 }]);
        let bottom = outline.edge_parts(outline.edge("bottom").unwrap());
        assert_eq!(bottom.len(), 2);
        assert!((length(&bottom) - (10.0 - 2.0 * 3.0_f64.sqrt())).abs() < 1e-14);
        let arc = outline.hole_parts(0);
        assert!((length(&arc) - 4.0 * (PI - PI / 3.0)).abs() < 1e-14, "{arc:?}");
        for part in &arc {
            assert!(part.at(0.5)[1] > 0.0);
        }
    }

    /// A circle that touches an edge in its middle, within rounding on either side of it, takes nothing of it, nor the edge of it.
    #[test]
    fn a_hole_that_touches_an_edge_takes_nothing_of_it() {
        for off in [0.0, 1e-12, -1e-12, 1e-9, 3e-8] {
            let outline = body(vec![Shape::Circle { centre: [5.0, 2.0 + off], radius: 2.0 }]);
            let bottom = outline.edge_parts(outline.edge("bottom").unwrap());
            assert!((length(&bottom) - 10.0).abs() < 1e-5, "{off}: {bottom:?}");
            assert!((length(&outline.hole_parts(0)) - 4.0 * PI).abs() < 1e-5, "{off}");
        }
        // Circles that touch each other from outside.
        let circle = |x: f64| Shape::Circle { centre: [x, 3.0], radius: 1.0 };
        let outline = body(vec![circle(4.0), circle(6.0)]);
        (0..2).for_each(|hole| assert!((length(&outline.hole_parts(hole)) - 2.0 * PI).abs() < 1e-9));
    }

    #[test]
    fn holes_that_overlap_take_parts_of_each_other() {
        // Circles of radius 1, their centres 1 apart: each loses 2·acos(1/2) of its border.
        let circle = |x: f64| Shape::Circle { centre: [x, 3.0], radius: 1.0 };
        let outline = body(vec![circle(4.0), circle(5.0)]);
        for hole in 0..2 {
            assert!((length(&outline.hole_parts(hole)) - (2.0 * PI - 2.0 * PI / 3.0)).abs() < 1e-13);
        }
    }

    #[test]
    fn a_hole_within_a_hole_borders_on_nothing() {
        let circle = |radius: f64| Shape::Circle { centre: [5.0, 3.0], radius };
        let outline = body(vec![circle(2.0), circle(1.0)]);
        assert!((length(&outline.hole_parts(0)) - 4.0 * PI).abs() < 1e-13);
        assert!(outline.hole_parts(1).is_empty());
        // Far from the sides of a square hole.
        let square = Polygon::new(vec![[2.0, 0.5], [8.0, 0.5], [8.0, 5.5], [2.0, 5.5]]).unwrap();
        let inside = body(vec![Shape::Polygon(square), circle(1.0)]);
        assert!(inside.hole_parts(1).is_empty() && inside.hole_parts(0).len() == 4);
    }

    #[test]
    fn borders_of_holes_are_closed_and_look_inwards() {
        let polygon = Polygon::new(vec![[3.0, 2.0], [5.0, 2.0], [4.0, 4.0]]).unwrap();
        let slot = Shape::Slot { from: [3.0, 3.0], to: [5.0, 4.0], radius: 0.5 };
        let long = 5.0_f64.sqrt();
        for (shape, area) in [(Shape::Polygon(polygon), 2.0), (slot, long + 0.25 * PI)] {
            let outline = body(vec![shape.clone()]);
            let parts = outline.hole_parts(0);
            assert!((length(&parts) - shape.perimeter()).abs() < 1e-13);
            // By Gauss ∮ x·n ds = −2 A.
            let flux = |part: &BorderPart| {
                let rule = crate::quadrature::GAUSS.iter();
                rule.map(|(at, w)| w * part.length() * dot(part.at(*at), part.normal(*at))).sum::<f64>()
            };
            assert!((-0.5 * parts.iter().map(flux).sum::<f64>() - area).abs() < 1e-12, "{shape:?}");
        }
    }

    #[test]
    fn an_edge_without_holes_is_whole_to_the_last_bit() {
        let outline = body(Vec::new());
        for edge in outline.edges() {
            let [part] = outline.edge_parts(edge)[..] else { panic!("one part") };
            assert_eq!((part.at(0.0), part.normal(0.0)), (edge.from, edge.normal));
        }
    }
}
