//! Pictures of bodies in the plane: shapes in their own coordinates, both axes to one scale.

use std::io;
use std::path::Path;

use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::draw::{COLORS, Canvas, Drawn, FINE, INK, ZERO, at, font, on_canvas, text};
use super::scale::short;
use crate::output::atomic;

/// How a shape is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Look {
    /// A thick line: the body itself.
    Body,
    /// A thin line: the body where it is not what the picture is about.
    Ghost,
    /// A line in colour.
    Line,
    /// A filled outline in colour.
    Area,
    /// Dots.
    Dots,
    /// Open circles.
    Circles,
}

/// Points of a shape.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// How it is drawn.
    pub look: Look,
    /// Its points, in the order of the line.
    pub points: Vec<(f64, f64)>,
}

/// A number beside a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Label {
    /// The number.
    pub value: f64,
    /// The place.
    pub at: (f64, f64),
    /// Direction in which the number stands from the place.
    pub away: (f64, f64),
}

/// A picture.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Picture {
    /// Heading.
    pub title: String,
    /// One line below it: what is drawn, in which unit, to which scale.
    pub note: String,
    /// What is drawn, the first lowest.
    pub shapes: Vec<Shape>,
    /// Numbers, the most important first; one that would lie on another is left out.
    pub labels: Vec<Label>,
}

/// Width in pixels, and the least and the largest height.
const WIDTH: i32 = 860;
const HEIGHTS: (i32, i32) = (320, 900);
/// Room around the shapes, for the numbers; that above them holds the heading.
const MARGIN: i32 = 76;
const TOP: i32 = 96;
/// Half the room of a number, pixels.
const ROOM: (f64, f64) = (52.0, 15.0);

/// From coordinates to pixels.
struct View {
    low: (f64, f64),
    scale: f64,
    left: f64,
    height: i32,
}

impl View {
    /// Around all shapes; `None` if there is no point, or one that is not finite.
    fn new(picture: &Picture) -> Option<Self> {
        let points = || picture.shapes.iter().flat_map(|s| &s.points);
        let bound = |of: fn(&(f64, f64)) -> f64| {
            points().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)))
        };
        let ((x0, x1), (y0, y1)) = (bound(|p| p.0), bound(|p| p.1));
        if !points().all(|p| p.0.is_finite() && p.1.is_finite()) || x0 > x1 {
            return None;
        }
        let (width, height) = ((x1 - x0).max(f64::MIN_POSITIVE), (y1 - y0).max(f64::MIN_POSITIVE));
        let room = (f64::from(WIDTH - 2 * MARGIN), f64::from(HEIGHTS.1 - TOP - MARGIN));
        let scale = (room.0 / width).min(room.1 / height);
        let height = ((scale * height) as i32).saturating_add(TOP + MARGIN).clamp(HEIGHTS.0, HEIGHTS.1);
        let left = 0.5 * (f64::from(WIDTH) - scale * width);
        scale.is_finite().then_some(Self { low: (x0, y0), scale, left, height })
    }

    fn pixel(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let bottom = f64::from(self.height - MARGIN);
        (self.left + self.scale * (x - self.low.0), bottom - self.scale * (y - self.low.1))
    }

    fn place(&self, point: (f64, f64)) -> (i32, i32) {
        let (x, y) = self.pixel(point);
        ((x * f64::from(FINE)).round() as i32, (y * f64::from(FINE)).round() as i32)
    }
}

/// Writes a picture as SVG.
///
/// # Errors
/// [`io::ErrorKind::InvalidInput`] if there is no point or one that is not finite; what the file system reports.
pub fn write_picture(path: &Path, picture: &Picture) -> io::Result<()> {
    let Some(view) = View::new(picture) else {
        let message = format!("picture `{}` has no points, or one that is not finite", picture.title);
        return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
    };
    let svg =
        on_canvas((WIDTH, view.height), |canvas| draw(canvas, picture, &view)).map_err(io::Error::other)?;
    atomic::write_atomically(path, svg.as_bytes())
}

