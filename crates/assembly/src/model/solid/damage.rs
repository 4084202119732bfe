//! How much of its family every point of a solid has lost.

use super::super::plane::at;
use super::body::SolidBody;
use crate::body::plus;

impl SolidBody {
    fn is_apart(&self, bond: (usize, usize)) -> bool {
        self.apart.binary_search(&bond).is_ok()
    }

    /// Cut shares of the family volumes of all points.
    pub(super) fn damage(&self) -> Vec<f64> {
        let (lattice, neighbourhood) = (&self.lattice, &self.law.neighbourhood);
        let mut damage = vec![0.0; lattice.points()];
        let known = |cut: &&(usize, usize)| neighbourhood.has_bonds(cut.0) && !self.is_apart(**cut);
        for &(offset, lower) in self.cuts.iter().filter(known) {
            if let Some(upper) = lattice.number(plus(lattice.cell(lower), neighbourhood.offsets[offset])) {
                [lower, upper].into_iter().for_each(|point| damage[point] += neighbourhood.parts[offset]);
            }
        }
        for (point, share) in damage.iter_mut().enumerate().filter(|d| *d.1 > 0.0) {
            let cell = lattice.cell(point);
            let steps = neighbourhood.bonded().flat_map(|k| [(k, true), (k, false)]);
            let present = steps.filter(|&(k, up)| {
                let other = lattice.number(at(cell, neighbourhood.offsets[k], up));
                other.is_some_and(|other| !self.is_apart((k, if up { point } else { other })))
            });
            *share /= present.map(|(k, _)| neighbourhood.parts[k]).sum::<f64>();
        }
        self.ghosts.iter().for_each(|&ghost| damage[ghost as usize] = 0.0);
        damage
    }
}
