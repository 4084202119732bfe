//! Families of any size: measures that many points make together, such as the strain of a triangle whose corners are no points
//! but move as points nearby do.

use super::{BlockMatrix, Survey, Term, Twofold, twofold};
use crate::bonds::{Mat, add};
use crate::sum::Sum;
use std::array::from_fn;
use std::ops::Range;

/// A point of a family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WideMember<const D: usize, const M: usize> {
    /// Its number.
    pub point: u32,
    /// Share in the motion of the middle; over all members they sum to one.
    pub share: f64,
    /// Measures per unknown of the point.
    pub rows: Mat<M, D>,
}

/// Energy of listed families of any size, `E = Σ ½ sᵀ C s` with the measures `s = Σ rows·u` of their members.
#[derive(Clone, Debug)]
pub struct WideFamilies<const D: usize, const M: usize> {
    points: usize,
    members: Vec<WideMember<D, M>>,
    /// Behind the last member of every family.
    ends: Vec<u32>,
    /// Of every family: the sum of the rows of its members, which is what a common motion makes, and its modulus.
    laws: Vec<(Mat<M, D>, Mat<M, M>)>,
}

impl<const D: usize, const M: usize> WideFamilies<D, M> {
    /// No families yet, of a body of `points` points.
    pub fn new(points: usize) -> Self {
        Self { points, members: Vec::new(), ends: Vec::new(), laws: Vec::new() }
    }

    /// Adds a family with what a common motion of its members makes, known better than by summing their rows, and a symmetric,
    /// positive semidefinite modulus. Rows of the first member are what is left of that.
    pub fn push(&mut self, members: &[WideMember<D, M>], common: Mat<M, D>, modulus: Mat<M, M>) {
        let first = self.members.len();
        self.members.extend_from_slice(members);
        if let Some((own, others)) = self.members[first..].split_first_mut() {
            own.rows = from_fn(|m| {
                from_fn(|c| common[m][c] - others.iter().map(|other| other.rows[m][c]).sum::<f64>())
            });
        }
        self.ends.push(self.members.len() as u32);
        self.laws.push((common, modulus));
    }

    /// Number of families.
    pub fn count(&self) -> usize {
        self.ends.len()
    }

    /// Number of pairs of points that families couple, a point and itself among them.
    pub fn pairs(&self) -> usize {
        self.all().map(|family| self.members(family).len()).map(|count| count * (count + 1) / 2).sum()
    }

    /// The members of a family.
    pub fn members(&self, family: usize) -> &[WideMember<D, M>] {
        let from = if family == 0 { 0 } else { self.ends[family - 1] };
        &self.members[from as usize..self.ends[family] as usize]
    }

    /// What is conjugate to measures of a family.
    pub fn stress(&self, family: usize, s: &[f64; M]) -> [f64; M] {
        let modulus = &self.laws[family].1;
        from_fn(|m| (0..M).map(|k| modulus[m][k] * s[k]).sum())
    }

    /// Adds the forces that do work with the measures of a family as `sigma` does.
    pub fn add_work(&self, family: usize, sigma: &[f64; M], force: &mut [f64]) {
        for member in self.members(family) {
            let action = action(&member.rows, sigma);
            (0..D).for_each(|c| force[c * self.points + member.point as usize] += action[c]);
        }
    }

    fn all(&self) -> Range<usize> {
        0..self.count()
    }

    /// Measures of a family, from unknowns relative to those of its first point: a translation costs no digits.
    fn measures(&self, family: usize, u: &[f64]) -> [f64; M] {
        let Some((first, others)) = self.members(family).split_first() else { return [0.0; M] };
        let common = &self.laws[family].0;
        let first: [f64; D] = from_fn(|c| u[c * self.points + first.point as usize]);
        let mut s: [f64; M] = from_fn(|m| (0..D).map(|c| common[m][c] * first[c]).sum());
        for member in others {
            for c in 0..D {
                let moved = u[c * self.points + member.point as usize] - first[c];
                (0..M).for_each(|m| s[m] += member.rows[m][c] * moved);
            }
        }
        s
    }

    /// The block of two members.
    fn block(&self, family: usize, a: &Mat<M, D>, b: &Mat<M, D>) -> Mat<D, D> {
        let modulus = &self.laws[family].1;
        let conjugate: Mat<M, D> = from_fn(|m| from_fn(|c| (0..M).map(|k| modulus[m][k] * b[k][c]).sum()));
        from_fn(|r| from_fn(|c| (0..M).map(|m| a[m][r] * conjugate[m][c]).sum()))
    }
}

/// Force on a member.
fn action<const D: usize, const M: usize>(rows: &Mat<M, D>, sigma: &[f64; M]) -> [f64; D] {
    from_fn(|c| (0..M).map(|m| rows[m][c] * sigma[m]).sum())
}

