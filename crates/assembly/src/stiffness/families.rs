//! Families of a fixed size: a point and a few others whose motion relative to it makes measures, such as the strain of a
//! triangle.

use super::{BlockMatrix, Survey, Term, Twofold, twofold};
use crate::bonds::{Mat, add};
use crate::sum::Sum;
use std::array::from_fn;

/// A point, `E` others, and the measures `s = own·u_point + Σ_e rows[e]·(u_others[e] − u_point)` that they make together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Family<const D: usize, const M: usize, const E: usize> {
    /// The point.
    pub point: u32,
    /// The other points.
    pub others: [u32; E],
    /// Measures per relative displacement of each other point.
    pub rows: [Mat<M, D>; E],
    /// Measures per unknown of the point itself.
    pub own: Mat<M, D>,
    /// Symmetric, positive semidefinite modulus conjugate to the measures.
    pub modulus: Mat<M, M>,
}

/// Energy of listed families, `E = Σ ½ sᵀ C s`.
#[derive(Clone, Debug)]
pub struct Families<const D: usize, const M: usize, const E: usize> {
    points: usize,
    families: Vec<Family<D, M, E>>,
}

impl<const D: usize, const M: usize, const E: usize> Family<D, M, E> {
    /// Measures in a body of `points` points.
    #[inline(always)]
    pub fn measures(&self, points: usize, u: &[f64]) -> [f64; M] {
        let own: [f64; D] = from_fn(|c| u[c * points + self.point as usize]);
        let mut s: [f64; M] = from_fn(|m| (0..D).map(|c| self.own[m][c] * own[c]).sum());
        for (&other, rows) in self.others.iter().zip(&self.rows) {
            for c in 0..D {
                let moved = u[c * points + other as usize] - own[c];
                for m in 0..M {
                    s[m] += rows[m][c] * moved;
                }
            }
        }
        s
    }

    /// What is conjugate to measures.
    #[inline(always)]
    pub fn stress(&self, s: &[f64; M]) -> [f64; M] {
        from_fn(|m| (0..M).map(|k| self.modulus[m][k] * s[k]).sum())
    }

    /// Forces on the other points; the point itself gets the negative of their sum, and what its own rows make.
    #[inline(always)]
    fn actions(&self, sigma: &[f64; M]) -> [[f64; D]; E] {
        from_fn(|e| from_fn(|c| (0..M).map(|m| self.rows[e][m][c] * sigma[m]).sum()))
    }

    /// Adds the forces that do work with the measures as `sigma` does, in a body of `points` points.
    pub fn add_work(&self, points: usize, sigma: &[f64; M], force: &mut [f64]) {
        let actions = self.actions(sigma);
        for (&other, action) in self.others.iter().zip(&actions) {
            for c in 0..D {
                force[c * points + other as usize] += action[c];
                force[c * points + self.point as usize] -= action[c];
            }
        }
        for c in 0..D {
            let own: f64 = (0..M).map(|m| self.own[m][c] * sigma[m]).sum();
            force[c * points + self.point as usize] += own;
        }
    }

    /// Adds to planes of its point the first of what is conjugate to its measures, and in a further plane its energy, both over a
    /// volume, m³.
    pub fn add_densities(&self, planes: usize, volume: f64, u: &[f64], sums: &mut [f64]) {
        let (n, point) = (sums.len() / (planes + 1), self.point as usize);
        let state = self.measures(n, u);
        let action = self.stress(&state);
        (0..planes).for_each(|q| sums[q * n + point] += action[q] / volume);
        let energy: f64 = (0..M).map(|q| 0.5 * state[q] * action[q]).sum();
        sums[planes * n + point] += energy / volume;
    }

    /// Adds the forces that do the work of what it is conjugate to with the values `t` of its point, planes of the first measures:
    /// the adjoint of its densities over no volume.
    pub fn add_strain_work(&self, planes: usize, t: &[f64], force: &mut [f64]) {
        let n = t.len() / planes;
        let own: [f64; M] = from_fn(|q| if q < planes { t[q * n + self.point as usize] } else { 0.0 });
        if own != [0.0; M] {
            self.add_work(n, &self.stress(&own), force);
        }
    }

    /// The block of two of its members.
    fn block(&self, a: &Mat<M, D>, b: &Mat<M, D>) -> Mat<D, D> {
        let conjugate: Mat<M, D> =
            from_fn(|m| from_fn(|c| (0..M).map(|k| self.modulus[m][k] * b[k][c]).sum()));
        from_fn(|r| from_fn(|c| (0..M).map(|m| a[m][r] * conjugate[m][c]).sum()))
    }

    /// Points and the rows that multiply their unknowns, the point itself first.
    fn members(&self) -> impl Iterator<Item = (usize, Mat<M, D>)> + '_ {
        let sum = |m: usize, c: usize| self.rows.iter().map(|rows| rows[m][c]).sum::<f64>();
        let own = from_fn(|m| from_fn(|c| self.own[m][c] - sum(m, c)));
        let others = self.others.iter().zip(&self.rows).map(|(&p, rows)| (p as usize, *rows));
        std::iter::once((self.point as usize, own)).chain(others)
    }
}

impl<const D: usize, const M: usize, const E: usize> Families<D, M, E> {
    /// The families of a body of `points` points.
    pub fn new(points: usize, families: Vec<Family<D, M, E>>) -> Self {
        Self { points, families }
    }

    /// All of them.
    pub fn list(&self) -> &[Family<D, M, E>] {
        &self.families
    }

    /// Keeps those that are wanted.
    pub fn retain(&mut self, wanted: impl Fn(&Family<D, M, E>) -> bool) {
        self.families.retain(wanted);
    }
}

impl<const D: usize, const M: usize, const E: usize> Term<D> for Families<D, M, E> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        for family in &self.families {
            let members: Vec<usize> = family.members().map(|m| m.0).collect();
            for (k, &i) in members.iter().enumerate() {
                members[k + 1..].iter().for_each(|&j| visit(i, j));
            }
        }
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        let n = self.points;
        for family in &self.families {
            family.add_work(n, &family.stress(&family.measures(n, u)), force);
        }
    }

    fn add_force_twofold(&self, u: Twofold<'_>, force: &mut [Sum]) -> bool {
        self.families.iter().for_each(|family| twofold::add_family(family, self.points, u, force));
        true
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        let of = |family: usize| {
            let family = &self.families[family];
            let s = family.measures(self.points, u);
            let sigma = family.stress(&s);
            let actions = family.actions(&sigma);
            let largest = |c: usize| actions.iter().map(|a| a[c].abs()).fold(0.0, f64::max);
            let energy = (0..M).map(|m| 0.5 * s[m] * sigma[m]).sum();
            Survey { energy, largest_action: from_fn(largest) }
        };
        Survey::of_all(self.families.len(), of)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        for family in &self.families {
            for (i, a) in family.members() {
                for (j, b) in family.members().filter(|(j, _)| *j >= i) {
                    tangent.add(i, j, &family.block(&a, &b));
                }
            }
        }
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        for family in &self.families {
            family.members().for_each(|(i, a)| add(&mut blocks[i], &family.block(&a, &a)));
        }
    }

    fn elements(&self) -> usize {
        self.families.len()
    }

    fn stored_factors(&self) -> usize {
        self.families.len() * ((E + 1) * M * D + M * M)
    }
}
