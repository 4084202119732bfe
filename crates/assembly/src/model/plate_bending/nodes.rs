//! The points of a plate: the corners of its cells.

use super::PlateError;
use crate::body::{Cell, SquareLattice};
use std::sync::Arc;

/// A side of a cell beyond which there is no body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeSegment {
    /// The points at its ends.
    pub points: [u32; 2],
    /// Unit normal out of the body.
    pub outward: [f64; 2],
}

/// Square cells with a point on every corner.
#[derive(Clone, Debug)]
pub struct PlateNodes {
    cells: Arc<SquareLattice>,
    /// A cell of this lattice is centred at a corner of the others, and has the quarters of these as its area.
    nodes: Arc<SquareLattice>,
}

/// The four sides of a cell by their outward normals, with the corners at their ends.
const SIDES: [([i32; 2], [[i32; 2]; 2]); 4] = [
    ([0, -1], [[0, 0], [1, 0]]),
    ([1, 0], [[1, 0], [1, 1]]),
    ([0, 1], [[1, 1], [0, 1]]),
    ([-1, 0], [[0, 1], [0, 0]]),
];

impl PlateNodes {
    /// The corners of the cells of a plane lattice whose rows run along x.
    ///
    /// # Errors
    /// [`PlateError::Lattice`] if it is not such a one.
    pub fn new(cells: Arc<SquareLattice>) -> Result<Self, PlateError> {
        if !cells.is_plane() || cells.is_turned() {
            return Err(PlateError::Lattice);
        }
        let h = cells.spacing();
        let [x, y, _] = cells.corner();
        let (columns, rows) = (cells.columns(), cells.rows());
        let around = |[i, j]: [i32; 2]| {
            let corners = [[i - 1, j - 1], [i, j - 1], [i - 1, j], [i, j]];
            corners.into_iter().filter(|&[a, b]| cells.number([a, b, 0]).is_some()).count()
        };
        let is_corner = |node: [i32; 2]| around(node) > 0;
        let (columns, rows) = (columns.start..columns.end + 1, rows.start..rows.end + 1);
        let corner = [x - 0.5 * h, y - 0.5 * h];
        let nodes = SquareLattice::plane(h, corner, columns, rows, is_corner);
        let quarters = |cell: Cell| 0.25 * around([cell[0], cell[1]]) as f64;
        let numbers = nodes.runs().iter().flat_map(|run| run.columns.clone().map(|column| run.cell(column)));
        let areas: Vec<(Cell, f64)> = numbers.map(|cell| (cell, quarters(cell))).collect();
        let nodes = nodes.with_areas(&areas);
        Ok(Self { cells, nodes: Arc::new(nodes) })
    }

    /// The cells.
    pub fn cells(&self) -> &Arc<SquareLattice> {
        &self.cells
    }

    /// The points as the centres of cells about them, which have the area of the body in them.
    pub fn lattice(&self) -> &Arc<SquareLattice> {
        &self.nodes
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.nodes.points()
    }

    /// Side of a cell, m.
    pub fn spacing(&self) -> f64 {
        self.cells.spacing()
    }

    /// Whether a cell, by its lower left corner, belongs to the body.
    pub fn has_cell(&self, [column, row]: [i32; 2]) -> bool {
        self.cells.number([column, row, 0]).is_some()
    }

    /// Number of the point at a corner of cells.
    pub fn number(&self, [column, row]: [i32; 2]) -> Option<usize> {
        self.nodes.number([column, row, 0])
    }

    /// Column and row of a point.
    pub fn node(&self, point: usize) -> [i32; 2] {
        let [column, row, _] = self.nodes.cell(point);
        [column, row]
    }

    /// Position of a point, m.
    pub fn place(&self, point: usize) -> [f64; 2] {
        self.nodes.place(point)
    }

    /// Area that a point stands for, m².
    pub fn area(&self, point: usize) -> f64 {
        self.nodes.area(point)
    }

    /// Numbers of the points on the corners of a cell: lower left, lower right, upper left, upper right.
    pub fn corners(&self, [i, j]: [i32; 2]) -> Option<[usize; 4]> {
        let [a, b] = [self.number([i, j])?, self.number([i, j + 1])?];
        // The corners of a cell are next to each other in their rows.
        Some([a, a + 1, b, b + 1])
    }

    /// Columns and rows of all cells.
    pub fn all_cells(&self) -> impl Iterator<Item = [i32; 2]> + '_ {
        self.cells.runs().iter().flat_map(|run| run.columns.clone().map(|column| [column, run.row]))
    }

    /// Sides of the cells that are `inside` beyond which there is no such cell.
    pub fn edges_of(&self, inside: impl Fn([i32; 2]) -> bool) -> Vec<EdgeSegment> {
        let mut edges = Vec::new();
        for [i, j] in self.all_cells().filter(|&cell| inside(cell)) {
            for (outward, ends) in SIDES {
                let beyond = [i + outward[0], j + outward[1]];
                if !(self.has_cell(beyond) && inside(beyond)) {
                    let ends = ends.map(|[a, b]| self.number([i + a, j + b]));
                    if let [Some(a), Some(b)] = ends {
                        let points = [a as u32, b as u32];
                        edges.push(EdgeSegment { points, outward: outward.map(f64::from) });
                    }
                }
            }
        }
        edges
    }

    /// Sides of cells on the edges of the body.
    pub fn edges(&self) -> Vec<EdgeSegment> {
        self.edges_of(|_| true)
    }

    /// Whether the side of a cell from a point to the next one along an axis belongs to the body.
    pub fn is_joined(&self, [i, j]: [i32; 2], axis: usize) -> bool {
        part_along(&|cell| self.has_cell(cell), [i, j], axis) > 0.0
    }

    /// The four cells about a point, whether they belong to the body or not.
    pub(super) fn cells_about(&self, [i, j]: [i32; 2]) -> impl Iterator<Item = [i32; 2]> + use<> {
        [[i - 1, j - 1], [i, j - 1], [i - 1, j], [i, j]].into_iter()
    }
}

/// Which cells count.
pub(super) type Inside<'a> = &'a dyn Fn([i32; 2]) -> bool;

/// Part of a line along the side of a cell that lies in cells that are `inside`, from a point to the next one along an axis: half of it
/// on either side.
pub(super) fn part_along(inside: Inside, [i, j]: [i32; 2], axis: usize) -> f64 {
    let beside = if axis == 0 { [i, j - 1] } else { [i - 1, j] };
    let sides = [[i, j], beside].into_iter().filter(|&cell| inside(cell));
    0.5 * sides.count() as f64
}
