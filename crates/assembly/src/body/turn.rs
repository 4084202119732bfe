//! Axes that are turned against those of the plane.

use super::geometry::{Point, dot, minus};
use std::f64::consts::FRAC_PI_2;

/// Angles nearer than this to a multiple of a right angle turn no square, rad: what rounding leaves of one.
const RIGHT: f64 = 1e-12;

/// Two axes at right angles through an origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turn {
    angle: f64,
    origin: Point,
    /// Unit vectors.
    axes: [Point; 2],
}

impl Turn {
    /// Axes turned by an angle, rad, counter-clockwise; `None` for a multiple of a right angle, which leaves squares as
    /// they are.
    pub(super) fn new(angle: f64, origin: Point) -> Option<Self> {
        let quarters = angle / FRAC_PI_2;
        if (quarters - quarters.round()).abs() * FRAC_PI_2 <= RIGHT {
            return None;
        }
        let (sin, cos) = angle.sin_cos();
        Some(Self { angle, origin, axes: [[cos, sin], [-sin, cos]] })
    }

    pub(super) fn angle(&self) -> f64 {
        self.angle
    }

    pub(super) fn axes(&self) -> [Point; 2] {
        self.axes
    }

    /// Coordinates along the axes of a position.
    pub(super) fn inwards(&self, position: Point) -> Point {
        self.components(minus(position, self.origin))
    }

    /// Components along the axes of a vector.
    pub(super) fn components(&self, vector: Point) -> Point {
        self.axes.map(|axis| dot(vector, axis))
    }

    /// The position of coordinates along the axes.
    pub(super) fn outwards(&self, coordinates: Point) -> Point {
        let vector = self.vector(coordinates);
        [0, 1].map(|k| self.origin[k] + vector[k])
    }

    /// The vector of components along the axes.
    pub(super) fn vector(&self, [a, b]: Point) -> Point {
        [0, 1].map(|k| a * self.axes[0][k] + b * self.axes[1][k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_angles_turn_nothing() {
        for k in -5..6 {
            assert_eq!(Turn::new((90.0 * f64::from(k)).to_radians(), [1.0, 2.0]), None);
        }
        assert!(Turn::new(1e-9, [0.0; 2]).is_some());
    }

    #[test]
    fn both_ways_are_inverse() {
        let turn = Turn::new(30.0f64.to_radians(), [1.0, -2.0]).unwrap();
        let [x, y] = turn.outwards([2.0, 0.0]);
        assert!((x - (1.0 + 3.0f64.sqrt())).abs() < 1e-15 && (y + 1.0).abs() < 1e-15);
        let back = turn.inwards([x, y]);
        assert!((back[0] - 2.0).abs() < 1e-15 && back[1].abs() < 1e-15);
        let [a, b] = turn.vector(turn.components([0.3, 0.7]));
        assert!((a - 0.3).abs() < 1e-15 && (b - 0.7).abs() < 1e-15);
    }
}
