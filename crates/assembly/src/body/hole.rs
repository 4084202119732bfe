//! Shapes of holes.

use super::geometry::{Point, distance, meet, to_segment};
use super::polygon::{Polygon, PolygonError};
use super::turn::Turn;
use std::f64::consts::TAU;
use thiserror::Error;

/// Where a hole is.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// All positions nearer than `radius` to `centre`, m.
    Circle {
        /// Its middle.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
    },
    /// All positions nearer than `radius` to a segment, m; a circle if its ends are the same.
    Slot {
        /// Centre of the one round end.
        from: [f64; 2],
        /// Centre of the other.
        to: [f64; 2],
        /// Half the width.
        radius: f64,
    },
    /// The inside of an ellipse.
    Ellipse {
        /// Its middle.
        centre: [f64; 2],
        /// Half its axes, along x and y before it is turned.
        half_axes: [f64; 2],
        /// By how much it is turned, rad, counter-clockwise.
        turn: f64,
        /// Its chords, whose ends are on it.
        chords: Polygon,
    },
    /// The inside of a simple polygon.
    Polygon(Polygon),
}

/// A hole, or a notch if it crosses the outline. Its border belongs to the body.
#[derive(Clone, Debug, PartialEq)]
pub struct Hole {
    /// What regions call it.
    pub name: Option<String>,
    /// Where it is.
    pub shape: Shape,
}

/// Why a shape is no hole of an outline.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum HoleError {
    /// A radius is not above zero.
    #[error("the radius of a hole must be above zero, found {found}")]
    Radius {
        /// What was given.
        found: f64,
    },
    /// A half axis of an ellipse is not above zero.
    #[error("half the axes of an ellipse must be above zero, found {found}")]
    HalfAxis {
        /// 0 along x, 1 along y.
        axis: usize,
        /// What was given.
        found: f64,
    },
    /// A coordinate is infinite or no number.
    #[error("the position of a hole must be finite")]
    NotFinite,
    /// The vertices of a polygon are not those of a simple one.
    #[error(transparent)]
    Polygon(#[from] PolygonError),
    /// It shares no position with the inside of the outline.
    #[error("the hole is outside of the body")]
    Outside,
    /// Another hole, or an edge, has its name.
    #[error("there is another hole or an edge of the name `{name}`")]
    SameName {
        /// The name.
        name: String,
    },
}

/// Chords of an ellipse: they are within 2e-5 of its longer half axis from it.
const CHORDS: usize = 512;

impl Shape {
    /// An ellipse with its axes along x and y before it is turned, rad, counter-clockwise; middle and half axes in m.
    ///
    /// # Errors
    /// [`HoleError::HalfAxis`], and [`HoleError::Polygon`] if an axis is rounding beside the other, or the middle is far away.
    pub fn ellipse(centre: [f64; 2], half_axes: [f64; 2], turn: f64) -> Result<Self, HoleError> {
        if let Some(axis) = (0..2).find(|&k| !(half_axes[k] > 0.0 && half_axes[k].is_finite())) {
            return Err(HoleError::HalfAxis { axis, found: half_axes[axis] });
        }
        // Quarters are images of each other, so that mirrors keep the shape.
        let quarter = |k: usize| (TAU * k as f64 / CHORDS as f64).sin();
        let sine = |k: usize| match (k % CHORDS) / (CHORDS / 4) {
            0 => quarter(k % CHORDS),
            1 => quarter(CHORDS / 2 - k % CHORDS),
            2 => -quarter(k % CHORDS - CHORDS / 2),
            _ => -quarter(CHORDS - k % CHORDS),
        };
        let (s, c) = turn.sin_cos();
        let vertex = |k: usize| {
            let [x, y] = [half_axes[0] * sine(k + CHORDS / 4), half_axes[1] * sine(k)];
            [centre[0] + c * x - s * y, centre[1] + s * x + c * y]
        };
        let chords = Polygon::new((0..CHORDS).map(vertex).collect())?;
        Ok(Self::Ellipse { centre, half_axes, turn, chords })
    }

    /// Radius of curvature of the border next to a position, m; none on the straight sides of slots, and of polygons.
    pub fn radius_at(&self, position: [f64; 2]) -> Option<f64> {
        match self {
            Self::Circle { radius, .. } => Some(*radius),
            Self::Slot { from, to, radius } => {
                let end = distance(position, *from).min(distance(position, *to));
                (end <= radius * (1.0 + 1e-6)).then_some(*radius)
            }
            Self::Ellipse { centre, half_axes: [a, b], turn, .. } => {
                let ([dx, dy], (s, c)) = ([0, 1].map(|k| position[k] - centre[k]), turn.sin_cos());
                let [x, y] = [c * dx + s * dy, c * dy - s * dx];
                Some((a * b).powi(2) * (x * x / a.powi(4) + y * y / b.powi(4)).powf(1.5))
            }
            Self::Polygon(_) => None,
        }
    }

    /// The polygon that bounds it; none of what is round.
    pub(super) fn polygon(&self) -> Option<&Polygon> {
        match self {
            Self::Polygon(polygon) | Self::Ellipse { chords: polygon, .. } => Some(polygon),
            Self::Circle { .. } | Self::Slot { .. } => None,
        }
    }

