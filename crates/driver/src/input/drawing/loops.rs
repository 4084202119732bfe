//! Loops of strokes: the border of a body and its holes.

use super::super::ReadError;
use super::ends::Ends;
use super::strokes::{Circle, Stroke, Strokes, UNTOLD};
use super::{Drawing, DrawnHole, Loop};
use peristat_assembly::body::{BorderMember, Polygon, PolygonError};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Ends of lines meet at this part of the size of a drawing.
const MEET: f64 = 1e-6;
/// Lines go straight on if they turn by less, rad.
const STRAIGHT: f64 = 1e-9;

/// Chords of a mesh that turn by less are those of a curve, rad.
const CORNER: f64 = PI / 6.0;

/// A loop with its strokes.
struct Ring {
    strokes: Vec<Stroke>,
    polygon: Polygon,
}

/// The larger of the lengths of the box around a drawing.
fn extent(strokes: &Strokes) -> f64 {
    let lines = strokes.strokes.iter().flat_map(|s| s.points.iter().copied());
    let round = strokes.circles.iter().flat_map(|c| [1.0, -1.0].map(|s| c.centre.map(|x| x + s * c.radius)));
    let all: Vec<[f64; 2]> = lines.chain(round).collect();
    let along = |k: usize| {
        let [low, high] = [f64::min, f64::max].map(|of| all.iter().map(|p| p[k]).reduce(of).unwrap_or(0.0));
        high - low
    };
    along(0).max(along(1))
}

/// The circle that is around all other lines, if there is one.
pub(super) fn round_border(strokes: &Strokes) -> Option<usize> {
    let size = extent(strokes);
    let is_all = |circle: &Circle| 2.0 * circle.radius >= size * (1.0 - MEET);
    strokes.circles.iter().position(is_all)
}

/// What strokes bound.
pub(super) fn drawing(strokes: Strokes) -> Result<Drawing, ReadError> {
    let within = MEET * extent(&strokes);
    let Strokes { strokes, circles, .. } = strokes;
    let strokes: Vec<Stroke> = strokes.into_iter().filter_map(|stroke| long(stroke, within)).collect();
    if strokes.is_empty() {
        return Err(ReadError::whole("has no closed line").hint("draw the border of the body"));
    }
    let ends = Ends::new(&strokes, within)?;
    let mut rings = Vec::new();
    for walk in ends.loops() {
        rings.push(Ring::new(
            walk.into_iter().map(|(k, backwards)| walked(&strokes[k], backwards)).collect(),
        )?);
    }
    let area = |k: &usize| rings[*k].polygon.area();
    // The first of several that are as large.
    let largest = (0..rings.len()).rev().max_by(|a, b| area(a).total_cmp(&area(b))).unwrap_or(0);
    let border = rings.remove(largest);
    check_nested(&border, &rings, &circles)?;
    Ok(assemble(&border, rings, circles))
}

/// A stroke without positions that are the same; none if it is short.
fn long(mut stroke: Stroke, within: f64) -> Option<Stroke> {
    let last = *stroke.points.last()?;
    stroke.points.dedup_by(|next, kept| (next[0] - kept[0]).hypot(next[1] - kept[1]) <= within);
    // Its end stays where others meet it.
    if let Some(end) = stroke.points.last_mut() {
        *end = last;
    }
    (stroke.points.len() > 1).then_some(stroke)
}

fn walked(stroke: &Stroke, backwards: bool) -> Stroke {
    let mut stroke = stroke.clone();
    if backwards {
        stroke.points.reverse();
    }
    stroke
}

impl Ring {
    /// A loop of strokes that follow each other, counter-clockwise from the lowest of the leftmost ends.
    fn new(strokes: Vec<Stroke>) -> Result<Self, ReadError> {
        let mut joined: Vec<Stroke> = Vec::new();
        for stroke in strokes {
            match joined.last().and_then(|last| together(last, &stroke)) {
                Some(both) => *joined.last_mut().expect("there is one") = both,
                None => joined.push(stroke),
            }
        }
        if joined.len() > 2
            && let Some(both) = together(&joined[joined.len() - 1], &joined[0])
        {
            joined[0] = both;
            joined.pop();
        }
        if signed_area(&vertices(&joined)) < 0.0 {
            joined.reverse();
            joined.iter_mut().for_each(|stroke| stroke.points.reverse());
        }
        let first = (0..joined.len()).min_by(|&a, &b| {
            let [a, b] = [a, b].map(|k| joined[k].points[0]);
            a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
        });
        joined.rotate_left(first.unwrap_or(0));
        let polygon = Polygon::new(vertices(&joined)).map_err(|error| explain(&error, &joined))?;
        Ok(Self { strokes: joined, polygon })
    }

    fn closed(&self) -> Loop {
        Loop { vertices: self.polygon.vertices().to_vec(), sides: self.strokes.iter().map(edges).collect() }
    }

    fn line(&self) -> usize {
        self.strokes[0].line
    }
}

fn edges(stroke: &Stroke) -> usize {
    stroke.points.len() - 1
}

fn vertices(strokes: &[Stroke]) -> Vec<[f64; 2]> {
    strokes.iter().flat_map(|stroke| stroke.points[..edges(stroke)].iter().copied()).collect()
}