fn draw(canvas: &Canvas<'_>, picture: &Picture, view: &View) -> Drawn {
    canvas.fill(&WHITE)?;
    let bold = font(17).style(FontStyle::Bold);
    text(canvas, &picture.title, at(28, 24), bold.color(&INK), HPos::Left)?;
    text(canvas, &picture.note, at(28, 50), font(13).color(&INK), HPos::Left)?;
    for shape in &picture.shapes {
        draw_shape(canvas, shape, view)?;
    }
    let mut taken: Vec<(f64, f64)> = Vec::new();
    for label in &picture.labels {
        let (x, y) = view.pixel(label.at);
        let size = label.away.0.hypot(label.away.1).max(f64::MIN_POSITIVE);
        let (x, y) = (x + 38.0 * label.away.0 / size, y - 14.0 * label.away.1 / size);
        if taken.iter().any(|t| (t.0 - x).abs() < ROOM.0 && (t.1 - y).abs() < ROOM.1) {
            continue;
        }
        taken.push((x, y));
        let style = font(12).style(FontStyle::Bold).color(&COLORS[0]);
        text(canvas, &short(label.value), at(x.round() as i32, y.round() as i32), style, HPos::Center)?;
    }
    Ok(canvas.present()?)
}

fn draw_shape(canvas: &Canvas<'_>, shape: &Shape, view: &View) -> Drawn {
    let points: Vec<(i32, i32)> = shape.points.iter().map(|&p| view.place(p)).collect();
    let line = |points, style: ShapeStyle| canvas.draw(&PathElement::new(points, style));
    match shape.look {
        Look::Body => line(points, INK.stroke_width(26))?,
        Look::Ghost => line(points, ZERO.stroke_width(10))?,
        Look::Line => line(points, COLORS[0].stroke_width(22))?,
        Look::Area => {
            canvas.draw(&Polygon::new(points.clone(), COLORS[0].mix(0.13).filled()))?;
            line(points, COLORS[0].stroke_width(12))?;
        }
        Look::Dots => {
            for point in points {
                canvas.draw(&Circle::new(point, 3 * FINE, INK.filled()))?;
            }
        }
        Look::Circles => {
            for point in points {
                canvas.draw(&Circle::new(point, 4 * FINE, WHITE.filled()))?;
                canvas.draw(&Circle::new(point, 4 * FINE, INK.stroke_width(14)))?;
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(size: f64) -> Picture {
        let points = vec![(0.0, 0.0), (size, 0.0), (size, size), (0.0, size)];
        let shapes = [Look::Body, Look::Ghost, Look::Line, Look::Area, Look::Dots, Look::Circles]
            .map(|look| Shape { look, points: points.clone() });
        let label = Label { value: -2.5e-6, at: (size, size), away: (1.0, 0.0) };
        Picture { title: "<t>".into(), note: "n".into(), shapes: shapes.into(), labels: vec![label, label] }
    }

    #[test]
    fn both_axes_have_one_scale_and_a_number_stands_once() {
        let view = View::new(&square(2.0)).unwrap();
        let (a, b) = (view.pixel((0.0, 0.0)), view.pixel((1.0, 1.0)));
        assert!(((b.0 - a.0) - (a.1 - b.1)).abs() < 1e-9);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.svg");
        write_picture(&path, &square(2.0)).unwrap();
        let svg = std::fs::read_to_string(path).unwrap();
        assert!(svg.contains("&lt;t&gt;") && svg.trim_end().ends_with("</svg>"));
        assert_eq!(svg.matches("−2.5×10⁻⁶").count(), 1);
    }

    #[test]
    fn a_picture_without_extent_or_points_is_no_panic() {
        assert!(View::new(&square(0.0)).is_none_or(|v| v.scale.is_finite()));
        assert!(View::new(&Picture::default()).is_none());
        assert!(View::new(&square(f64::NAN)).is_none());
    }
}
