//! Bonds of a uniform lattice: one class per offset, so that geometry and moduli are stored once.

mod assemble;
mod sweep;
mod twofold;
mod weights;

use weights::CHUNK;
pub use weights::{Override, Weights};

use super::{BlockMatrix, ConnectedParts, Survey, Term, Twofold};
use crate::bonds::{BondGeometry, BondModel, Mat, Rows};
use crate::sum::Sum;
use peristat_vector::vectorised;
use std::marker::PhantomData;

/// The points `first .. first + count` of a body of `points` points, in lattice order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lattice {
    /// Points of the whole body: the length of a component plane.
    pub points: usize,
    /// Number of the first lattice point.
    pub first: usize,
    /// Points of the lattice.
    pub count: usize,
}

/// All bonds `(p, p + step)` of a lattice.
#[derive(Clone, Debug)]
struct BondClass<const D: usize, const M: usize> {
    step: usize,
    weight: f64,
    rows: Rows<D, M>,
    modulus: [f64; M],
}

/// Energy of the bonds of a lattice, `E = Σ ½ α s·diag(moduli)·s`, α from [`Weights`].
#[derive(Clone, Debug)]
pub struct LatticeBonds<const D: usize, const M: usize, B> {
    lattice: Lattice,
    classes: Vec<BondClass<D, M>>,
    weights: Weights,
    model: PhantomData<B>,
}

impl<const D: usize, const M: usize, B: BondModel<D, M>> LatticeBonds<D, M, B> {
    /// Bonds of `model` with one geometry per class of the weights.
    ///
    /// # Panics
    /// The weights are those of another lattice or of other classes.
    pub fn new(lattice: Lattice, model: &B, geometries: &[BondGeometry], weights: Weights) -> Self {
        assert_eq!(lattice.count, weights.points(), "the weights are those of the lattice");
        assert_eq!(geometries.len(), weights.classes(), "one geometry per class");
        let class = |(class, &geometry): (usize, &BondGeometry)| BondClass {
            step: weights.step(class),
            weight: weights.of_class(class),
            rows: model.rows(&geometry),
            modulus: model.moduli(&geometry).map(|c| weights.of_class(class) * c),
        };
        let classes = geometries.iter().enumerate().map(class).collect();
        Self { lattice, classes, weights, model: PhantomData }
    }
}

impl<const D: usize, const M: usize, B: BondModel<D, M>> Term<D> for LatticeBonds<D, M, B> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        for (index, class) in self.classes.iter().enumerate() {
            for lower in 0..self.lattice.count.saturating_sub(class.step) {
                if self.weights.weight(index, lower) != 0.0 {
                    let i = self.lattice.first + lower;
                    visit(i, i + class.step);
                }
            }
        }
    }

    fn reach(&self) -> usize {
        self.classes.iter().map(|c| c.step).max().unwrap_or(0)
    }

    fn join(&self, parts: &mut ConnectedParts) {
        let neighbours = self.classes.iter().position(|c| c.step == 1 && c.weight != 0.0);
        for chunk in 0..self.weights.chunks() {
            // In a plain chunk the bonds between neighbours already join every point the longer ones would.
            let first = self.lattice.first;
            match neighbours {
                Some(index) if self.weights.is_plain(chunk) => {
                    let lower = self.weights.bonds_of(index, chunk).0;
                    if !lower.is_empty() {
                        parts.join_run(first + lower.start..=first + lower.end);
                    }
                }
                _ => {
                    for index in 0..self.classes.len() {
                        for lower in self.weights.bonds_of(index, chunk).0 {
                            if self.weights.weight(index, lower) != 0.0 {
                                parts.join(first + lower, first + lower + self.classes[index].step);
                            }
                        }
                    }
                }
            }
        }
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        vectorised(
            #[inline(always)]
            || self.add_force_plain(u, force),
        );
    }

    fn add_force_twofold(&self, u: Twofold<'_>, force: &mut [Sum]) -> bool {
        vectorised(
            #[inline(always)]
            || self.add_twofold(u, force),
        );
        true
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        vectorised(
            #[inline(always)]
            || self.survey_plain(u),
        )
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        self.assemble(tangent);
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        self.assemble_diagonal(blocks);
    }

    fn elements(&self) -> usize {
        self.weights.bonds()
    }

    fn stored_factors(&self) -> usize {
        self.weights.stored_factors()
    }
}
