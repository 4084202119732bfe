//! Stresses of the points, and the loads that belong to stresses.
//!
//! The bonds tell the stress `σ = μ (tr E) 1 + 2 μ E` of a body with `λ = μ`, and so the strain E, exact for every uniform
//! strain. The stress is `p 1 + 2 μ E` with the pressure p of the dilatation, or of its mean over a block; a body of revolution
//! has the hoop strain `u_x/x` beside E.

use super::super::super::plane::PlaneFields;
use super::super::Dilatation;
use super::BorderedState;
use super::rings::weight;
use crate::body::{Cell, SquareLattice};
use crate::model::Points;
use std::collections::HashMap;

impl BorderedState {
    pub(super) fn fields_of(&self, u: &[f64]) -> PlaneFields {
        let mut fields = self.plate.fields(u);
        let parameters = &self.parameters;
        let (shear, bulk, lame) = (parameters.shear_modulus(), parameters.bulk_modulus(), parameters.lame());
        let [xx, yy, _] = &fields.stress;
        let traces: Vec<f64> = xx.iter().zip(yy).map(|(x, y)| (x + y) / (4.0 * shear)).collect();
        let hoops: Vec<f64> = (0..traces.len()).map(|p| self.hoop(u, p)).collect();
        let wholes: Vec<f64> = traces.iter().zip(&hoops).map(|(trace, hoop)| trace + hoop).collect();
        let means = match parameters.dilatation {
            Dilatation::Points => None,
            Dilatation::Blocks => Some(self.block_means(&wholes)),
        };
        let [xx, yy, _] = &mut fields.stress;
        for (p, (&trace, &hoop)) in traces.iter().zip(&hoops).enumerate() {
            let (whole, mean) = (wholes[p], means.as_ref().map_or(wholes[p], |means| means[p]));
            // Beyond that of the bonds.
            let pressure = lame * whole - shear * trace + bulk * (mean - whole);
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

    /// Means over blocks of two by two real points.
    fn block_means(&self, values: &[f64]) -> Vec<f64> {
        let lattice = &self.plate.lattice;
        let is_real = |cell: Cell| self.plate.mirrors.is_none() || self.plate.mirrors.is_real(cell);
        let mut sums: HashMap<Cell, [f64; 2]> = HashMap::new();
        for (p, value) in values.iter().enumerate().filter(|(p, _)| is_real(lattice.cell(*p))) {
            let (sum, weight) =
                (sums.entry(SquareLattice::parent(lattice.cell(p))).or_default(), weight(&self.plate, p));
            *sum = [sum[0] + weight * value, sum[1] + weight];
        }
        let mean = |p: usize| sums.get(&SquareLattice::parent(lattice.cell(p))).map_or(0.0, |s| s[0] / s[1]);
        (0..values.len()).map(mean).collect()
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