impl<const D: usize, const M: usize> Term<D> for WideFamilies<D, M> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        for family in self.all() {
            let members = self.members(family);
            for (k, a) in members.iter().enumerate() {
                members[k + 1..].iter().for_each(|b| visit(a.point as usize, b.point as usize));
            }
        }
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        for family in self.all() {
            self.add_work(family, &self.stress(family, &self.measures(family, u)), force);
        }
    }

    fn add_force_twofold(&self, u: Twofold<'_>, force: &mut [Sum]) -> bool {
        for family in self.all() {
            let (common, modulus) = &self.laws[family];
            twofold::add_wide_family((common, modulus), self.points, self.members(family), u, force);
        }
        true
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        let of = |family: usize| {
            let s = self.measures(family, u);
            let sigma = self.stress(family, &s);
            let actions = self.members(family).iter().map(|member| action(&member.rows, &sigma));
            let largest = actions.fold([0.0; D], |most: [f64; D], a| from_fn(|c| most[c].max(a[c].abs())));
            let energy = (0..M).map(|m| 0.5 * s[m] * sigma[m]).sum();
            Survey { energy, largest_action: largest }
        };
        Survey::of_all(self.count(), of)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        for family in self.all() {
            let members = self.members(family);
            for a in members {
                for b in members.iter().filter(|b| b.point >= a.point) {
                    tangent.add(a.point as usize, b.point as usize, &self.block(family, &a.rows, &b.rows));
                }
            }
        }
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        for family in self.all() {
            for member in self.members(family) {
                add(&mut blocks[member.point as usize], &self.block(family, &member.rows, &member.rows));
            }
        }
    }

    fn elements(&self) -> usize {
        self.count()
    }

    fn stored_factors(&self) -> usize {
        // A member is a point, a share and its rows.
        self.count() * (D * M + M * M) + self.members.len() * (2 + D * M)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stiffness::{Families, Family};

    const MODULUS: Mat<2, 2> = [[7.0, 1.0], [1.0, 3.0]];

    fn family(others: &[u32]) -> WideFamilies<2, 2> {
        let rows = |k: u32| [[1.5 + f64::from(k), -0.5], [0.25, 2.0 - f64::from(k)]];
        let member = |&point: &u32| WideMember { point, share: 0.25, rows: rows(point) };
        let mut families = WideFamilies::new(5);
        let members: Vec<_> = std::iter::once(&0).chain(others).map(member).collect();
        families.push(&members, [[0.0, 0.5], [0.0, 0.0]], MODULUS);
        families
    }

    const U: [f64; 10] = [0.5, 1.0, 3.0, -0.25, 0.75, 2.0, -1.0, 0.125, 4.0, -2.0];

    fn force(term: &dyn Term<2>, u: &[f64]) -> Vec<f64> {
        let mut force = vec![0.0; 10];
        term.add_force(u, &mut force);
        force
    }

    #[test]
    fn of_three_points_it_is_a_family() {
        let wide = family(&[1, 2]);
        let others = [1, 2].map(|k| wide.members(0)[k].rows);
        let own = [[0.0, 0.5], [0.0, 0.0]];
        let one = Family { point: 0, others: [1, 2], rows: others, own, modulus: MODULUS };
        let plain = Families::new(5, vec![one]);
        for (a, b) in force(&wide, &U).iter().zip(force(&plain, &U)) {
            assert!((a - b).abs() < 1e-13);
        }
        assert!((wide.survey(&U).energy - plain.survey(&U).energy).abs() < 1e-13);
    }

    #[test]
    fn tangent_and_both_precisions_are_one_stiffness() {
        let families = family(&[1, 2, 3, 4]);
        let mut twofold = vec![Sum::default(); 10];
        assert!(families.add_force_twofold(Twofold { high: &U, low: &[0.0; 10] }, &mut twofold));
        let terms: Vec<Box<dyn Term<2>>> = vec![Box::new(families)];
        let mut matrix = BlockMatrix::sparse(5, &terms);
        terms[0].add_tangent(&mut matrix);
        let mut diagonal = vec![[[0.0; 2]; 2]; 5];
        terms[0].add_diagonal(&mut diagonal);
        let plain = force(&*terms[0], &U);
        for k in 0..10 {
            assert!((plain[k] - twofold[k].total()).abs() < 1e-13);
            let mut unit = [0.0; 10];
            unit[k] = 1.0;
            let column = force(&*terms[0], &unit);
            assert!((column[k] - diagonal[k % 5][k / 5][k / 5]).abs() < 1e-13);
        }
        assert!(plain.iter().any(|f| f.abs() > 0.1));
    }

    #[test]
    fn a_translation_makes_what_it_is_said_to() {
        let mut u = [1e6 / 7.0; 10];
        u[5..].fill(0.0);
        assert_eq!(family(&[1, 2, 3, 4]).survey(&u).energy, 0.0);
    }
}
