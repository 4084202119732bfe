//! What every result is certified with.

use super::drift::drift;
use super::measures::{BLOCK, STRAIN_FREE, finite, ground, ratio, worst};
use super::problem::Spread;
use super::weigh::work;
use super::workspace::StateSolution;
use super::{Problem, Resultants, extent};
use peristat_assembly::model::{Model, RigidMotion};
use peristat_assembly::stiffness::Survey;
use peristat_assembly::sum::Sum;
use peristat_assembly::system::System;
use peristat_solve::PcgStatus;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// Imbalance of one rigid motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Balance {
    /// The motion that loads and reactions must do no work on.
    pub motion: Cow<'static, str>,
    /// Sum of their works over the sum of the magnitudes.
    pub relative: f64,
}

/// Numbers that show whether a solution is one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Certificate {
    /// Whether the solve settled and left digits that can be trusted.
    pub converged: bool,
    /// Digits of displacements and rotations that can be trusted.
    pub digits: u32,
    /// Digits of strains, and so of stresses, section forces and reactions, that can be trusted.
    pub strain_digits: u32,
    /// Bound on the error of displacements and rotations by rounding and iteration, relative to the largest.
    pub error: f64,
    /// Bound on the error of strains by rounding and iteration, relative to the largest; and of reactions.
    pub strain_error: f64,
    /// Largest element-wise residual over the largest end action of a bond, the worst component.
    pub residual: f64,
    /// Correction that one more solve would make, relative to the largest unknown of its kind: an estimate of the
    /// algebraic error.
    pub next_correction: f64,
    /// How wrong the plain direct answer was, in energy norm; in the strain form how far off the supports it was.
    pub first_correction: f64,
    /// Loads and reactions against every rigid motion: forces and moments.
    pub balance: Vec<Balance>,
    /// Stored energy against the work of loads and reactions, relative (Clapeyron).
    pub energy_balance: f64,
    /// Stored energy.
    pub energy: f64,
    /// Resultants of loads as they were asked for and as they act, and of reactions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub resultants: Option<Resultants>,
}

impl Certificate {
    /// Takes the resultants of a state. Other loads than were asked for are no solution, unless they are those of a published
    /// form, which has them in the limit: then the `slack` is infinite.
    pub(super) fn account(&mut self, resultants: Resultants, slack: f64) {
        if resultants.difference > slack {
            self.converged = false;
            self.strain_error = self.strain_error.max(resultants.difference);
            self.strain_digits = trusted(self.strain_error);
        }
        self.resultants = Some(resultants);
    }
}

/// What is seen of an error is a sample of it: bound over sample. The stress suite finds errors of up to 20 samples.
const SAFETY: f64 = 30.0;

/// Fewer digits than this deserve a warning, and do not do for a solve that ended before it was done.
pub(crate) const FEW_DIGITS: u32 = 6;

/// Certifies a solution; `scales` are displacements of each component that count as equally large, so that forces and
/// moments can be compared by their works.
pub(super) fn certify<const D: usize>(
    problem: &dyn Problem<D>,
    system: &System<D>,
    load: &[f64],
    solution: &StateSolution,
    scales: &[f64; D],
) -> Certificate {
    let (model, u) = (problem.model(), &solution.u);
    let (energy, action) = match &solution.stored {
        Some((energy, largest_action)) => (*energy, work(largest_action, scales)),
        None => {
            let Survey { energy, largest_action } = system.survey(u);
            (energy, work(&largest_action, scales))
        }
    };
    let residual = ratio(work(&solution.residual, scales), action);
    let mut works = Sum::default();
    u.iter().zip(load).for_each(|(u, f)| works.add(0.5 * u * f));
    solution.held.iter().for_each(|&(k, r)| works.add(0.5 * u[k] * r));
    let works = works.total();
    let energy_balance = ratio((energy - works).abs(), energy.abs().max(works.abs()));
    // Motions alone that strain nothing leave only the rounding of a sudden jump, which has no balance.
    let jumps = !is_loaded(system, load) && energy <= STRAIN_FREE * solution.jump_energy;
    let strains = !(jumps || solution.cancels);
    let or_zero = |value: f64| if strains { value } else { 0.0 };
    let mut balance = balance(model, load, solution.held.iter().copied().chain(ground(system, u)));
    balance.iter_mut().for_each(|b| b.relative = if jumps { 0.0 } else { finite(b.relative) });
    let energy_balance = finite(or_zero(energy_balance));
    let adrift = if solution.by_factor { 0.0 } else { drift(model, system, load, solution, scales) };
    let stiffening = ratio(solution.correction_energy, 2.0 * energy.abs());
    let usual = solution.action.max(usual_action(system, load, scales));
    let (strain_correction, action) = match problem.spread() {
        // Section forces are sums of loads and of what holds a line: only the energy density is one of strains.
        Spread::Chain => (stiffening.sqrt(), solution.action),
        _ => (ratio(solution.correction_action, usual), usual),
    };
    let held_error = ratio(solution.held_error, action);
    let seen = Seen {
        correction: worst([solution.next_correction, adrift]),
        stiffening: or_zero(stiffening),
        strain_correction: or_zero(worst([strain_correction, held_error])),
        imbalance: worst(balance.iter().map(|b| b.relative).chain([energy_balance])),
        calibration: model.calibration_error(),
        contrast: model.contrast(),
    };
    let status = solution.status;
    let failed =
        matches!(status, PcgStatus::NotFinite | PcgStatus::IndefiniteOperator) || !energy.is_finite();
    Certificate {
        residual: finite(or_zero(residual)),
        next_correction: finite(solution.next_correction),
        first_correction: finite(solution.first_correction),
        balance,
        energy_balance,
        energy,
        ..seen.certificate(!failed, status == PcgStatus::Converged)
    }
}

