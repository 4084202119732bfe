//! The cells of a plate as a limited number of square blocks, for maps.

use crate::scene::PlateScene;
use peristat_assembly::body::SquareLattice;
use std::collections::BTreeMap;

/// Blocks of a drawing of lines, at most.
const DRAWN: usize = 25_600;
/// Blocks of a map in a report, at most, and of one of several states.
const MAPPED: [usize; 2] = [120_000, 40_000];

/// Blocks of cells with the points on their corners.
pub(super) struct Blocks<'a> {
    cells: &'a SquareLattice,
    /// Cells along a side of a block.
    pub(super) step: i32,
    /// Column and row of every block, row by row.
    pub(super) places: Vec<[i32; 2]>,
    /// Points of every block.
    points: Vec<Vec<u32>>,
}

impl<'a> Blocks<'a> {
    /// The blocks for a drawing.
    pub(super) fn drawn(scene: &'a PlateScene) -> Self {
        Self::within(scene, DRAWN)
    }

    /// The blocks for a map in a report.
    pub(super) fn mapped(scene: &'a PlateScene) -> Self {
        Self::within(scene, MAPPED[usize::from(scene.states.len() > 1 || scene.case.is_traced())])
    }

    fn within(scene: &'a PlateScene, most: usize) -> Self {
        let nodes = scene.plate.nodes();
        let cells = nodes.cells();
        let [width, height] = [cells.columns().len(), cells.rows().len()];
        let fits = |step: &usize| width.div_ceil(*step) * height.div_ceil(*step) <= most;
        let step = (1..).find(fits).unwrap_or(1) as i32;
        let first = [cells.columns().start, cells.rows().start];
        let mut found: BTreeMap<[i32; 2], Vec<u32>> = BTreeMap::new();
        for cell in nodes.all_cells() {
            let [column, row] = [0, 1].map(|k| (cell[k] - first[k]) / step);
            let corners = nodes.corners(cell).into_iter().flatten().map(|p| p as u32);
            // Rows first.
            found.entry([row, column]).or_default().extend(corners);
        }
        let places = found.keys().map(|[row, column]| [*column, *row]).collect();
        Self { cells, step, places, points: found.into_values().collect() }
    }

    /// Lower left corner of the first block, and the sides of a whole one.
    pub(super) fn layout(&self) -> ([f64; 2], f64) {
        let first = [self.cells.columns().start, self.cells.rows().start];
        (self.cells.node(first), f64::from(self.step) * self.cells.spacing())
    }

    /// Number of columns and rows of blocks, and the parts of the last ones that are there.
    pub(super) fn size(&self) -> ([usize; 2], [f64; 2]) {
        let step = self.step as usize;
        let counts = [self.cells.columns().len(), self.cells.rows().len()];
        let last = counts.map(|count| ((count - 1) % step + 1) as f64 / step as f64);
        (counts.map(|count| count.div_ceil(step)), last)
    }

    /// Corners of all blocks, around from the lower left.
    pub(super) fn corners(&self) -> impl Iterator<Item = [[f64; 2]; 4]> + '_ {
        let first = [self.cells.columns().start, self.cells.rows().start];
        let end = [self.cells.columns().end, self.cells.rows().end];
        self.places.iter().map(move |place| {
            [[0, 0], [1, 0], [1, 1], [0, 1]].map(|side: [i32; 2]| {
                self.cells.node([0, 1].map(|k| (first[k] + (place[k] + side[k]) * self.step).min(end[k])))
            })
        })
    }

    /// Means of the values of points over the blocks, every cell of one counting alike.
    pub(super) fn means(&self, values: &[f64]) -> Vec<f64> {
        let mean =
            |points: &Vec<u32>| points.iter().map(|&p| values[p as usize]).sum::<f64>() / points.len() as f64;
        self.points.iter().map(mean).collect()
    }
}
