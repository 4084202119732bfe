//! The way to the first bonds that soften, and on from where no step of the load factor is short enough.

use super::super::super::RunError;
use super::super::body::{SofteningBonds, State};
use super::super::control::{Control, Goal, Load, Step};
use super::super::course::Course;
use super::super::point::Cost;
use super::{Dissipation, ENOUGH, JUMPS};
use peristat_assembly::law::Law;
use peristat_assembly::stiffness::Answer;

/// Bonds whose ways differ by no more than this part of a step soften together.
const TOGETHER: f64 = 1e-6;
/// Parts of the largest energy that a first step may take.
const ENERGIES: [f64; 3] = [1.0, 0.25, 0.0625];

impl<const D: usize> Dissipation<D> {
    /// A step of the load factor that dissipates no more than it may; where there is none, one of energy that the bonds
    /// drive which such a step would soften first.
    pub(super) fn approach(
        &mut self,
        course: &mut Course<D>,
        goal: Goal,
        load: Load<D>,
    ) -> Result<Step<D>, RunError> {
        let mut refused = 0;
        self.fewest = ENOUGH;
        loop {
            let Step::To(state, mut cost, arrived) = self.start.step(course, goal, load)? else {
                return Ok(Step::Stuck);
            };
            cost.refused += refused;
            if dissipates(course, &state) <= JUMPS * self.largest {
                return Ok(Step::To(state, cost, arrived));
            }
            refused = cost.refused + 1;
            if self.start.shorten() {
                continue;
            }
            let grown = state.load_factor - course.state.load_factor;
            return Ok(match self.snap_back(course, grown, &mut cost)? {
                Some(state) => Step::To(state, cost, false),
                None => Step::To(state, cost, arrived),
            });
        }
    }

    /// A step of energy that bonds drive which would soften first if the load factor grew: as in the last step, or with all
    /// bonds unloading or elastic.
    fn snap_back(
        &mut self,
        course: &mut Course<D>,
        grown: f64,
        cost: &mut Cost,
    ) -> Result<Option<State<D>>, RunError> {
        self.fewest = 1;
        let bonds = &course.body.bonds;
        let slope = |k: usize| bonds.law(k).piece(course.stretch(k), &bonds.history()[k]).slope;
        let elastic: Vec<f64> =
            bonds.list().iter().enumerate().map(|(k, bond)| bond.stiffness * slope(k)).collect();
        let unloading = self.tangent.direction(course, &elastic, 1.0)?;
        for rate in [Some(self.start.direction(course)), unloading].into_iter().flatten() {
            let step: Vec<f64> = rate.iter().map(|u| grown * u).collect();
            let Some(weights) = Self::first_to_soften(course, &step) else { continue };
            self.last = Some((step, grown));
            for part in ENERGIES {
                self.energy = part * self.largest;
                if let Some(state) = self.solve(course, &weights, &mut cost.effort)? {
                    cost.negative = self.tangent.negative_eigenvalues();
                    return Ok(Some(state));
                }
            }
        }
        self.energy = self.largest;
        Ok(None)
    }

    /// Weights of the bonds that soften first along a step that goes on straight.
    fn first_to_soften(course: &Course<D>, step: &[f64]) -> Option<Vec<f64>> {
        let bonds = &course.body.bonds;
        let rates = bonds.elongation_rates(&course.state.answers.bonds, step);
        let way = |k: usize| {
            let left = softens_at(bonds, k) - course.state.answers.bonds[k].elongation;
            let is_there = rates[k] > 0.0 && !bonds.history()[k].broken;
            if is_there { left.max(0.0) / rates[k] } else { f64::INFINITY }
        };
        let ways: Vec<f64> = (0..rates.len()).map(way).collect();
        let first = ways.iter().copied().fold(f64::INFINITY, f64::min);
        let weight = |(k, way): (usize, &f64)| match *way <= first + TOGETHER {
            true => bonds.list()[k].stiffness * bonds.list()[k].length * bonds.law(k).dissipation_rate(),
            false => 0.0,
        };
        first.is_finite().then(|| ways.iter().enumerate().map(weight).collect())
    }
}

/// Elongation at which a bond begins to soften.
pub(super) fn softens_at<const D: usize>(bonds: &SofteningBonds<D>, bond: usize) -> f64 {
    let (history, length) = (&bonds.history()[bond], bonds.list()[bond].length);
    bonds.law(bond).piece(history.permanent, history).upper * length
}

/// Energy that a step to a state dissipates.
pub(super) fn dissipates<const D: usize>(course: &Course<D>, state: &State<D>) -> f64 {
    let bonds = &course.body.bonds;
    let of = |(k, answer): (usize, &Answer<D>)| {
        let (bond, law, history) = (&bonds.list()[k], bonds.law(k), &bonds.history()[k]);
        let stretch = answer.elongation / bond.length;
        let [before, after] = [*history, law.commit(stretch, history)]
            .map(|history| law.energies(stretch, &history).dissipated);
        bond.stiffness * bond.length * bond.length * (after - before)
    };
    state.answers.bonds.iter().enumerate().map(of).sum()
}