/// The action of an element, as a work, of a body in the plane that bears its loads by strains; what is held bears its own. One that
/// hands each load to a spring beneath it has actions that are rounding, and no measure of themselves.
fn usual_action<const D: usize>(system: &System<D>, load: &[f64], scales: &[f64; D]) -> f64 {
    /// Bonds of a point that share what a section bears.
    const BONDS: f64 = 10.0;
    let points = load.len() / D;
    let work = |unknown: usize| scales[unknown / points] * load[unknown].abs();
    let all: f64 = (0..load.len()).map(work).sum();
    let held: f64 = prescribed(system).map(work).sum();
    (all - held).max(0.0) / (BONDS * (points as f64).sqrt())
}

/// Samples of the errors of a solution, all relative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    /// Of displacements.
    pub(super) correction: f64,
    /// Of the energy, by strains that are rounding: they resist a motion that would cost none.
    pub(super) stiffening: f64,
    /// Of strains.
    pub(super) strain_correction: f64,
    /// Of forces, moments and energies.
    pub(super) imbalance: f64,
    /// Of the numbers that the model is made of.
    pub(super) calibration: f64,
    /// How much larger errors may be in one strain than in all.
    pub(super) contrast: f64,
}

impl Seen {
    /// Bounds and digits, and whether they do: for a solve that is not `sound` never, for one that did not reach its own
    /// `end` if they are not few. All else is zero.
    pub(super) fn certificate(self, sound: bool, end: bool) -> Certificate {
        let bound = |sample: f64| (SAFETY * sample).min(f64::MAX);
        let calibration = self.contrast * self.calibration;
        let error = bound(worst([self.correction, self.stiffening, calibration]));
        let strain_error = bound(worst([self.strain_correction, self.imbalance, calibration]));
        let [digits, strain_digits] = [error, strain_error].map(trusted);
        let least = if end { 1 } else { FEW_DIGITS };
        Certificate {
            converged: sound && digits >= least && strain_digits >= 1,
            digits,
            strain_digits,
            error,
            strain_error,
            residual: 0.0,
            next_correction: 0.0,
            first_correction: 0.0,
            balance: Vec::new(),
            energy_balance: 0.0,
            energy: 0.0,
            resultants: None,
        }
    }
}

/// Digits that a relative error leaves.
fn trusted(error: f64) -> u32 {
    (-error.log10()).floor().clamp(0.0, 15.0) as u32
}

/// The unknowns that nothing but prescribed motions moves.
fn prescribed<const D: usize>(system: &System<D>) -> impl Iterator<Item = usize> {
    let held = system.constraints().rows().iter().filter(|row| row.masters.is_empty());
    held.map(|row| row.unknown)
}

/// Whether a load acts on anything that can move.
fn is_loaded<const D: usize>(system: &System<D>, load: &[f64]) -> bool {
    let on_held = prescribed(system).filter(|unknown| load[*unknown] != 0.0).count();
    load.iter().filter(|f| **f != 0.0).count() > on_held
}

