//! Simple polygons.

use super::geometry::{Point, between_segments, distance, dot, in_box, left_normal, meet, minus, side};
use super::turn::Turn;
use thiserror::Error;

/// Why vertices are not those of a simple polygon. Vertices and edges count from one; edge `k` starts at vertex `k`.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PolygonError {
    /// Fewer than three vertices.
    #[error("a polygon has at least three vertices, found {found}")]
    TooFewVertices {
        /// How many there are.
        found: usize,
    },
    /// A coordinate is infinite or no number.
    #[error("vertex {vertex} is not finite")]
    NotFinite {
        /// Which vertex.
        vertex: usize,
    },
    /// A vertex is at the place of the next one.
    #[error("vertices {vertex} and {next} are at the same place")]
    Repeated {
        /// The first of the two.
        vertex: usize,
        /// The second.
        next: usize,
    },
    /// All vertices are on one line.
    #[error("the polygon has no area: all its vertices are on one line")]
    NoArea,
    /// Two edges cross, touch or overlap.
    #[error("the polygon crosses or touches itself: edges {first} and {second} meet")]
    Crosses {
        /// The first of the two edges.
        first: usize,
        /// The second.
        second: usize,
    },
}

/// A simple polygon: its edges meet in common vertices only.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    vertices: Vec<Point>,
    counter_clockwise: bool,
}

impl Polygon {
    /// Closes `vertices` (m, in either direction, the first not repeated at the end) to a polygon.
    ///
    /// # Errors
    /// [`PolygonError`]; whether edges meet is decided exactly.
    pub fn new(vertices: Vec<[f64; 2]>) -> Result<Self, PolygonError> {
        let n = vertices.len();
        if n < 3 {
            return Err(PolygonError::TooFewVertices { found: n });
        }
        if let Some(k) = vertices.iter().position(|v| !v.iter().all(|x| x.is_finite())) {
            return Err(PolygonError::NotFinite { vertex: k + 1 });
        }
        if let Some(k) = (0..n).find(|&k| vertices[k] == vertices[(k + 1) % n]) {
            return Err(PolygonError::Repeated { vertex: k + 1, next: (k + 1) % n + 1 });
        }
        if vertices.iter().all(|v| side(vertices[0], vertices[1], *v) == 0.0) {
            return Err(PolygonError::NoArea);
        }
        if let Some([first, second]) = meeting_edges(&vertices) {
            return Err(PolygonError::Crosses { first: first + 1, second: second + 1 });
        }
        // The lowest of the leftmost vertices is convex.
        let k =
            (0..n).min_by(|&a, &b| vertices[a].partial_cmp(&vertices[b]).expect("finite")).expect("three");
        let turn = side(vertices[(k + n - 1) % n], vertices[k], vertices[(k + 1) % n]);
        // A vertex amid a straight left side is no lowest one, so the turn is not zero.
        Ok(Self { counter_clockwise: turn > 0.0, vertices })
    }

    /// The same polygon in other axes.
    pub(super) fn seen_from(&self, axes: &Turn) -> Self {
        Self { vertices: self.vertices.iter().map(|v| axes.inwards(*v)).collect(), ..*self }
    }

    /// Vertices in the order given, m.
    pub fn vertices(&self) -> &[[f64; 2]] {
        &self.vertices
    }

    /// Ends of edge `k`, from zero, in the order given.
    pub fn edge(&self, k: usize) -> [[f64; 2]; 2] {
        [self.vertices[k], self.vertices[(k + 1) % self.vertices.len()]]
    }

    /// Ends of all edges.
    pub fn edges(&self) -> impl Iterator<Item = [[f64; 2]; 2]> + '_ {
        (0..self.vertices.len()).map(|k| self.edge(k))
    }

    /// Unit normal of edge `k`, from zero, that points out of the polygon.
    pub fn normal(&self, k: usize) -> [f64; 2] {
        let [from, to] = self.edge(k);
        let normal = left_normal(from, to);
        // Adding zero removes the sign of a zero.
        if self.counter_clockwise { normal.map(|x| -x + 0.0) } else { normal.map(|x| x + 0.0) }
    }

    /// Length of the border, m.
    pub fn perimeter(&self) -> f64 {
        self.edges().map(|[a, b]| distance(a, b)).sum()
    }

    /// Area, m².
    pub fn area(&self) -> f64 {
        let origin = self.vertices[0];
        let twice: f64 =
            self.edges().map(|e| e.map(|v| minus(v, origin))).map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum();
        0.5 * twice.abs()
    }

    /// Sines of the angles by which the border turns at its vertices, positive where the polygon is convex.
    pub(super) fn turns(&self) -> impl Iterator<Item = f64> + '_ {
        let n = self.vertices.len();
        let sign = if self.counter_clockwise { 1.0 } else { -1.0 };
        (0..n).map(move |k| {
            let along = |k: usize| {
                let [from, to] = self.edge(k % n);
                minus(to, from).map(|d| d / distance(from, to))
            };
            let (before, behind) = (along(k), along(k + 1));
            sign * (before[0] * behind[1] - before[1] * behind[0])
        })
    }

    /// Whether a position is in the polygon or on its border: exact for the coordinates as given.
    pub fn contains(&self, position: [f64; 2]) -> bool {
        let mut winding = 0;
        for [a, b] in self.edges() {
            let turn = side(a, b, position);
            if turn == 0.0 && in_box(position, a, b) {
                return true;
            }
            match (a[1] <= position[1], b[1] <= position[1]) {
                (true, false) if turn > 0.0 => winding += 1,
                (false, true) if turn < 0.0 => winding -= 1,
                _ => {}
            }
        }
        winding != 0
    }

    /// Distance of a segment from the polygon; zero where they share a point.
    pub(super) fn distance(&self, from: Point, to: Point) -> f64 {
        if self.contains(from) {
            return 0.0;
        }
        self.edges().map(|[a, b]| between_segments(a, b, from, to)).fold(f64::INFINITY, f64::min)
    }

    /// Lower left and upper right corner of the box around it, m.
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        let fold = |start: f64, pick: fn(f64, f64) -> f64| {
            [0, 1].map(|k| self.vertices.iter().map(|v| v[k]).fold(start, pick))
        };
        [fold(f64::INFINITY, f64::min), fold(f64::NEG_INFINITY, f64::max)]
    }
}

