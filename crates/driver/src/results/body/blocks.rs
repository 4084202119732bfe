//! The cells of a solid as a limited number of blocks, for pictures: of a large body a block is several cells. Listed points are in
//! cells that are wider than their spacing, so that few inside stay empty.

use peristat_assembly::body::{Cell, PointBody, SquareLattice, plus};

/// Places of the box around a body, at most, whether there is a block or not.
const MOST_PLACES: usize = 4_000_000;
/// Of a place without a block.
const NONE: u32 = u32::MAX;
/// Side of a cell that holds listed points, spacings.
const WIDTH: f64 = 1.5;
/// Part of a cell that is rounding.
const ROUNDING: f64 = 1e-9;
/// Cells of listed points along an axis, at most.
const FEW_ALONG: f64 = 1000.0;

/// Blocks of cells, numbered row by row along x, layer by layer along z.
pub(super) struct Blocks {
    /// The lowest corner of the box around the body, m.
    corner: [f64; 3],
    /// Side of a cell, m.
    pub(super) side: f64,
    /// Columns, rows and layers of cells.
    sides: [usize; 3],
    /// Cells along a side.
    pub(super) step: i32,
    /// Number of blocks along the axes.
    pub(super) size: [i32; 3],
    /// Number of the block of every place of the box.
    numbers: Vec<u32>,
    /// Place of every block.
    pub(super) cells: Vec<Cell>,
    /// Block of every point.
    of: Vec<u32>,
    counts: Vec<f64>,
}

impl Blocks {
    /// The smallest blocks of which `fits` says that they are few enough.
    pub(super) fn new(body: &PointBody, fits: impl Fn(&Self) -> bool) -> Self {
        let (corner, side, sides) = grid(body);
        let has_room =
            |step: &usize| sides.iter().map(|s| s.div_ceil(*step)).product::<usize>() <= MOST_PLACES;
        let mut step = (1..).find(has_room).unwrap_or(1) as i32;
        loop {
            let blocks = Self::of_step(body, (corner, side, sides), step);
            // A single block cannot be fewer.
            if fits(&blocks) || blocks.cells.len() < 2 {
                return blocks;
            }
            step += 1;
        }
    }

    fn of_step(body: &PointBody, (corner, side, sides): ([f64; 3], f64, [usize; 3]), step: i32) -> Self {
        let size = sides.map(|s| s.div_ceil(step as usize) as i32);
        let numbers = vec![NONE; size.iter().map(|&s| s as usize).product()];
        let (cells, of) = (Vec::new(), Vec::with_capacity(body.points()));
        let mut blocks = Self { corner, side, sides, step, size, numbers, cells, of, counts: Vec::new() };
        let place = |at: [f64; 3]| {
            let cell = |k: usize| (((at[k] - corner[k]) / side) as usize).min(sides[k] - 1);
            [0, 1, 2].map(|k| cell(k) as i32 / step)
        };
        body.visit(|at| {
            let at = blocks.at(place(at));
            blocks.numbers[at] = 0;
        });
        let taken = blocks.numbers.iter_mut().enumerate().filter(|(_, number)| **number != NONE);
        for (next, (at, number)) in (0..).zip(taken) {
            *number = next;
            let (row, [columns, rows, _]) = (at as i32 / size[0], size);
            blocks.cells.push([at as i32 % columns, row % rows, row / rows]);
        }
        blocks.counts = vec![0.0; blocks.cells.len()];
        body.visit(|at| {
            let number = blocks.numbers[blocks.at(place(at))];
            blocks.of.push(number);
            blocks.counts[number as usize] += 1.0;
        });
        blocks
    }

    /// Where a place of the box stands in their order.
    fn at(&self, [i, j, k]: Cell) -> usize {
        ((k * self.size[1] + j) * self.size[0] + i) as usize
    }

    /// The block at a place, if there is one.
    pub(super) fn number(&self, place: Cell) -> Option<usize> {
        let is_in = (0..3).all(|k| (0..self.size[k]).contains(&place[k]));
        let number = if is_in { self.numbers[self.at(place)] } else { NONE };
        (number != NONE).then_some(number as usize)
    }

    /// The mean of values of points in every block.
    pub(super) fn means(&self, values: &[f64]) -> Vec<f64> {
        let mut means = vec![0.0; self.counts.len()];
        self.of.iter().zip(values).for_each(|(&b, v)| means[b as usize] += v / self.counts[b as usize]);
        means
    }

    /// Where the corner before a block is, m; blocks at the end may be cut off.
    pub(super) fn place(&self, node: Cell) -> [f64; 3] {
        [0, 1, 2].map(|k| {
            let line = (node[k] * self.step).min(self.sides[k] as i32);
            self.corner[k] + f64::from(line) * self.side
        })
    }

