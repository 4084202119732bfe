//! Points on a square lattice that fill a body in the plane.

mod place;

use super::turn::Turn;
use std::ops::Range;

/// Index of a cell: column and row.
pub type Cell = [i32; 2];

/// Parts in the body of the four triangles of a block, which is the square between four next points: those with their right
/// angles at its lower left, lower right, upper left and upper right point.
pub type Parts = [f64; 4];

/// Centres of the parts of four such triangles, in cells from the first point of the block.
pub type Centres = [[f64; 2]; 4];

/// Consecutive cells of one row that belong to the body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// Row.
    pub row: i32,
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
}

/// Centres of the square cells of a body, numbered row by row from the lower left.
///
/// Rows run along x, or along any other direction ([`turned`](Self::turned)). Only cells of the body have points. What is stored grows with the number of runs of consecutive cells, not with the
/// number of points. Points have the area of a cell, but for those that a border of the body cuts.
#[derive(Clone, Debug, PartialEq)]
pub struct SquareLattice {
    spacing: f64,
    /// Lower left corner of cell `[0, 0]` in the axes of the lattice, m.
    corner: [f64; 2],
    /// Axes that are not x and y.
    turn: Option<Turn>,
    first_row: i32,
    /// Per row: index of its first run; one more at the end.
    rows: Vec<u32>,
    runs: Vec<Run>,
    points: usize,
    /// Points whose areas are not those of a cell, ascending, and their areas per that of a cell.
    cut: Vec<(u32, f64)>,
    /// Blocks that a border cuts, ascending by their lower left cells.
    blocks: Vec<(Cell, Parts)>,
    /// Centres of the parts of these blocks, where they are known.
    centres: Vec<Centres>,
}

impl SquareLattice {
    /// The cells of the ranges `columns` × `rows` that are `inside`. Cell `[0, 0]` has its lower left corner at `corner`;
    /// `spacing` is the side of a cell, m.
    ///
    /// # Panics
    /// More than `u32::MAX` points.
    pub fn new(
        spacing: f64,
        corner: [f64; 2],
        columns: Range<i32>,
        rows: Range<i32>,
        inside: impl Fn(Cell) -> bool,
    ) -> Self {
        let mut lattice = Self {
            spacing,
            corner,
            turn: None,
            first_row: rows.start,
            rows: vec![0],
            runs: Vec::new(),
            points: 0,
            cut: Vec::new(),
            blocks: Vec::new(),
            centres: Vec::new(),
        };
        for row in rows {
            let mut column = columns.start;
            while column < columns.end {
                let from = column;
                while column < columns.end && inside([column, row]) {
                    column += 1;
                }
                lattice.push(row, from..column);
                column += i32::from(column == from);
            }
            lattice.rows.push(lattice.runs.len() as u32);
        }
        assert!(u32::try_from(lattice.points).is_ok(), "points are numbered by u32");
        lattice
    }

    /// A rectangle of `size` cells.
    pub fn rectangle(spacing: f64, corner: [f64; 2], size: [i32; 2]) -> Self {
        let mut lattice = Self::new(spacing, corner, 0..0, 0..0, |_| true);
        for row in 0..size[1] {
            lattice.push(row, 0..size[0]);
            lattice.rows.push(lattice.runs.len() as u32);
        }
        lattice
    }

    /// The lattice with areas of cells, per that of a whole one; other cells are whole. Cells without points have no area.
    pub fn with_areas(mut self, areas: &[(Cell, f64)]) -> Self {
        let numbered = areas.iter().filter(|a| a.1 != 1.0);
        self.cut = numbered.filter_map(|&(cell, area)| Some((self.number(cell)? as u32, area))).collect();
        self.cut.sort_unstable_by_key(|c| c.0);
        self
    }

    /// The lattice with parts of the triangles of blocks, by their lower left cells, where a border cuts them. Of others all is
    /// in the body if their four points are, else nothing.
    pub fn with_blocks(mut self, mut blocks: Vec<(Cell, Parts)>) -> Self {
        blocks.sort_unstable_by_key(|block| block.0);
        self.blocks = blocks;
        self.centres = Vec::new();
        self
    }

    /// The lattice with the centres of the parts of its [`blocks`](Self::blocks), in their order.
    ///
    /// # Panics
    /// There is not one for every block.
    pub fn with_centres(mut self, centres: Vec<Centres>) -> Self {
        assert_eq!(centres.len(), self.blocks.len(), "every block has its centres");
        self.centres = centres;
        self
    }

    /// The lattice with the blocks of another one, and their centres.
    pub(crate) fn with_blocks_of(self, other: &Self) -> Self {
        Self { blocks: other.blocks.clone(), centres: other.centres.clone(), ..self }
    }

    /// Centres of the parts of all blocks, in their order; none where they are not known.
    pub fn centres(&self) -> &[Centres] {
        &self.centres
    }

    /// The blocks that a border cuts, ascending by their lower left cells, with the parts of their triangles; none where all cells
    /// are whole.
    pub fn blocks(&self) -> &[(Cell, Parts)] {
        &self.blocks
    }

