//! Neighbours within a radius, found by a list of points per cell.

use super::geometry::{Point, distance};
use std::collections::HashMap;

/// Per point its neighbours in ascending order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Neighbours {
    starts: Vec<usize>,
    list: Vec<u32>,
}

impl Neighbours {
    /// Neighbours at a distance of at most `radius` (m, above zero), the point itself left out.
    ///
    /// Cells have at least the side `radius`, so the neighbours of a point are in nine of them.
    pub(super) fn within(positions: &[Point], radius: f64) -> Self {
        let cells = Cells::new(positions, radius);
        let mut found = Self { starts: vec![0], list: Vec::new() };
        for (p, &position) in positions.iter().enumerate() {
            let start = found.list.len();
            let near = |q: &&u32| **q as usize != p && distance(position, positions[**q as usize]) <= radius;
            for members in cells.around(position) {
                found.list.extend(members.iter().filter(near));
            }
            found.list[start..].sort_unstable();
            found.starts.push(found.list.len());
        }
        found
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.starts.len() - 1
    }

    /// Neighbours of a point in ascending order.
    pub fn of(&self, point: usize) -> &[u32] {
        &self.list[self.starts[point]..self.starts[point + 1]]
    }

    /// Every pair of neighbours once, the lower number first, in ascending order.
    pub fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        (0..self.points()).flat_map(move |p| {
            let own = p as u32;
            self.of(p).iter().filter(move |q| **q > own).map(move |q| [own, *q])
        })
    }
}

/// About how many pairs of points there are at a distance of at most `radius` (m, above zero), from the numbers of points in
/// squares of this side: in time that grows with the points alone, however many pairs there are.
pub(super) fn about(positions: &[Point], radius: f64) -> f64 {
    // Beside its own square a circle covers this part of the eight around it.
    const PART: f64 = (std::f64::consts::PI - 1.0) / 8.0;
    let mut squares: HashMap<[i64; 2], f64> = HashMap::new();
    for p in positions {
        *squares.entry(p.map(|x| (x / radius).floor() as i64)).or_default() += 1.0;
    }
    let of_square = |(&[i, j], own): (&[i64; 2], &f64)| {
        let square = |a: i64, b: i64| squares.get(&[i.saturating_add(a), j.saturating_add(b)]);
        let block: f64 = (-1..=1).flat_map(|a| (-1..=1).filter_map(move |b| square(a, b))).sum();
        own * (own - 1.0 + PART * (block - own))
    };
    // Whole numbers and one factor: the order does not matter but for rounding.
    0.5 * squares.iter().map(of_square).sum::<f64>()
}

struct Cells {
    origin: Point,
    side: f64,
    size: [usize; 2],
    starts: Vec<u32>,
    members: Vec<u32>,
}

impl Cells {
    fn new(positions: &[Point], radius: f64) -> Self {
        let bound = |k: usize, start: f64, pick: fn(f64, f64) -> f64| {
            positions.iter().map(|p| p[k]).fold(start, pick)
        };
        let origin = [0, 1].map(|k| bound(k, f64::INFINITY, f64::min));
        let extent = [0, 1].map(|k| (bound(k, f64::NEG_INFINITY, f64::max) - origin[k]).max(0.0));
        // No more cells than a few per point, however small the radius.
        let mut side = radius;
        let counts = |side: f64| extent.map(|e| (e / side).floor() + 1.0);
        while counts(side).iter().product::<f64>() > 4.0 * positions.len() as f64 + 16.0 {
            side *= 2.0;
        }
        let size = counts(side).map(|c| c as usize);
        let mut cells =
            Self { origin, side, size, starts: vec![0; size[0] * size[1] + 1], members: Vec::new() };
        for &p in positions {
            let [i, j] = cells.cell(p);
            cells.starts[j * size[0] + i + 1] += 1;
        }
        for k in 1..cells.starts.len() {
            cells.starts[k] += cells.starts[k - 1];
        }
        let mut next = cells.starts.clone();
        cells.members = vec![0; positions.len()];
        for (k, &p) in positions.iter().enumerate() {
            let [i, j] = cells.cell(p);
            let slot = &mut next[j * size[0] + i];
            cells.members[*slot as usize] = k as u32;
            *slot += 1;
        }
        cells
    }

    fn cell(&self, position: Point) -> [usize; 2] {
        let at = |k: usize| (((position[k] - self.origin[k]) / self.side) as usize).min(self.size[k] - 1);
        [at(0), at(1)]
    }

    /// Points of the cell of a position and the eight around it: one stretch per row of cells.
    fn around(&self, position: Point) -> impl Iterator<Item = &[u32]> {
        let [i, j] = self.cell(position);
        let columns = i.saturating_sub(1)..(i + 2).min(self.size[0]);
        (j.saturating_sub(1)..(j + 2).min(self.size[1])).map(move |row| {
            let at = |column: usize| self.starts[row * self.size[0] + column] as usize;
            &self.members[at(columns.start)..at(columns.end)]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn cells_find_what_comparing_all_finds(
            positions in proptest::collection::vec([-3.0..3.0f64, 0.0..0.4f64], 1..60), radius in 1e-3..8.0f64,
        ) {
            let found = Neighbours::within(&positions, radius);
            for p in 0..positions.len() {
                let near = |q: &u32| *q as usize != p && distance(positions[p], positions[*q as usize]) <= radius;
                let all: Vec<u32> = (0..positions.len() as u32).filter(near).collect();
                prop_assert_eq!(found.of(p), all);
            }
            prop_assert_eq!(2 * found.pairs().count(), found.list.len());
        }
    }

    /// Squares, clusters in one square and at the corner of four, and lines.
    #[test]
    fn the_number_of_pairs_is_known_without_them() {
        let grid = |n: i32, h: f64| (0..n * n).map(move |k| [f64::from(k % n) * h, f64::from(k / n) * h]);
        let line = |n: i32, h: f64| (0..n).map(move |k| [f64::from(k) * h, 0.5 * f64::from(k) * h]);
        let moved = |by: f64| grid(20, 1e-3).map(move |[x, y]| [x + by, y + by]);
        let bodies: [Vec<Point>; 5] = [
            grid(60, 0.3).collect(),
            moved(0.5).collect(),
            moved(-0.01).collect(),
            moved(0.5).chain(line(300, 0.2)).collect(),
            line(2000, 0.1).collect(),
        ];
        for positions in bodies {
            let exact = Neighbours::within(&positions, 1.0).pairs().count() as f64;
            let ratio = about(&positions, 1.0) / exact;
            // Measured 0.94, 1, 0.45, 0.99 and 0.90.
            assert!((0.4..1.1).contains(&ratio), "{ratio} of {exact}");
        }
    }

    #[test]
    fn few_points_far_apart_need_few_cells() {
        let found = Neighbours::within(&[[0.0; 2], [1e9, 1e9], [1e9, 1e9 + 1.0]], 1.0);
        assert_eq!(found.pairs().collect::<Vec<_>>(), [[1, 2]]);
        let column = Neighbours::within(&[[2.0, 0.0], [2.0, 1.0], [2.0, 2.0]], 1.0);
        assert_eq!((column.of(0), column.of(1)), (&[1][..], &[0, 2][..]));
    }
}
