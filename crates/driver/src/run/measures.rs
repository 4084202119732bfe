//! Worst values, ratios and what springs take: what certificates are made of.

use peristat_assembly::system::System;

/// Points whose rigid motions are found together.
pub(super) const BLOCK: usize = 256;

/// Stored energy over that of a sudden jump, or of loads that do not cancel, below which a solution is free of strain: rounding
/// leaves 1e-32, the slenderest beam of the finest grid 1e-15.
pub(super) const STRAIN_FREE: f64 = 1e-24;

/// A measure of doubt that can be written: the largest number for what is none.
pub(super) fn finite(value: f64) -> f64 {
    worst([value]).min(f64::MAX)
}

/// The largest of some samples; infinite if one of them is no number.
pub(super) fn worst(samples: impl IntoIterator<Item = f64>) -> f64 {
    let number = |sample: f64| if sample.is_nan() { f64::INFINITY } else { sample };
    samples.into_iter().map(number).fold(0.0, f64::max)
}

/// `a / b`, zero where `a` is.
pub(super) fn ratio(a: f64, b: f64) -> f64 {
    if a == 0.0 { 0.0 } else { a / b }
}

/// Forces on the body of the terms that are tied to the ground, by unknown.
pub(super) fn ground<const D: usize>(system: &System<D>, u: &[f64]) -> Vec<(usize, f64)> {
    let mut forces = Vec::new();
    for term in system.terms() {
        let mut unknowns = Vec::new();
        term.ground_motions(&mut |motion| {
            unknowns.extend(motion.iter().map(|&(component, point, _)| component * system.points() + point));
        });
        if !unknowns.is_empty() {
            unknowns.sort_unstable();
            unknowns.dedup();
            let mut force = vec![0.0; system.size()];
            term.add_force(u, &mut force);
            forces.extend(unknowns.into_iter().map(|k| (k, -force[k])));
        }
    }
    forces
}
