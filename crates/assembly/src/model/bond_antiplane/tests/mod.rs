//! What holds for plates in antiplane shear.

mod closed_forms;
mod patch;

use super::super::bond_plane::Influence;
use super::super::plane::{Edges, Mirrors, PlaneModel};
use super::{AntiplaneParameters, BondAntiplane};
use crate::body::SquareLattice;
use crate::model::BodyModel;
use crate::model::Model;
use std::sync::Arc;

const PLATE: AntiplaneParameters = AntiplaneParameters {
    shear_modulus: 27.0e9,
    thickness: 0.02,
    horizon_ratio: 3.0,
    influence: Influence::Constant,
    edges: Edges::Overlay,
};

fn plate(lattice: &Arc<SquareLattice>, parameters: AntiplaneParameters) -> BondAntiplane {
    BondAntiplane::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap()
}

/// A value for every place.
fn at_points(plate: &BondAntiplane, of: impl Fn([f64; 2]) -> f64) -> Vec<f64> {
    (0..crate::model::Points::points(plate)).map(|p| of(plate.place(p))).collect()
}

fn force(plate: &BondAntiplane, w: &[f64]) -> Vec<f64> {
    let mut force = vec![0.0; w.len()];
    plate.terms().iter().for_each(|term| term.add_force(w, &mut force));
    force
}

fn energy(plate: &BondAntiplane, w: &[f64]) -> f64 {
    plate.terms().iter().map(|term| term.survey(w).energy).sum()
}

/// Conjugate gradients from displacements that stay where points are held, without loads elsewhere but `load`.
fn solve(plate: &BondAntiplane, mut w: Vec<f64>, load: &[f64], held: impl Fn(usize) -> bool) -> Vec<f64> {
    let free: Vec<f64> = (0..w.len()).map(|p| f64::from(!held(p))).collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let terms = plate.terms();
    let product = |x: &[f64]| {
        let mut f = vec![0.0; x.len()];
        terms.iter().for_each(|term| term.add_force(x, &mut f));
        f
    };
    let internal = product(&w);
    let mut r: Vec<f64> = (0..w.len()).map(|p| free[p] * (load[p] - internal[p])).collect();
    let (mut p, mut rr) = (r.clone(), dot(&r, &r));
    let small = 1e-28 * rr;
    while rr > small {
        let q: Vec<f64> = product(&p).iter().zip(&free).map(|(q, free)| q * free).collect();
        let step = rr / dot(&p, &q);
        (0..w.len()).for_each(|k| w[k] += step * p[k]);
        (0..w.len()).for_each(|k| r[k] -= step * q[k]);
        let before = std::mem::replace(&mut rr, dot(&r, &r));
        (0..w.len()).for_each(|k| p[k] = r[k] + rr / before * p[k]);
    }
    w
}
