//! Loads of a state, and how far they may be from what was meant.

use peristat_assembly::model::Model;

/// Forces on the unknowns, and what their rounding may be.
pub(super) struct Load<'a> {
    pub(super) forces: &'a [f64],
    /// An error that their rounding may be.
    pub(super) rounding: Vec<f64>,
}

impl<'a> Load<'a> {
    pub(super) fn new<const D: usize>(model: &dyn Model<D>, forces: &'a [f64]) -> Self {
        Self { forces, rounding: rounding(model, forces) }
    }
}

/// Part of its rounding by which a double is off, other for every one: no two of them cancel.
fn part(k: usize) -> f64 {
    let hash = (k as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32;
    f64::EPSILON * (hash as f64 / f64::from(1_u32 << 31) - 1.0)
}

/// The rounding of every force on an unknown, and of the components along the axes that loads are given in: a slanted member has
/// mixed them.
fn rounding<const D: usize>(model: &dyn Model<D>, forces: &[f64]) -> Vec<f64> {
    let (n, origin) = (model.points(), model.position(0));
    let mut rounding: Vec<f64> = forces.iter().enumerate().map(|(k, f)| part(k) * f).collect();
    let motions = model.rigid_motions();
    let translations = (0..motions.len()).filter(|&kind| !motions[kind].is_rotation);
    let is_displacement: [bool; D] = std::array::from_fn(|c| !model.components()[c].is_rotation);
    let is_pushed = |&point: &usize| (0..D).any(|c| is_displacement[c] && forces[c * n + point] != 0.0);
    let pushed: Vec<usize> = (0..n).filter(is_pushed).collect();
    for (axis, kind) in translations.enumerate() {
        for &point in &pushed {
            let along = model.rigid_motion(kind, point, origin);
            let force: f64 = (0..D).map(|c| along[c] * forces[c * n + point]).sum();
            for c in (0..D).filter(|&c| !model.is_idle(c, point)) {
                rounding[c * n + point] += part(axis * n + point) * along[c] * force;
            }
        }
    }
    rounding
}
