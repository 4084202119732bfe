//! Stresses of the points, and the loads that belong to stresses.
//!
//! The bonds tell the stress `σ = μ (tr E) 1 + 2 μ E` of a body with `λ = μ`, and so the strain E, exact for every uniform
//! strain. The stress is `p 1 + 2 μ E` with the pressure p of the dilatation, or of its mean over a block.

use super::super::super::plane::PlaneFields;
use super::super::Dilatation;
use super::BorderedState;
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
        let means = match parameters.dilatation {
            Dilatation::Points => None,
            Dilatation::Blocks => Some(self.block_means(&traces)),
        };
        let [xx, yy, _] = &mut fields.stress;
        for (p, &trace) in traces.iter().enumerate() {
            let mean = means.as_ref().map_or(trace, |means| means[p]);
            // Beyond that of the bonds.
            let pressure = (lame - shear) * trace + bulk * (mean - trace);
            xx[p] += pressure;
            yy[p] += pressure;
            fields.energy_density[p] +=
                0.5 * (lame - shear) * trace * trace + 0.5 * bulk * (mean * mean - trace * trace);
        }
        fields
    }

    /// Means over blocks of two by two real points.
    fn block_means(&self, values: &[f64]) -> Vec<f64> {
        let lattice = &self.plate.lattice;
        let is_real = |cell: Cell| self.plate.mirrors.is_none() || self.plate.mirrors.is_real(cell);
        let mut sums: HashMap<Cell, [f64; 2]> = HashMap::new();
        for (p, value) in values.iter().enumerate().filter(|(p, _)| is_real(lattice.cell(*p))) {
            let sum = sums.entry(SquareLattice::parent(lattice.cell(p))).or_default();
            *sum = [sum[0] + value, sum[1] + 1.0];
        }
        let mean = |p: usize| sums.get(&SquareLattice::parent(lattice.cell(p))).map_or(0.0, |s| s[0] / s[1]);
        (0..values.len()).map(mean).collect()
    }

    pub(super) fn add_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        let n = self.points();
        let traces: Vec<f64> = (0..n).map(|p| t[p] + t[n + p]).collect();
        self.plate.add_strain_work(t, points, force);
        let Some(of) = &self.dilatations else { return };
        let cell = self.plate.kind.bond.volume;
        let modulus = cell * (self.parameters.lame() - self.parameters.shear_modulus());
        for (k, (&point, volume)) in of.points.iter().zip(&of.volumes).enumerate() {
            let trace = traces[point as usize];
            if trace != 0.0 {
                of.own.add_work(k, &[modulus * volume * trace], force);
            }
        }
        of.grid.add_dilatation_work(traces.iter().map(|trace| modulus * trace).collect(), force);
    }
}
