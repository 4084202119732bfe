//! Bonds between places that are no points, such as the border of a body: a place moves as a weighted mean of points.

use super::{BlockMatrix, Survey, Term, Twofold, twofold};
use crate::bonds::{Mat, Rows, add, block};
use crate::sum::Sum;
use std::array::from_fn;
use std::ops::Range;

/// Points and their shares in the motion of a place; they sum to one.
pub type Place = Vec<(u32, f64)>;

/// A bond between two places.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedBond<const D: usize, const M: usize> {
    /// The two places.
    pub ends: [Place; 2],
    /// Points and their shares in the mean displacement, where they are not those of both ends alike.
    pub mean: Option<Place>,
    /// Measures.
    pub rows: Rows<D, M>,
    /// Moduli conjugate to the measures, weight included, >= 0.
    pub moduli: [f64; M],
}

/// A point that moves a bond.
#[derive(Clone, Copy, Debug)]
pub(super) struct Member {
    /// Its number.
    pub(super) point: u32,
    /// Share in the relative displacement of the ends; over all members they sum to zero.
    pub(super) difference: f64,
    /// Share in the mean displacement of the ends; they sum to one.
    pub(super) mean: f64,
}

/// Energy of listed bonds between places, `E = Σ ½ s·diag(moduli)·s`.
#[derive(Clone, Debug)]
pub struct PlacedBonds<const D: usize, const M: usize> {
    points: usize,
    members: Vec<Member>,
    /// Behind the last member of every bond.
    ends: Vec<u32>,
    laws: Vec<(Rows<D, M>, [f64; M])>,
}

impl<const D: usize, const M: usize> PlacedBonds<D, M> {
    /// No bonds yet, of a body of `points` points.
    pub fn new(points: usize) -> Self {
        Self { points, members: Vec::new(), ends: Vec::new(), laws: Vec::new() }
    }

    /// Adds a bond; the two points that have the largest parts in the relative displacement of its ends, one on either side.
    pub fn push(&mut self, bond: &PlacedBond<D, M>) -> [u32; 2] {
        let members = members(bond);
        let by = |a: &&Member, b: &&Member| a.difference.total_cmp(&b.difference);
        let foremost = [members.iter().min_by(by), members.iter().max_by(by)];
        self.members.extend(&members);
        self.ends.push(self.members.len() as u32);
        self.laws.push((bond.rows, bond.moduli));
        foremost.map(|member| member.map_or(0, |m| m.point))
    }

    /// Number of bonds.
    pub fn count(&self) -> usize {
        self.ends.len()
    }

    /// Number of pairs of points that bonds couple, a point and itself among them.
    pub fn pairs(&self) -> usize {
        self.all().map(|bond| self.members(bond).len()).map(|count| count * (count + 1) / 2).sum()
    }

    /// The points that move a bond, with their shares in the displacement of its middle.
    pub fn middle(&self, bond: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.members(bond).iter().map(|m| (m.point as usize, m.mean))
    }

    /// The points that move a bond, with their shares in the relative displacement of its ends, which sum to zero.
    pub fn difference(&self, bond: usize) -> impl Iterator<Item = (u32, f64)> + '_ {
        self.members(bond).iter().map(|m| (m.point, m.difference))
    }

    /// Measures of a bond by its points.
    pub fn rows(&self, bond: usize) -> &Rows<D, M> {
        &self.laws[bond].0
    }

    /// Some of the bonds.
    pub fn part(&self, bonds: &[usize]) -> Self {
        let mut part = Self::new(self.points);
        for &bond in bonds {
            part.members.extend_from_slice(self.members(bond));
            part.ends.push(part.members.len() as u32);
            part.laws.push(self.laws[bond]);
        }
        part
    }

    /// Takes all points from some bonds, which keep their numbers.
    pub fn remove(&mut self, bonds: &[usize]) {
        let mut gone = vec![false; self.count()];
        bonds.iter().for_each(|&bond| gone[bond] = true);
        let (mut members, mut ends) =
            (Vec::with_capacity(self.members.len()), Vec::with_capacity(gone.len()));
        for bond in self.all() {
            if !gone[bond] {
                members.extend_from_slice(self.members(bond));
            }
            ends.push(members.len() as u32);
        }
        (self.members, self.ends) = (members, ends);
    }

    /// Moduli of a bond, weight included.
    pub fn moduli(&self, bond: usize) -> &[f64; M] {
        &self.laws[bond].1
    }

    /// Adds the forces on points that do the work of the conjugate forces of a bond.
    pub fn add_work(&self, bond: usize, sigma: &[f64; M], force: &mut [f64]) {
        let rows = &self.laws[bond].0;
        for member in self.members(bond) {
            let action = action(rows, member, sigma);
            (0..D).for_each(|c| force[c * self.points + member.point as usize] += action[c]);
        }
    }

    fn members(&self, bond: usize) -> &[Member] {
        let from = if bond == 0 { 0 } else { self.ends[bond - 1] };
        &self.members[from as usize..self.ends[bond] as usize]
    }

    fn all(&self) -> Range<usize> {
        0..self.count()
    }

    /// Measures of a bond, from displacements relative to those of its first point: a translation costs no digits.
    pub fn measures(&self, bond: usize, u: &[f64]) -> [f64; M] {
        let rows = &self.laws[bond].0;
        let Some((first, others)) = self.members(bond).split_first() else { return [0.0; M] };
        let at = |c: usize, m: &Member| u[c * self.points + m.point as usize];
        let first: [f64; D] = from_fn(|c| at(c, first));
        let (mut difference, mut mean) = ([0.0; D], first);
        for member in others {
            for c in 0..D {
                let moved = at(c, member) - first[c];
                difference[c] += member.difference * moved;
                mean[c] += member.mean * moved;
            }
        }
        let part = |m: usize, c: usize| rows.difference[m][c] * difference[c] + rows.mean[m][c] * mean[c];
        from_fn(|m| (0..D).map(|c| part(m, c)).sum())
    }

    fn conjugate(&self, bond: usize, s: &[f64; M]) -> [f64; M] {
        from_fn(|m| self.laws[bond].1[m] * s[m])
    }
}

