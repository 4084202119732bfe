//! Bonds with memory: each resists its elongation by a law, and remembers what it has been through.

#[cfg(test)]
mod tests;

use super::Parts;
use crate::bonds::Mat;
use crate::law::{BondEnergy, Law};
use rayon::prelude::*;
use std::array::from_fn;

/// Bonds that one thread takes at a time: fixed, so that sums do not depend on the number of threads.
const BLOCK: usize = 2048;

/// Which elongation a displacement gives a bond.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Kinematics {
    /// `e = n·(u_j − u_i)` along the undeformed bond: a turn by θ looks like a stretch of −θ²/2.
    #[default]
    Linear,
    /// `e = |y_j − y_i| − ξ`: rigid motions of any size cost nothing.
    Finite,
}

/// A bond between two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HistoryBond<const D: usize> {
    /// The two points, the lower number first.
    pub points: [u32; 2],
    /// Unit vector from the first to the second.
    pub direction: [f64; D],
    /// Length ξ, m.
    pub length: f64,
    /// Elastic stiffness k, N/m.
    pub stiffness: f64,
    /// Which of the laws it follows.
    pub law: usize,
}

/// What a bond does in a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer<const D: usize> {
    /// Unit vector along the bond as it lies now.
    pub direction: [f64; D],
    /// Elongation e, m.
    pub elongation: f64,
    /// Axial force N, N, positive in tension.
    pub force: f64,
    /// `dN/de`, N/m.
    pub tangent: f64,
    /// Secant stiffness, N/m, >= 0.
    pub secant: f64,
    /// Force over the length that the bond has now, N/m: what resists its turning; zero for linear kinematics.
    pub turning: f64,
}

impl<const D: usize> Answer<D> {
    /// At rest.
    const REST: Self =
        Self { direction: [0.0; D], elongation: 0.0, force: 0.0, tangent: 0.0, secant: 0.0, turning: 0.0 };

    /// The block `(1 − θ) K_t + θ K_s` of the tangent and the secant stiffness on the difference of displacements,
    /// `k n nᵀ + (N/L)(I − n nᵀ)`. The secant one is without the compression that would make it indefinite.
    pub fn block(&self, secant_part: f64) -> Mat<D, D> {
        let axial = (1.0 - secant_part) * self.tangent + secant_part * self.secant;
        let across = if secant_part > 0.0 {
            (1.0 - secant_part) * self.turning + secant_part * self.turning.max(0.0)
        } else {
            self.turning
        };
        let n = &self.direction;
        from_fn(|r| from_fn(|c| (axial - across) * (n[r] * n[c]) + if r == c { across } else { 0.0 }))
    }
}

/// What all bonds do in a state.
#[derive(Clone, Debug)]
pub struct BondAnswers<const D: usize> {
    /// Bond by bond.
    pub bonds: Vec<Answer<D>>,
    /// Incremental potential since the committed state, and what was stored there, J.
    pub energy: f64,
}

/// Bonds with memory between the points of a body, with `D` displacements per point.
#[derive(Clone, Debug)]
pub struct HistoryBonds<const D: usize, L: Law> {
    points: usize,
    kinematics: Kinematics,
    laws: Vec<L>,
    bonds: Vec<HistoryBond<D>>,
    history: Vec<L::History>,
}

impl<const D: usize, L: Law> HistoryBonds<D, L> {
    /// Virgin bonds of a body of `points` points, in the order of their points.
    ///
    /// # Panics
    /// A bond has none of the laws.
    pub fn new(points: usize, kinematics: Kinematics, laws: Vec<L>, mut bonds: Vec<HistoryBond<D>>) -> Self {
        assert!(bonds.iter().all(|b| b.law < laws.len()), "every bond has a law");
        bonds.sort_by_key(|b| b.points);
        let history = vec![L::History::default(); bonds.len()];
        Self { points, kinematics, laws, bonds, history }
    }

    /// The bonds.
    pub fn list(&self) -> &[HistoryBond<D>] {
        &self.bonds
    }

