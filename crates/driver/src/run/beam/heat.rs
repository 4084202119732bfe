//! What a change of temperature is in results of beams: strains without section forces.

use crate::scene::beam::LineHeat;
use peristat_assembly::model::timoshenko_beam::{BeamFields, PHI, TimoshenkoBeam, U};

/// Takes the section forces of the load of a temperature off those of all loads, and the energy of what needs none; `area` is that of
/// the section, if it is known.
pub(super) fn take_off(heat: &LineHeat, fields: &mut BeamFields, area: Option<f64>) {
    let [axial, moment] = heat.forces;
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
            (n + 0.5 * axial) * heat.strains[0] + (forces.moment[cell][end] + 0.5 * moment) * heat.strains[1]
        });
        let count = sides.clone().count() as f64;
        *density -= sides.sum::<f64>() / count / area;
    }
}

/// Energy of lines that have become warmer beyond that of all strains: `½ Σ L F*·e* − u·f`, f the load of them.
pub(super) fn energy(heat: &[LineHeat], beam: &TimoshenkoBeam, u: &[f64]) -> f64 {
    let n = beam.points();
    let of = |heat: &LineHeat| {
        let chain = &beam.chains()[heat.chain];
        let first = beam.first_real(heat.chain);
        let last = first + chain.points - 1;
        let rise = |component: usize| {
            let plane = u.get(component * n..).unwrap_or_default();
            plane.get(last).zip(plane.get(first)).map_or(0.0, |(last, first)| last - first)
        };
        let [axial, moment] = heat.forces;
        let held = axial * heat.strains[0] + moment * heat.strains[1];
        0.5 * held * chain.line().length - axial * rise(U) - moment * rise(PHI)
    };
    heat.iter().map(of).sum()
}
