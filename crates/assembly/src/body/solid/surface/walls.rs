//! Walls of a body that a surface bounds.

use super::super::super::lattice::SquareLattice;
use super::super::shape::SIDES;
use super::super::wall::Wall;
use super::facets::Surface;
use super::grid::Grid;
use super::patch::{Part, REST};

impl Surface {
    /// Its walls on the cells inside: a wall for every name of it, those without a name that lie flat on sides of the box around it by
    /// the names of the sides, and all others as `rest`. Every side of a cell on the border is in one.
    pub fn walls(&self, grid: &Grid, lattice: &SquareLattice) -> Vec<Wall> {
        let patches = self.patches(grid, lattice).into_iter();
        let there = patches.filter(|(part, patch)| matches!(part, Part::Named(_)) || patch.is_there());
        let wall = |(part, patch): (Part, super::Patch)| {
            let name = match part {
                Part::Named(name) => self.names[name as usize].clone(),
                Part::Side(side) => SIDES[side].to_string(),
                Part::Rest => REST.to_string(),
            };
            let face = patch.plane(lattice);
            Wall::of_surface(name, face, patch)
        };
        there.map(wall).collect()
    }
}