fn signed_area(vertices: &[[f64; 2]]) -> f64 {
    let o = vertices.first().copied().unwrap_or_default();
    let next = vertices.iter().skip(1);
    vertices
        .iter()
        .zip(next)
        .map(|(a, b)| (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]))
        .sum()
}

/// Two strokes that follow each other as one: where a line goes straight on, and where both are parts of a curve.
fn together(a: &Stroke, b: &Stroke) -> Option<Stroke> {
    if a.names != b.names {
        return None;
    }
    let way = |points: &[[f64; 2]]| [points[1][0] - points[0][0], points[1][1] - points[0][1]];
    if let (&[from, _], &[_, to]) = (&a.points[..], &b.points[..]) {
        let (d, e) = (way(&a.points), way(&b.points));
        let lengths = d[0].hypot(d[1]) * e[0].hypot(e[1]);
        let (turn, along) = (d[0] * e[1] - d[1] * e[0], d[0] * e[0] + d[1] * e[1]);
        if turn.abs() <= STRAIGHT * lengths && along > 0.0 {
            return Some(Stroke { points: vec![from, to], ..a.clone() });
        }
    }
    let [d, e] = [way(&a.points[a.points.len() - 2..]), way(&b.points)];
    let turn = (d[0] * e[1] - d[1] * e[0]).atan2(d[0] * e[0] + d[1] * e[1]);
    let is_curve = match a.curve {
        Some(UNTOLD) => a.curve == b.curve && turn.abs() < CORNER,
        curve => curve.is_some() && curve == b.curve,
    };
    is_curve.then(|| {
        let points = a.points.iter().chain(&b.points[1..]).copied().collect();
        Stroke { points, ..a.clone() }
    })
}

/// Why strokes bound nothing, by their lines.
fn explain(error: &PolygonError, strokes: &[Stroke]) -> ReadError {
    let line = |edge: usize| {
        let mut left = edge - 1;
        let found = strokes.iter().find(|stroke| {
            let is_it = left < edges(stroke);
            left = left.saturating_sub(edges(stroke));
            is_it
        });
        found.map_or(0, |stroke| stroke.line)
    };
    match *error {
        PolygonError::Crosses { first, second } => {
            let (first, second) = (line(first), line(second));
            let met = if first == second { String::new() } else { format!(", at what line {first} draws") };
            ReadError::at(second, format!("the outline crosses or touches itself{met}"))
                .hint("a border has no crossings: trim lines where they meet")
        }
        ref other => ReadError::at(strokes[0].line, format!("a closed line bounds nothing: {other}")),
    }
}

/// A fault for loops beside the border, and for those within a hole.
fn check_nested(border: &Ring, rings: &[Ring], circles: &[Circle]) -> Result<(), ReadError> {
    let lines = rings.iter().map(|ring| (ring.polygon.vertices()[0], ring.line(), ring.polygon.area()));
    let round = circles.iter().map(|c| (c.centre, c.line, PI * c.radius * c.radius));
    for (at, line, area) in lines.chain(round) {
        if !border.polygon.contains(at) {
            let message = format!("there is a second outline beside that of line {}", border.line());
            return Err(ReadError::at(line, message).hint("a body has one outline, and holes in it"));
        }
        let in_ring = rings.iter().find(|ring| ring.polygon.area() > area && ring.polygon.contains(at));
        let is_within = |c: &&Circle| {
            PI * c.radius * c.radius > area && (at[0] - c.centre[0]).hypot(at[1] - c.centre[1]) < c.radius
        };
        let around = in_ring.map(Ring::line).or(circles.iter().find(is_within).map(|c| c.line));
        if let Some(around) = around {
            return Err(ReadError::at(line, format!("this closed line is in the hole of line {around}"))
                .hint("what is in a hole is no part of the body: remove one of both"));
        }
    }
    Ok(())
}

fn assemble(border: &Ring, rings: Vec<Ring>, circles: Vec<Circle>) -> Drawing {
    let mut names: BTreeMap<String, Vec<BorderMember>> = BTreeMap::new();
    let mut call = |own: &[String], members: &mut dyn Iterator<Item = BorderMember>| {
        let members: Vec<BorderMember> = members.collect();
        for name in own {
            names.entry(name.clone()).or_default().extend(&members);
        }
    };
    let mut first = 0;
    for stroke in &border.strokes {
        let count = edges(stroke);
        call(&stroke.names, &mut (first..first + count).map(BorderMember::Edge));
        first += count;
    }
    let mut holes = Vec::new();
    for circle in circles {
        call(&circle.names, &mut std::iter::once(BorderMember::Hole(holes.len())));
        holes.push(DrawnHole::Circle { centre: circle.centre, radius: circle.radius });
    }
    for ring in rings {
        let hole = holes.len();
        if ring.strokes.iter().all(|stroke| stroke.names == ring.strokes[0].names) {
            call(&ring.strokes[0].names, &mut std::iter::once(BorderMember::Hole(hole)));
        } else {
            let mut first = 0;
            for stroke in &ring.strokes {
                let count = edges(stroke);
                let members = (first..first + count).map(|edge| BorderMember::HoleEdge { hole, edge });
                call(&stroke.names, &mut members.into_iter());
                first += count;
            }
        }
        holes.push(DrawnHole::Loop(ring.closed()));
    }
    Drawing { border: border.closed(), holes, names: names.into_iter().collect(), parts: Vec::new() }
}
