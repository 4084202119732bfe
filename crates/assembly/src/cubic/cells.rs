//! Which cells of a grid belong to a body, and which of their components rest.

use super::grid::Grid;
use crate::bonds::Mat;
use std::collections::HashMap;

/// The bit of a cell that belongs to the body.
pub(super) const SOLID: u8 = 8;
/// How far the bits of components that follow others are from those of components that rest.
pub(super) const FOLLOWING: u8 = 4;

/// The cells of a level.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    pub(super) grid: Grid,
    /// Per place: [`SOLID`], and a bit for each component that rests or follows others.
    pub(super) state: Vec<u8>,
    /// Springs to the ground, N/m, by place.
    pub(super) springs: HashMap<usize, Mat<3, 3>>,
    /// Along every axis, cells by which the first one is behind a cell of the coarser grid.
    pub(super) shift: [usize; 3],
}

impl Cells {
    pub(super) fn new(grid: Grid) -> Self {
        let state = vec![0; grid.len()];
        // Cells meet those of the coarser grid at planes of symmetry.
        let shift = |k: usize| {
            let is_odd = grid.cells[k] % 2 == 1;
            usize::from(grid.mirrored[k] == [false, true] && is_odd)
        };
        let shift = [0, 1, 2].map(shift);
        Self { grid, state, springs: HashMap::new(), shift }
    }

    /// Whether the grid has a coarser one: a number of cells between two planes of symmetry that can be halved.
    pub(super) fn can_be_coarser(&self) -> bool {
        (0..3).all(|k| self.grid.mirrored[k] != [true; 2] || self.grid.cells[k].is_multiple_of(2))
    }

    /// The cells of twice the spacing: of the body, and at rest, if any of those that they cover is.
    pub(super) fn coarser(&self) -> Self {
        let Grid { cells, rim, mirrored, .. } = self.grid;
        let halved = |k: usize| (cells[k] + self.shift[k]).div_ceil(2);
        let mut coarse = Self::new(Grid::new([0, 1, 2].map(halved), rim, mirrored));
        self.grid.for_each(|cell, place| {
            let parent = coarse.grid.at([0, 1, 2].map(|k| ((cell[k] + self.shift[k]) / 2) as i64));
            // What follows others beside a face that is held rests on a coarser grid.
            coarse.state[parent] |= self.state[place] & 15 | self.state[place] >> FOLLOWING;
            if let Some(spring) = self.springs.get(&place) {
                coarse.add_spring(parent, spring);
            }
        });
        coarse.finish();
        coarse
    }

    pub(super) fn add_spring(&mut self, place: usize, spring: &Mat<3, 3>) {
        let sum = self.springs.entry(place).or_insert([[0.0; 3]; 3]);
        (0..9).for_each(|k| sum[k / 3][k % 3] += spring[k / 3][k % 3]);
    }

    /// Completes the rim, once all cells have their states.
    pub(super) fn finish(&mut self) {
        self.grid.mirror(&mut self.state, |state, _| state);
    }

    pub(super) fn is_solid(&self, place: usize) -> bool {
        self.state[place] & SOLID != 0
    }
}
