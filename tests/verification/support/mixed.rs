//! Plates of several materials made by hand: Young's modulus 1 in the base material, spacing and thickness given.

use nalgebra::DMatrix;
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::bond_plane::{
    BondPlane, Influence, PlaneMaterial, PlaneParameters, PlaneState, VolumeFactor, Weights,
};
use peristat_assembly::model::plane::{Calibration, Edges, Mirrors};
use peristat_assembly::model::{BodyModel, Model};
use peristat_assembly::system::System;
use std::sync::Arc;

/// Matched bonds in plane stress, E = 1, thickness 1.
pub(crate) fn parameters(horizon_ratio: f64, edges: Edges) -> PlaneParameters {
    PlaneParameters {
        material: PlaneMaterial { youngs_modulus: 1.0, thickness: 1.0, state: PlaneState::Stress },
        horizon_ratio,
        influence: Influence::Constant,
        calibration: Calibration::Matched,
        weights: Weights::Nearest,
        volume_factor: VolumeFactor::Full,
        edges,
    }
}

/// A plate of some cells with moduli by place.
pub(crate) fn plate(
    lattice: SquareLattice,
    parameters: PlaneParameters,
    modulus: impl Fn([f64; 2]) -> f64,
) -> BondPlane {
    let factors = (0..lattice.points()).map(|p| modulus(lattice.place(p))).collect();
    BondPlane::mixed(Arc::new(lattice), Mirrors::NONE, parameters, &[], factors).expect("the bonds exist")
}

/// The stiffness of a plate by rows.
pub(crate) struct Stiffness {
    rows: Vec<Vec<(usize, f64)>>,
}

impl Stiffness {
    pub(crate) fn of<const D: usize>(model: &impl Model<D>) -> Self {
        let system = System::<D>::new(model, Vec::new(), Vec::new()).expect("no contradiction");
        let n = system.points();
        let matrix = system.stiffness().to_csr(|point, component| component * n + point);
        let mut rows = vec![Vec::new(); D * n];
        for (&value, (i, j)) in &matrix {
            rows[i].push((j, value));
        }
        Self { rows }
    }

    /// All of it.
    pub(crate) fn dense(&self) -> DMatrix<f64> {
        let mut dense = DMatrix::zeros(self.rows.len(), self.rows.len());
        let all = self.rows.iter().enumerate().flat_map(|(i, row)| row.iter().map(move |&(j, k)| (i, j, k)));
        all.for_each(|(i, j, k)| dense[(i, j)] += k);
        dense
    }

    /// Forces of some displacements.
    pub(crate) fn forces(&self, u: &[f64]) -> Vec<f64> {
        self.rows.iter().map(|row| row.iter().map(|&(j, k)| k * u[j]).sum()).collect()
    }

    /// The displacements that prescribed ones leave without forces, by conjugate gradients.
    pub(crate) fn relaxed(&self, prescribed: &[Option<f64>]) -> Vec<f64> {
        let mut u: Vec<f64> = prescribed.iter().map(|p| p.unwrap_or(0.0)).collect();
        let free = |of: Vec<f64>| -> Vec<f64> {
            of.iter().zip(prescribed).map(|(v, p)| if p.is_some() { 0.0 } else { *v }).collect()
        };
        let diagonal: Vec<f64> = (0..u.len())
            .map(|i| self.rows[i].iter().find(|e| e.0 == i && e.1 > 0.0).map_or(1.0, |e| e.1))
            .collect();
        let scaled = |r: &[f64]| -> Vec<f64> { r.iter().zip(&diagonal).map(|(r, d)| r / d).collect() };
        let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        let mut r = free(self.forces(&u).iter().map(|f| -f).collect());
        let mut z = scaled(&r);
        let mut p = z.clone();
        let (mut rz, first) = (dot(&r, &z), dot(&r, &z));
        for _ in 0..20_000 {
            if rz <= 1e-26 * first {
                return u;
            }
            let kp = free(self.forces(&p));
            let step = rz / dot(&p, &kp);
            u.iter_mut().zip(&p).for_each(|(u, p)| *u += step * p);
            r.iter_mut().zip(&kp).for_each(|(r, k)| *r -= step * k);
            z = scaled(&r);
            let next = dot(&r, &z);
            p.iter_mut().zip(&z).for_each(|(p, z)| *p = z + next / rz * *p);
            rz = next;
        }
        panic!("conjugate gradients did not settle: {:e}", rz / first)
    }
}

/// Components `[ux, uy]` that are prescribed, by points.
pub(crate) fn prescribed(
    plate: &impl BodyModel,
    of: impl Fn(usize, [f64; 2]) -> [Option<f64>; 2],
) -> Vec<Option<f64>> {
    let n = plate.points();
    let all: Vec<[Option<f64>; 2]> = (0..n).map(|p| of(p, plate.place(p))).collect();
    (0..2 * n).map(|k| all[k % n][k / n]).collect()
}

/// The line nearest to some pairs: value at zero, slope.
pub(crate) fn line(pairs: &[(f64, f64)]) -> [f64; 2] {
    let n = pairs.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| pairs.iter().map(of).sum::<f64>() / n;
    let [x, y] = [mean(|p| p.0), mean(|p| p.1)];
    let slope = pairs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>()
        / pairs.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>();
    [y - slope * x, slope]
}
