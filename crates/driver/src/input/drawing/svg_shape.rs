//! Shapes of SVG as strokes.

use super::super::ReadError;
use super::curve::{Arc, Ellipse, cubic};
use super::strokes::{Circle, Stroke, Strokes};
use super::svg::{Axes, line};
use roxmltree::Node;
use std::f64::consts::TAU;
use svgtypes::{PathParser, PathSegment, PointsParser};

type Point = [f64; 2];

/// An element, its axes and how far chords may be from its curves.
struct Shape<'a, 'i> {
    node: Node<'a, 'i>,
    axes: &'a Axes,
    deviation: f64,
}

/// Adds the lines of an element; others than shapes have none.
pub(super) fn add(node: Node, axes: &Axes, deviation: f64, to: &mut Strokes) -> Result<(), ReadError> {
    let shape = Shape { node, axes, deviation: deviation / axes.stretch().max(f64::MIN_POSITIVE) };
    match node.tag_name().name() {
        "path" => shape.path(to),
        "line" => {
            let ends = [["x1", "y1"], ["x2", "y2"]];
            let [a, b] = ends.map(|keys| keys.map(|key| shape.number(key, Some(0.0))));
            shape.add(vec![[a[0].clone()?, a[1].clone()?], [b[0].clone()?, b[1].clone()?]], to)
        }
        "rect" => shape.rectangle(to),
        "circle" => {
            let radius = shape.number("r", None)?;
            shape.round([radius; 2], to)
        }
        "ellipse" => shape.round([shape.number("rx", None)?, shape.number("ry", None)?], to),
        kind @ ("polyline" | "polygon") => {
            let text = node.attribute("points").unwrap_or_default();
            let mut points: Vec<Point> = PointsParser::from(text).map(|(x, y)| [x, y]).collect();
            if kind == "polygon" {
                points.extend(points.first().copied());
            }
            points.windows(2).try_for_each(|ends| shape.add(ends.to_vec(), to))
        }
        _ => Ok(()),
    }
}

impl Shape<'_, '_> {
    fn number(&self, key: &str, otherwise: Option<f64>) -> Result<f64, ReadError> {
        let Some(text) = self.node.attribute(key) else {
            let kind = self.node.tag_name().name();
            return otherwise.ok_or_else(|| {
                ReadError::at(line(self.node), format!("the `{kind}` has no attribute `{key}`"))
            });
        };
        let value = text.trim().trim_end_matches("px").parse::<f64>().ok().filter(|x| x.is_finite());
        value.ok_or_else(|| {
            let found: String = text.chars().take(40).collect();
            ReadError::at(line(self.node), format!("expected a number of `{key}`, found `{found}`"))
                .hint("lengths are read in units of the drawing, without `mm` or `%`")
        })
    }

    fn names(&self) -> Vec<String> {
        self.node.attribute("id").filter(|id| !id.is_empty()).map(Into::into).into_iter().collect()
    }

    /// Adds chords in axes of the element.
    fn add(&self, points: Vec<Point>, to: &mut Strokes) -> Result<(), ReadError> {
        let points = points.into_iter().map(|p| self.axes.at(p)).collect();
        to.add(Stroke { points, names: self.names(), line: line(self.node), curve: None })
    }

    fn rectangle(&self, to: &mut Strokes) -> Result<(), ReadError> {
        let [x, y] = [self.number("x", Some(0.0))?, self.number("y", Some(0.0))?];
        let [w, h] = [self.number("width", None)?, self.number("height", None)?];
        let rx = self
            .number("rx", Some(f64::NAN))
            .or_else(|e| if self.node.has_attribute("rx") { Err(e) } else { Ok(0.0) })?;
        let ry = self
            .number("ry", Some(f64::NAN))
            .or_else(|e| if self.node.has_attribute("ry") { Err(e) } else { Ok(0.0) })?;
        // One radius is both.
        let [rx, ry] = [if rx.is_nan() { ry } else { rx }, if ry.is_nan() { rx } else { ry }];
        let clean = |r: f64, side: f64| if r.is_nan() { 0.0 } else { r.clamp(0.0, (0.5 * side).max(0.0)) };
        let (rx, ry) = (clean(rx, w), clean(ry, h));
        let corners =
            [[x, y, 1.0, 1.0], [x + w, y, -1.0, 1.0], [x + w, y + h, -1.0, -1.0], [x, y + h, 1.0, -1.0]];
        for k in 0..4 {
            let ([ax, ay, ai, aj], [bx, by, bi, bj]) = (corners[k], corners[(k + 1) % 4]);
            let is_flat = k % 2 == 0;
            let from = if is_flat { [ax + ai * rx, ay] } else { [ax, ay + aj * ry] };
            let end = if is_flat { [bx + bi * rx, by] } else { [bx, by + bj * ry] };
            if from != end {
                self.add(vec![from, end], to)?;
            }
            let next = if is_flat { [bx, by + bj * ry] } else { [bx + bi * rx, by] };
            if let Some(arc) = Ellipse::of_svg([end, next], [rx, ry], 0.0, (false, true)) {
                self.add(ended(arc.chords(self.deviation), end, next), to)?;
            }
        }
        Ok(())
    }

