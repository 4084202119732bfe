//! The loads of a body in the plane as forces and stresses on its points.

use super::eigenstrain::Eigenstrain;
use super::stress_field::StressField;
use super::traction::on_border::OnBorder;
use crate::scene::Resultant;
use peristat_assembly::model::BodyModel;

/// Forces along x, y and z, N, on points.
pub(crate) type Forces = Vec<(u32, [f64; 3])>;

/// The loads of one load case.
#[derive(Clone, Debug, Default)]
pub struct BodyLoads {
    /// Forces on points of the model, N.
    pub(crate) forces: Forces,
    /// The same of tractions that act through the border, by numbers of the model from the start.
    pub(crate) through_border: Forces,
    /// What stresses do to lines of symmetry at once, by images of the model.
    pub(crate) into_lines: Forces,
    /// Moments about z on points of the model, N m.
    pub(crate) moments: Vec<(u32, f64)>,
    /// Force on every point per volume, N/m³.
    pub(crate) density: [f64; 3],
    /// Force on every point along x per volume and per x, N/m⁴.
    pub(crate) spin: f64,
    /// Stresses that act by the rows of the bonds.
    pub(crate) stresses: Vec<StressField>,
    /// Strains that need no stress, by numbers of the model from the start.
    pub(crate) eigenstrain: Option<Eigenstrain>,
    /// The force per volume that was asked for on the whole body, however it acts.
    pub(crate) weight: [f64; 3],
    /// Tractions as the case gives them.
    pub(crate) on_border: Vec<OnBorder>,
    /// Whether formulas give forces on a border.
    pub(crate) by_formula: bool,
    /// Whether these carry the forces through joined sides.
    pub(crate) carry_ends: bool,
    /// Resultant as the case asks for it.
    pub(crate) asked: Resultant,
    /// Along which axes stresses that are asked for nothing there go through a mirror.
    pub(crate) inside: [bool; 3],
}

impl BodyLoads {
    /// The same with the numbers that points have in the model.
    pub(crate) fn numbered(mut self, number: &dyn Fn(u32) -> u32) -> Self {
        self.forces.iter_mut().for_each(|f| f.0 = number(f.0));
        self.forces.append(&mut self.through_border);
        self.moments.iter_mut().for_each(|m| m.0 = number(m.0));
        self.stresses.iter_mut().for_each(|field| *field = field.numbered(number));
        self
    }

    /// The same with the forces through joined sides, on points of the model.
    pub(crate) fn with_ends(mut self, forces: &[(u32, [f64; 3])]) -> Self {
        if !self.carry_ends {
            self.forces.extend(forces);
        }
        self
    }

    /// Adds strains that need no stress.
    pub(super) fn stretch(&mut self, more: Eigenstrain) {
        self.eigenstrain = Some(match self.eigenstrain.take() {
            Some(own) => own.plus(1.0, &more),
            None => more,
        });
    }

    /// Whether the forces are numbers.
    pub(crate) fn is_finite(&self) -> bool {
        let all = self.forces.iter().chain(&self.through_border);
        all.flat_map(|f| f.1).all(f64::is_finite)
    }

    /// Whether nothing acts.
    pub fn is_zero(&self) -> bool {
        self.forces.is_empty()
            && self.through_border.is_empty()
            && self.moments.is_empty()
            && self.density == [0.0; 3]
            && self.spin == 0.0
            && self.stresses.is_empty()
            && self.eigenstrain.is_none()
    }

    /// Adds the loads times a factor to `force`, N, one plane per unknown; moments per length by which rotations are
    /// multiplied. What acts along an axis in which points do not move is left out.
    pub fn add_to(&self, model: &dyn BodyModel, factor: f64, force: &mut [f64]) {
        let n = model.points();
        let planes = (0..3).filter_map(|axis| Some((axis, model.along(axis)? * n)));
        let planes: Vec<(usize, usize)> = planes.collect();
        for &(point, f) in &self.forces {
            planes.iter().for_each(|&(axis, plane)| force[plane + point as usize] += factor * f[axis]);
        }
        // A moment does its work on the rotation, the unknown is a multiple of that.
        if let Some((component, turning)) = model.turning() {
            for &(point, value) in &self.moments {
                force[component * n + point as usize] += factor * value / turning;
            }
        }
        if self.density != [0.0; 3] || self.spin != 0.0 {
            for point in 0..n {
                let volume = factor * model.volume(point);
                planes.iter().for_each(|&(axis, plane)| force[plane + point] += volume * self.density[axis]);
                if self.spin != 0.0 {
                    force[point] += volume * self.spin * model.place(point)[0];
                }
            }
        }
        self.stresses.iter().for_each(|field| field.add_to(model, factor, force));
        self.eigenstrain.iter().for_each(|own| own.add_to(model, factor, force));
    }
}
