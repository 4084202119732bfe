//! Points on a lattice that fill a body: layers of rows of square or cubic cells. A plane is one layer.

mod cell;
mod coarser;
mod cut;
mod place;
mod slots;
mod within;

pub use cell::{minus, plus};
pub(super) use slots::STEPS;

use super::turn::Turn;
use std::ops::Range;

/// Index of a cell: column, row and layer. The layer of a plane is 0.
pub type Cell = [i32; 3];

/// Parts in the body of the four triangles of a block, which is the square between four next points: those with their right
/// angles at its lower left, lower right, upper left and upper right point.
pub type TriangleParts = [f64; 4];

/// Centres of the parts of four such triangles, in cells from the first point of the block.
pub type Centres = [[f64; 2]; 4];

/// Consecutive cells of one row that belong to the body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// Row.
    pub row: i32,
    /// Layer.
    pub layer: i32,
    /// Columns.
    pub columns: Range<i32>,
    /// Number of the point in the first cell.
    pub first: usize,
}

impl Run {
    /// Numbers of its points.
    pub fn points(&self) -> Range<usize> {
        self.first..self.first + self.columns.len()
    }

    /// Number of the point in a column of the run.
    pub fn number(&self, column: i32) -> usize {
        self.first + (column - self.columns.start) as usize
    }

    /// The cell in a column.
    pub fn cell(&self, column: i32) -> Cell {
        [column, self.row, self.layer]
    }

    /// Row and layer.
    pub fn line(&self) -> [i32; 2] {
        [self.row, self.layer]
    }
}

/// Centres of the cells of a body, numbered layer by layer and row by row from the lower left.
///
/// Rows run along x, or in the plane along any other direction ([`turned`](Self::turned)). Only cells of the body have points.
/// What is stored grows with the number of runs of consecutive cells, not with the number of points. Points have the area of a
/// cell, but for those that a border of the body cuts.
///
/// A lattice of one layer is a plane: its cells are squares, and so are those of the [`coarser`](Self::coarser) one. Cells in
/// several layers are cubes, and what is said of their areas is so of their volumes.
#[derive(Clone, Debug, PartialEq)]
pub struct SquareLattice {
    spacing: f64,
    /// Lowest corner of cell `[0, 0, 0]` in the axes of the lattice, m. Points of a plane have z = 0.
    corner: [f64; 3],
    /// Axes that are not x and y.
    turn: Option<Turn>,
    /// First row and layer that can hold cells.
    first: [i32; 2],
    /// Number of such rows and layers.
    lines: [u32; 2],
    /// Per layer and row: index of its first run; one more at the end.
    starts: Vec<u32>,
    runs: Vec<Run>,
    points: usize,
    /// Points whose areas are not those of a cell, ascending, and their areas per that of a cell.
    cut: Vec<(u32, f64)>,
    /// Blocks that a border of a plane cuts, ascending by their lower left cells.
    blocks: Vec<(Cell, TriangleParts)>,
    /// Centres of the parts of these blocks, where they are known.
    centres: Vec<Centres>,
    /// Steps between next points that slots thinner than a cell part, by the lower cell and the index of the step, ascending.
    slots: Vec<(Cell, u8)>,
}

impl SquareLattice {
    /// The cells of the ranges of columns, rows and layers that are `inside`. Cell `[0, 0, 0]` has its lowest corner at `corner`;
    /// `spacing` is the side of a cell, m.
    ///
    /// # Panics
    /// More than `u32::MAX` points.
    pub fn new(
        spacing: f64,
        corner: [f64; 3],
        [columns, rows, layers]: [Range<i32>; 3],
        inside: impl Fn(Cell) -> bool,
    ) -> Self {
        let mut lattice = Self::empty(spacing, corner, [rows.clone(), layers.clone()]);
        for line in layers.flat_map(|layer| rows.clone().map(move |row| [row, layer])) {
            let mut column = columns.start;
            while column < columns.end {
                let from = column;
                while column < columns.end && inside([column, line[0], line[1]]) {
                    column += 1;
                }
                lattice.push(line, from..column);
                column += i32::from(column == from);
            }
            lattice.end_line();
        }
        assert!(u32::try_from(lattice.points).is_ok(), "points are numbered by u32");
        lattice
    }

    /// The cells of rows and layers from zero on that have these columns, in order and apart from each other.
    ///
    /// # Panics
    /// More than `u32::MAX` points.
    pub fn of_lines(
        spacing: f64,
        corner: [f64; 3],
        [rows, layers]: [i32; 2],
        mut columns: impl FnMut([i32; 2]) -> Vec<Range<i32>>,
    ) -> Self {
        let mut lattice = Self::empty(spacing, corner, [0..rows, 0..layers]);
        for line in (0..layers).flat_map(|layer| (0..rows).map(move |row| [row, layer])) {
            columns(line).into_iter().for_each(|range| lattice.push(line, range));
            lattice.end_line();
        }
        assert!(u32::try_from(lattice.points).is_ok(), "points are numbered by u32");
        lattice
    }