    /// Length of the border, m.
    pub fn perimeter(&self) -> f64 {
        match self {
            Self::Circle { radius, .. } => TAU * radius,
            Self::Slot { from, to, radius } => TAU * radius + 2.0 * distance(*from, *to),
            Self::Polygon(polygon) | Self::Ellipse { chords: polygon, .. } => polygon.perimeter(),
        }
    }

    /// Distance of a position from the border, m.
    pub fn distance(&self, position: [f64; 2]) -> f64 {
        match (self.polygon(), self.stadium()) {
            (_, Some((from, to, radius))) => (to_segment(position, from, to) - radius).abs(),
            (Some(polygon), _) => {
                polygon.edges().map(|[a, b]| to_segment(position, a, b)).fold(f64::INFINITY, f64::min)
            }
            _ => f64::INFINITY,
        }
    }

    /// A circle and a slot as segment and radius.
    pub(super) fn stadium(&self) -> Option<(Point, Point, f64)> {
        match self {
            Self::Circle { centre, radius } => Some((*centre, *centre, *radius)),
            Self::Slot { from, to, radius } => Some((*from, *to, *radius)),
            Self::Ellipse { .. } | Self::Polygon(_) => None,
        }
    }

    pub(super) fn seen_from(&self, axes: &Turn) -> Self {
        match self {
            Self::Circle { centre, radius } => {
                Self::Circle { centre: axes.inwards(*centre), radius: *radius }
            }
            Self::Slot { from, to, radius } => {
                Self::Slot { from: axes.inwards(*from), to: axes.inwards(*to), radius: *radius }
            }
            // Fields around holes are those of lattices along x and y.
            Self::Polygon(polygon) | Self::Ellipse { chords: polygon, .. } => {
                Self::Polygon(polygon.seen_from(axes))
            }
        }
    }

    pub(super) fn check(&self) -> Result<(), HoleError> {
        let Some((from, to, radius)) = self.stadium() else { return Ok(()) };
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(HoleError::Radius { found: radius });
        }
        let finite = from.iter().chain(&to).all(|x| x.is_finite());
        if finite { Ok(()) } else { Err(HoleError::NotFinite) }
    }

    pub(super) fn meets(&self, body: &Polygon) -> bool {
        match (self.polygon(), self.stadium()) {
            (_, Some((from, to, radius))) => body.distance(from, to) < radius,
            (Some(hole), _) => {
                hole.edges().any(|[from, to]| body.distance(from, to) == 0.0)
                    || hole.contains(body.vertices()[0])
            }
            _ => false,
        }
    }

    /// Whether a position is in it, its border aside.
    pub(super) fn removes(&self, position: Point) -> bool {
        match (self.polygon(), self.stadium()) {
            (_, Some((from, to, radius))) => to_segment(position, from, to) < radius,
            (Some(hole), _) => {
                let on_border = hole.edges().any(|[a, b]| meet(a, b, position, position));
                hole.contains(position) && !on_border
            }
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ellipse_has_its_area_within_its_chords_and_its_tips_on_them() {
        let shape = Shape::ellipse([3.0, -1.0], [10.0, 20.0], 0.0).unwrap();
        let polygon = shape.polygon().unwrap();
        // n chords have n sin(2π/n)/2π of the area: 2.5e-5 of it are missing with 512.
        let area = 0.5 * CHORDS as f64 * (TAU / CHORDS as f64).sin() * 10.0 * 20.0;
        assert!((polygon.area().abs() / area - 1.0).abs() < 1e-13, "{}", polygon.area());
        for tip in [[13.0, -1.0], [3.0, 19.0], [-7.0, -1.0], [3.0, -21.0]] {
            assert!(polygon.vertices().contains(&tip), "{tip:?}");
        }
        assert!(shape.removes([3.0, 18.9]) && !shape.removes([3.0, 19.0]) && !shape.removes([11.0, 17.0]));
    }

    #[test]
    fn a_turned_ellipse_takes_its_tips_and_its_sharpness_along() {
        let (s, c) = 0.6_f64.sin_cos();
        let shape = Shape::ellipse([3.0, -1.0], [10.0, 20.0], 0.6).unwrap();
        let tip = |share: f64| [3.0 - share * 20.0 * s, -1.0 + share * 20.0 * c];
        assert!(shape.removes(tip(0.999)) && !shape.removes(tip(1.001)));
        assert!((shape.radius_at(tip(1.0)).unwrap() - 5.0).abs() < 1e-12);
    }

    #[test]
    fn an_ellipse_is_sharpest_at_the_ends_of_its_longer_axis() {
        let shape = Shape::ellipse([3.0, -1.0], [10.0, 20.0], 0.0).unwrap();
        // a²/b and b²/a.
        assert!((shape.radius_at([3.0, 19.0]).unwrap() - 5.0).abs() < 1e-12);
        assert!((shape.radius_at([-7.0, -1.0]).unwrap() - 40.0).abs() < 1e-12);
    }

    #[test]
    fn an_ellipse_without_a_half_axis_is_refused() {
        for (half_axes, axis) in [([0.0, 1.0], 0), ([1.0, -2.0], 1), ([1.0, f64::NAN], 1)] {
            let error = Shape::ellipse([0.0; 2], half_axes, 0.0).unwrap_err();
            assert!(matches!(error, HoleError::HalfAxis { axis: found, .. } if found == axis), "{error}");
        }
    }
}
