//! Rigid regions that bear on the rest of the body like pins in their holes: in some directions only.
//!
//! A pin in contact presses on one side of its hole. Glued all around, it makes a crack specimen too stiff at its mouth; the
//! bonds behind it and beside it are therefore cut.

use peristat_assembly::body::{Cell, PointBody, SquareLattice, plus};
use peristat_assembly::model::plane::Mirrors;
use std::collections::HashSet;

/// Cosines closer than this are the same: ties are cut, whatever rounding says.
const TIE: f64 = 1e-9;

/// Where a rigid region bears on other points.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bearing {
    /// Points of the region by numbers of the body, ascending.
    pub(crate) points: Vec<u32>,
    /// Centre of the region, m.
    pub(crate) centre: [f64; 2],
    /// Unit vector.
    pub(crate) direction: [f64; 2],
    /// Cosine of the half angle.
    pub(crate) cosine: f64,
}

impl Bearing {
    fn holds(&self, point: usize) -> bool {
        self.points.binary_search(&(point as u32)).is_ok()
    }

    /// Whether a place seen from the centre, m, is beside or behind the bearing.
    fn lets_go(&self, [x, y]: [f64; 2]) -> bool {
        x * self.direction[0] + y * self.direction[1] <= (self.cosine + TIE) * x.hypot(y)
    }
}

/// Bonds of a lattice between rigid regions and points on which they do not bear: indices of offsets and lower points,
/// sorted. `real` is the lattice without images.
pub(crate) fn on_lattice(
    bearings: &[Bearing],
    (lattice, real): (&SquareLattice, &SquareLattice),
    mirrors: &Mirrors,
    offsets: &[Cell],
) -> Vec<(usize, usize)> {
    let own = |cell: Cell| real.number(mirrors.image(cell).0);
    let mut cuts = Vec::new();
    for bearing in bearings {
        let is_in = |cell: Cell| own(cell).is_some_and(|p| bearing.holds(p));
        for point in (0..lattice.points()).filter(|&p| is_in(lattice.cell(p))) {
            let cell = lattice.cell(point);
            let (image, signs) = mirrors.image(cell);
            let at = real.place_of(image);
            for (k, &offset) in offsets.iter().enumerate() {
                for step in [offset, offset.map(|k| -k)] {
                    let other = plus(cell, step);
                    let Some(number) = lattice.number(other).filter(|_| !is_in(other)) else { continue };
                    // An image sees what its point sees, mirrored.
                    let along = lattice.vector(step);
                    let seen = [0, 1].map(|c| at[c] + signs[c] * along[c] - bearing.centre[c]);
                    if bearing.lets_go(seen) {
                        cuts.push((k, if step == offset { point } else { number }));
                    }
                }
            }
        }
    }
    cuts.sort_unstable();
    cuts.dedup();
    cuts
}

/// The same for listed points, by the positions of the ends of a bond, m.
pub(crate) fn between<'a>(
    bearings: &'a [Bearing],
    body: &PointBody,
) -> impl Fn([f64; 2], [f64; 2]) -> bool + 'a {
    let key = |at: [f64; 2]| at.map(f64::to_bits);
    let places = |b: &Bearing| b.points.iter().map(|&p| key(body.place(p as usize))).collect();
    let regions: Vec<HashSet<[u64; 2]>> = bearings.iter().map(places).collect();
    move |a, b| {
        bearings.iter().zip(&regions).any(|(bearing, places)| {
            let other = match [a, b].map(|at| places.contains(&key(at))) {
                [true, false] => b,
                [false, true] => a,
                _ => return false,
            };
            bearing.lets_go([0, 1].map(|c| other[c] - bearing.centre[c]))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bearing(points: Vec<u32>, centre: [f64; 2], half_angle: f64) -> Bearing {
        Bearing { points, centre, direction: [0.0, 1.0], cosine: half_angle.to_radians().cos() }
    }

    #[test]
    fn ties_are_cut() {
        let pin = bearing(Vec::new(), [0.0; 2], 45.0);
        assert!(pin.lets_go([0.3, 0.3]) && pin.lets_go([-0.1, 0.1]) && pin.lets_go([0.0, -1.0]));
        assert!(!pin.lets_go([0.3, 0.300_001]));
    }

    #[test]
    fn only_bonds_to_other_points_in_front_of_the_region_stay() {
        // Two points in the middle of 5 × 4 cells that press upwards.
        let lattice = SquareLattice::rectangle(1.0, [0.0; 2], [6, 5]);
        let points: Vec<u32> = [[2, 2, 0], [3, 2, 0]].map(|c| lattice.number(c).unwrap() as u32).into();
        let pin = bearing(points.clone(), [3.0, 2.5], 60.0);
        let offsets = [[1, 0, 0], [0, 1, 0], [1, 1, 0], [-1, 1, 0]];
        let cuts = on_lattice(&[pin], (&lattice, &lattice), &Mirrors::NONE, &offsets);
        // Each point has eight bonds, one of them to the other, and three upwards. Of those the one to [1, 3], seen at
        // atan 1.5/1 = 56.3 degrees, still is in front.
        assert_eq!(cuts.len(), 2 * (8 - 1 - 3));
        let upwards = |&(k, lower): &(usize, usize)| offsets[k][1] == 1 && points.contains(&(lower as u32));
        assert_eq!(cuts.iter().filter(|c| upwards(c)).count(), 0);
    }

    #[test]
    fn images_are_cut_as_their_points_are() {
        let (columns, rows) = (6, 5);
        let whole = SquareLattice::rectangle(1.0, [-6.0, 0.0], [2 * columns, rows]);
        let half = SquareLattice::rectangle(1.0, [0.0; 2], [columns, rows]);
        let mirrors = Mirrors::in_plane([Some(0), None], [None; 2]);
        let extended = mirrors.extended(&half, 2);
        let pin = |lattice: &SquareLattice, columns: [i32; 2], x: f64| {
            let points = columns.map(|i| lattice.number([i, 2, 0]).unwrap() as u32).into();
            bearing(points, [x, 2.5], 50.0)
        };
        let offsets = [[1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [-1, 1, 0], [2, 1, 0]];
        let both = [pin(&whole, [7, 8], 2.0), pin(&whole, [3, 4], -2.0)];
        let expected = on_lattice(&both, (&whole, &whole), &Mirrors::NONE, &offsets);
        let one = [pin(&half, [1, 2], 2.0)];
        let found = on_lattice(&one, (&extended, &half), &mirrors, &offsets);
        // Bonds by their ends, in the part of the whole lattice that the half one has with its images.
        let ends = |lattice: &SquareLattice, shift: i32, (k, lower): (usize, usize)| {
            let first = plus(lattice.cell(lower), [-shift, 0, 0]);
            [first, plus(first, offsets[k])]
        };
        let known = |e: &[Cell; 2]| e.iter().all(|&c| extended.number(c).is_some());
        let expected: HashSet<_> = expected.into_iter().map(|c| ends(&whole, 6, c)).filter(known).collect();
        let found: HashSet<_> = found.into_iter().map(|c| ends(&extended, 0, c)).collect();
        assert!(found.len() > 10);
        assert_eq!(found, expected);
    }
}
