//! The points of a body in the plane as a limited number of blocks, for maps: of a large lattice a block is several cells, of
//! many listed points a square with all points in it.

use crate::scene::body::BodyScene;
use peristat_assembly::body::{Crack, PointBody};
use std::collections::{BTreeMap, HashSet};
use std::ops::Range;

/// How many blocks there are, and along a side, at most.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    pub(super) blocks: usize,
    pub(super) along: usize,
}

/// Of a drawing of lines.
const DRAWN: Limits = Limits { blocks: 25_600, along: 400 };

/// From the lower left corner of a block to all of them, around.
const AROUND: [[i32; 2]; 4] = [[0, 0], [1, 0], [1, 1], [0, 1]];

/// Blocks of a body.
#[derive(Debug)]
pub(super) struct Raster {
    /// Corners of every block, around from the lower left, row by row.
    pub(super) blocks: Vec<[[f64; 2]; 4]>,
    /// Block of every point of the body.
    of: Vec<u32>,
    counts: Vec<f64>,
    /// Numbers of blocks by columns and rows; none where every point is a block of its own.
    pub(super) grid: Option<Grid>,
    /// Cells of a lattice along a side of a block.
    pub(super) step: usize,
}

/// Blocks on a grid.
#[derive(Debug)]
pub(super) struct Grid {
    pub(super) columns: i32,
    pub(super) rows: i32,
    numbers: Vec<Option<u32>>,
    /// Column and row of every block.
    pub(super) cells: Vec<[i32; 2]>,
}

/// Cells along a side of a block.
fn step(columns: usize, rows: usize, limits: Limits) -> usize {
    let fits = |step: &usize| {
        let [a, b] = [columns, rows].map(|count| count.div_ceil(*step));
        a * b <= limits.blocks && a.max(b) <= limits.along
    };
    (1..).find(fits).unwrap_or(1)
}

impl Raster {
    /// The blocks of the body of a scene for a drawing.
    pub(super) fn new(scene: &BodyScene) -> Self {
        Self::within(scene, DRAWN)
    }

    /// The blocks of the body of a scene, no more than some number.
    pub(super) fn within(scene: &BodyScene, limits: Limits) -> Self {
        match scene.body() {
            // Of a solid a block has all layers.
            PointBody::Lattice(lattice) | PointBody::Solid(lattice) => {
                let (columns, rows) = (lattice.columns(), lattice.rows());
                let step = step(columns.len(), rows.len(), limits) as i32;
                let cells = lattice.runs().iter().flat_map(|run| {
                    let (start, row) = (columns.start, (run.row - rows.start) / step);
                    run.columns.clone().map(move |column| [(column - start) / step, row])
                });
                let count = |range: &Range<i32>| (range.len() as i32 + step - 1) / step;
                let size = [count(&columns), count(&rows)];
                // Blocks at the end may be cut off by the border of the body.
                let line = |range: &Range<i32>, index: i32| (range.start + index * step).min(range.end);
                let node = |[i, j]: [i32; 2]| lattice.node([line(&columns, i), line(&rows, j)]);
                Self { step: step as usize, ..Self::on_grid(size, cells, &node) }
            }
            PointBody::Cloud(cloud) if cloud.points() <= limits.blocks => {
                let half = |k: usize| 0.5 * cloud.areas()[k].sqrt();
                let block = |k: usize| {
                    let at = cloud.positions()[k];
                    AROUND.map(|side| [0, 1].map(|c| at[c] + f64::from(2 * side[c] - 1) * half(k)))
                };
                Self {
                    blocks: (0..cloud.points()).map(block).collect(),
                    of: (0..cloud.points() as u32).collect(),
                    counts: vec![1.0; cloud.points()],
                    grid: None,
                    step: 1,
                }
            }
            PointBody::Cloud(cloud) => {
                let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
                for at in cloud.positions() {
                    (0..2).for_each(|k| (low[k], high[k]) = (low[k].min(at[k]), high[k].max(at[k])));
                }
                const SIDE: i32 = 160;
                let step = (high[0] - low[0]).max(high[1] - low[1]) / f64::from(SIDE);
                let cell = |at: &[f64; 2]| [0, 1].map(|k| (((at[k] - low[k]) / step) as i32).min(SIDE - 1));
                let node = |index: [i32; 2]| [0, 1].map(|k| low[k] + f64::from(index[k]) * step);
                Self::on_grid([SIDE; 2], cloud.positions().iter().map(cell), &node)
            }
        }
    }

