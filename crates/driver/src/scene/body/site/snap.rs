//! Coordinates of outlines and holes that rounding alone tells apart: scripts write cos(π/2) as 6e-17, and a side of such
//! vertices would be no straight side. Those closer than a small part of the body become one value.

use crate::case::Hole;

/// Coordinates that differ by less than this part of the size of the body are the same: it is what single precision, in which
/// drawings are often stored, leaves of them.
const SAME: f64 = 1e-7;

/// The coordinates of a body without the noise of rounding.
#[derive(Debug)]
pub(crate) struct Snap {
    /// Along x and along y, ascending.
    kept: [Vec<f64>; 2],
    within: f64,
}

impl Snap {
    /// Coordinates among corners that stay as they are, vertices, and positions of holes.
    pub(crate) fn new(corners: &[[f64; 2]], vertices: &[[f64; 2]], holes: &[Hole]) -> Self {
        // What is no number is refused elsewhere.
        let finite = |v: &&[f64; 2]| v.iter().all(|x| x.is_finite());
        let body = || corners.iter().chain(vertices).filter(finite);
        let extent = |k: usize| {
            let [low, high] = [f64::min, f64::max].map(|of| body().map(|v| v[k]).reduce(of).unwrap_or(0.0));
            high - low
        };
        // Sizes beyond all numbers are refused elsewhere, too.
        let within = Some(SAME * extent(0).max(extent(1))).filter(|w| w.is_finite()).unwrap_or(0.0);
        let given: Vec<[f64; 2]> =
            vertices.iter().copied().chain(holes.iter().flat_map(positions)).filter(|v| finite(&v)).collect();
        let kept = [0, 1].map(|k| {
            let mut all: Vec<(f64, bool)> = corners.iter().map(|v| (v[k], true)).collect();
            all.extend(given.iter().map(|v| (v[k], false)));
            all.sort_by(|a, b| a.0.total_cmp(&b.0));
            groups(&all, within).into_iter().map(|near| common(near, within)).collect()
        });
        Self { kept, within }
    }

    /// A position at the coordinates that are kept.
    pub(crate) fn position(&self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| {
            let kept = &self.kept[k];
            let next = kept.partition_point(|c| *c < at[k]);
            let near = kept[next.saturating_sub(1)..]
                .iter()
                .take(2)
                .min_by(|a, b| (*a - at[k]).abs().total_cmp(&(*b - at[k]).abs()));
            near.copied().filter(|c| (c - at[k]).abs() <= self.within).unwrap_or(at[k])
        })
    }

    /// Positions at the coordinates that are kept.
    pub(crate) fn positions(&self, at: &[[f64; 2]]) -> Vec<[f64; 2]> {
        at.iter().map(|p| self.position(*p)).collect()
    }

    /// A hole at them.
    pub(crate) fn hole(&self, hole: &Hole) -> Hole {
        let mut hole = hole.clone();
        match &mut hole {
            Hole::Circle(circle) => circle.centre = self.position(circle.centre),
            Hole::Ellipse(ellipse) => ellipse.centre = self.position(ellipse.centre),
            Hole::Slot(slot) => [slot.from, slot.to] = [slot.from, slot.to].map(|end| self.position(end)),
            Hole::Polygon(polygon) => polygon.vertices = self.positions(&polygon.vertices),
        }
        hole
    }
}

/// The positions that a hole is given by.
fn positions(hole: &Hole) -> Vec<[f64; 2]> {
    match hole {
        Hole::Circle(circle) => vec![circle.centre],
        Hole::Ellipse(ellipse) => vec![ellipse.centre],
        Hole::Slot(slot) => vec![slot.from, slot.to],
        Hole::Polygon(polygon) => polygon.vertices.clone(),
    }
}

/// Groups of ascending coordinates that are not wider than this: near ones do not chain up along a round border.
fn groups(all: &[(f64, bool)], within: f64) -> Vec<&[(f64, bool)]> {
    let (mut groups, mut rest) = (Vec::new(), all);
    while let Some(first) = rest.first() {
        let (group, others) = rest.split_at(rest.partition_point(|c| c.0 - first.0 <= within));
        groups.push(group);
        rest = others;
    }
    groups
}

/// What coordinates next to each other become: that which stays, zero, or the one with the fewest digits.
fn common(near: &[(f64, bool)], within: f64) -> f64 {
    let stays = near.iter().find(|c| c.1).map(|c| c.0);
    let zero = near.iter().any(|c| c.0.abs() <= within).then_some(0.0);
    let shortest = || near.iter().map(|c| c.0).min_by_key(|c| c.to_string().len());
    stays.or(zero).or_else(shortest).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_that_rounding_tells_apart_become_one() {
        let vertices = [[0.0, 0.0], [50.0, -1e-14], [49.999_999_999_999_99, 25.0], [3e-15, 50.0]];
        let snap = Snap::new(&[], &vertices, &[]);
        assert_eq!(snap.positions(&vertices), [[0.0, 0.0], [50.0, 0.0], [50.0, 25.0], [0.0, 50.0]]);
        // Single precision keeps seven digits; a spacing of a ten thousandth has a hundredth of it.
        assert_eq!(snap.position([f64::from(0.1f32) - 0.1, 50.0]), [0.0, 50.0]);
        assert_eq!(snap.position([5e-5, 50.0]), [5e-5, 50.0]);
    }

    #[test]
    fn corners_stay_and_holes_move() {
        let corners = [[0.1, 0.0], [0.1 + 0.2, 1.0]];
        let hole = Hole::Polygon(crate::case::PolygonHole {
            name: None,
            vertices: vec![[0.3, 0.2], [0.2, 0.3], [0.2, 1.0 - 1e-12]],
        });
        let Hole::Polygon(moved) = Snap::new(&corners, &[], std::slice::from_ref(&hole)).hole(&hole) else {
            panic!("a polygon")
        };
        assert_eq!(moved.vertices, [[0.1 + 0.2, 0.2], [0.2, 0.3], [0.2, 1.0]]);
    }

    #[test]
    fn what_is_no_number_stays() {
        let vertices = [[f64::NAN, 0.0], [f64::INFINITY, 1.0], [0.0, 1e-300]];
        let snap = Snap::new(&[], &vertices, &[]);
        assert!(snap.position(vertices[0])[0].is_nan());
        assert_eq!(snap.position(vertices[1]), vertices[1]);
    }
}
