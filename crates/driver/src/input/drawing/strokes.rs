//! The lines of a drawing as its reader finds them.

use super::super::ReadError;

/// A straight line, or the chords of a curve.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stroke {
    /// Its positions from end to end, two at least.
    pub(crate) points: Vec<[f64; 2]>,
    /// What the drawing calls it.
    pub(crate) names: Vec<String>,
    /// Where it stands in the file.
    pub(crate) line: usize,
    /// The curve that it is a part of, if the file tells.
    pub(crate) curve: Option<i64>,
}

/// A circle, which is no polygon where it is a hole.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Circle {
    pub(crate) centre: [f64; 2],
    pub(crate) radius: f64,
    pub(crate) names: Vec<String>,
    pub(crate) line: usize,
}

/// The number of curves of which a mesh tells nothing: Gmsh saves those in physical groups alone.
pub(crate) const UNTOLD: i64 = i64::MIN;

/// All lines of a drawing.
#[derive(Debug, Default)]
pub(crate) struct Strokes {
    pub(crate) strokes: Vec<Stroke>,
    pub(crate) circles: Vec<Circle>,
    positions: usize,
}

/// Positions of all chords together, at most: a few letters of a file make thousands of them.
const MOST: usize = 4_000_000;

impl Strokes {
    /// Adds a line.
    pub(crate) fn add(&mut self, stroke: Stroke) -> Result<(), ReadError> {
        if !stroke.points.iter().flatten().all(|x| x.is_finite()) {
            return Err(ReadError::at(stroke.line, "a coordinate is not finite"));
        }
        self.positions += stroke.points.len();
        if self.positions > MOST {
            return Err(ReadError::at(
                stroke.line,
                format!("the curves up to here have more than {MOST} chords"),
            )
            .hint("use a larger spacing: chords are a hundredth of it from their curve"));
        }
        self.strokes.push(stroke);
        Ok(())
    }

    /// Adds a circle.
    pub(crate) fn add_circle(&mut self, circle: Circle) -> Result<(), ReadError> {
        let [x, y] = circle.centre;
        if ![x, y, circle.radius].iter().all(|v| v.is_finite()) {
            return Err(ReadError::at(circle.line, "a coordinate is not finite"));
        }
        if circle.radius <= 0.0 {
            return Err(ReadError::at(
                circle.line,
                format!("the radius of a circle must be greater than zero, found {}", circle.radius),
            ));
        }
        self.circles.push(circle);
        Ok(())
    }
}
