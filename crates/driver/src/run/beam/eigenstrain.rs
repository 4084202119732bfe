//! What strains without stress are in results of beams.

use crate::scene::beam::Eigenstrain;
use peristat_assembly::model::timoshenko_beam::{BeamFields, PHI, TimoshenkoBeam, U};

/// Takes the section forces of the load of such strains off those of all loads, and the energy of what needs none; `area` is that of
/// the section, if it is known.
pub(super) fn take_off(given: &Eigenstrain, fields: &mut BeamFields, area: Option<f64>) {
    let [axial, moment] = given.forces;
    let forces = &mut fields.forces;
    forces.moment.iter_mut().flatten().for_each(|m| *m -= moment);
    forces.axial.iter_mut().flatten().for_each(|n| *n -= axial);
    let Some(area) = area else { return };
    // ½ c (e − e*)² is ½ c e² − F* e + ½ F* e*, with F* = c e* and c e = F + F*: that less F e*, and less ½ F* e*.
    let cells = forces.moment.len();
    for (point, density) in fields.energy_density.iter_mut().enumerate() {
        let beside = [point.checked_sub(1).map(|cell| (cell, 1)), (point < cells).then_some((point, 0))];
        let sides = beside.into_iter().flatten().map(|(cell, end)| {
            let n = forces.axial.get(cell).map_or(0.0, |n| n[end]);
            (n + 0.5 * axial) * given.strains[0]
                + (forces.moment[cell][end] + 0.5 * moment) * given.strains[1]
        });
        let count = sides.clone().count() as f64;
        *density -= sides.sum::<f64>() / count / area;
    }
}

/// Energy of lines with such strains beyond that of all strains: `½ Σ L F*·e* − u·f`, f the load of them.
pub(super) fn energy(all: &[Eigenstrain], beam: &TimoshenkoBeam, u: &[f64]) -> f64 {
    let n = beam.points();
    let of = |given: &Eigenstrain| {
        let chain = &beam.chains()[given.chain];
        let first = beam.first_real(given.chain);
        let last = first + chain.points - 1;
        let rise = |component: usize| {
            let plane = u.get(component * n..).unwrap_or_default();
            plane.get(last).zip(plane.get(first)).map_or(0.0, |(last, first)| last - first)
        };
        let [axial, moment] = given.forces;
        let held = axial * given.strains[0] + moment * given.strains[1];
        0.5 * held * chain.line().length - axial * rise(U) - moment * rise(PHI)
    };
    all.iter().map(of).sum()
}
