//! Where a row of cells crosses a surface.
//!
//! A row crosses triangles inside, never at their edges and corners: it is moved by ε along y and ε² along z, where ε is as small
//! as it takes. Nothing is moved in fact. The side of an edge on which the row runs is the sign of a determinant, which is exact
//! (Shewchuk's predicates); where it is zero, the sign of what ε and then ε² add to it decides, which is a difference of two
//! coordinates of the edge. Both triangles at an edge see the same signs, so that the row goes through one of them, and through a
//! closed surface as often inwards as outwards, whatever the triangles are.
//!
//! Source: Edelsbrunner & Mücke, Simulation of simplicity, ACM Trans. Graph. 9 (1990).

use super::facets::Facet;
use robust::{Coord, orient2d};

/// Where a row enters the inside, or leaves it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    /// Its coordinate, m.
    pub(super) x: f64,
    /// 1 where the row enters, −1 where it leaves.
    pub(super) turn: i32,
}

/// A triangle seen along x.
pub(super) struct Shadow<'a> {
    facet: &'a Facet,
    /// Corners in y and z.
    corners: [Coord<f64>; 3],
    /// Whether they run counter-clockwise; then the triangle looks along x.
    is_ahead: bool,
}

impl<'a> Shadow<'a> {
    /// None where the triangle lies along x.
    pub(super) fn new(facet: &'a Facet) -> Option<Self> {
        let corners = facet.corners.map(|[_, y, z]| Coord { x: y, y: z });
        let area = orient2d(corners[0], corners[1], corners[2]);
        (area != 0.0).then_some(Self { facet, corners, is_ahead: area > 0.0 })
    }

    /// Where the row at y and z crosses the triangle.
    pub(super) fn crossing(&self, y: f64, z: f64) -> Option<Crossing> {
        let at = Coord { x: y, y: z };
        let mut shares = [0.0; 3];
        for (k, share) in shares.iter_mut().enumerate() {
            let [a, b] = [self.corners[(k + 1) % 3], self.corners[(k + 2) % 3]];
            let size = orient2d(a, b, at);
            if is_left(size, a, b) != self.is_ahead {
                return None;
            }
            *share = size.abs();
        }
        let all: f64 = shares.iter().sum();
        let x = (0..3).map(|k| shares[k] / all * self.facet.corners[k][0]).sum::<f64>();
        let [low, high] = self.facet.range(0);
        // A triangle nearly along x is crossed anywhere in it, as far as rounding tells.
        let x = if x.is_finite() { x.clamp(low, high) } else { 0.5 * (low + high) };
        Some(Crossing { x, turn: if self.is_ahead { -1 } else { 1 } })
    }
}

/// Whether the moved row is on the left of the edge from `a` to `b`; `size` is the determinant of all three.
fn is_left(size: f64, a: Coord<f64>, b: Coord<f64>) -> bool {
    match (size, a.y - b.y) {
        (size, _) if size != 0.0 => size > 0.0,
        (_, rise) if rise != 0.0 => rise > 0.0,
        _ => b.x > a.x,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Corners and rows on the same few whole numbers, so that rows run through edges and corners and along faces all the time.
        #[test]
        fn rows_cross_closed_surfaces_as_often_inwards_as_outwards(
            corners in proptest::collection::vec([0..4_i32, 0..4, 0..4], 4..9), y in 0..7_i32, z in 0..7_i32,
        ) {
            // The border of any tetrahedra that follow each other is closed, however they overlap.
            let mut crossings = Vec::new();
            for corners in corners.windows(4) {
                for [a, b, c] in [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]] {
                    let facet = Facet { corners: [a, b, c].map(|k| corners[k].map(f64::from)), name: None };
                    let shadow = Shadow::new(&facet);
                    crossings.extend(shadow.and_then(|s| s.crossing(0.5 * f64::from(y), 0.5 * f64::from(z))));
                }
            }
            prop_assert_eq!(crossings.iter().map(|c| c.turn).sum::<i32>(), 0);
        }
    }

    #[test]
    fn of_all_triangles_at_a_corner_one_is_crossed() {
        // A fan around the corner (0, 0), with edges along and across the row's shifts.
        let ring = [
            [1.0, 0.0],
            [1.0, 1.0],
            [0.0, 1.0],
            [-1.0, 1.0],
            [-1.0, 0.0],
            [-1.0, -1.0],
            [0.0, -1.0],
            [1.0, -1.0],
        ];
        let place = |[y, z]: [f64; 2]| [2.0 * y + 3.0 * z, y, z];
        let crossed = |at: [f64; 2]| {
            let fan = (0..8).filter_map(|k| {
                let corners = [[0.0; 2], ring[k], ring[(k + 1) % 8]].map(place);
                Shadow::new(&Facet { corners, name: None })?.crossing(at[0], at[1])
            });
            fan.collect::<Vec<_>>()
        };
        for at in [[0.0, 0.0], [0.5, 0.5], [0.0, 0.5], [-0.5, 0.0], [0.25, 0.5]] {
            let found = crossed(at);
            assert_eq!(found.len(), 1, "{at:?}");
            assert!((found[0].x - place(at)[0]).abs() < 1e-15 && found[0].turn == -1);
        }
        assert!(crossed([2.0, 0.0]).is_empty());
    }
}
