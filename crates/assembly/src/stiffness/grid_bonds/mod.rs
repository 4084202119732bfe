//! Bonds of a lattice by offset: nothing is stored per bond. One type for every lattice and every bond model.

mod assemble;
mod beside;
mod breaking;
mod chunk_forces;
mod chunks;
mod gather;
mod precision;
mod shares;
mod survey;

pub use chunks::Exception;

use super::{BlockMatrix, ConnectedParts, Survey, TakeForces, Term, Twofold, twofold};
use crate::body::{Cell, SquareLattice};
use crate::bonds::{BondGeometry, BondModel, Mat};
use crate::sum::Sum;
use chunks::{CHUNK, Chunks};
use std::array::from_fn;
use std::marker::PhantomData;
use std::sync::Arc;

/// The bonds of one offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Offset<const M: usize> {
    /// From the lower point of a bond to the other, cells: to a higher layer, up in the same one, or to the right in the same row.
    pub step: Cell,
    /// Multiply the moduli of the bonds, >= 0.
    pub weights: [f64; M],
}

/// Rows and moduli of the bonds of one offset.
#[derive(Clone, Debug)]
struct Class<const D: usize, const M: usize, R = f64> {
    step: Cell,
    difference: [[R; D]; M],
    /// Half of the rows for the mean displacement.
    half_mean: [[R; D]; M],
    modulus: [R; M],
}

impl<const D: usize, const M: usize> Class<D, M> {
    /// In numbers of 32 bits.
    fn in_single(&self) -> Class<D, M, f32> {
        let single = |numbers: &Mat<M, D>| numbers.map(|row| row.map(|number| number as f32));
        Class {
            step: self.step,
            difference: single(&self.difference),
            half_mean: single(&self.half_mean),
            modulus: self.modulus.map(|number| number as f32),
        }
    }
}

/// Energy of the bonds of a lattice, `E = Σ ½ f s·diag(moduli)·s`, the factor f of a bond one but for exceptions.
#[derive(Clone, Debug)]
pub struct GridBonds<const D: usize, const M: usize, B> {
    lattice: Arc<SquareLattice>,
    classes: Vec<Class<D, M>>,
    in_single: Vec<Class<D, M, f32>>,
    chunks: Chunks,
    bonds: usize,
    model: PhantomData<B>,
}

impl<const D: usize, const M: usize, B: BondModel<D, M>> GridBonds<D, M, B> {
    /// Bonds of `model` between all points of the lattice at the offsets; factors of several exceptions on one bond
    /// multiply.
    ///
    /// # Panics
    /// An offset does not go to a higher layer, nor up in its own, nor to the right in its row.
    pub fn new(
        lattice: Arc<SquareLattice>,
        model: &B,
        offsets: &[Offset<M>],
        exceptions: &[Exception],
    ) -> Self {
        let class = |offset: &Offset<M>| {
            let [a, b, c] = offset.step;
            assert!(
                [c, b, a] > [0; 3],
                "an offset goes to a higher layer, up in its own, or to the right in its row"
            );
            let bond = BondGeometry { xi: lattice.vector(offset.step) };
            let (rows, moduli) = (model.rows(&bond), model.moduli(&bond));
            Class {
                step: offset.step,
                difference: rows.difference,
                half_mean: rows.half_mean(),
                modulus: from_fn(|m| offset.weights[m] * moduli[m]),
            }
        };
        let classes: Vec<Class<D, M>> = offsets.iter().map(class).collect();
        let steps: Vec<Cell> = offsets.iter().map(|o| o.step).collect();
        let chunks = Chunks::new(&lattice, &steps, exceptions);
        let in_single = classes.iter().map(Class::in_single).collect();
        let mut bonds = Self { lattice, classes, in_single, chunks, bonds: 0, model: PhantomData };
        bonds.bonds = bonds.count();
        bonds
    }

    /// The same with a factor for every bond, by index of its offset and its points, the lower one first.
    ///
    /// # Panics
    /// As [`new`](Self::new).
    pub fn with_factors(
        lattice: Arc<SquareLattice>,
        model: &B,
        offsets: &[Offset<M>],
        factor: impl Fn(usize, [usize; 2]) -> f64,
    ) -> Self {
        let mut bonds = Self::new(lattice, model, offsets, &[]);
        let mut factors = Vec::new();
        bonds.for_each_bond(|offset, ends, _| {
            let factor = factor(offset, ends);
            if factor != 1.0 {
                factors.push((offset as u32, ends.map(|p| p as u32), factor));
            }
        });
        for (offset, [lower, upper], factor) in factors {
            bonds.chunks.multiply(2 * offset as usize, lower as usize, factor);
            bonds.chunks.multiply(2 * offset as usize + 1, upper as usize, factor);
        }
        bonds.bonds = bonds.count();
        bonds
    }

    /// The lattice.
    pub fn lattice(&self) -> &Arc<SquareLattice> {
        &self.lattice
    }

