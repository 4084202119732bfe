//! Stresses of the points, and the loads that belong to stresses.
//!
//! The bonds tell the stress `σ = μ (tr E) 1 + 2 μ E` of a body with `λ = μ`, and so the strain E, exact for every uniform
//! strain. The stress is `p 1 + 2 μ E` with the pressure p of the dilatation, or of its means over blocks; a body of revolution
//! has the hoop strain `u_x/x` beside E.

use super::super::super::plane::PlaneFields;
use super::super::Dilatation;
use super::super::blocks::{Block, Means};
use super::BorderedState;
use super::families::Dilatations;
use super::rings::weight;
use crate::body::SquareLattice;
use crate::model::Points;
use crate::stiffness::WideMember;

impl BorderedState {
    pub(super) fn fields_of(&self, u: &[f64]) -> PlaneFields {
        let mut fields = self.plate.fields(u);
        let parameters = &self.parameters;
        let (shear, bulk, lame) = (parameters.shear_modulus(), parameters.bulk_modulus(), parameters.lame());
        let [xx, yy, _] = &fields.stress;
        let traces: Vec<f64> = xx.iter().zip(yy).map(|(x, y)| (x + y) / (4.0 * shear)).collect();
        let hoops: Vec<f64> = (0..traces.len()).map(|p| self.hoop(u, p)).collect();
        let wholes: Vec<f64> = traces.iter().zip(&hoops).map(|(trace, hoop)| trace + hoop).collect();
        let means = match (parameters.dilatation, &self.dilatations) {
            (Dilatation::Blocks, Some(of)) => Some(self.block_means(of, u, &wholes)),
            _ => None,
        };
        let [xx, yy, _] = &mut fields.stress;
        for (p, (&trace, &hoop)) in traces.iter().zip(&hoops).enumerate() {
            let (whole, block) = (wholes[p], self.block(p));
            let [mean, own] =
                means.as_ref().map_or([whole; 2], |means| [means.of(block), means.at(p, block)]);
            // Beyond that of the bonds.
            let pressure = lame * whole - shear * trace + bulk * (own - whole);
            xx[p] += pressure;
            yy[p] += pressure;
            let across = lame * trace * hoop + 0.5 * (lame + 2.0 * shear) * hoop * hoop;
            fields.energy_density[p] += 0.5 * (lame - shear) * trace * trace + across;
            fields.energy_density[p] += 0.5 * bulk * (mean * mean - whole * whole);
            if parameters.is_axisymmetric() {
                fields.across.push(pressure + shear * trace + 2.0 * shear * hoop);
            }
        }
        fields
    }

    /// Hoop strain of a point; zero in a plate, and of images.
    fn hoop(&self, u: &[f64], point: usize) -> f64 {
        let is_ring =
            self.parameters.is_axisymmetric() && self.plate.ghosts.binary_search(&(point as u32)).is_err();
        if is_ring { u[point] / self.plate.lattice.place(point)[0] } else { 0.0 }
    }

    /// The block of a point.
    fn block(&self, point: usize) -> Block {
        (SquareLattice::parent(self.plate.lattice.cell(point)), 0)
    }

    /// Means over blocks of two by two real points of dilatations as the families measure them, which have the pressure: beside the
    /// border that of the bonds is off by a difference of the first order, times a bulk modulus without bound.
    fn block_means(&self, of: &Dilatations, u: &[f64], wholes: &[f64]) -> Means<'_> {
        let (lattice, mirrors, n) = (&self.plate.lattice, self.plate.mirrors, self.points());
        let is_real = |p: usize| mirrors.is_none() || mirrors.is_real(lattice.cell(p));
        let weight = |p: usize| if is_real(p) { weight(&self.plate, p) } else { 0.0 };
        let (mut values, mut weights): (Vec<f64>, Vec<f64>) = (wholes.to_vec(), (0..n).map(weight).collect());
        for (k, (&point, &volume)) in of.points.iter().zip(&of.volumes).enumerate() {
            let moved = |member: &WideMember<2, 2>| {
                let row = |m: usize| {
                    (0..2).map(|c| member.rows[m][c] * u[c * n + member.point as usize]).sum::<f64>()
                };
                row(0) + row(1)
            };
            values[point as usize] = of.own.members(k).iter().map(moved).sum();
            weights[point as usize] = volume;
        }
        Means::new((lattice, mirrors), &|p| self.block(p), &|p| weights[p], &values)
    }

    /// Adds the forces that do the work of the stresses of strains `t`, three planes, and, in a body of revolution, of hoop
    /// strains as large as those along x.
    pub(super) fn add_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        let n = self.points();
        let traces: Vec<f64> = (0..n).map(|p| t[p] + t[n + p]).collect();
        let hoop = |p: usize| if self.parameters.is_axisymmetric() { t[p] } else { 0.0 };
        let hoops: Vec<f64> = (0..n).map(hoop).collect();
        let weights: Vec<f64> = (0..n).map(|p| weight(&self.plate, p)).collect();
        self.plate.add_border_work(t, force);
        t.iter_mut().zip(weights.iter().cycle()).for_each(|(t, weight)| *t *= weight);
        self.plate.add_bond_work(t, points, force);
        let Some(of) = &self.dilatations else { return };
        let cell = self.plate.kind.bond.volume;
        let modulus = self.parameters.whole_modulus();
        let stress = |p: usize, m: usize| modulus[m][0] * traces[p] + modulus[m][1] * hoops[p];
        for (k, (&point, volume)) in of.points.iter().zip(&of.volumes).enumerate() {
            let own = [0, 1].map(|m| cell * volume * stress(point as usize, m));
            if own != [0.0; 2] {
                of.own.add_work(k, &own, force);
            }
        }
        let all = |m: usize| (0..n).map(|p| cell * weights[p] * stress(p, m)).collect();
        of.grid.add_measure_work([all(0), all(1)], force);
    }
}