    /// Blocks from the cells of a grid that the points lie in.
    fn on_grid(
        [columns, rows]: [i32; 2],
        cells: impl Iterator<Item = [i32; 2]> + Clone,
        node: &dyn Fn([i32; 2]) -> [f64; 2],
    ) -> Self {
        let place = |[i, j]: [i32; 2]| (j * columns + i) as usize;
        let mut numbers = vec![None; (columns * rows) as usize];
        cells.clone().for_each(|cell| numbers[place(cell)] = Some(0));
        let (mut blocks, mut own) = (Vec::new(), Vec::new());
        for cell in (0..rows).flat_map(|j| (0..columns).map(move |i| [i, j])) {
            if let Some(number) = &mut numbers[place(cell)] {
                *number = blocks.len() as u32;
                own.push(cell);
                blocks.push(AROUND.map(|[i, j]| node([cell[0] + i, cell[1] + j])));
            }
        }
        let of: Vec<u32> = cells.map(|cell| numbers[place(cell)].unwrap_or(0)).collect();
        let mut counts = vec![0.0; blocks.len()];
        of.iter().for_each(|&b| counts[b as usize] += 1.0);
        Self { blocks, of, counts, grid: Some(Grid { columns, rows, numbers, cells: own }), step: 1 }
    }

    /// Means of the values of points over the blocks.
    pub(super) fn means(&self, values: &[f64]) -> Vec<f64> {
        let mut means = vec![0.0; self.blocks.len()];
        self.of.iter().zip(values).for_each(|(&b, v)| means[b as usize] += v);
        means.iter_mut().zip(&self.counts).for_each(|(mean, count)| *mean /= count);
        means
    }

