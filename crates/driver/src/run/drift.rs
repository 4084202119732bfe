//! How far springs let a body go that an iteration has not brought to where they hold it.

use super::measures::{ground, ratio, worst};
use super::workspace::{StateSolution, size};
use nalgebra::{DMatrix, DVector};
use peristat_assembly::model::Model;
use peristat_assembly::system::{FreeMotion, System, sprung_motions};

/// Motions that are looked at together.
const TOGETHER: usize = 32;

/// How far the residual would carry a body along the motions that only springs resist, part by part, relative to the largest
/// unknown: where springs are soft enough an iteration ends before it has met them. With a factor there is no such doubt.
pub(super) fn drift<const D: usize>(
    model: &dyn Model<D>,
    system: &System<D>,
    load: &[f64],
    solution: &StateSolution,
    scales: &[f64; D],
) -> f64 {
    if !system.terms().iter().any(|term| term.is_grounded()) {
        return 0.0;
    }
    let mut residual = vec![0.0; system.size()];
    system.force(&solution.u, &mut residual);
    residual.iter_mut().zip(load).for_each(|(r, f)| *r = f - *r);
    system.constraints().restrict(&mut residual);
    let motions = motions(model, system);
    let far = motions.chunks(TOGETHER).map(|some| carried(some, system, &residual, scales));
    ratio(worst(far), size(&solution.u, scales))
}

/// Unknowns that a motion moves, and how far.
type Motion = Vec<(usize, f64)>;

fn motions<const D: usize>(model: &dyn Model<D>, system: &System<D>) -> Vec<Motion> {
    let (parts, points) = (model.connected(), system.points());
    let unknowns = |motion: &FreeMotion| {
        let at = |point: usize| {
            motion.at(model, &parts, point).into_iter().enumerate().map(move |(c, v)| (c * points + point, v))
        };
        (0..points).flat_map(at).filter(|moved| moved.1 != 0.0).collect()
    };
    sprung_motions(model, system).iter().map(unknowns).collect()
}

/// The displacement along some motions by which springs would take a residual: `Σ aᵢ mᵢ` with `G a = w`, their stiffness on the
/// motions and the work of the residual. A motion that is softer than rounding is as soft as that.
fn carried<const D: usize>(
    motions: &[Motion],
    system: &System<D>,
    residual: &[f64],
    scales: &[f64; D],
) -> f64 {
    let n = motions.len();
    let along = |motion: &Motion, of: &[f64]| motion.iter().map(|&(k, v)| v * of[k]).sum::<f64>();
    let mut stiffness = DMatrix::zeros(n, n);
    for (i, motion) in motions.iter().enumerate() {
        let (mut moved, mut force) = (vec![0.0; system.size()], vec![0.0; system.size()]);
        motion.iter().for_each(|&(k, v)| moved[k] = v);
        ground(system, &moved).into_iter().for_each(|(k, f)| force[k] -= f);
        motions.iter().enumerate().for_each(|(j, other)| stiffness[(i, j)] = along(other, &force));
    }
    let work = DVector::from_iterator(n, motions.iter().map(|motion| along(motion, residual)));
    // The search for eigenvalues of what is no number would not end.
    if stiffness.iter().chain(&work).any(|value| !value.is_finite()) {
        return f64::INFINITY;
    }
    let eigen = stiffness.symmetric_eigen();
    let mut amounts = eigen.eigenvectors.transpose() * work;
    let largest = eigen.eigenvalues.amax();
    for (amount, value) in amounts.iter_mut().zip(&eigen.eigenvalues) {
        *amount = ratio(*amount, value.max(f64::EPSILON * largest));
    }
    let amounts = &eigen.eigenvectors * amounts;
    let mut moved = vec![0.0; system.size()];
    for (motion, amount) in motions.iter().zip(&amounts) {
        motion.iter().for_each(|&(k, v)| moved[k] += amount * v);
    }
    size(&moved, scales)
}