    fn round(&self, radii: [f64; 2], to: &mut Strokes) -> Result<(), ReadError> {
        let centre = [self.number("cx", Some(0.0))?, self.number("cy", Some(0.0))?];
        if let (Some(scale), true) = (self.axes.scale(), radii[0] == radii[1]) {
            let (centre, radius) = (self.axes.at(centre), scale * radii[0]);
            return to.add_circle(Circle { centre, radius, names: self.names(), line: line(self.node) });
        }
        let arc = Arc { centre, radius: radii[0], start: 0.0, sweep: TAU };
        let mut points = Ellipse { arc, across: radii[1], turn: 0.0 }.chords(self.deviation);
        if let Some(last) = points.len().checked_sub(1) {
            points[last] = points[0];
        }
        self.add(points, to)
    }

    fn path(&self, to: &mut Strokes) -> Result<(), ReadError> {
        let text = self.node.attribute("d").unwrap_or_default();
        let mut pen = Pen::default();
        for segment in PathParser::from(text) {
            let segment = segment
                .map_err(|error| ReadError::at(line(self.node), format!("the path is broken: {error}")))?;
            if let Some(points) = pen.chords(segment, self.deviation) {
                self.add(points, to)?;
            }
        }
        Ok(())
    }
}

/// Chords that start and end exactly there.
fn ended(mut points: Vec<Point>, from: Point, end: Point) -> Vec<Point> {
    let last = points.len() - 1;
    (points[0], points[last]) = (from, end);
    points
}

/// Where a path is.
#[derive(Default)]
struct Pen {
    at: Point,
    /// Where the part of the path began.
    start: Point,
    /// The position before the end of the last curve, and its degree.
    control: Option<(Point, u8)>,
}

impl Pen {
    /// What a segment draws; moves draw nothing.
    fn chords(&mut self, segment: PathSegment, deviation: f64) -> Option<Vec<Point>> {
        use PathSegment as S;
        let from = self.at;
        let place = |abs: bool, x: f64, y: f64| if abs { [x, y] } else { [from[0] + x, from[1] + y] };
        let reflected = |degree: u8| match self.control {
            Some((c, d)) if d == degree => [2.0 * from[0] - c[0], 2.0 * from[1] - c[1]],
            _ => from,
        };
        let mut control = None;
        let (end, points) = match segment {
            S::MoveTo { abs, x, y } => {
                (self.start, self.control) = (place(abs, x, y), None);
                self.at = self.start;
                return None;
            }
            S::ClosePath { .. } => (self.start, None),
            S::LineTo { abs, x, y } => (place(abs, x, y), None),
            S::HorizontalLineTo { abs, x } => ([place(abs, x, 0.0)[0], from[1]], None),
            S::VerticalLineTo { abs, y } => ([from[0], place(abs, 0.0, y)[1]], None),
            S::CurveTo { abs, x1, y1, x2, y2, x, y } => {
                let (a, b, end) = (place(abs, x1, y1), place(abs, x2, y2), place(abs, x, y));
                control = Some((b, 3));
                (end, Some(cubic([from, a, b, end], deviation)))
            }
            S::SmoothCurveTo { abs, x2, y2, x, y } => {
                let (a, b, end) = (reflected(3), place(abs, x2, y2), place(abs, x, y));
                control = Some((b, 3));
                (end, Some(cubic([from, a, b, end], deviation)))
            }
            S::Quadratic { abs, x1, y1, x, y } => {
                let (c, end) = (place(abs, x1, y1), place(abs, x, y));
                control = Some((c, 2));
                (end, Some(quadratic(from, c, end, deviation)))
            }
            S::SmoothQuadratic { abs, x, y } => {
                let (c, end) = (reflected(2), place(abs, x, y));
                control = Some((c, 2));
                (end, Some(quadratic(from, c, end, deviation)))
            }
            S::EllipticalArc { abs, rx, ry, x_axis_rotation, large_arc, sweep, x, y } => {
                let end = place(abs, x, y);
                let arc =
                    Ellipse::of_svg([from, end], [rx, ry], x_axis_rotation.to_radians(), (large_arc, sweep));
                (end, arc.map(|arc| ended(arc.chords(deviation), from, end)))
            }
        };
        (self.at, self.control) = (end, control);
        match points {
            Some(points) => Some(points),
            None => (from != end).then(|| vec![from, end]),
        }
    }
}

fn quadratic(from: Point, control: Point, end: Point, deviation: f64) -> Vec<Point> {
    let toward = |p: Point| [0, 1].map(|k| p[k] + 2.0 / 3.0 * (control[k] - p[k]));
    cubic([from, toward(from), toward(end), end], deviation)
}