/// The points of both ends and of the mean, once each, with their shares.
fn members<const D: usize, const M: usize>(bond: &PlacedBond<D, M>) -> Vec<Member> {
    let mut all: Vec<Member> = Vec::new();
    let mut add = |point: u32, difference: f64, mean: f64| match all.iter_mut().find(|m| m.point == point) {
        Some(known) => {
            known.difference += difference;
            known.mean += mean;
        }
        None => all.push(Member { point, difference, mean }),
    };
    let both = if bond.mean.is_none() { 0.5 } else { 0.0 };
    for (place, sign) in bond.ends.iter().zip([-1.0, 1.0]) {
        place.iter().for_each(|&(point, share)| add(point, sign * share, both * share));
    }
    bond.mean.iter().flatten().for_each(|&(point, share)| add(point, 0.0, share));
    all.retain(|m| m.difference != 0.0 || m.mean != 0.0);
    // Shares that rounding lets sum to something else would resist a translation.
    if let Some((first, others)) = all.split_first_mut() {
        first.difference = -others.iter().map(|m| m.difference).sum::<f64>();
        first.mean = 1.0 - others.iter().map(|m| m.mean).sum::<f64>();
    }
    all
}

/// Rows that multiply the unknowns of a member.
pub(super) fn row<const D: usize, const M: usize>(rows: &Rows<D, M>, member: &Member) -> Mat<M, D> {
    from_fn(|m| from_fn(|c| member.difference * rows.difference[m][c] + member.mean * rows.mean[m][c]))
}

/// Force on a member.
fn action<const D: usize, const M: usize>(rows: &Rows<D, M>, member: &Member, sigma: &[f64; M]) -> [f64; D] {
    let row = row(rows, member);
    from_fn(|c| (0..M).map(|m| row[m][c] * sigma[m]).sum())
}

