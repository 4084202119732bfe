//! The cells that a bond passes, and where it goes from one to the next.

use crate::body::Cell;

/// The way of a bond from the cell of its first point to that of its second one.
#[derive(Clone, Debug)]
pub(in super::super::super::super) struct Path {
    /// Cells in their order, from that of the first point.
    pub(super) cells: Vec<Cell>,
    /// Shares of its length at which it enters the cells, and one.
    pub(super) entries: Vec<f64>,
    offset: Cell,
}

impl Path {
    /// That of an offset. A bond that goes through a corner or an edge of cells has no part in the cells beside it.
    pub(in super::super::super::super) fn of(offset: Cell) -> Self {
        // Borders of cells are half a spacing beyond their centres; times 2 |a| |b| |c| all shares are whole numbers.
        let counts = offset.map(|x| x.unsigned_abs().max(1));
        let all: u32 = counts.iter().product();
        let mut shares: Vec<u32> = vec![0];
        for (count, _) in counts.iter().zip(offset).filter(|(_, along)| *along != 0) {
            shares.extend((0..*count).map(|q| (2 * q + 1) * (all / count)));
        }
        shares.push(2 * all);
        shares.sort_unstable();
        shares.dedup();
        let whole = f64::from(2 * all);
        let entries: Vec<f64> = shares.iter().map(|&s| f64::from(s) / whole).collect();
        let cell = |ends: &[f64]| offset.map(|x| (f64::from(x) * 0.5 * (ends[0] + ends[1])).round() as i32);
        Self { cells: entries.windows(2).map(cell).collect(), entries, offset }
    }

    /// Its cells, from that of the first point, and the parts of its length that they have.
    pub(in super::super::super::super) fn pieces(&self) -> impl Iterator<Item = (Cell, f64)> + '_ {
        self.cells.iter().zip(self.entries.windows(2)).map(|(cell, ends)| (*cell, ends[1] - ends[0]))
    }

    /// The place at a share of its length, in spacings from the first point.
    pub(super) fn at(&self, share: f64) -> [f64; 3] {
        self.offset.map(|x| f64::from(x) * share)
    }

    /// Where it enters a cell, or behind the last one its end, in spacings from the first point.
    pub(super) fn place(&self, piece: usize) -> [f64; 3] {
        self.at(self.entries[piece])
    }

    /// Share of its length from where it enters one cell to where it enters another.
    pub(super) fn share(&self, from: usize, to: usize) -> f64 {
        self.entries[to] - self.entries[from]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bonds_pass_cells_one_after_the_other() {
        let straight = Path::of([0, 2, 0]);
        assert_eq!(straight.cells, [[0, 0, 0], [0, 1, 0], [0, 2, 0]]);
        assert_eq!(straight.entries, [0.0, 0.25, 0.75, 1.0]);
        let diagonal = Path::of([-1, 1, 0]);
        assert_eq!((diagonal.cells.len(), diagonal.place(1)), (2, [-0.5, 0.5, 0.0]));
        let steep = Path::of([1, 2, 0]);
        assert_eq!(steep.cells, [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 2, 0]]);
        assert_eq!(steep.place(2), [0.5, 1.0, 0.0]);
        assert!((steep.share(1, 3) - 0.5).abs() < 1e-15);
        let solid = Path::of([1, -1, 2]);
        assert_eq!(solid.cells, [[0, 0, 0], [0, 0, 1], [1, -1, 1], [1, -1, 2]]);
        assert_eq!(solid.place(2), [0.5, -0.5, 1.0]);
    }
}
