//! Stresses and energy densities of points, and the loads that belong to stresses.
//!
//! With the weights r_ij of a point its stress is `σ_i = 3E Σ_j r_ij L n⊗n e_ij`: in a uniform strain that of the membrane
//! at every point, those at edges included.

use super::super::plane::PlaneFields;
use super::ShellMembrane;
use super::family::ShellOffset;
use rayon::prelude::*;

impl ShellMembrane {
    /// Stresses `[σ_xx, σ_ss, σ_xs]`, Pa, and energies per volume, J/m³, of all points.
    pub(super) fn recovered(&self, u: &[f64]) -> PlaneFields {
        let n = self.lattice.points();
        let modulus = 3.0 * self.parameters.youngs_modulus;
        let at = |point: usize| {
            let mut sums = [0.0; 4];
            let mut add = |offset: &ShellOffset, weight: f64, e: f64| {
                let action = modulus * weight * e;
                (0..3).for_each(|q| sums[q] += offset.product[q] * action);
                sums[3] += 0.5 * e * action;
            };
            self.families.for_each_bond(&self.lattice, point, |offset, other, sign, weight| {
                let [a, t, k] = offset.row;
                let [du, dv] = [0, 1].map(|c| sign * (u[c * n + other] - u[c * n + point]));
                add(offset, weight, a * du + t * dv + k * (u[2 * n + point] + u[2 * n + other]));
            });
            if let Some(ends) = &self.ends {
                let (body, cell) = ((&*self.lattice, &self.mirrors), self.lattice.cell(point));
                for (bond, part) in ends.of(point) {
                    let weight = self.families.weight(body, cell, part.offset, part.up);
                    let e = ends.bonds.measures(bond, u)[0] / part.share;
                    add(&self.families.offsets[part.offset], weight, e);
                }
            }
            if let Some(curvature) = &self.curvature {
                sums[3] += curvature.energy(point, u) / (self.cell_area() * self.parameters.thickness);
            }
            sums
        };
        let all = (0..n).into_par_iter().with_min_len(1024);
        let sums: Vec<[f64; 4]> = all.map(|p| if self.is_ghost(p) { [0.0; 4] } else { at(p) }).collect();
        let plane = |q: usize| sums.iter().map(|s| s[q]).collect();
        PlaneFields { stress: [plane(0), plane(1), plane(2)], energy_density: plane(3), across: Vec::new() }
    }

    /// Adds the forces that do the work `Σ_k t_k·V_k σ_k` with the strains `t`, three planes, of some points, none for all.
    pub(super) fn add_work(&self, t: &[f64], points: Option<&[usize]>, force: &mut [f64]) {
        let n = self.lattice.points();
        let modulus = 3.0 * self.parameters.youngs_modulus * self.parameters.thickness * self.cell_area();
        let mut add = |point: usize| {
            let own: [f64; 3] = std::array::from_fn(|q| t[q * n + point]);
            if own == [0.0; 3] {
                return;
            }
            self.families.for_each_bond(&self.lattice, point, |offset, other, sign, weight| {
                let [a, b, k] = offset.row;
                let product: f64 = offset.product.iter().zip(&own).map(|(n, t)| n * t).sum();
                let action = modulus * weight * product;
                for (c, coefficient) in [sign * a, sign * b].into_iter().enumerate() {
                    force[c * n + other] += coefficient * action;
                    force[c * n + point] -= coefficient * action;
                }
                force[2 * n + other] += k * action;
                force[2 * n + point] += k * action;
            });
        };
        match points {
            Some(points) => points.iter().filter(|p| !self.is_ghost(**p)).for_each(|&p| add(p)),
            None => self.real_points().for_each(add),
        }
        if let Some(ends) = &self.ends {
            let whole = 2.0 * modulus;
            ends.add_work((&self.lattice, &self.mirrors), &self.families, (t, whole), force);
        }
    }

    /// Whether a point is an image.
    pub(super) fn is_ghost(&self, point: usize) -> bool {
        self.ghosts.binary_search(&(point as u32)).is_ok()
    }
}
