//! What strains without stress are in results of beams.

use crate::scene::beam::Eigenstrain;
use peristat_assembly::model::timoshenko_beam::{PHI, SectionForces, TimoshenkoBeam, U};

/// Takes the section forces of the load of such strains off those of all loads.
pub(super) fn take_off(given: &Eigenstrain, forces: &mut SectionForces) {
    let [axial, moment] = given.forces;
    forces.moment.iter_mut().flatten().for_each(|m| *m -= moment);
    forces.axial.iter_mut().flatten().for_each(|n| *n -= axial);
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
