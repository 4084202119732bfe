//! Resultants of what acts on a body in the plane.

use super::super::Resultant;
use super::{PlaneScene, PlaneState};

impl PlaneScene {
    /// Resultant of the loads of a state, as the case asks for them.
    pub fn asked(&self, state: &PlaneState) -> Resultant {
        let mut sum = Resultant::default();
        state.terms.iter().for_each(|&(case, factor)| sum.add_multiple(factor, &self.load_cases[case].asked));
        sum
    }

    /// Which parts of resultants mean anything: forces along x and y, and the moment. Rings have forces along their axis
    /// only, and a line of symmetry takes moments.
    pub fn statical(&self) -> [bool; 3] {
        if self.model.is_revolved() {
            return [false, true, false];
        }
        let mirrors = self.model.lattice().map(|(_, mirrors)| *mirrors).unwrap_or_default();
        match self.model.deflects() {
            true => {
                let turns = mirrors.joined[1] || mirrors.rows == [None; 2];
                [true, false, turns]
            }
            false => [true, true, mirrors.is_none()],
        }
    }

    /// Resultant of forces on the unknowns, component by component. What acts on an image acts on its point, in its mirror.
    pub fn resultant(&self, forces: &[f64]) -> Resultant {
        let (n, turning) = (self.model.point_count(), self.model.turning());
        let lattice = self.model.lattice().filter(|(_, mirrors)| !mirrors.is_none());
        let mut sum = Resultant::default();
        for point in 0..n {
            let mut force = [forces[point], forces[n + point]];
            let mut at = None;
            if let Some((lattice, mirrors)) = lattice {
                let (cell, signs) = mirrors.image(lattice.cell(point));
                (0..2).for_each(|k| force[k] *= signs[k]);
                at = Some(lattice.centre(cell));
            }
            if force != [0.0; 2] {
                self.bonds().add_force(&mut sum, force, at.unwrap_or_else(|| self.model.place(point)));
            }
            if let Some(length) = turning.filter(|_| forces[2 * n + point] != 0.0) {
                sum.add_moment(forces[2 * n + point] * length);
            }
        }
        sum
    }
}
