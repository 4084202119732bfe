//! Stress, strain and energy density of the points, from bonds and triangles.

use super::neighbourhood::{Neighbourhood, direction_product};
use super::{Body, BondPlane};
use crate::bonds::Mat;
use rayon::prelude::*;

/// Fields by component planes; images have zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneFields {
    /// `[σ_xx, σ_yy, σ_xy]`, Pa, of every point.
    pub stress: [Vec<f64>; 3],
    /// Strain energy density, J/m³, of every point.
    pub energy_density: Vec<f64>,
}

impl BondPlane {
    /// Stresses and energy densities of a state.
    pub fn fields(&self, u: &[f64]) -> PlaneFields {
        let n = self.points();
        let mut sums = match &self.body {
            Body::Lattice(body) => {
                let (spacing, thickness) = (body.lattice.spacing(), self.parameters.material.thickness);
                let volume = body.volume(thickness);
                let shares = virial_shares(&body.hood, spacing, 1.0 / volume);
                let mut sums = body.whole.sums::<3>(u, &shares);
                sums[3 * n..].par_iter_mut().with_min_len(4096).for_each(|energy| *energy /= volume);
                for &(point, part) in body.lattice.cut_cells() {
                    (0..4).for_each(|q| sums[q * n + point as usize] /= part);
                }
                body.ghosts.iter().for_each(|&g| (0..4).for_each(|q| sums[q * n + g as usize] = 0.0));
                sums
            }
            Body::Cloud(body) => body.sums(u, self.parameters.material.thickness),
        };
        for triangle in self.overlay().list() {
            let point = triangle.point as usize;
            let strain = triangle.measures(n, u);
            let (stress, volume) = (triangle.stress(&strain), self.real_volume(point));
            for q in 0..3 {
                sums[q * n + point] += stress[q] / volume;
                sums[3 * n + point] += 0.5 * strain[q] * stress[q] / volume;
            }
        }
        let energy_density = sums.split_off(3 * n);
        let xy = sums.split_off(2 * n);
        let yy = sums.split_off(n);
        PlaneFields { stress: [sums, yy, xy], energy_density }
    }

    /// Strains `[ε_xx, ε_yy, γ_xy]` of every point: `C⁻¹ σ`.
    pub fn strain(&self, stress: &[Vec<f64>; 3]) -> [Vec<f64>; 3] {
        let mut strain = stress.clone();
        let [xx, yy, xy] = &mut strain;
        let material = self.parameters.material;
        let points = xx.par_iter_mut().zip(yy.par_iter_mut()).zip(xy.par_iter_mut()).with_min_len(4096);
        points.for_each(|((x, y), s)| [*x, *y, *s] = material.strain([*x, *y, *s]));
        strain
    }

    /// Volume of a point that is no image.
    pub(super) fn real_volume(&self, point: usize) -> f64 {
        let thickness = self.parameters.material.thickness;
        match &self.body {
            Body::Lattice(body) => body.volume(thickness) * body.lattice.fraction(point),
            Body::Cloud(body) => body.areas[point] * thickness,
        }
    }
}

/// `½ ξ N scale` per offset that has bonds: with the forces of the bonds it makes `V_k σ_k` of their points.
pub(super) fn virial_shares(hood: &Neighbourhood, spacing: f64, scale: f64) -> Vec<Mat<3, 1>> {
    let of = |k: usize| {
        let step = hood.offsets[k];
        let half = 0.5 * spacing * super::neighbourhood::length(step) * scale;
        direction_product(step).map(|n| [half * n])
    };
    hood.bonded().map(of).collect()
}
