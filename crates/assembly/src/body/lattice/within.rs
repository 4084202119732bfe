//! The part of a lattice in a box of cells.

use super::slots::STEPS;
use super::{Cell, SquareLattice, plus};
use std::ops::Range;

impl SquareLattice {
    /// The cells in ranges of columns, rows and layers, where they are; their areas are kept, and blocks and slots between them.
    /// Points are numbered anew.
    pub fn within(&self, ranges: &[Range<i32>; 3]) -> Self {
        let [columns, rows, layers] = ranges;
        let clipped = |of: Range<i32>, by: &Range<i32>| of.start.max(by.start)..of.end.min(by.end);
        let lines = [clipped(self.rows(), rows), clipped(self.layers(), layers)];
        let mut part = Self::empty(self.spacing, self.corner, lines.clone());
        part.turn = self.turn;
        let [rows, layers] = lines;
        for [row, layer] in layers.flat_map(|layer| rows.clone().map(move |row| [row, layer])) {
            for run in self.runs_of(row, layer) {
                part.push([row, layer], clipped(run.columns.clone(), columns));
            }
            part.end_line();
        }
        let cut = self.cut.iter().map(|&(point, area)| (self.cell(point as usize), area));
        let mut part = part.with_areas(&cut.collect::<Vec<_>>());
        let is_in = |cell: Cell| cell.iter().zip(ranges).all(|(k, range)| range.contains(k));
        let is_whole = |cell: Cell| is_in(cell) && is_in(plus(cell, [1, 1, 0]));
        let blocks = self.blocks.iter().filter(|block| is_whole(block.0));
        part.blocks = blocks.copied().collect();
        let centres = self.blocks.iter().zip(&self.centres).filter(|(block, _)| is_whole(block.0));
        part.centres = centres.map(|(_, centres)| *centres).collect();
        let slots =
            self.slots.iter().filter(|slot| is_in(slot.0) && is_in(plus(slot.0, STEPS[slot.1 as usize])));
        part.slots = slots.copied().collect();
        part
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_has_the_cells_of_its_box_where_they_were() {
        let hole = |[i, j, k]: Cell| i == 2 && j == 1 && k < 2;
        let whole = SquareLattice::new(0.5, [1.0, 2.0, 3.0], [0..5, 0..4, 0..3], |cell| !hole(cell));
        let areas = [([1, 1, 1], 0.5), ([4, 3, 2], 0.25)];
        let whole = whole.with_areas(&areas);
        let ranges = [1..4, -7..3, 1..9];
        let part = whole.within(&ranges);
        let inside = |cell: &Cell| cell.iter().zip(&ranges).all(|(k, range)| range.contains(k));
        let expected: Vec<Cell> = (0..whole.points()).map(|p| whole.cell(p)).filter(inside).collect();
        let found: Vec<Cell> = (0..part.points()).map(|p| part.cell(p)).collect();
        assert_eq!((found, part.points()), (expected, 3 * 3 * 2 - 1));
        for point in 0..part.points() {
            let cell = part.cell(point);
            let there = whole.number(cell).unwrap();
            assert_eq!((part.number(cell), part.position(point)), (Some(point), whole.position(there)));
            assert_eq!(part.fraction(point), whole.fraction(there));
        }
    }

    #[test]
    fn blocks_and_slots_need_all_of_their_cells() {
        let parts = |k: f64| [k; 4];
        let blocks = vec![([0, 0, 0], parts(0.1)), ([1, 1, 0], parts(0.2)), ([2, 1, 0], parts(0.3))];
        let whole = SquareLattice::rectangle(1.0, [0.0; 2], [4, 4]).with_blocks(blocks);
        let whole = whole.with_slots(vec![([1, 1, 0], 0), ([2, 1, 0], 0), ([1, 0, 0], 1)]);
        let part = whole.within(&[1..3, 1..4, 0..1]);
        assert_eq!(part.blocks(), [([1, 1, 0], parts(0.2))]);
        assert_eq!(part.slots(), [([1, 1, 0], 0)]);
    }
}