    /// The cells of a plane, of the ranges `columns` × `rows`, that are `inside`. Cell `[0, 0, 0]` has its lower left corner at
    /// `corner`; `spacing` is the side of a cell, m.
    ///
    /// # Panics
    /// More than `u32::MAX` points.
    pub fn plane(
        spacing: f64,
        corner: [f64; 2],
        columns: Range<i32>,
        rows: Range<i32>,
        inside: impl Fn([i32; 2]) -> bool,
    ) -> Self {
        Self::new(spacing, in_plane(corner, spacing), [columns, rows, 0..1], |[i, j, _]| inside([i, j]))
    }

    /// A rectangle of `size` cells.
    pub fn rectangle(spacing: f64, corner: [f64; 2], [columns, rows]: [i32; 2]) -> Self {
        Self::cuboid(spacing, in_plane(corner, spacing), [columns, rows, 1])
    }

    /// A box of `size` cells. `corner` is its lowest one, m.
    pub fn cuboid(spacing: f64, corner: [f64; 3], [columns, rows, layers]: [i32; 3]) -> Self {
        let mut lattice = Self::empty(spacing, corner, [0..rows, 0..layers]);
        for line in (0..layers).flat_map(|layer| (0..rows).map(move |row| [row, layer])) {
            lattice.push(line, 0..columns);
            lattice.end_line();
        }
        lattice
    }

    /// No cells; those of every line are to be pushed, and every line is to be ended, in order.
    fn empty(spacing: f64, corner: [f64; 3], lines: [Range<i32>; 2]) -> Self {
        Self {
            spacing,
            corner,
            turn: None,
            first: [lines[0].start, lines[1].start],
            lines: lines.map(|range| range.len() as u32),
            starts: vec![0],
            runs: Vec::new(),
            points: 0,
            cut: Vec::new(),
            blocks: Vec::new(),
            centres: Vec::new(),
            slots: Vec::new(),
        }
    }

    fn push(&mut self, [row, layer]: [i32; 2], columns: Range<i32>) {
        if !columns.is_empty() {
            let count = columns.len();
            self.runs.push(Run { row, layer, columns, first: self.points });
            self.points += count;
        }
    }

    fn end_line(&mut self) {
        self.starts.push(self.runs.len() as u32);
    }

    /// Side of a cell, m.
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.points
    }

    /// Rows that can hold cells.
    pub fn rows(&self) -> Range<i32> {
        self.range(0)
    }

    /// Layers that can hold cells.
    pub fn layers(&self) -> Range<i32> {
        self.range(1)
    }

    fn range(&self, axis: usize) -> Range<i32> {
        self.first[axis]..self.first[axis] + self.lines[axis] as i32
    }

    /// Whether there is one layer alone.
    pub fn is_plane(&self) -> bool {
        self.lines[1] == 1
    }

    /// Columns from the first cell to behind the last.
    pub fn columns(&self) -> Range<i32> {
        let from = self.runs.iter().map(|r| r.columns.start).min().unwrap_or(0);
        from..self.runs.iter().map(|r| r.columns.end).max().unwrap_or(from)
    }

    /// All runs, in the order of their points.
    pub fn runs(&self) -> &[Run] {
        &self.runs
    }

    /// Which of the lines a row of a layer is, layer by layer; none where it can hold no cells.
    #[inline]
    pub(crate) fn line(&self, [row, layer]: [i32; 2]) -> Option<usize> {
        let [row, layer] = [row - self.first[0], layer - self.first[1]].map(|k| k as u32);
        // Those before the first are far behind the last, too.
        let is_there = row < self.lines[0] && layer < self.lines[1];
        is_there.then(|| layer as usize * self.lines[0] as usize + row as usize)
    }

    /// Runs of a row of a layer from left to right; none where there are no cells.
    #[inline]
    pub fn runs_of(&self, row: i32, layer: i32) -> &[Run] {
        match self.line([row, layer]) {
            Some(line) => &self.runs[self.starts[line] as usize..self.starts[line + 1] as usize],
            None => &[],
        }
    }

    /// Number of the point in a cell.
    #[inline]
    pub fn number(&self, [column, row, layer]: Cell) -> Option<usize> {
        let run = self.runs_of(row, layer).iter().find(|r| r.columns.contains(&column))?;
        Some(run.number(column))
    }

    /// Cell of a point.
    pub fn cell(&self, point: usize) -> Cell {
        let run = &self.runs[self.runs.partition_point(|r| r.first <= point) - 1];
        run.cell(run.columns.start + (point - run.first) as i32)
    }

    /// Stretches of points whose neighbours at an offset follow each other, too: for the `columns` of a row and layer, calls
    /// `visit` with those of every stretch and the number of the first neighbour.
    ///
    /// Always inlined: what `visit` does is compiled for the vectors that its caller has.
    #[inline(always)]
    pub fn shifted(
        &self,
        [row, layer]: [i32; 2],
        columns: &Range<i32>,
        step: Cell,
        mut visit: impl FnMut(Range<i32>, usize),
    ) {
        for run in self.runs_of(row + step[1], layer + step[2]) {
            let from = columns.start.max(run.columns.start - step[0]);
            let to = columns.end.min(run.columns.end - step[0]);
            if from < to {
                visit(from..to, run.number(from + step[0]));
            }
        }
    }
}

/// The lowest corner of a plane whose points have z = 0.
fn in_plane([x, y]: [f64; 2], spacing: f64) -> [f64; 3] {
    [x, y, -0.5 * spacing]
}

#[cfg(test)]
mod tests;
