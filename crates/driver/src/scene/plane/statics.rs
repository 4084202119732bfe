//! Resultants of what acts on a body in the plane.

use super::super::Resultant;
use super::{PlaneScene, PlaneState};
use crate::model::Material;
use peristat_assembly::model::plane::PlaneModel;

impl PlaneScene {
    /// Resultant of the loads of a state, as the case asks for them.
    pub fn asked(&self, state: &PlaneState) -> Resultant {
        let mut sum = Resultant::default();
        state.terms.iter().for_each(|&(case, factor)| sum.add_multiple(factor, &self.load_cases[case].asked));
        sum
    }

    /// Which parts of resultants mean anything: forces along x and y, and the moment.
    pub fn statical(&self) -> [bool; 3] {
        statical(&*self.model)
    }

    /// Whether discrete loads have exactly the resultant that is asked for. One stress in all of a body of revolution is exact for
    /// the energies of its points, which beside the axis, and in bodies thinner than the horizon, have other volumes than these.
    pub fn loads_are_exact(&self, state: &PlaneState) -> bool {
        let has_one_stress = |&(case, _): &(usize, f64)| self.load_cases[case].carry_ends;
        !(self.model.is_revolved() && state.terms.iter().any(has_one_stress))
    }

    /// Along which axes the loads of a state do more through a line of symmetry than they are asked for: inside the body.
    pub fn inside(&self, state: &PlaneState) -> [bool; 2] {
        [0, 1].map(|axis| state.terms.iter().any(|&(case, _)| self.load_cases[case].inside[axis]))
    }

    /// What the loads of a state on images do to lines of symmetry at once, by images: a border moves with points on both sides of
    /// a line that it meets, and across the line what acts on one is taken by the line together with as much of its point.
    pub fn into_mirrors(&self, state: &PlaneState, factor: f64) -> Vec<(u32, [f64; 2])> {
        let Some((lattice, mirrors)) = self.model.lattice().filter(|(_, mirrors)| !mirrors.is_none()) else {
            return Vec::new();
        };
        let turned = |&(point, force): &(u32, [f64; 2])| {
            let (_, signs) = mirrors.image(lattice.cell(point as usize));
            let taken = [0, 1].map(|k| (1.0 - signs[k]) * force[k]);
            (taken != [0.0; 2]).then_some((point, taken))
        };
        let of_case = |&(case, part): &(usize, f64)| {
            let forces = self.load_cases[case].forces.iter().filter_map(turned);
            forces.map(move |(point, force)| (point, force.map(|f| part * factor * f)))
        };
        state.terms.iter().flat_map(of_case).collect()
    }

    /// Resultant of forces on the unknowns, component by component.
    pub fn resultant(&self, forces: &[f64]) -> Resultant {
        resultant(&*self.model, self.material(), forces)
    }
}

/// Which parts of resultants mean anything: forces along x and y, and the moment. Rings have forces along their axis only, and
/// a line of symmetry takes moments.
pub(super) fn statical(model: &dyn PlaneModel) -> [bool; 3] {
    if model.is_revolved() {
        return [false, true, false];
    }
    let mirrors = model.lattice().map(|(_, mirrors)| *mirrors).unwrap_or_default();
    match model.component("w").is_some() {
        true => [true, false, mirrors.joined[1] || mirrors.lines[1] == [None; 2]],
        false => [true, true, mirrors.is_none()],
    }
}

/// Adds a force, N, at a position to a resultant: what a shell has along its circumference turns it about its axis.
pub(super) fn add_force(material: &dyn Material, to: &mut Resultant, force: [f64; 2], at: [f64; 2]) {
    match material.cylinder_radius() {
        Some(radius) => {
            to.add([force[0], 0.0], [0.0; 2]);
            to.add_moment(radius * force[1]);
        }
        None => to.add(force, at),
    }
}

/// Resultant of forces on the unknowns of a model, component by component. What acts on an image acts on its point, in its
/// mirror.
pub(super) fn resultant(model: &dyn PlaneModel, material: &dyn Material, forces: &[f64]) -> Resultant {
    let n = model.points();
    let turning = model.component("phi").map(|(_, phi)| phi.scale);
    let lattice = model.lattice().filter(|(_, mirrors)| !mirrors.is_none());
    let mut sum = Resultant::default();
    for point in 0..n {
        let mut force = [forces[point], forces[n + point]];
        let turn = turning.map_or(0.0, |length| length * forces[2 * n + point]);
        if force == [0.0; 2] && turn == 0.0 {
            continue;
        }
        let mut at = model.place(point);
        if let Some((lattice, mirrors)) = lattice {
            let (cell, signs) = mirrors.image(lattice.cell(point));
            (0..2).for_each(|k| force[k] *= signs[k]);
            at = lattice.place_of(cell);
        }
        add_force(material, &mut sum, force, at);
        if turn != 0.0 {
            sum.add_moment(turn);
        }
    }
    sum
}
