//! Resultants of what acts on a body.

use super::scene::{BodyScene, BodyState};
use crate::model::Material;
use crate::scene::body::load::eigenstrain::Eigenstrain;
use crate::scene::body::load::sums::Forces;
use crate::scene::{ASKED, Counted, Resultant};
use peristat_assembly::model::BodyModel;

/// Difference of loads by formulas as asked and as applied: two rules of integration that see a kink within a cell.
const KINKS: f64 = 1e-3;

impl BodyScene {
    /// Resultant of the loads of a state, as the case asks for them.
    pub fn asked(&self, state: &BodyState) -> Resultant {
        let mut sum = Resultant::default();
        state.terms.iter().for_each(|&(case, factor)| sum.add_multiple(factor, &self.load_cases[case].asked));
        sum
    }

    /// Which parts of resultants mean anything.
    pub fn statical(&self) -> Counted {
        statical(&*self.model, self.material())
    }

    /// Difference of the loads as asked and as applied, relative to their magnitudes, that is no fault. One stress in all of a body of
    /// revolution is exact for the energies of its points, which beside the axis, and in bodies thinner than the horizon, have other
    /// volumes than these; formulas may have kinks.
    pub fn slack(&self, state: &BodyState) -> f64 {
        let has_one_stress = |&(case, _): &(usize, f64)| self.load_cases[case].carry_ends;
        let by_formula = |&(case, _): &(usize, f64)| self.load_cases[case].by_formula;
        if self.material().surface().axis().is_some() && state.terms.iter().any(has_one_stress) {
            f64::INFINITY
        } else if state.terms.iter().any(by_formula) {
            KINKS
        } else {
            ASKED
        }
    }

    /// Along which axes the loads of a state do more through a line of symmetry than they are asked for: inside the body.
    pub fn inside(&self, state: &BodyState) -> [bool; 3] {
        [0, 1, 2].map(|axis| state.terms.iter().any(|&(case, _)| self.load_cases[case].inside[axis]))
    }

    /// Strains of a state that need no stress.
    pub fn eigenstrain(&self, state: &BodyState) -> Option<Eigenstrain> {
        let of_case =
            |&(case, factor): &(usize, f64)| Some((self.load_cases[case].eigenstrain.as_ref()?, factor));
        let mut terms = state.terms.iter().filter_map(of_case);
        let (first, factor) = terms.next()?;
        Some(terms.fold(first.clone().times(factor), |sum, (own, factor)| sum.plus(factor, own)))
    }

    /// What the loads of a state on images do to lines of symmetry at once, by images: a border moves with points on both sides of
    /// a line that it meets, and across the line what acts on one is taken by the line together with as much of its point.
    pub fn into_mirrors(&self, state: &BodyState, factor: f64) -> Forces {
        let Some((lattice, mirrors)) = self.model.lattice().filter(|(_, mirrors)| !mirrors.is_none()) else {
            return Vec::new();
        };
        let turned = |&(point, force): &(u32, [f64; 3])| {
            let (_, signs) = mirrors.image(lattice.cell(point as usize));
            let taken = [0, 1, 2].map(|k| (1.0 - signs[k]) * force[k]);
            (taken != [0.0; 3]).then_some((point, taken))
        };
        let of_case = |&(case, part): &(usize, f64)| {
            let at_once = self.load_cases[case].into_lines.iter().copied();
            let forces = self.load_cases[case].forces.iter().filter_map(turned).chain(at_once);
            forces.map(move |(point, force)| (point, force.map(|f| part * factor * f)))
        };
        state.terms.iter().flat_map(of_case).collect()
    }

    /// Resultant of forces on the unknowns, component by component.
    pub fn resultant(&self, forces: &[f64]) -> Resultant {
        super::site::resultants::resultant(&*self.model, self.material(), forces)
    }
}

/// Which parts of resultants mean anything. Rings have forces along their axis only, a line of symmetry takes moments, and bonds in
/// antiplane shear resist no rotation.
fn statical(model: &dyn BodyModel, material: &dyn Material) -> Counted {
    let only_along = |axis: usize| [0, 1, 2].map(|k| k == axis);
    let force = material.surface().resultant();
    if force.contains(&false) {
        return Counted { force, moment: [false; 3] };
    }
    let mirrors = model.lattice().map(|(_, mirrors)| *mirrors).unwrap_or_default();
    if material.cylinder_radius().is_some() {
        let turns = mirrors.joined[1] || mirrors.lines[1] == [None; 2];
        return Counted { force: only_along(0), moment: [false, false, turns] };
    }
    let force = [0, 1, 2].map(|axis| model.along(axis).is_some());
    let turns = force[0] && mirrors.is_none();
    // A solid resists turning about every axis.
    Counted { force, moment: [turns && force[2], turns && force[2], turns] }
}
