//! Bonds with memory: each resists its elongation by a law, and remembers what it has been through.

mod answer;
mod ends;
#[cfg(test)]
mod tests;

pub use answer::{Answer, BondAnswers, Kinematics};
pub use ends::EndedBond;

use super::ConnectedParts;
use crate::law::{BondEnergy, Law};
use ends::Ends;
use rayon::prelude::*;
use std::array::from_fn;

/// Bonds that one thread takes at a time: fixed, so that sums do not depend on the number of threads.
const BLOCK: usize = 2048;

/// A bond between two points, or two places that move with points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HistoryBond<const D: usize> {
    /// The two points, the lower number first; between places those that move the ends most.
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

/// Bonds with memory between the points of a body, with `D` displacements per point.
#[derive(Clone, Debug)]
pub struct HistoryBonds<const D: usize, L: Law> {
    points: usize,
    kinematics: Kinematics,
    laws: Vec<L>,
    /// Those between points come first.
    bonds: Vec<HistoryBond<D>>,
    ends: Ends,
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
        let ends = Ends::new(bonds.len());
        Self { points, kinematics, laws, bonds, ends, history }
    }

    /// The same with virgin bonds between places, behind those that there are.
    ///
    /// # Panics
    /// A bond has none of the laws.
    #[must_use]
    pub fn with_ended(mut self, bonds: Vec<EndedBond<D>>) -> Self {
        assert!(bonds.iter().all(|b| b.bond.law < self.laws.len()), "every bond has a law");
        for ended in bonds {
            self.bonds.push(ended.bond);
            self.ends.push(&ended.shares, (ended.share, ended.of));
            self.history.push(L::History::default());
        }
        self
    }

    /// The bonds.
    pub fn list(&self) -> &[HistoryBond<D>] {
        &self.bonds
    }

    /// What they remember.
    pub fn history(&self) -> &[L::History] {
        &self.history
    }

    /// Takes over what bonds like these remembered.
    ///
    /// # Panics
    /// They are not as many.
    pub fn set_history(&mut self, history: Vec<L::History>) {
        assert_eq!(history.len(), self.bonds.len(), "every bond has a memory");
        self.history = history;
    }

    /// Points and their shares in the difference of the displacements of the ends of a bond; they sum to zero.
    pub fn shares(&self, bond: usize) -> impl Iterator<Item = (u32, f64)> + '_ {
        let (plain, placed) = match self.ends.shares(bond) {
            Some(shares) => (None, shares),
            None => (Some(self.bonds[bond].points), &[][..]),
        };
        let plain = plain.into_iter().flat_map(|[i, j]| [(i, -1.0), (j, 1.0)]);
        plain.chain(placed.iter().copied())
    }

    /// Points in whose families a bond is, with the part that its energy is of what it stands for there.
    pub fn families(&self, bond: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let (plain, placed) = match self.ends.stands_for(bond) {
            Some((_, of)) => (None, of),
            None => (Some(self.bonds[bond].points), &[][..]),
        };
        let plain = plain.into_iter().flatten().map(|point| (point, 1.0));
        plain.chain(placed.iter().copied()).map(|(point, part)| (point as usize, part))
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
            .enumerate()
            .map(|(block, ((answers, bonds), history))| {
                let mut energy = 0.0;
                for (k, ((answer, bond), history)) in answers.iter_mut().zip(bonds).zip(history).enumerate() {
                    let eta = self.difference(u, block * BLOCK + k, bond);
                    energy += self.answer(eta, (bond, history), answer);
                }
                energy
            })
            .collect();
        answers.energy = energies.iter().sum();
    }

    /// Fills in the answer of a bond to a difference of displacements and returns its energy.
    #[inline]
    fn answer(
        &self,
        eta: [f64; D],
        (bond, history): (&HistoryBond<D>, &L::History),
        answer: &mut Answer<D>,
    ) -> f64 {
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
    fn difference(&self, u: &[f64], number: usize, bond: &HistoryBond<D>) -> [f64; D] {
        if let Some(shares) = self.ends.shares(number) {
            return ends::difference(u, self.points, shares);
        }
        let [i, j] = bond.points.map(|p| p as usize);
        from_fn(|c| u[c * self.points + j] - u[c * self.points + i])
    }

    /// Adds the forces of bonds with some axial forces on the points, `Σ Bᵀ N`.
    pub fn add_force(&self, answers: &[Answer<D>], mut axial: impl FnMut(usize) -> f64, force: &mut [f64]) {
        for (k, (bond, answer)) in self.bonds.iter().zip(answers).enumerate() {
            let ([i, j], n) = (bond.points.map(|p| p as usize), axial(k));
            if let Some(shares) = self.ends.shares(k) {
                for &(point, share) in shares {
                    (0..D).for_each(|c| {
                        force[c * self.points + point as usize] += share * (answer.direction[c] * n);
                    });
                }
                continue;
            }
            for c in 0..D {
                force[c * self.points + i] -= answer.direction[c] * n;
                force[c * self.points + j] += answer.direction[c] * n;
            }
        }
    }

    /// Rates of the elongations while the unknowns change at the rate `v`, m.
    pub fn elongation_rates(&self, answers: &[Answer<D>], v: &[f64]) -> Vec<f64> {
        let rate = |(k, (bond, answer)): (usize, (&HistoryBond<D>, &Answer<D>))| {
            let eta = self.difference(v, k, bond);
            (0..D).map(|c| answer.direction[c] * eta[c]).sum()
        };
        self.bonds.par_iter().zip(answers).enumerate().with_min_len(BLOCK).map(rate).collect()
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
        let turn = |(k, bond): (usize, &HistoryBond<D>)| {
            let eta = self.difference(u, k, bond);
            let along: f64 = (0..D).map(|c| bond.direction[c] * eta[c]).sum();
            let across = (0..D).map(|c| (eta[c] - along * bond.direction[c]).powi(2)).sum::<f64>().sqrt();
            across.atan2(bond.length + along)
        };
        self.intact().map(turn).fold(0.0, f64::max)
    }

    /// Numbers of the bonds that still bear something, and these.
    fn intact(&self) -> impl Iterator<Item = (usize, &HistoryBond<D>)> {
        let all = self.bonds.iter().enumerate();
        all.filter(|(k, bond)| !self.laws[bond.law].is_broken(&self.history[*k]))
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
    pub fn connected(&self) -> ConnectedParts {
        let mut parts = ConnectedParts::new(self.points);
        for (k, bond) in self.intact() {
            let first = bond.points[0] as usize;
            self.shares(k).for_each(|(point, _)| parts.join(first, point as usize));
        }
        parts
    }

    /// How far bonds have softened, with the stiffness of each as its weight, per point: 0 to 1.
    pub fn damage(&self) -> Vec<f64> {
        let (mut sum, mut weight) = (vec![0.0; self.points], vec![0.0; self.points]);
        for (k, (bond, history)) in self.bonds.iter().zip(&self.history).enumerate() {
            let share = self.laws[bond.law].damage(history);
            // A shorter bond is stiffer by its length squared per part of the energy.
            let of_whole = self.ends.stands_for(k).map_or(1.0, |(share, _)| share * share) * bond.stiffness;
            for (point, part) in self.families(k) {
                let stiffness = of_whole / part;
                sum[point] += stiffness * share;
                weight[point] += stiffness;
            }
        }
        sum.iter().zip(&weight).map(|(sum, weight)| if *weight > 0.0 { sum / weight } else { 0.0 }).collect()
    }
}
