//! What acts on a plate as a whole.

use super::scene::PlateScene;
use super::statics;
use super::{Heat, fracture};
use crate::scene::body::BodyState;
use crate::scene::{ASKED, Counted, Resultant};
use peristat_assembly::model::plate_bending::PlateFields;

impl PlateScene {
    /// Resultant of the loads of a state, as the case asks for them.
    pub fn asked(&self, state: &BodyState) -> Resultant {
        let mut sum = Resultant::default();
        state.terms.iter().for_each(|&(case, factor)| sum.add_multiple(factor, &self.load_cases[case].asked));
        sum
    }

    /// What checks know beside probes.
    pub(crate) fn facts(&self) -> &'static [&'static str] {
        fracture::facts(self.fracture.as_ref())
    }

    /// What curvatures that need no moments do to the unknowns in a state.
    pub(crate) fn heat(&self, state: &BodyState) -> Heat {
        let mut sum = Heat::default();
        state.terms.iter().for_each(|&(case, factor)| sum.add(factor, &self.load_cases[case].heat));
        sum
    }

    /// The energy of moments and shear forces at the points.
    pub(crate) fn energy(&self, fields: &PlateFields) -> f64 {
        let of_point = |point: usize| {
            let parts = self.plate.sections().about(self.plate.nodes(), point);
            let density = |number: usize| {
                let section = self.plate.section(number);
                section.energy(fields.moment[point], fields.shear[point])
            };
            parts.iter().map(|&(number, part)| part * density(number)).sum::<f64>()
        };
        let area = self.plate.nodes().spacing().powi(2);
        (0..self.plate.nodes().points()).map(|point| area * of_point(point)).sum()
    }

    /// Volume of the quarters of cells about a point.
    pub fn volume(&self, point: usize) -> f64 {
        let (nodes, area) = (self.plate.nodes(), self.plate.nodes().spacing().powi(2));
        let parts = self.plate.sections().about(nodes, point);
        parts.iter().map(|&(number, part)| part * area * self.thickness.of_sections[number]).sum()
    }

    /// Resultant of forces on some unknowns, by number.
    pub fn resultant(&self, forces: impl Iterator<Item = (usize, f64)>) -> Resultant {
        statics::resultant(self.plate.nodes(), forces)
    }

    /// Which parts of resultants mean anything: the force across the plane, and the moments about axes in it.
    pub fn statical(&self) -> Counted {
        Counted { force: [false, false, true], moment: [true, true, false] }
    }

    /// Difference of the loads as asked and as applied, relative to their magnitudes, that is no fault: formulas act by their
    /// values at points.
    pub fn slack(&self, state: &BodyState) -> f64 {
        let is_approximate = |&(case, _): &(usize, f64)| self.load_cases[case].is_approximate;
        if state.terms.iter().any(is_approximate) { f64::INFINITY } else { ASKED }
    }
}
