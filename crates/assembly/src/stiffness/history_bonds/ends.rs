//! Bonds with memory between places: their ends move as weighted means of points.

use super::HistoryBond;
use std::array::from_fn;

/// A bond with memory between places that are no points, such as the border of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct EndedBond<const D: usize> {
    /// What it is but for how its ends move.
    pub bond: HistoryBond<D>,
    /// Points and their shares in the difference of the displacements of its ends; they sum to zero.
    pub shares: Vec<(u32, f64)>,
    /// Its length over that of a whole bond.
    pub share: f64,
    /// Points whose missing bonds it stands for, with the part that its energy is of theirs.
    pub of: Vec<(u32, f64)>,
}

/// How the ends of bonds between places move.
#[derive(Clone, Debug)]
pub(super) struct Ends {
    /// Number of the first of them: bonds before it lie between points.
    first: usize,
    shares: Vec<(u32, f64)>,
    /// Behind the last share of every one.
    behind: Vec<u32>,
    of: Vec<(f64, Vec<(u32, f64)>)>,
}

impl Ends {
    /// No such bonds, behind some between points.
    pub(super) fn new(first: usize) -> Self {
        Self { first, shares: Vec::new(), behind: Vec::new(), of: Vec::new() }
    }

    pub(super) fn push(&mut self, shares: &[(u32, f64)], of: (f64, Vec<(u32, f64)>)) {
        self.shares.extend_from_slice(shares);
        self.behind.push(self.shares.len() as u32);
        self.of.push(of);
    }

    /// Points and their shares; none of a bond between points.
    #[inline]
    pub(super) fn shares(&self, bond: usize) -> Option<&[(u32, f64)]> {
        let k = bond.checked_sub(self.first)?;
        let from = if k == 0 { 0 } else { self.behind[k - 1] };
        Some(&self.shares[from as usize..self.behind[k] as usize])
    }

    /// Its length over that of a whole bond, and the points whose missing bonds it stands for; none of a bond between points.
    pub(super) fn stands_for(&self, bond: usize) -> Option<(f64, &[(u32, f64)])> {
        bond.checked_sub(self.first).map(|k| (self.of[k].0, &self.of[k].1[..]))
    }
}

/// Difference of the displacements of the ends, from displacements relative to those of the first point: a translation costs
/// no digits.
pub(super) fn difference<const D: usize>(u: &[f64], points: usize, shares: &[(u32, f64)]) -> [f64; D] {
    let Some((&(first, _), others)) = shares.split_first() else { return [0.0; D] };
    from_fn(|c| {
        let of = |point: u32| u[c * points + point as usize];
        others.iter().map(|&(point, share)| share * (of(point) - of(first))).sum()
    })
}

#[cfg(test)]
mod tests {
    use super::super::{HistoryBonds, Kinematics};
    use super::*;
    use crate::law::Bilinear;
    use crate::law::{Compression, Unloading};

    /// A bond from a point to a place that moves with three others, behind one between points.
    fn bonds(kinematics: Kinematics) -> HistoryBonds<2, Bilinear> {
        let bond =
            |points, stiffness| HistoryBond { points, direction: [0.6, 0.8], length: 0.7, stiffness, law: 0 };
        let third = 1.0 / 3.0;
        let shares = vec![(0, -1.0), (1, 1.5), (2, -0.5 * third), (3, -third)];
        let law = Bilinear::new([0.01, 0.05], Unloading::Damage, Compression::Elastic).unwrap();
        let ended = EndedBond { bond: bond([0, 1], 3.0), shares, share: 0.4, of: vec![(0, 0.4)] };
        HistoryBonds::new(4, kinematics, vec![law], vec![bond([0, 2], 2.0)]).with_ended(vec![ended])
    }

    #[test]
    fn forces_are_the_gradient_of_the_energy() {
        const STEP: f64 = 1e-7;
        for kinematics in [Kinematics::Linear, Kinematics::Finite] {
            let bonds = bonds(kinematics);
            let energy = |u: &[f64]| {
                let mut answers = bonds.at_rest();
                bonds.evaluate(u, &mut answers);
                answers.energy
            };
            // The first bond has a stretch of 0.9 %, the second one softens.
            let u = [0.0, 0.02, 0.008, 0.003, 0.0, 0.004, 0.002, -0.004];
            let (mut answers, mut force) = (bonds.at_rest(), vec![0.0; 8]);
            bonds.evaluate(&u, &mut answers);
            assert!(answers.bonds[1].tangent < 0.0 && answers.bonds[0].tangent > 0.0);
            bonds.add_force(&answers.bonds, |k| answers.bonds[k].force, &mut force);
            for k in 0..8 {
                let [low, high] = [-STEP, STEP].map(|step| {
                    let mut u = u;
                    u[k] += step;
                    energy(&u)
                });
                // Forces are of the order of 0.02; measured: 1e-10.
                assert!(((high - low) / (2.0 * STEP) - force[k]).abs() < 1e-8, "{kinematics:?} {k}");
            }
        }
    }

    #[test]
    fn a_translation_strains_nothing() {
        let (bonds, mut answers) = (bonds(Kinematics::Finite), bonds(Kinematics::Finite).at_rest());
        bonds.evaluate(&[1e6 / 7.0; 8], &mut answers);
        assert_eq!(answers.energy, 0.0);
    }

    #[test]
    fn all_points_that_move_a_bond_hang_together_until_it_fails() {
        let mut bonds = bonds(Kinematics::Linear);
        assert_eq!(bonds.connected().numbered().spans().len(), 1);
        bonds.fail(1);
        // Point 0 and 2 by the bond between them, 1 and 3 alone.
        assert_eq!(bonds.connected().numbered().spans().len(), 3);
        // The part counts for the point that it begins at, as the whole bond: 0.4 × 3 beside 2.
        let damage = bonds.damage();
        assert!((damage[0] - 1.2 / 3.2).abs() < 1e-15 && damage[1..] == [0.0; 3], "{damage:?}");
    }
}
