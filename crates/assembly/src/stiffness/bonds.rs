//! Bonds that share nothing: graded grids, varying sections.

use super::{BlockMatrix, Survey, Term, Twofold, twofold};
use crate::bonds::{Mat, Rows, add, block};
use crate::sum::Sum;
use std::array::from_fn;

/// A bond with its own measures and moduli.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bond<const D: usize, const M: usize> {
    /// The two points, the lower number first.
    pub points: [u32; 2],
    /// Measures.
    pub rows: Rows<D, M>,
    /// Moduli conjugate to the measures, weight included, >= 0.
    pub moduli: [f64; M],
}

/// Energy of listed bonds, `E = Σ ½ s·diag(moduli)·s`.
#[derive(Clone, Debug)]
pub struct Bonds<const D: usize, const M: usize> {
    points: usize,
    bonds: Vec<Bond<D, M>>,
}

impl<const D: usize, const M: usize> Bond<D, M> {
    #[inline(always)]
    fn ends(&self) -> [usize; 2] {
        self.points.map(|p| p as usize)
    }

    /// Measures and conjugate forces in a body of `points` points.
    #[inline(always)]
    pub fn response(&self, points: usize, u: &[f64]) -> ([f64; M], [f64; M]) {
        let [i, j] = self.ends();
        let difference: [f64; D] = from_fn(|c| u[c * points + j] - u[c * points + i]);
        let mean: [f64; D] = from_fn(|c| 0.5 * (u[c * points + i] + u[c * points + j]));
        let measure = |m: usize| {
            let part = |c: usize| self.rows.difference[m][c] * difference[c] + self.rows.mean[m][c] * mean[c];
            (0..D).map(part).sum::<f64>()
        };
        let s: [f64; M] = from_fn(measure);
        (s, from_fn(|m| self.moduli[m] * s[m]))
    }

    /// Adds the forces on its points, of `points` in all, that do the work of forces conjugate to its measures.
    pub fn add_work(&self, points: usize, sigma: &[f64; M], force: &mut [f64]) {
        let [i, j] = self.ends();
        let (first, second) = (self.rows.first(), self.rows.second());
        for c in 0..D {
            force[c * points + i] += (0..M).map(|m| first[m][c] * sigma[m]).sum::<f64>();
            force[c * points + j] += (0..M).map(|m| second[m][c] * sigma[m]).sum::<f64>();
        }
    }
}

impl<const D: usize, const M: usize> Bonds<D, M> {
    /// The bonds of a body of `points` points; bonds of no modulus are left out.
    pub fn new(points: usize, bonds: impl Iterator<Item = Bond<D, M>>) -> Self {
        Self { points, bonds: bonds.filter(|b| b.moduli.iter().any(|c| *c != 0.0)).collect() }
    }

    /// All of them.
    pub fn list(&self) -> &[Bond<D, M>] {
        &self.bonds
    }

    /// Keeps those that are wanted.
    pub fn retain(&mut self, wanted: impl Fn(&Bond<D, M>) -> bool) {
        self.bonds.retain(wanted);
    }
}

impl<const D: usize, const M: usize> Term<D> for Bonds<D, M> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        self.bonds.iter().map(Bond::ends).for_each(|[i, j]| visit(i, j));
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        for bond in &self.bonds {
            let ([i, j], (_, sigma)) = (bond.ends(), bond.response(self.points, u));
            for c in 0..D {
                let difference: f64 = (0..M).map(|m| bond.rows.difference[m][c] * sigma[m]).sum();
                let mean: f64 = (0..M).map(|m| 0.5 * bond.rows.mean[m][c] * sigma[m]).sum();
                force[c * self.points + i] += mean - difference;
                force[c * self.points + j] += mean + difference;
            }
        }
    }

    fn add_force_twofold(&self, u: Twofold<'_>, force: &mut [Sum]) -> bool {
        for bond in &self.bonds {
            let rows = [&bond.rows.difference, &bond.rows.half_mean()];
            twofold::add_bond((rows, &bond.moduli), self.points, bond.ends(), u, force);
        }
        true
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        let of = |bond: usize| {
            let bond = &self.bonds[bond];
            let (s, sigma) = bond.response(self.points, u);
            let ends = [bond.rows.first(), bond.rows.second()];
            let action = |c: usize| {
                let at = |b: &[[f64; D]; M]| (0..M).map(|m| b[m][c] * sigma[m]).sum::<f64>().abs();
                at(&ends[0]).max(at(&ends[1]))
            };
            let energy = (0..M).map(|m| 0.5 * s[m] * sigma[m]).sum();
            Survey { energy, largest_action: from_fn(action) }
        };
        Survey::of_all(self.bonds.len(), of)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        for bond in &self.bonds {
            let [i, j] = bond.ends();
            let (first, second) = (bond.rows.first(), bond.rows.second());
            tangent.add(i, i, &block(&first, &bond.moduli, &first));
            tangent.add(i, j, &block(&first, &bond.moduli, &second));
            tangent.add(j, j, &block(&second, &bond.moduli, &second));
        }
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        for bond in &self.bonds {
            let [i, j] = bond.ends();
            let (first, second) = (bond.rows.first(), bond.rows.second());
            add(&mut blocks[i], &block(&first, &bond.moduli, &first));
            add(&mut blocks[j], &block(&second, &bond.moduli, &second));
        }
    }

    fn elements(&self) -> usize {
        self.bonds.len()
    }

    fn stored_factors(&self) -> usize {
        self.bonds.len() * (2 * D * M + M)
    }
}
