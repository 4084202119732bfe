//! The points of a body in the plane as a limited number of blocks, for maps: of a large lattice a block is several cells, of
//! many listed points a square with all points in it.

use crate::scene::body::BodyScene;
use peristat_assembly::body::PointBody;
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
pub(super) const AROUND: [[i32; 2]; 4] = [[0, 0], [1, 0], [1, 1], [0, 1]];

/// Blocks of a body.
#[derive(Debug)]
pub(super) struct Raster {
    /// Corners of every block, around from the lower left, row by row.
    pub(super) blocks: Vec<[[f64; 2]; 4]>,
    /// Block of every point of the body.
    pub(super) of: Vec<u32>,
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
                let half = |k: usize| 0.5 * cloud.sizes()[k].sqrt();
                let block = |k: usize| {
                    let at = cloud.place(k);
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
                let cell = |at: &[f64; 3]| [0, 1].map(|k| (((at[k] - low[k]) / step) as i32).min(SIDE - 1));
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
pub(super) mod tests {
    use super::*;

    /// A grid of 3 × 2 blocks of four points each.
    pub(in super::super) fn raster() -> Raster {
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
}
