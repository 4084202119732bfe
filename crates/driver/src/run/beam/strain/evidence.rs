//! What a solution in strains is certified with.

use crate::run::certificate::{Balance, Certificate, Seen};
use crate::run::measures::{STRAIN_FREE, finite, ratio, worst};
use peristat_assembly::model::RigidMotion;
use peristat_assembly::model::timoshenko_beam::StrainChecks;

/// What a solution in strains tells of itself.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Evidence {
    /// What the last pass over the strains found.
    pub(super) checks: StrainChecks,
    /// Sums of the magnitudes of all forces and of their moments about the first point.
    pub(super) sizes: [f64; 2],
    /// Number of cells.
    pub(super) cells: usize,
    /// Length of the beam.
    pub(super) length: f64,
    /// Of the stiffness of the strains, scaled by its diagonal.
    pub(super) least_eigenvalue: f64,
    /// What the displacements at the supports lack, relative to the largest.
    pub(super) next_correction: f64,
    /// The same before the rounding of the reactions was taken out; 0 if it was not.
    pub(super) first_correction: f64,
    /// Whether there are loads.
    pub(super) loaded: bool,
    /// What reactions, as doubles, lack makes this much of the actions on the strains at most, √J.
    pub(super) rounding: f64,
    /// Energy of the springs.
    pub(super) spring_energy: f64,
    /// Energy of prescribed motions of about this size, if they are resisted.
    pub(super) jump_energy: f64,
}

/// Certifies a solution in strains.
///
/// The residual is that of `K v = r` for the strains v, with every kind of equation in units of the energy, √K_cc, and r
/// summed anew from the left end and its reactions; so it also says whether the loads are in balance. Scaled like this
/// the stiffness has eigenvalues of about one, unless the bond law locks. The residual over the least of them and the
/// largest strain estimates the error of the strains; the next correction is the larger of this and of what the supports
/// lack. Where springs take nearly all of the energy, strains are measured by it. The work of loads and reactions is that
/// of the displacements: it agrees with the energy of the strains only if these were summed up as the loads were. Section
/// forces are those of reactions that are rounded, which are much larger where a support takes a load at once.
pub(super) fn certify(motions: &[RigidMotion], calibration: f64, evidence: &Evidence) -> Certificate {
    let Evidence { checks, sizes, length, spring_energy, jump_energy, .. } = *evidence;
    let strains = evidence.loaded || checks.energy > STRAIN_FREE * jump_energy;
    let or_zero = |value: f64| if strains { finite(value) } else { 0.0 };
    // Springs do half the work of their reactions, and store it.
    let (energy, work) = (checks.energy + spring_energy, checks.work + spring_energy);
    let energy_balance = or_zero(ratio((energy - work).abs(), energy.abs().max(work.abs())));
    let usual = (energy.abs() / evidence.cells as f64).sqrt();
    let (action, strain) = (checks.action.max(usual), checks.strain.max(usual));
    // Where only moments act, forces are rounding and no measure of themselves.
    let sizes = [sizes[0].max(sizes[1] / length), sizes[1].max(sizes[0] * length)];
    let balance = motions.iter().zip(checks.closure).zip(sizes);
    let balance: Vec<Balance> = balance
        .map(|((motion, sum), size)| Balance {
            motion: motion.name.into(),
            relative: or_zero(ratio(sum.abs(), size)),
        })
        .collect();
    let strain_correction = or_zero(ratio(checks.residual, strain * evidence.least_eigenvalue));
    let next_correction = worst([evidence.next_correction, strain_correction]);
    let seen = Seen {
        correction: next_correction,
        stiffening: strain_correction.powi(2),
        strain_correction: worst([strain_correction, or_zero(ratio(evidence.rounding, action))]),
        imbalance: worst(balance.iter().map(|b| b.relative).chain([energy_balance])),
        calibration,
        contrast: 1.0,
    };
    Certificate {
        residual: or_zero(ratio(checks.residual, action)),
        next_correction,
        first_correction: evidence.first_correction,
        balance,
        energy_balance,
        energy,
        ..seen.certificate(energy.is_finite(), true)
    }
}
