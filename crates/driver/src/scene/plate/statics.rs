//! Resultants of what acts on a plate.

use super::scene::{PlateScene, PlateState};
use crate::scene::{ASKED, Counted, Resultant};
use peristat_assembly::model::plate_bending::{PHI_X, PHI_Y, PlateNodes, W};

/// Adds a force along z and the moments that do work with the two rotations, at a place. A slope along x is a turn about −y.
pub(super) fn act(sum: &mut Resultant, [force, along_x, along_y]: [f64; 3], [x, y]: [f64; 2]) {
    if force != 0.0 {
        sum.add([0.0, 0.0, force], [x, y, 0.0]);
    }
    if along_y != 0.0 {
        sum.add_moment(0, along_y);
    }
    if along_x != 0.0 {
        sum.add_moment(1, -along_x);
    }
}

/// Resultant of forces on some unknowns, by number.
pub(super) fn resultant(nodes: &PlateNodes, forces: impl Iterator<Item = (usize, f64)>) -> Resultant {
    let (n, mut sum) = (nodes.points(), Resultant::default());
    for (unknown, value) in forces.filter(|force| force.1 != 0.0) {
        let mut parts = [0.0; 3];
        parts[unknown / n] = value;
        act(&mut sum, [parts[W], parts[PHI_X], parts[PHI_Y]], nodes.place(unknown % n));
    }
    sum
}

impl PlateScene {
    /// Resultant of the loads of a state, as the case asks for them.
    pub fn asked(&self, state: &PlateState) -> Resultant {
        let mut sum = Resultant::default();
        state.terms.iter().for_each(|&(case, factor)| sum.add_multiple(factor, &self.load_cases[case].asked));
        sum
    }

    /// Resultant of forces on some unknowns, by number.
    pub fn resultant(&self, forces: impl Iterator<Item = (usize, f64)>) -> Resultant {
        resultant(self.plate.nodes(), forces)
    }

    /// Which parts of resultants mean anything: the force across the plane, and the moments about axes in it.
    pub fn statical(&self) -> Counted {
        Counted { force: [false, false, true], moment: [true, true, false] }
    }

    /// Difference of the loads as asked and as applied, relative to their magnitudes, that is no fault: formulas act by their
    /// values at points.
    pub fn slack(&self, state: &PlateState) -> f64 {
        let is_approximate = |&(case, _): &(usize, f64)| self.load_cases[case].is_approximate;
        if state.terms.iter().any(is_approximate) { f64::INFINITY } else { ASKED }
    }
}