    /// Corners that move with the blocks around them, by some multiple.
    pub(super) fn moved(&self, u: [&[f64]; 3], factor: f64) -> impl Fn(Cell) -> [f64; 3] + use<'_> {
        let means = u.map(|values| self.means(values));
        move |node| {
            let around = (0..8).filter_map(|corner| {
                let step = [0, 1, 2].map(|k| -(corner >> k & 1));
                self.number(plus(node, step))
            });
            let own: Vec<usize> = around.collect();
            let at = self.place(node);
            let mean = |k: usize| own.iter().map(|&b| means[k][b]).sum::<f64>() / own.len().max(1) as f64;
            [0, 1, 2].map(|k| at[k] + factor * mean(k))
        }
    }

    /// Numbers of places in their order: without a block, with one, without one, and so on.
    pub(super) fn spans(&self) -> Vec<usize> {
        let mut spans = vec![0];
        for number in &self.numbers {
            // Those with a block stand second.
            let is_there = *number != NONE;
            if is_there == (spans.len() % 2 == 1) {
                spans.push(0);
            }
            if let Some(last) = spans.last_mut() {
                *last += 1;
            }
        }
        spans
    }
}

/// The lowest corner of the box around a body, the side of its cells, and how many there are along the axes.
fn grid(body: &PointBody) -> ([f64; 3], f64, [usize; 3]) {
    if let PointBody::Solid(lattice) = body {
        let first = [lattice.columns().start, lattice.rows().start, lattice.layers().start];
        let corner = [0, 1, 2].map(|k| lattice.corner()[k] + f64::from(first[k]) * lattice.spacing());
        return (corner, lattice.spacing(), sides(lattice));
    }
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    body.visit(|at| (0..3).for_each(|k| (low[k], high[k]) = (low[k].min(at[k]), high[k].max(at[k]))));
    let half = 0.5 * body.spacing();
    let extent = [0, 1, 2].map(|k| high[k] - low[k] + 2.0 * half);
    // Points that lie far apart have larger cells: a few times as many places as there may be, of which blocks take several.
    let longest = extent.iter().fold(0.0, |a: f64, b| a.max(*b));
    let share: f64 = extent.iter().map(|e| (e / longest).cbrt()).product();
    let most = longest * share / (MOST_PLACES as f64).cbrt();
    let side = (WIDTH * body.spacing()).max(most).max(longest / FEW_ALONG);
    (low.map(|x| x - half), side, extent.map(|e| (e / side - ROUNDING).ceil().max(1.0) as usize))
}

/// Cells along the axes of the box.
fn sides(lattice: &SquareLattice) -> [usize; 3] {
    [lattice.columns().len(), lattice.rows().len(), lattice.layers().len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use peristat_assembly::body::Cloud;

    #[test]
    fn blocks_are_numbered_along_rows_and_know_their_places_and_points() {
        // 5 × 3 × 2 cells, one corner of which is missing, in blocks of 2 × 2 × 2.
        let lattice =
            SquareLattice::new(0.5, [1.0, 0.0, 0.0], [0..5, 0..3, 0..2], |cell| cell[0] < 4 || cell[1] < 2);
        let blocks = Blocks::new(&PointBody::Solid(lattice.clone()), |blocks| blocks.step == 2);
        assert_eq!((blocks.size, blocks.cells.len()), ([3, 2, 1], 5));
        assert_eq!(blocks.cells[2..4], [[2, 0, 0], [0, 1, 0]]);
        assert_eq!((blocks.number([2, 0, 0]), blocks.number([2, 1, 0])), (Some(2), None));
        assert_eq!(blocks.spans(), [0, 5, 1]);
        // The block at the end has half the cells, and is half as long.
        assert_eq!((blocks.counts[2], blocks.place([3, 2, 1])), (4.0, [3.5, 1.5, 1.0]));
        let x: Vec<f64> = (0..lattice.points()).map(|p| lattice.position(p)[0]).collect();
        assert_eq!(blocks.means(&x), [1.5, 2.5, 3.25, 1.5, 2.5]);
    }

    #[test]
    fn blocks_are_as_small_as_they_may_be() {
        let cube = PointBody::Solid(SquareLattice::cuboid(1.0, [0.0; 3], [10, 10, 10]));
        let step = |most: usize| Blocks::new(&cube, |blocks| blocks.cells.len() <= most).step;
        assert_eq!([1000, 999, 125, 124, 0].map(step), [1, 2, 2, 3, 10]);
    }

    #[test]
    fn listed_points_fill_their_blocks() {
        // A cube of 6³ points a spacing apart: 4³ cells of one and a half spacings, the last ones as wide as the others.
        let at = |k: usize| [k % 6, k / 6 % 6, k / 36].map(|i| i as f64);
        let cloud = Cloud::in_space((0..216).map(at).collect(), vec![1.0; 216], Vec::new()).unwrap();
        let blocks = Blocks::new(&PointBody::Cloud(cloud), |_| true);
        assert_eq!((blocks.size, blocks.cells.len()), ([4; 3], 64));
        for (node, expected) in [([0; 3], -0.5), ([4; 3], 5.5)] {
            assert!(
                blocks.place(node).iter().all(|x| (x - expected).abs() < 1e-12),
                "{:?}",
                blocks.place(node)
            );
        }
        let x: Vec<f64> = (0..216).map(|k| at(k)[0]).collect();
        // Every mean lies in its cell; some points lie on the sides of cells.
        for (cell, mean) in blocks.cells.iter().zip(blocks.means(&x)) {
            let middle = 1.5 * f64::from(cell[0]) + 0.25;
            assert!((mean - middle).abs() <= 0.75 + 1e-9, "{cell:?} {mean}");
        }
    }
}