    /// The lattice with whole cells.
    pub fn with_whole_cells(self) -> Self {
        Self { cut: Vec::new(), blocks: Vec::new(), centres: Vec::new(), ..self }
    }

    /// Points that have not the area of a cell, ascending, and their areas per that of a cell.
    pub fn cut_cells(&self) -> &[(u32, f64)] {
        &self.cut
    }

    /// Those of [`cut_cells`](Self::cut_cells) among consecutive points.
    pub fn cut_cells_of(&self, points: Range<usize>) -> &[(u32, f64)] {
        let before = |end: usize| self.cut.partition_point(|&(p, _)| (p as usize) < end);
        &self.cut[before(points.start)..before(points.end)]
    }

    /// Area of a point per that of a whole cell.
    pub fn fraction(&self, point: usize) -> f64 {
        let found = self.cut.binary_search_by_key(&point, |c| c.0 as usize);
        found.map_or(1.0, |index| self.cut[index].1)
    }

    /// Area of a point, m².
    pub fn area(&self, point: usize) -> f64 {
        self.fraction(point) * (self.spacing * self.spacing)
    }

    fn push(&mut self, row: i32, columns: Range<i32>) {
        if !columns.is_empty() {
            let count = columns.len();
            self.runs.push(Run { row, columns, first: self.points });
            self.points += count;
        }
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
        self.first_row..self.first_row + self.rows.len() as i32 - 1
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

    /// Runs of a row from left to right; none for a row without cells.
    pub fn runs_of(&self, row: i32) -> &[Run] {
        let k = row - self.first_row;
        if k < 0 || k as usize + 1 >= self.rows.len() {
            return &[];
        }
        &self.runs[self.rows[k as usize] as usize..self.rows[k as usize + 1] as usize]
    }

    /// Number of the point in a cell.
    pub fn number(&self, [column, row]: Cell) -> Option<usize> {
        let run = self.runs_of(row).iter().find(|r| r.columns.contains(&column))?;
        Some(run.number(column))
    }

    /// Cell of a point.
    pub fn cell(&self, point: usize) -> Cell {
        let run = &self.runs[self.runs.partition_point(|r| r.first <= point) - 1];
        [run.columns.start + (point - run.first) as i32, run.row]
    }

    /// The cell of twice the size that a cell becomes part of.
    pub fn parent([column, row]: Cell) -> Cell {
        [column.div_euclid(2), row.div_euclid(2)]
    }

    /// The lattice of twice the spacing in the same axes: a cell belongs to it if any of the four that it covers does. If this one has cells
    /// that are not whole, areas of cells are sums of those that they cover, else all are whole.
    pub fn coarser(&self) -> Self {
        let halved = |range: Range<i32>| range.start.div_euclid(2)..(range.end + 1).div_euclid(2);
        let rows = halved(self.rows());
        let mut coarse = Self::new(2.0 * self.spacing, self.corner, 0..0, rows.start..rows.start, |_| true);
        coarse.turn = self.turn;
        for row in rows {
            let fine = self.runs_of(2 * row).iter().chain(self.runs_of(2 * row + 1));
            let mut spans: Vec<Range<i32>> = fine.map(|r| halved(r.columns.clone())).collect();
            spans.sort_by_key(|s| s.start);
            let mut merged: Vec<Range<i32>> = Vec::new();
            for span in spans {
                match merged.last_mut() {
                    Some(last) if span.start <= last.end => last.end = last.end.max(span.end),
                    _ => merged.push(span),
                }
            }
            merged.into_iter().for_each(|columns| coarse.push(row, columns));
            coarse.rows.push(coarse.runs.len() as u32);
        }
        if !self.cut.is_empty() {
            coarse.cut = (0..coarse.points)
                .map(|p| (p as u32, self.area_below(coarse.cell(p))))
                .filter(|c| c.1 != 1.0)
                .collect();
        }
        coarse
    }

    /// Area of the four cells that a cell of twice the spacing covers, per that of it.
    fn area_below(&self, [column, row]: Cell) -> f64 {
        let children = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[a, b]| [2 * column + a, 2 * row + b]);
        0.25 * children.iter().filter_map(|c| Some(self.fraction(self.number(*c)?))).sum::<f64>()
    }

    /// Stretches of points whose neighbours at an offset follow each other, too: for every run of `cells`, columns of the
    /// row `row`, calls `visit` with the columns and the number of the first neighbour.
    #[inline]
    pub fn shifted(
        &self,
        row: i32,
        columns: &Range<i32>,
        step: Cell,
        mut visit: impl FnMut(Range<i32>, usize),
    ) {
        for run in self.runs_of(row + step[1]) {
            let from = columns.start.max(run.columns.start - step[0]);
            let to = columns.end.min(run.columns.end - step[0]);
            if from < to {
                visit(from..to, run.number(from + step[0]));
            }
        }
    }
}

#[cfg(test)]
mod tests;