    /// What they remember.
    pub fn history(&self) -> &[L::History] {
        &self.history
    }

    /// Law of a bond.
    pub fn law(&self, bond: usize) -> &L {
        &self.laws[self.bonds[bond].law]
    }

    /// Kinematics of all bonds.
    pub fn kinematics(&self) -> Kinematics {
        self.kinematics
    }

    /// Answers of the bonds at rest.
    pub fn at_rest(&self) -> BondAnswers<D> {
        let mut answers = BondAnswers { bonds: vec![Answer::REST; self.bonds.len()], energy: 0.0 };
        self.evaluate(&vec![0.0; D * self.points], &mut answers);
        answers
    }

    /// Finds what the bonds do under the unknowns `u`, `D` planes, coming from what is committed.
    pub fn evaluate(&self, u: &[f64], answers: &mut BondAnswers<D>) {
        let blocks = answers.bonds.par_chunks_mut(BLOCK).zip(self.bonds.par_chunks(BLOCK));
        let energies: Vec<f64> = blocks
            .zip(self.history.par_chunks(BLOCK))
            .map(|((answers, bonds), history)| {
                let mut energy = 0.0;
                for ((answer, bond), history) in answers.iter_mut().zip(bonds).zip(history) {
                    energy += self.answer(u, (bond, history), answer);
                }
                energy
            })
            .collect();
        answers.energy = energies.iter().sum();
    }

    /// Fills in the answer of a bond and returns its energy.
    #[inline]
    fn answer(
        &self,
        u: &[f64],
        (bond, history): (&HistoryBond<D>, &L::History),
        answer: &mut Answer<D>,
    ) -> f64 {
        let eta = self.difference(u, bond);
        let along: f64 = (0..D).map(|c| bond.direction[c] * eta[c]).sum();
        let mut length = bond.length;
        (answer.elongation, answer.direction) = (along, bond.direction);
        if self.kinematics == Kinematics::Finite {
            let y: [f64; D] = from_fn(|c| bond.length * bond.direction[c] + eta[c]);
            length = y.iter().map(|v| v * v).sum::<f64>().sqrt();
            let squared: f64 = eta.iter().map(|v| v * v).sum();
            // |y| − ξ without the difference of two large numbers.
            answer.elongation = (2.0 * bond.length * along + squared) / (length + bond.length);
            answer.direction = y.map(|v| v / length);
        }
        let stretch = answer.elongation / bond.length;
        let response = self.laws[bond.law].response(stretch, history);
        answer.force = bond.stiffness * bond.length * response.force;
        answer.tangent = bond.stiffness * response.tangent;
        answer.secant = bond.stiffness * response.secant;
        answer.turning = if self.kinematics == Kinematics::Finite { answer.force / length } else { 0.0 };
        bond.stiffness * bond.length * bond.length * response.energy
    }

    #[inline]
    fn difference(&self, u: &[f64], bond: &HistoryBond<D>) -> [f64; D] {
        let [i, j] = bond.points.map(|p| p as usize);
        from_fn(|c| u[c * self.points + j] - u[c * self.points + i])
    }

    /// Adds the forces of bonds with some axial forces on the points, `Σ Bᵀ N`.
    pub fn add_force(&self, answers: &[Answer<D>], mut axial: impl FnMut(usize) -> f64, force: &mut [f64]) {
        for (k, (bond, answer)) in self.bonds.iter().zip(answers).enumerate() {
            let ([i, j], n) = (bond.points.map(|p| p as usize), axial(k));
            for c in 0..D {
                force[c * self.points + i] -= answer.direction[c] * n;
                force[c * self.points + j] += answer.direction[c] * n;
            }
        }
    }

    /// Rates of the elongations while the unknowns change at the rate `v`, m.
    pub fn elongation_rates(&self, answers: &[Answer<D>], v: &[f64]) -> Vec<f64> {
        let rate = |(bond, answer): (&HistoryBond<D>, &Answer<D>)| {
            let eta = self.difference(v, bond);
            (0..D).map(|c| answer.direction[c] * eta[c]).sum()
        };
        self.bonds.par_iter().zip(answers).with_min_len(BLOCK).map(rate).collect()
    }

