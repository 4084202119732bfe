//! Convex parts of the plane, cut by rows of points.

use super::geometry::{Point, left_normal, minus, moved};
use super::turn::Turn;

/// A convex part of the plane with its border.
#[derive(Clone, Debug)]
pub(super) enum Convex {
    /// All positions within `radius` of a segment; a disc if its ends are the same.
    Stadium { from: Point, to: Point, radius: f64 },
    /// Corners in order.
    Polygon(Vec<Point>),
    /// Where `(x − point)·normal ≥ 0`.
    HalfPlane { point: Point, normal: Point },
}

impl Convex {
    /// Rectangle along a segment: beyond both its ends by `ends`, from `low` to `high` to the left of it.
    pub(super) fn beside(from: Point, to: Point, ends: f64, [low, high]: [f64; 2]) -> Self {
        let normal = left_normal(from, to);
        let along = [normal[1], -normal[0]];
        let (from, to) = (moved(from, -ends, along), moved(to, ends, along));
        let corner = |p, across| moved(p, across, normal);
        Self::Polygon(vec![corner(from, low), corner(to, low), corner(to, high), corner(from, high)])
    }

    /// The same part in other axes.
    pub(super) fn seen_from(&self, axes: &Turn) -> Self {
        match self {
            Self::Stadium { from, to, radius } => {
                Self::Stadium { from: axes.inwards(*from), to: axes.inwards(*to), radius: *radius }
            }
            Self::Polygon(corners) => Self::Polygon(corners.iter().map(|c| axes.inwards(*c)).collect()),
            Self::HalfPlane { point, normal } => {
                Self::HalfPlane { point: axes.inwards(*point), normal: axes.components(*normal) }
            }
        }
    }

    /// Lowest and highest y.
    pub(super) fn rows(&self) -> [f64; 2] {
        match self {
            Self::Stadium { from, to, radius } => [from[1].min(to[1]) - radius, from[1].max(to[1]) + radius],
            Self::Polygon(corners) => span(corners.iter().map(|c| c[1])),
            Self::HalfPlane { .. } => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// First and last x of a row.
    pub(super) fn row(&self, y: f64) -> Option<[f64; 2]> {
        match self {
            Self::Stadium { from, to, radius } => {
                let mut found = [disc(*from, *radius, y), None, None];
                if from != to {
                    let across = moved([0.0; 2], *radius, left_normal(*from, *to));
                    let middle = [
                        moved(*from, -1.0, across),
                        moved(*to, -1.0, across),
                        moved(*to, 1.0, across),
                        moved(*from, 1.0, across),
                    ];
                    found = [found[0], disc(*to, *radius, y), strip(&middle, [y, y])];
                }
                let found = span(found.into_iter().flatten().flatten());
                (found[0] <= found[1]).then_some(found)
            }
            Self::Polygon(corners) => strip(corners, [y, y]),
            Self::HalfPlane { point, normal } => {
                let height = (y - point[1]) * normal[1];
                let x = point[0] - height / normal[0];
                match normal[0] {
                    0.0 => (height >= 0.0).then_some([f64::NEG_INFINITY, f64::INFINITY]),
                    n if n > 0.0 => Some([x, f64::INFINITY]),
                    _ => Some([f64::NEG_INFINITY, x]),
                }
            }
        }
    }

    /// Whether a position belongs to the part: the same answer that its row gives.
    pub(super) fn contains(&self, position: Point) -> bool {
        self.row(position[1]).is_some_and(|[from, to]| from <= position[0] && position[0] <= to)
    }
}

fn span(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
}

fn disc(centre: Point, radius: f64, y: f64) -> Option<[f64; 2]> {
    let height = (y - centre[1]).abs();
    let half = ((radius - height) * (radius + height)).sqrt();
    (height <= radius).then(|| [centre[0] - half, centre[0] + half])
}

/// First and last x of the part of a convex polygon with `low ≤ y ≤ high`.
pub(super) fn strip(corners: &[Point], [low, high]: [f64; 2]) -> Option<[f64; 2]> {
    let mut found = [f64::INFINITY, f64::NEG_INFINITY];
    for (k, &b) in corners.iter().enumerate() {
        let a = corners[if k == 0 { corners.len() - 1 } else { k - 1 }];
        if a[1].max(b[1]) < low || a[1].min(b[1]) > high {
            continue;
        }
        let d = minus(b, a);
        // Only edges with ends on both sides of a border of the strip are clipped by it.
        let at = |y: f64| a[0] + ((y - a[1]) / d[1]).clamp(0.0, 1.0) * d[0];
        for end in [a, b] {
            let x = match end[1] {
                y if y < low => at(low),
                y if y > high => at(high),
                _ => end[0],
            };
            found = [found[0].min(x), found[1].max(x)];
        }
    }
    (found[0] <= found[1]).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::super::geometry::{dot, to_segment};
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn rows_of_flat_and_empty_parts() {
        let box_of = |[x, y]: [f64; 2], [w, h]: [f64; 2]| {
            Convex::Polygon(vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]])
        };
        assert_eq!(box_of([1.0, 2.0], [3.0, 0.0]).row(2.0), Some([1.0, 4.0]));
        assert_eq!(box_of([1.0, 2.0], [0.0, 1.0]).row(2.5), Some([1.0, 1.0]));
        assert_eq!(box_of([1.0, 2.0], [3.0, 1.0]).row(3.1), None);
        let triangle = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
        assert_eq!(strip(&triangle, [1.0, 2.0]), Some([0.0, 3.0]));
        assert_eq!(strip(&triangle, [-1.0, 9.0]), Some([0.0, 4.0]));
        assert_eq!(strip(&triangle, [4.5, 9.0]), None);
        let shrunk = Convex::Stadium { from: [0.0; 2], to: [0.0; 2], radius: -1e-9 };
        assert_eq!(shrunk.row(0.0), None);
    }

    proptest! {
        #[test]
        fn rows_agree_with_distances(
            a in [-3.0..3.0f64, -3.0..3.0], b in [-3.0..3.0f64, -3.0..3.0], r in 0.01..2.0f64, p in [-5.0..5.0f64, -5.0..5.0],
        ) {
            let stadium = Convex::Stadium { from: a, to: b, radius: r };
            let off = to_segment(p, a, b) - r;
            prop_assume!(off.abs() > 1e-9);
            prop_assert_eq!(stadium.contains(p), off < 0.0);
            let half = Convex::HalfPlane { point: a, normal: b };
            let height = dot(minus(p, a), b);
            prop_assert_eq!(half.contains(p), height >= 0.0);
        }
    }
}