/// Work of all forces on the body in every rigid motion, over the sum of the magnitudes. The sum is at least what the works
/// in the other motions make of it: where only moments act, forces are rounding and no measure of themselves.
pub(super) fn balance<const D: usize>(
    model: &dyn Model<D>,
    load: &[f64],
    reactions: impl Iterator<Item = (usize, f64)>,
) -> Vec<Balance> {
    // Rotations about the first point: a far origin would hide an imbalance behind large arms.
    let (n, origin) = (model.points(), model.position(0));
    let mut sums = vec![(Sum::default(), 0.0_f64); model.rigid_motions().len()];
    let add = |(sum, size): &mut (Sum, f64), work: f64| {
        sum.add(work);
        *size += work.abs();
    };
    let mut motions = [[0.0; D]; BLOCK];
    for (component, plane) in load.chunks_exact(n).enumerate() {
        for (block, forces) in plane.chunks(BLOCK).enumerate().filter(|(_, f)| f.iter().any(|f| *f != 0.0)) {
            for (kind, sum) in sums.iter_mut().enumerate() {
                model.rigid_motions_from(kind, block * BLOCK, origin, &mut motions[..forces.len()]);
                forces.iter().zip(&motions).for_each(|(force, motion)| add(sum, motion[component] * force));
            }
        }
    }
    for (unknown, force) in reactions.filter(|reaction| reaction.1 != 0.0) {
        for (kind, sum) in sums.iter_mut().enumerate() {
            add(sum, model.rigid_motion(kind, unknown % n, origin)[unknown / n] * force);
        }
    }
    let sizes: Vec<f64> = (0..sums.len()).map(|kind| extent::displacement(model, kind, origin)).collect();
    let least = sums.iter().zip(&sizes).map(|(sum, size)| sum.1 / size).fold(0.0, f64::max);
    let balance = |((motion, (sum, scale)), size): ((&RigidMotion, (Sum, f64)), &f64)| Balance {
        motion: motion.name.into(),
        relative: ratio(sum.total().abs(), scale.max(least * size)),
    };
    model.rigid_motions().iter().zip(sums).zip(&sizes).map(balance).collect()
}

#[cfg(test)]
mod tests {
    use super::{FEW_DIGITS, Seen, trusted};

    #[test]
    fn an_error_leaves_the_digits_before_it() {
        assert_eq!([0.2, 0.1, 3e-7, 1e-20, 0.0].map(trusted), [0, 1, 6, 15, 15]);
        assert_eq!([1.0, 1e300, f64::MAX].map(trusted), [0; 3]);
    }

    const SEEN: Seen = Seen {
        correction: 1e-14,
        stiffening: 1e-24,
        strain_correction: 1e-12,
        imbalance: 1e-13,
        calibration: 1e-15,
        contrast: 1.0,
    };

    #[test]
    fn the_largest_sample_decides() {
        let certificate = SEEN.certificate(true, true);
        assert_eq!([certificate.error, certificate.strain_error].map(|e| (e / 3e-13).round()), [1.0, 100.0]);
        assert_eq!((certificate.converged, certificate.digits, certificate.strain_digits), (true, 12, 10));
        let calibrated = Seen { calibration: 1e-9, ..SEEN }.certificate(true, true);
        assert_eq!([calibrated.digits, calibrated.strain_digits], [7, 7]);
        assert_eq!(Seen { imbalance: 1e-5, ..SEEN }.certificate(true, true).strain_digits, 3);
        let rounded = Seen { stiffening: 1e-8, strain_correction: 1e-4, ..SEEN }.certificate(true, true);
        assert_eq!((rounded.digits, rounded.strain_digits), (6, 2));
        // What the numbers of bonds lack weighs as the moduli differ.
        let stiff = Seen { calibration: 1e-9, contrast: 10.0, ..SEEN }.certificate(true, true);
        assert_eq!([stiff.digits, stiff.strain_digits], [6, 6]);
        assert!(!SEEN.certificate(false, true).converged);
    }

    #[test]
    fn what_ended_early_needs_more_than_a_digit() {
        let with = |correction: f64, end: bool| Seen { correction, ..SEEN }.certificate(true, end);
        let [rough, fine] = [1e-6, 1e-8];
        assert!(with(rough, true).converged && with(rough, true).digits < FEW_DIGITS);
        assert!(!with(rough, false).converged && with(fine, false).converged);
        assert!(!with(0.01, true).converged);
    }

    #[test]
    fn a_sample_that_is_no_number_leaves_no_digits_and_a_bound_that_is_one() {
        let lost = [
            Seen { correction: f64::NAN, ..SEEN },
            Seen { strain_correction: f64::NAN, ..SEEN },
            Seen { imbalance: f64::INFINITY, ..SEEN },
        ];
        for seen in lost {
            let certificate = seen.certificate(true, true);
            assert!(!certificate.converged, "{certificate:?}");
            assert!(certificate.error.is_finite() && certificate.strain_error.is_finite(), "{certificate:?}");
        }
    }
}
