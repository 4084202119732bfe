//! The lattice of twice the spacing.

use super::{Cell, SquareLattice};
use std::ops::Range;

impl SquareLattice {
    /// The cell of twice the size that a cell becomes part of.
    pub fn parent(cell: Cell) -> Cell {
        cell.map(|k| k.div_euclid(2))
    }

    /// The lattice of twice the spacing in the same axes: a cell belongs to it if any of those that it covers does, eight, or
    /// four in a plane, which stays in its middle. If this one has cells that are not whole, areas of cells are sums of those
    /// that they cover, else all are whole.
    pub fn coarser(&self) -> Self {
        let [rows, layers] = [halved(&self.rows()), halved(&self.layers())];
        let mut coarse = Self::empty(2.0 * self.spacing, self.corner, [rows.clone(), layers.clone()]);
        coarse.turn = self.turn;
        if self.is_plane() {
            let moved = self.first[1] - 2 * layers.start;
            coarse.corner[2] += (f64::from(moved) - 0.5) * self.spacing;
        }
        for [row, layer] in layers.flat_map(|layer| rows.clone().map(move |row| [row, layer])) {
            self.halved_line([row, layer]).into_iter().for_each(|columns| coarse.push([row, layer], columns));
            coarse.end_line();
        }
        if !self.cut.is_empty() {
            coarse.cut = (0..coarse.points)
                .map(|p| (p as u32, self.area_below(coarse.cell(p))))
                .filter(|c| c.1 != 1.0)
                .collect();
        }
        coarse
    }

    /// Columns of the coarser cells of a line.
    fn halved_line(&self, [row, layer]: [i32; 2]) -> Vec<Range<i32>> {
        let below = [2 * layer, 2 * layer + 1].into_iter().flat_map(|l| [[2 * row, l], [2 * row + 1, l]]);
        let fine = below.flat_map(|[row, layer]| self.runs_of(row, layer));
        let mut spans: Vec<Range<i32>> = fine.map(|r| halved(&r.columns)).collect();
        spans.sort_by_key(|s| s.start);
        let mut merged: Vec<Range<i32>> = Vec::new();
        for span in spans {
            match merged.last_mut() {
                Some(last) if span.start <= last.end => last.end = last.end.max(span.end),
                _ => merged.push(span),
            }
        }
        merged
    }

    /// Area of the cells that a cell of twice the spacing covers, per that of it.
    fn area_below(&self, cell: Cell) -> f64 {
        let part = if self.is_plane() { 0.25 } else { 0.125 };
        let children = (0..8).map(|child| [0, 1, 2].map(|k| 2 * cell[k] + (child >> k & 1)));
        part * children.filter_map(|c| Some(self.fraction(self.number(c)?))).sum::<f64>()
    }
}

fn halved(range: &Range<i32>) -> Range<i32> {
    range.start.div_euclid(2)..(range.end + 1).div_euclid(2)
}
