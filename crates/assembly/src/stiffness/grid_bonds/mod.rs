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
mod tables;
mod visit;

pub use chunks::Exception;
pub use tables::{Between, Tables};

use super::{BlockMatrix, ConnectedParts, Survey, TakeForces, Term, Twofold, twofold};
use crate::body::{Cell, SquareLattice, plus};
use crate::bonds::{BondGeometry, BondModel, Mat};
use crate::sum::Sum;
use chunks::{CHUNK, Chunks};
use precision::Precision;
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
    /// Number of offsets.
    offsets: usize,
    /// By offset, table by table.
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
        Self::of_tables(lattice, model, offsets, exceptions, Tables { of: &[], others: &[], between: &[] })
    }

    /// The same of points that have other weights than those of the offsets.
    ///
    /// # Panics
    /// As [`new`](Self::new); a point has a table that is not there, or there are more than 254 other tables.
    pub fn of_tables(
        lattice: Arc<SquareLattice>,
        model: &B,
        offsets: &[Offset<M>],
        exceptions: &[Exception],
        tables: Tables<'_, M>,
    ) -> Self {
        assert!(tables.others.len() <= tables::MOST, "a table of unit weights follows them");
        let class = |step: Cell, weights: &[f64; M]| {
            let [a, b, c] = step;
            assert!(
                [c, b, a] > [0; 3],
                "an offset goes to a higher layer, up in its own, or to the right in its row"
            );
            let bond = BondGeometry { xi: lattice.vector(step) };
            let (rows, moduli) = (model.rows(&bond), model.moduli(&bond));
            Class {
                step,
                difference: rows.difference,
                half_mean: rows.half_mean(),
                modulus: from_fn(|m| weights[m] * moduli[m]),
            }
        };
        let steps: Vec<Cell> = offsets.iter().map(|o| o.step).collect();
        let base: Vec<[f64; M]> = offsets.iter().map(|o| o.weights).collect();
        let known: Vec<&[[f64; M]]> =
            std::iter::once(&base).chain(tables.others).map(Vec::as_slice).collect();
        let unit = vec![[1.0; M]; if tables.of.is_empty() { 0 } else { steps.len() }];
        let all = known.iter().copied().chain([&unit[..]]);
        let classes: Vec<Class<D, M>> =
            all.flat_map(|weights| steps.iter().zip(weights).map(|(step, own)| class(*step, own))).collect();
        let mut chunks = tables.chunks(&lattice, &steps, &known);
        for e in exceptions.iter().filter(|e| e.factor != 1.0) {
            if let Some(upper) = lattice.number(plus(lattice.cell(e.lower), steps[e.offset])) {
                chunks.multiply(2 * e.offset, e.lower, e.factor);
                chunks.multiply(2 * e.offset + 1, upper, e.factor);
            }
        }
        let in_single = classes.iter().map(Class::in_single).collect();
        let offsets = steps.len();
        let mut bonds = Self { lattice, offsets, classes, in_single, chunks, bonds: 0, model: PhantomData };
        bonds.bonds = bonds.count();
        bonds
    }

    /// The offsets with the moduli of the first table.
    fn offsets(&self) -> &[Class<D, M>] {
        &self.classes[..self.offsets]
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
}

impl<const D: usize, const M: usize, B: BondModel<D, M>> Term<D> for GridBonds<D, M, B> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        self.for_each_bond(|_, [i, j], _| visit(i, j));
    }

    fn reach(&self) -> usize {
        let mut reach = 0;
        for run in self.lattice.runs() {
            for class in self.offsets() {
                self.lattice.shifted(run.line(), &run.columns, class.step, |columns, other| {
                    reach = reach.max(other - run.number(columns.start));
                });
            }
        }
        reach
    }

    fn join(&self, parts: &mut ConnectedParts) {
        let next = &[[1, 0, 0], [0, 1, 0], [0, 0, 1]][..if self.lattice.is_plane() { 2 } else { 3 }];
        let resists = |step: &Cell| {
            let mut all = self.classes.iter().filter(|class| class.step == *step);
            all.all(|class| class.modulus != [0.0; M])
        };
        let index = |step: &Cell| self.offsets().iter().position(|class| class.step == *step);
        let plain: Vec<usize> = next.iter().filter(|step| resists(step)).filter_map(index).collect();
        // Where no bond is an exception, neighbours in a row hang together, and one bond joins two stretches of rows.
        let are_rows = self.chunks.stored_factors() == 0 && plain.len() == next.len();
        for chunk in self.chunks.all() {
            // Inside a body the bonds to the next points already join all that longer ones would.
            let inner = plain.len() == next.len() && chunk.is_plain() && chunk.is_inner;
            let own = f64::classes_of(self, chunk);
            let all = (0..own.len()).filter(|index| own[*index].modulus != [0.0; M]);
            // Then its points hang together.
            let hangs = own.iter().any(|class| class.step == next[0] && class.modulus != [0.0; M]);
            let joined: Vec<usize> = if inner { plain.clone() } else { all.collect() };
            for index in joined {
                let step = own[index].step;
                self.lattice.shifted(chunk.line, &chunk.columns(), step, |columns, other| {
                    let k = (columns.start - chunk.from) as usize;
                    let first = chunk.first as usize + k;
                    if chunk.is_plain() && step == [1, 0, 0] {
                        parts.join_run(first..=first + columns.len());
                    } else if are_rows
                        || chunk.is_plain() && hangs && next[1..].contains(&step) && chunk.is_inner
                    {
                        parts.join(first, other);
                    } else {
                        let present = (0..columns.len()).filter(|&step| self.has(chunk, index, k + step));
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
        self.for_each_with_moduli(|class, ends, moduli| {
            let class = &self.classes[class];
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