    /// Corners of all blocks, around.
    pub(super) fn corners(&self) -> impl Iterator<Item = [[f64; 2]; 4]> + '_ {
        self.blocks.iter().copied()
    }

    /// Middle of a block.
    pub(super) fn middle(&self, block: usize) -> [f64; 2] {
        [0, 1].map(|k| 0.5 * (self.blocks[block][0][k] + self.blocks[block][2][k]))
    }

    /// Sides of blocks along which most pairs of neighbours across them are among some: the block, and 0 for its side on
    /// the right, 1 for that above.
    pub(super) fn between(&self, pairs: &[[usize; 2]]) -> Vec<[usize; 2]> {
        let Some(grid) = &self.grid else { return Vec::new() };
        let mut counts: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        for pair in pairs {
            let [mut a, mut b] = pair.map(|point| self.of[point] as usize);
            if a > b {
                (a, b) = (b, a);
            }
            let ([i, j], [k, l]) = (grid.cells[a], grid.cells[b]);
            match [k - i, l - j] {
                [1, 0] => *counts.entry([a, 0]).or_default() += 1,
                [0, 1] => *counts.entry([a, 1]).or_default() += 1,
                _ => {}
            }
        }
        counts.into_iter().filter(|(_, count)| 2 * count >= self.step).map(|(side, _)| side).collect()
    }

    /// Ends of a side of a block, from the corners of all.
    pub(super) fn side([block, side]: [usize; 2], corners: &[[[f64; 2]; 4]]) -> [[f64; 2]; 2] {
        let around = corners[block];
        [around[if side == 0 { 1 } else { 3 }], around[2]]
    }

    /// Corners of all blocks moved by `factor` times the displacements, means over the blocks. A corner moves with the mean
    /// of the blocks around it that neither a crack nor a side of `apart` separates from its own.
    pub(super) fn deformed(
        &self,
        mean: &[Vec<f64>; 2],
        factor: f64,
        (cracks, apart): (&[Crack], &[[usize; 2]]),
    ) -> Vec<[[f64; 2]; 4]> {
        let mut all: Vec<[[f64; 2]; 4]> = self.corners().collect();
        let apart: HashSet<[usize; 2]> = apart.iter().copied().collect();
        // The neighbour along a row or a column, if it hangs together with the block.
        let joined = |block: usize, [i, j]: [i32; 2]| {
            let other = self.beside(block, [i, j])?;
            let side = [block.min(other), usize::from(j != 0)];
            (other == block || !apart.contains(&side)).then_some(other)
        };
        for (block, corners) in all.iter_mut().enumerate() {
            for (corner, [right, up]) in corners.iter_mut().zip(AROUND) {
                let (mut sum, mut count) = ([0.0; 2], 0.0);
                for [i, j] in AROUND.map(|[i, j]| [right - i, up - j]) {
                    // To the block across the corner along one side or the other.
                    let ways = [[[i, 0], [0, j]], [[0, j], [i, 0]]];
                    let found = ways.into_iter().find_map(|[a, b]| joined(joined(block, a)?, b));
                    let Some(other) = found else { continue };
                    let (a, b) = (self.middle(block), self.middle(other));
                    if other == block || !cracks.iter().any(|c| c.cuts(a, b, 0.0)) {
                        (0..2).for_each(|k| sum[k] += mean[k][other]);
                        count += 1.0;
                    }
                }
                (0..2).for_each(|k| corner[k] += factor * sum[k] / count);
            }
        }
        all
    }

    /// The block at an offset from another one; itself at none.
    pub(super) fn beside(&self, block: usize, [i, j]: [i32; 2]) -> Option<usize> {
        if [i, j] == [0, 0] {
            return Some(block);
        }
        let grid = self.grid.as_ref()?;
        let [column, row] = [grid.cells[block][0] + i, grid.cells[block][1] + j];
        let fits = (0..grid.columns).contains(&column) && row >= 0;
        let number = grid.numbers.get((row * grid.columns + column) as usize).copied().flatten();
        number.filter(|_| fits).map(|n| n as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grid of 3 × 2 blocks of four points each.
    fn raster() -> Raster {
        let cells = (0..4).flat_map(|j| (0..6).map(move |i| [i / 2, j / 2]));
        Raster::on_grid([3, 2], cells, &|node| node.map(f64::from))
    }

    #[test]
    fn blocks_are_as_small_as_their_number_allows() {
        let step = |columns, rows| step(columns, rows, DRAWN);
        assert_eq!([step(160, 160), step(161, 160), step(400, 60), step(401, 60)], [1, 2, 1, 2]);
        assert_eq!(step(1000, 1000), 7);
    }

    #[test]
    fn means_are_those_of_the_points_of_a_block() {
        let raster = raster();
        let values: Vec<f64> = (0..24).map(f64::from).collect();
        // Points 0, 1, 6, 7 are in the first block.
        assert_eq!(raster.means(&values), [3.5, 5.5, 7.5, 15.5, 17.5, 19.5]);
        assert_eq!(raster.blocks[4], [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]]);
    }

    #[test]
    fn a_side_is_one_along_which_most_neighbours_are_parted() {
        // Points 6 to 8 of the second row, and 12 to 14 above them; and 1 and 2 beside each other.
        let raster = Raster { step: 2, ..raster() };
        let found = raster.between(&[[6, 12], [13, 7], [8, 14], [1, 2], [0, 1]]);
        assert_eq!(found, [[0, 0], [0, 1], [1, 1]]);
        let single = Raster { step: 4, ..raster };
        assert_eq!(single.between(&[[6, 12], [13, 7], [8, 14], [1, 2], [0, 1]]), [[0, 1]]);
        let corners: Vec<_> = single.corners().collect();
        assert_eq!(Raster::side([0, 1], &corners), [[0.0, 1.0], [1.0, 1.0]]);
    }

    #[test]
    fn corners_move_with_their_neighbours_but_not_across_a_crack() {
        let raster = raster();
        let up = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
        let moved = |cracks: &[Crack], apart: &[[usize; 2]]| {
            raster.deformed(&[vec![0.0; 6], up.clone()], 2.0, (cracks, apart))
        };
        let whole = moved(&[], &[]);
        assert_eq!((whole[0][2], whole[4][0], whole[4][2]), ([1.0, 2.0], [1.0, 2.0], [2.0, 4.0]));
        let crack = Crack::new(vec![[-1.0, 1.0], [4.0, 1.0]]).unwrap();
        let grown = [[0, 1], [1, 1], [2, 1]];
        for open in [moved(&[crack], &[]), moved(&[], &grown)] {
            assert_eq!((open[0][2], open[4][0]), ([1.0, 1.0], [1.0, 3.0]));
        }
        // Around the end of what has grown the body hangs together.
        let tip = moved(&[], &grown[..1]);
        assert_eq!((tip[0][2], tip[4][0]), (whole[0][2], whole[4][0]));
        assert_eq!((tip[0][3], tip[3][0]), ([0.0, 1.0], [0.0, 3.0]));
    }
}
