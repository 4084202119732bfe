//! Loads of a state, and how far they may be from what was meant.

use super::measures::BLOCK;
use peristat_assembly::model::Model;
use std::array::from_fn;

/// Forces on the unknowns, and what their rounding may be.
pub(super) struct Load<'a, const D: usize> {
    pub(super) forces: &'a [f64],
    model: &'a dyn Model<D>,
}

/// Part of its rounding by which a double is off, other for every one: no two of them cancel.
fn part(k: usize) -> f64 {
    let hash = (k as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32;
    f64::EPSILON * (hash as f64 / f64::from(1_u32 << 31) - 1.0)
}

impl<'a, const D: usize> Load<'a, D> {
    pub(super) fn new(model: &'a dyn Model<D>, forces: &'a [f64]) -> Self {
        Self { forces, model }
    }

    /// The forces with signs by chance: none of them cancels another.
    pub(super) fn scatter(&self, to: &mut [f64]) {
        to.iter_mut().zip(self.forces).enumerate().for_each(|(k, (to, f))| *to = f.copysign(part(k)));
    }

    /// Adds an error that the rounding of the forces may be: that of every force on an unknown, and of the components along
    /// the axes that loads are given in: a slanted member has mixed them.
    pub(super) fn add_rounding(&self, errors: &mut [f64]) {
        let (model, n) = (self.model, self.model.points());
        errors.iter_mut().zip(self.forces).enumerate().for_each(|(k, (error, f))| *error += part(k) * f);
        let motions = model.rigid_motions();
        let translations = (0..motions.len()).filter(|&kind| !motions[kind].is_rotation);
        let is_displacement: [bool; D] = from_fn(|c| !model.components()[c].is_rotation);
        let mut along = [[0.0; D]; BLOCK];
        for (axis, kind) in translations.enumerate() {
            for first in (0..n).step_by(BLOCK) {
                let points = first..n.min(first + BLOCK);
                let planes: [&[f64]; D] = from_fn(|c| &self.forces[c * n..][points.clone()]);
                let is_pushed = |k: usize| (0..D).any(|c| is_displacement[c] && planes[c][k] != 0.0);
                if !(0..points.len()).any(is_pushed) {
                    continue;
                }
                model.rigid_motions_from(kind, first, model.position(0), &mut along[..points.len()]);
                for (k, point) in points.enumerate().filter(|(k, _)| is_pushed(*k)) {
                    let force: f64 = (0..D).map(|c| along[k][c] * planes[c][k]).sum();
                    for c in (0..D).filter(|&c| along[k][c] != 0.0 && !model.is_idle(c, point)) {
                        errors[c * n + point] += part(axis * n + point) * along[k][c] * force;
                    }
                }
            }
        }
    }
}
