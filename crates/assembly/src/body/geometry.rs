//! Exact and measured relations between points and segments of the plane.

use robust::{Coord, orient2d};

/// A position, m (or cells where a function says so).
pub(super) type Point = [f64; 2];

/// A position or a direction in the plane as one in space.
pub fn in_space([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

pub(super) fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

pub(super) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// `from` moved by a multiple of a direction.
pub(super) fn moved(from: Point, by: f64, direction: Point) -> Point {
    [from[0] + by * direction[0], from[1] + by * direction[1]]
}

pub(super) fn distance(a: Point, b: Point) -> f64 {
    let d = minus(b, a);
    d[0].hypot(d[1])
}

/// Distance of positions in space.
pub(super) fn distance_in_space(a: [f64; 3], b: [f64; 3]) -> f64 {
    // In the plane exactly the distance there: the last step changes nothing.
    (b[0] - a[0]).hypot(b[1] - a[1]).hypot(b[2] - a[2])
}

/// Positive where `p` is to the left of the line from `a` to `b`, zero exactly on it.
pub(super) fn side(a: Point, b: Point, p: Point) -> f64 {
    let coord = |[x, y]: Point| Coord { x, y };
    orient2d(coord(a), coord(b), coord(p))
}

/// Whether `p` is in the box of `a` and `b`.
pub(super) fn in_box(p: Point, a: Point, b: Point) -> bool {
    (0..2).all(|k| a[k].min(b[k]) <= p[k] && p[k] <= a[k].max(b[k]))
}

/// Whether two closed segments share a point: exact for the coordinates as given.
pub(super) fn meet(a: Point, b: Point, c: Point, d: Point) -> bool {
    let apart = |s: f64, t: f64| (s > 0.0 && t > 0.0) || (s < 0.0 && t < 0.0);
    let (sc, sd) = (side(a, b, c), side(a, b, d));
    if apart(sc, sd) {
        return false;
    }
    let (sa, sb) = (side(c, d, a), side(c, d, b));
    if apart(sa, sb) {
        return false;
    }
    let collinear = [sa, sb, sc, sd].iter().all(|s| *s == 0.0);
    !collinear || in_box(a, c, d) || in_box(b, c, d) || in_box(c, a, b) || in_box(d, a, b)
}

/// Distance of a point from a closed segment.
pub(super) fn to_segment(p: Point, a: Point, b: Point) -> f64 {
    let d = minus(b, a);
    let square = dot(d, d);
    let t = if square > 0.0 { (dot(minus(p, a), d) / square).clamp(0.0, 1.0) } else { 0.0 };
    distance(p, moved(a, t, d))
}

/// Distance of two closed segments; zero exactly if they meet.
pub(super) fn between_segments(a: Point, b: Point, c: Point, d: Point) -> f64 {
    if meet(a, b, c, d) {
        return 0.0;
    }
    let ends = [to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}

/// Unit vector to the left of the direction from `a` to `b`, which differ.
pub(super) fn left_normal(a: Point, b: Point) -> Point {
    let d = minus(b, a);
    let length = d[0].hypot(d[1]);
    [-d[1] / length, d[0] / length]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_meet_at_ends_in_passing_and_along_each_other() {
        let [o, x] = [[0.0, 0.0], [2.0, 0.0]];
        assert!(meet(o, x, [1.0, -1.0], [1.0, 1.0]));
        assert!(meet(o, x, [2.0, 0.0], [3.0, 1.0]));
        assert!(meet(o, x, [1.0, 0.0], [1.0, 1.0]));
        assert!(meet(o, x, [1.0, 0.0], [5.0, 0.0]));
        assert!(meet(o, x, [0.5, 0.0], [0.6, 0.0]));
        assert!(!meet(o, x, [2.1, 0.0], [5.0, 0.0]));
        assert!(!meet(o, x, [0.0, 1e-300], [2.0, 1.0]));
        assert!(meet(o, o, o, x));
        assert!(!meet([1.0, 1.0], [1.0, 1.0], o, x));
        assert_eq!(between_segments(o, x, [1.0, 0.25], [1.0, 3.0]), 0.25);
        assert_eq!(between_segments(o, x, [5.0, 4.0], [6.0, 9.0]), 5.0);
    }

    #[test]
    fn sides_are_exact_where_products_cancel() {
        // The classical case that a rounded determinant gets wrong: points next to y = x around (12, 12).
        let ulp = f64::EPSILON;
        let p = [0.5 + ulp, 0.5];
        assert!(side([12.0, 12.0], [24.0, 24.0], p) != 0.0);
        assert_eq!(side([12.0, 12.0], [24.0, 24.0], [0.5 + ulp, 0.5 + ulp]), 0.0);
    }
}