/// Two edges that meet elsewhere than in the vertex they share: swept from left to right.
fn meeting_edges(vertices: &[Point]) -> Option<[usize; 2]> {
    let n = vertices.len();
    let ends = |k: usize| (vertices[k], vertices[(k + 1) % n]);
    let reach = |k: usize| {
        let (a, b) = ends(k);
        [a[0].min(b[0]), a[0].max(b[0])]
    };
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| reach(i)[0].total_cmp(&reach(j)[0]).then(i.cmp(&j)));
    let mut found: Option<[usize; 2]> = None;
    for (place, &i) in order.iter().enumerate() {
        let right = reach(i)[1];
        for &j in order[place + 1..].iter().take_while(|&&j| reach(j)[0] <= right) {
            let pair = [i.min(j), i.max(j)];
            if conflict(ends(i), ends(j)) && found.is_none_or(|f| pair < f) {
                found = Some(pair);
            }
        }
    }
    found
}

fn conflict((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let folded = |joint: Point, p: Point, q: Point| {
        side(joint, p, q) == 0.0 && dot(minus(p, joint), minus(q, joint)) > 0.0
    };
    let overlap = |a: f64, b: f64, c: f64, d: f64| a.max(b) >= c.min(d) && c.max(d) >= a.min(b);
    match (b == c, a == d) {
        (true, true) => true,
        (true, false) => folded(b, a, d),
        (false, true) => folded(a, b, c),
        _ => overlap(a[1], b[1], c[1], d[1]) && meet(a, b, c, d),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_named() {
        let fault = |v: &[Point]| Polygon::new(v.to_vec()).unwrap_err();
        assert_eq!(fault(&[[0.0; 2], [1.0, 0.0]]), PolygonError::TooFewVertices { found: 2 });
        assert_eq!(fault(&[[0.0; 2], [1.0, f64::NAN], [0.0, 1.0]]), PolygonError::NotFinite { vertex: 2 });
        let repeated = [[0.0; 2], [1.0, 0.0], [0.0, 1.0], [0.0; 2]];
        assert_eq!(fault(&repeated), PolygonError::Repeated { vertex: 4, next: 1 });
        assert_eq!(fault(&[[0.0; 2], [1.0, 1.0], [3.0, 3.0]]), PolygonError::NoArea);
        let bow = [[0.0; 2], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert_eq!(fault(&bow), PolygonError::Crosses { first: 1, second: 3 });
        let spike = [[0.0; 2], [2.0, 0.0], [2.0, 2.0], [2.0, 1.0], [0.0, 1.0]];
        assert_eq!(fault(&spike), PolygonError::Crosses { first: 2, second: 3 });
        // A vertex on another edge pinches the polygon.
        let pinched = [[0.0; 2], [4.0, 0.0], [4.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
        assert_eq!(fault(&pinched), PolygonError::Crosses { first: 1, second: 3 });
    }

    #[test]
    fn normals_point_outwards_in_either_direction() {
        let vertices = vec![[0.0; 2], [0.0, 1.0], [0.0, 2.0], [3.0, 2.0], [3.0, 0.0]];
        let clockwise = Polygon::new(vertices.clone()).unwrap();
        let other = Polygon::new(vertices.into_iter().rev().collect()).unwrap();
        assert_eq!((clockwise.area(), other.area()), (6.0, 6.0));
        assert_eq!(clockwise.normal(0), [-1.0, 0.0]);
        assert_eq!(clockwise.normal(4), [0.0, -1.0]);
        assert_eq!(other.normal(0), [1.0, 0.0]);
        assert_eq!(other.normal(2), [-1.0, 0.0]);
        assert_eq!(other.bounds(), [[0.0; 2], [3.0, 2.0]]);
    }

    #[test]
    fn borders_belong_to_it() {
        let polygon = Polygon::new(vec![[0.0; 2], [2.0, 0.0], [0.0, 2.0]]).unwrap();
        for p in [[0.0; 2], [1.0, 1.0], [0.5, 1.5], [1.0, 0.0], [0.25, 0.25]] {
            assert!(polygon.contains(p), "{p:?}");
        }
        for p in [[1.0, 1.0 + 1e-15], [-1e-300, 1.0], [3.0, 0.0], [0.0, 2.5]] {
            assert!(!polygon.contains(p), "{p:?}");
        }
    }
}
