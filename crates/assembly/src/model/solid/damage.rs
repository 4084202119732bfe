//! How much of its family every point of a solid has lost.

use super::body::SolidBody;
use crate::body::plus;

impl SolidBody {
    /// Cut shares of the family volumes of all points.
    pub(super) fn damage(&self) -> Vec<f64> {
        let (lattice, hood) = (&self.lattice, &self.law.hood);
        let mut damage = vec![0.0; lattice.points()];
        for &(offset, lower) in self.cuts.iter().filter(|cut| hood.has_bonds(cut.0)) {
            if let Some(upper) = lattice.number(plus(lattice.cell(lower), hood.offsets[offset])) {
                [lower, upper].into_iter().for_each(|point| damage[point] += hood.parts[offset]);
            }
        }
        for (point, share) in damage.iter_mut().enumerate().filter(|d| *d.1 > 0.0) {
            let cell = lattice.cell(point);
            let steps = hood.bonded().flat_map(|k| [(k, hood.offsets[k]), (k, hood.offsets[k].map(|x| -x))]);
            let present = steps.filter(|(_, step)| lattice.number(plus(cell, *step)).is_some());
            *share /= present.map(|(k, _)| hood.parts[k]).sum::<f64>();
        }
        self.ghosts.iter().for_each(|&ghost| damage[ghost as usize] = 0.0);
        damage
    }
}