    /// Commits a state; returns how many bonds have changed and how many of them broke.
    pub fn commit(&mut self, answers: &BondAnswers<D>) -> [usize; 2] {
        let (mut changed, mut broke) = (0, 0);
        for ((bond, answer), history) in self.bonds.iter().zip(&answers.bonds).zip(&mut self.history) {
            let law = &self.laws[bond.law];
            let next = law.commit(answer.elongation / bond.length, history);
            if next != *history {
                changed += 1;
                broke += usize::from(law.is_broken(&next) && !law.is_broken(history));
                *history = next;
            }
        }
        [changed, broke]
    }

    /// The largest angle, rad, by which a bond that still bears something has turned under the unknowns `u`.
    pub fn largest_turn(&self, u: &[f64]) -> f64 {
        let intact = self.bonds.iter().zip(&self.history).filter(|(b, h)| !self.laws[b.law].is_broken(h));
        let turn = |(bond, _): (&HistoryBond<D>, &L::History)| {
            let eta = self.difference(u, bond);
            let along: f64 = (0..D).map(|c| bond.direction[c] * eta[c]).sum();
            let across = (0..D).map(|c| (eta[c] - along * bond.direction[c]).powi(2)).sum::<f64>().sqrt();
            across.atan2(bond.length + along)
        };
        intact.map(turn).fold(0.0, f64::max)
    }

    /// Breaks a bond for good.
    pub fn fail(&mut self, bond: usize) {
        let law = self.laws[self.bonds[bond].law];
        self.history[bond] = law.broken(&self.history[bond]);
    }

    /// Goes on from what bonds remembered.
    ///
    /// # Panics
    /// There are not as many histories as bonds.
    pub fn restore(&mut self, history: Vec<L::History>) {
        assert_eq!(history.len(), self.bonds.len(), "every bond has a history");
        self.history = history;
    }

    /// Energies in the committed state, J.
    pub fn energies(&self, answers: &BondAnswers<D>) -> BondEnergy {
        let of = |k: usize| {
            let (bond, answer) = (&self.bonds[k], &answers.bonds[k]);
            let energy = self.laws[bond.law].energies(answer.elongation / bond.length, &self.history[k]);
            let scale = bond.stiffness * bond.length * bond.length;
            BondEnergy { stored: scale * energy.stored, dissipated: scale * energy.dissipated }
        };
        let mut sum = BondEnergy::default();
        // In blocks: the error of a long sum grows with its number of terms.
        for first in (0..self.bonds.len()).step_by(BLOCK) {
            let mut part = BondEnergy::default();
            for energy in (first..self.bonds.len().min(first + BLOCK)).map(of) {
                part.stored += energy.stored;
                part.dissipated += energy.dissipated;
            }
            sum.stored += part.stored;
            sum.dissipated += part.dissipated;
        }
        sum
    }

    /// Parts of the body that bonds which still bear something hold together.
    pub fn connected(&self) -> Parts {
        let mut parts = Parts::new(self.points);
        let intact = self.bonds.iter().zip(&self.history).filter(|(b, h)| !self.laws[b.law].is_broken(h));
        intact.for_each(|(bond, _)| parts.join(bond.points[0] as usize, bond.points[1] as usize));
        parts
    }

    /// How far bonds have softened, with the stiffness of each as its weight, per point: 0 to 1.
    pub fn damage(&self) -> Vec<f64> {
        let (mut sum, mut weight) = (vec![0.0; self.points], vec![0.0; self.points]);
        for (bond, history) in self.bonds.iter().zip(&self.history) {
            let share = self.laws[bond.law].damage(history);
            for point in bond.points.map(|p| p as usize) {
                sum[point] += bond.stiffness * share;
                weight[point] += bond.stiffness;
            }
        }
        sum.iter().zip(&weight).map(|(sum, weight)| if *weight > 0.0 { sum / weight } else { 0.0 }).collect()
    }
}
