//! Slots thinner than a cell, which part next points.

use super::{Cell, SquareLattice, minus};

/// Steps from a point of a plane to next ones above it, or to its right.
pub(in super::super) const STEPS: [Cell; 4] = [[1, 0, 0], [-1, 1, 0], [0, 1, 0], [1, 1, 0]];

impl SquareLattice {
    /// The lattice with the steps between its points that slots part.
    pub(crate) fn with_slots(mut self, mut slots: Vec<(Cell, u8)>) -> Self {
        slots.sort_unstable();
        slots.dedup();
        self.slots = slots;
        self
    }

    /// The steps that slots part, each by the cell where it begins and its index.
    pub(crate) fn slots(&self) -> &[(Cell, u8)] {
        &self.slots
    }

    /// Whether no slot parts two next cells.
    pub(crate) fn is_open(&self, from: Cell, to: Cell) -> bool {
        if self.slots.is_empty() {
            return true;
        }
        let [step, back] = [minus(to, from), minus(from, to)];
        let parted = |lower: Cell, step: Cell| {
            let index = STEPS.iter().position(|s| *s == step)?;
            self.slots.binary_search(&(lower, index as u8)).ok()
        };
        parted(from, step).or_else(|| parted(to, back)).is_none()
    }
}
