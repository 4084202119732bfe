//! Where a crack ends within a body, and the crack whose bonds have to be cut so that it acts as if it ended there.
//!
//! Next to its front a crack that cuts all bonds that cross it acts longer than it is: by 0.43, 0.40 and 0.47 spacings with two, three and
//! four of them per horizon, found from the energy of rows of cracks in plane strain (`σ √(W tan(π a / W))`), and alike in the plane. Without the
//! bonds that cross it within a tenth of the horizon of its front these lengths are 0.00, 0.01 and 0.03 spacings.

use super::{Crack, Point, Shape};
use crate::body::geometry::{distance, in_space};

/// Ends of a path that are so near to each other, over what tips recede by, make it a loop.
const CLOSED: f64 = 1e-3;

/// By how much the front of a crack recedes, and where.
pub struct Recess<'a> {
    /// Length, m.
    pub by: f64,
    /// How densely fronts of surfaces are looked at, m.
    pub step: f64,
    /// Lower and upper corners of a box around the body, m.
    pub within: [[f64; 3]; 2],
    /// Whether the body goes on beyond a place of the border of a crack, m, in a direction of length one.
    pub goes_on: &'a dyn Fn([f64; 3], [f64; 3]) -> bool,
}

/// A place on the front of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrontPlace {
    /// Where it is, m.
    pub at: [f64; 3],
    /// Direction of length one in the surface, across the front and away from the crack.
    pub ahead: [f64; 3],
    /// Unit normal of the surface.
    pub normal: [f64; 3],
}

impl Crack {
    /// The crack that acts as long as this one does in a continuum: it spares bonds that cross it next to its front.
    #[must_use]
    pub fn receded(&self, recess: &Recess) -> Self {
        Self(match &self.0 {
            Shape::Path(path) => Shape::Path(shortened(path, recess)),
            Shape::Surface(surface) => Shape::Surface(surface.receded(recess)),
        })
    }
}

/// A path without its ends within the body; one that would be lost keeps them.
fn shortened(path: &[Point], recess: &Recess) -> Vec<Point> {
    let last = path.len() - 1;
    let is_closed = distance(path[0], path[last]) <= CLOSED * recess.by;
    let goes_on = |tip: Point, before: Point| {
        let length = distance(tip, before);
        let ahead = [0, 1].map(|k| (tip[k] - before[k]) / length);
        !is_closed && (recess.goes_on)(in_space(tip), in_space(ahead))
    };
    let cuts = [goes_on(path[0], path[1]), goes_on(path[last], path[last - 1])];
    let length: f64 = path.windows(2).map(|w| distance(w[0], w[1])).sum();
    let lost = cuts.iter().filter(|cut| **cut).count() as f64 * recess.by;
    if lost >= length * (1.0 - 1e-9) {
        return path.to_vec();
    }
    let mut path = path.to_vec();
    for cut in cuts {
        if cut {
            path = without_start(&path, recess.by);
        }
        path.reverse();
    }
    path
}

/// A path without a length at its start, m, which is less than all of it.
fn without_start(path: &[Point], mut by: f64) -> Vec<Point> {
    let mut first = 0;
    while first + 2 < path.len() && distance(path[first], path[first + 1]) <= by {
        by -= distance(path[first], path[first + 1]);
        first += 1;
    }
    let share = by / distance(path[first], path[first + 1]);
    let start = [0, 1].map(|k| path[first][k] + share * (path[first + 1][k] - path[first][k]));
    [start].into_iter().chain(path[first + 1..].iter().copied()).collect()
}
