//! The loads of a body in the plane as forces and stresses on its points.

use super::stress_field::StressField;
use crate::scene::Resultant;
use peristat_assembly::model::plane::PlaneModel;

/// The loads of one load case.
#[derive(Clone, Debug, Default)]
pub struct BodyLoads {
    /// Forces on points of the model, N.
    pub(crate) forces: Vec<(u32, [f64; 2])>,
    /// The same of tractions that act through the border, by numbers of the model from the start.
    pub(crate) through_border: Vec<(u32, [f64; 2])>,
    /// Moments on points of the model, N m; where points move across the plane, forces along that, N.
    pub(crate) across: Vec<(u32, f64)>,
    /// Force on every point per volume, N/m³.
    pub(crate) density: [f64; 2],
    /// Force on every point along x per volume and per x, N/m⁴.
    pub(crate) spin: f64,
    /// Stresses that act by the rows of the bonds.
    pub(crate) stresses: Vec<StressField>,
    /// Whether these carry the forces through joined sides.
    pub(crate) carry_ends: bool,
    /// Resultant as the case asks for it.
    pub(crate) asked: Resultant,
    /// Along which axes stresses that are asked for nothing there go through a mirror.
    pub(crate) inside: [bool; 2],
}

impl BodyLoads {
    /// The same with the numbers that points have in the model.
    pub(crate) fn numbered(mut self, number: &dyn Fn(u32) -> u32) -> Self {
        self.forces.iter_mut().for_each(|f| f.0 = number(f.0));
        self.forces.append(&mut self.through_border);
        self.across.iter_mut().for_each(|m| m.0 = number(m.0));
        self.stresses.iter_mut().for_each(|field| *field = field.numbered(number));
        self
    }

    /// The same with the forces through joined sides, on points of the model.
    pub(crate) fn with_ends(mut self, forces: &[(u32, [f64; 2])]) -> Self {
        if !self.carry_ends {
            self.forces.extend(forces);
        }
        self
    }

    /// Whether nothing acts.
    pub fn is_zero(&self) -> bool {
        self.forces.is_empty()
            && self.through_border.is_empty()
            && self.across.is_empty()
            && self.density == [0.0; 2]
            && self.spin == 0.0
            && self.stresses.is_empty()
    }

    /// Adds the loads times a factor to `force`, N, the plane of x first, then that of y and, where points turn, that of
    /// moments per length by which rotations are multiplied, or that across the plane.
    pub fn add_to(&self, model: &dyn PlaneModel, factor: f64, force: &mut [f64]) {
        let n = model.points();
        for &(point, f) in &self.forces {
            (0..2).for_each(|c| force[c * n + point as usize] += factor * f[c]);
        }
        // A moment does its work on the rotation, the unknown is a multiple of that.
        let turning = model.scale(2);
        for &(point, value) in &self.across {
            force[2 * n + point as usize] += factor * value / turning;
        }
        if self.density != [0.0; 2] || self.spin != 0.0 {
            for point in 0..n {
                let volume = factor * model.volume(point);
                (0..2).for_each(|c| force[c * n + point] += volume * self.density[c]);
                if self.spin != 0.0 {
                    force[point] += volume * self.spin * model.place(point)[0];
                }
            }
        }
        self.stresses.iter().for_each(|field| field.add_to(model, factor, force));
    }
}