    /// Moduli of the bonds of an offset, by its index, that have the factor one.
    pub fn moduli(&self, offset: usize) -> &[f64; M] {
        &self.classes[offset].modulus
    }

    /// Calls `visit` with every bond: index of its offset, its points, its factor, which is not zero.
    pub fn for_each_bond(&self, mut visit: impl FnMut(usize, [usize; 2], f64)) {
        for chunk in self.chunks.all() {
            for (index, class) in self.classes.iter().enumerate() {
                self.lattice.shifted(chunk.line, &chunk.columns(), class.step, |columns, other| {
                    let k = (columns.start - chunk.from) as usize;
                    for (step, other) in (0..columns.len()).zip(other..) {
                        let factor = self.chunks.factor(chunk, index, k + step);
                        if factor != 0.0 {
                            visit(index, [chunk.first as usize + k + step, other], factor);
                        }
                    }
                });
            }
        }
    }

    fn count(&self) -> usize {
        let mut count = 0;
        for chunk in self.chunks.all() {
            for (index, class) in self.classes.iter().enumerate() {
                self.lattice.shifted(chunk.line, &chunk.columns(), class.step, |columns, _| {
                    let k = (columns.start - chunk.from) as usize;
                    count += match chunk.is_plain() {
                        true => columns.len(),
                        false => {
                            let present = |k: &usize| self.chunks.factor(chunk, index, *k) != 0.0;
                            (k..k + columns.len()).filter(present).count()
                        }
                    };
                });
            }
        }
        count
    }
}

impl<const D: usize, const M: usize, B: BondModel<D, M>> Term<D> for GridBonds<D, M, B> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        self.for_each_bond(|_, [i, j], _| visit(i, j));
    }

    fn reach(&self) -> usize {
        let mut reach = 0;
        for run in self.lattice.runs() {
            for class in &self.classes {
                self.lattice.shifted(run.line(), &run.columns, class.step, |columns, other| {
                    reach = reach.max(other - run.number(columns.start));
                });
            }
        }
        reach
    }

    fn join(&self, parts: &mut ConnectedParts) {
        let next = &[[1, 0, 0], [0, 1, 0], [0, 0, 1]][..if self.lattice.is_plane() { 2 } else { 3 }];
        let plain: Vec<usize> = next
            .iter()
            .filter_map(|step| self.classes.iter().position(|c| c.step == *step && c.modulus != [0.0; M]))
            .collect();
        // Where no bond is an exception, neighbours in a row hang together, and one bond joins two stretches of rows.
        let are_rows = self.chunks.stored_factors() == 0 && plain.len() == next.len();
        for chunk in self.chunks.all() {
            // Inside a body the bonds to the next points already join all that longer ones would.
            let (all, inner) = (0..self.classes.len(), plain.len() == next.len() && chunk.is_plain());
            let joined: Vec<usize> = if inner && chunk.is_inner { plain.clone() } else { all.collect() };
            for index in joined {
                let step = self.classes[index].step;
                self.lattice.shifted(chunk.line, &chunk.columns(), step, |columns, other| {
                    let k = (columns.start - chunk.from) as usize;
                    let first = chunk.first as usize + k;
                    if chunk.is_plain() && step == [1, 0, 0] {
                        parts.join_run(first..=first + columns.len());
                    } else if are_rows || chunk.is_plain() && next[1..].contains(&step) && chunk.is_inner {
                        parts.join(first, other);
                    } else {
                        let present = (0..columns.len())
                            .filter(|&step| self.chunks.factor(chunk, index, k + step) != 0.0);
                        present.for_each(|step| parts.join(first + step, other + step));
                    }
                });
            }
        }
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        self.gather::<f64>(u, force, &|_, forces, own| {
            for (own, forces) in own.into_iter().zip(forces) {
                own.iter_mut().zip(forces).for_each(|(f, part)| *f += part);
            }
        });
    }

    fn add_force_twofold(&self, u: Twofold<'_>, force: &mut [Sum]) -> bool {
        self.for_each_bond(|class, ends, factor| {
            let class = &self.classes[class];
            let moduli = class.modulus.map(|c| factor * c);
            let rows = [&class.difference, &class.half_mean];
            twofold::add_bond((rows, &moduli), self.lattice.points(), ends, u, force);
        });
        true
    }

    fn sweep(&self, u: &[f64], out: &mut [f64], take: TakeForces<'_, D>) -> bool {
        self.gather(u, out, take);
        true
    }

    fn sweep_in_single(&self, u: &[f32], out: &mut [f32], take: TakeForces<'_, D, f32>) -> bool {
        self.gather(u, out, take);
        true
    }

    fn sweeps_in_single(&self) -> bool {
        true
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        self.survey_chunks(u)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        self.assemble(tangent);
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        self.assemble_diagonal(blocks);
    }

    fn elements(&self) -> usize {
        self.bonds
    }

    fn stored_factors(&self) -> usize {
        self.chunks.stored_factors()
    }
}

#[cfg(test)]
mod tests;