impl<const D: usize, const M: usize> Term<D> for PlacedBonds<D, M> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        for bond in self.all() {
            let members = self.members(bond);
            for (k, a) in members.iter().enumerate() {
                members[k + 1..].iter().for_each(|b| visit(a.point as usize, b.point as usize));
            }
        }
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        for bond in self.all() {
            self.add_work(bond, &self.conjugate(bond, &self.measures(bond, u)), force);
        }
    }

    fn add_force_twofold(&self, u: Twofold<'_>, force: &mut [Sum]) -> bool {
        for bond in self.all() {
            let (rows, moduli) = &self.laws[bond];
            twofold::add_placed_bond((rows, moduli), self.points, self.members(bond), u, force);
        }
        true
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        let of = |bond: usize| {
            let s = self.measures(bond, u);
            let sigma = self.conjugate(bond, &s);
            let actions = self.members(bond).iter().map(|m| action(&self.laws[bond].0, m, &sigma));
            let largest = actions.fold([0.0; D], |most: [f64; D], a| from_fn(|c| most[c].max(a[c].abs())));
            let energy = (0..M).map(|m| 0.5 * s[m] * sigma[m]).sum();
            Survey { energy, largest_action: largest }
        };
        Survey::of_all(self.count(), of)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        for bond in self.all() {
            let (rows, moduli) = &self.laws[bond];
            let members = self.members(bond);
            for a in members {
                let own = row(rows, a);
                for b in members.iter().filter(|b| b.point >= a.point) {
                    tangent.add(a.point as usize, b.point as usize, &block(&own, moduli, &row(rows, b)));
                }
            }
        }
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        for bond in self.all() {
            let (rows, moduli) = &self.laws[bond];
            for member in self.members(bond) {
                let own = row(rows, member);
                add(&mut blocks[member.point as usize], &block(&own, moduli, &own));
            }
        }
    }

    fn elements(&self) -> usize {
        self.count()
    }

    fn stored_factors(&self) -> usize {
        // A member is two numbers and a point.
        self.count() * (2 * D * M + M) + 3 * self.members.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stiffness::{Bond, Bonds};

    /// A beam bond over a length of one, γ = (w_j − w_i) − (φ_i + φ_j)/2 and φ_j − φ_i.
    fn rows() -> Rows<2, 2> {
        Rows { difference: [[1.0, 0.0], [0.0, 1.0]], mean: [[0.0, -1.0], [0.0, 0.0]] }
    }

    /// A bond from a point to a place between two others, one of which it has in common with the first end.
    fn placed() -> PlacedBonds<2, 2> {
        let ends = [vec![(1, 1.5), (0, -0.5)], vec![(1, 0.25), (2, 0.75)]];
        one(3, PlacedBond { ends, mean: None, rows: rows(), moduli: [7.0, 3.0] })
    }

    fn one<const M: usize>(points: usize, bond: PlacedBond<2, M>) -> PlacedBonds<2, M> {
        let mut bonds = PlacedBonds::new(points);
        bonds.push(&bond);
        bonds
    }

    #[test]
    fn between_points_it_is_a_bond() {
        let ends = [vec![(0, 1.0)], vec![(1, 1.0)]];
        let placed = one(2, PlacedBond { ends, mean: None, rows: rows(), moduli: [7.0, 3.0] });
        let bond = Bond { points: [0, 1], rows: rows(), moduli: [7.0, 3.0] };
        let plain = Bonds::new(2, std::iter::once(bond));
        let u = [0.25, 0.5, -0.125, 0.75];
        let force = |term: &dyn Term<2>| {
            let mut force = vec![0.0; 4];
            term.add_force(&u, &mut force);
            force
        };
        assert_eq!(force(&placed), force(&plain));
        assert_eq!(placed.survey(&u).energy, plain.survey(&u).energy);
    }

    #[test]
    fn ends_move_with_their_points() {
        let u = [0.5, 1.0, 3.0, -0.25, 0.75, 2.0];
        // w of the ends: 1.5 − 0.25 and 0.25 + 2.25; φ: 1.125 + 0.125 and 0.1875 + 1.5.
        let shear: f64 = (2.5 - 1.25) - 0.5 * (1.25 + 1.6875);
        let turn: f64 = 1.6875 - 1.25;
        let energy = 0.5 * (7.0 * shear * shear + 3.0 * turn * turn);
        assert!((placed().survey(&u).energy - energy).abs() < 1e-15);
    }

    #[test]
    fn tangent_and_both_precisions_are_one_stiffness() {
        let (bonds, u) = (placed(), [0.5, 1.0, 3.0, -0.25, 0.75, 2.0]);
        let mut force = vec![0.0; 6];
        bonds.add_force(&u, &mut force);
        let mut twofold = vec![Sum::default(); 6];
        assert!(bonds.add_force_twofold(Twofold { high: &u, low: &[0.0; 6] }, &mut twofold));
        let terms: Vec<Box<dyn Term<2>>> = vec![Box::new(bonds)];
        let mut matrix = BlockMatrix::sparse(3, &terms);
        terms[0].add_tangent(&mut matrix);
        let mut diagonal = vec![[[0.0; 2]; 2]; 3];
        terms[0].add_diagonal(&mut diagonal);
        for k in 0..6 {
            assert!((force[k] - twofold[k].total()).abs() < 1e-15);
            let mut unit = [0.0; 6];
            unit[k] = 1.0;
            let mut column = vec![0.0; 6];
            terms[0].add_force(&unit, &mut column);
            assert!((column[k] - diagonal[k % 3][k / 3][k / 3]).abs() < 1e-15);
        }
        assert!(force.iter().any(|f| f.abs() > 0.1));
    }

    #[test]
    fn a_translation_strains_nothing() {
        let third = 1.0 / 3.0;
        let ends = [vec![(0, third), (1, third), (2, 1.0 - 2.0 * third)], vec![(2, 0.1), (0, 0.9)]];
        let rows = Rows { difference: [[0.6, 0.8]], mean: [[0.0; 2]] };
        let bonds = one(3, PlacedBond { ends, mean: None, rows, moduli: [1.0] });
        assert_eq!(bonds.survey(&[1e6 / 7.0; 6]).energy, 0.0);
    }
}
