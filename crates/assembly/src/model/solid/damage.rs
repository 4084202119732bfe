//! How much of its family every point of a solid has lost.

use super::body::SolidBody;
use crate::body::plus;

impl SolidBody {
    /// Cut shares of the family volumes of all points.
    pub(super) fn damage(&self) -> Vec<f64> {
        let (lattice, neighbourhood) = (&self.lattice, &self.law.neighbourhood);
        let mut damage = vec![0.0; lattice.points()];
        for &(offset, lower) in self.cuts.iter().filter(|cut| neighbourhood.has_bonds(cut.0)) {
            if let Some(upper) = lattice.number(plus(lattice.cell(lower), neighbourhood.offsets[offset])) {
                [lower, upper].into_iter().for_each(|point| damage[point] += neighbourhood.parts[offset]);
            }
        }
        for (point, share) in damage.iter_mut().enumerate().filter(|d| *d.1 > 0.0) {
            let cell = lattice.cell(point);
            let steps = neighbourhood
                .bonded()
                .flat_map(|k| [(k, neighbourhood.offsets[k]), (k, neighbourhood.offsets[k].map(|x| -x))]);
            let present = steps.filter(|(_, step)| lattice.number(plus(cell, *step)).is_some());
            *share /= present.map(|(k, _)| neighbourhood.parts[k]).sum::<f64>();
        }
        self.ghosts.iter().for_each(|&ghost| damage[ghost as usize] = 0.0);
        damage
    }
}
