//! Sums and differences of cells.

use super::Cell;

/// The cell at an offset from another one.
pub fn plus(cell: Cell, step: Cell) -> Cell {
    [0, 1, 2].map(|k| cell[k] + step[k])
}

/// The offset from a cell to another one.
pub fn minus(cell: Cell, from: Cell) -> Cell {
    [0, 1, 2].map(|k| cell[k] - from[k])
}
