//! Bonds of a uniform lattice: one class per offset, so that geometry and moduli are stored once.

mod assemble;
mod sweep;

use super::{BlockMatrix, Parts, Survey, Term};
use crate::bonds::{BondGeometry, BondModel, Rows};
use std::array::from_fn;
use std::marker::PhantomData;
use std::ops::Range;

/// Points per chunk: the inner loops run over one chunk of one class.
const CHUNK: usize = 64;
/// Marks a chunk all of whose bonds have factor one.
const PLAIN: u32 = u32::MAX;

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
pub struct BondClass<const D: usize, const M: usize> {
    /// Difference of the point numbers, >= 1.
    pub step: usize,
    /// Relative position of the second point.
    pub geometry: BondGeometry,
    /// Dimensionless weight α of every bond of the class.
    pub weight: f64,
    rows: Rows<D, M>,
    modulus: [f64; M],
}

/// A bond whose weight differs from that of its class.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Override {
    /// Index of the class.
    pub class: usize,
    /// Lower point, counted from the first lattice point.
    pub lower: usize,
    /// Multiplies the weight of the class; zero where there is no bond.
    pub factor: f64,
}

/// Energy of the bonds of a lattice, `E = Σ ½ α factor s·diag(moduli)·s`.
///
/// Factors are stored only for the chunks of 64 points that hold an exception (ends, splits): the interior of a
/// uniform lattice stores nothing per bond.
#[derive(Clone, Debug)]
pub struct LatticeBonds<const D: usize, const M: usize, B> {
    lattice: Lattice,
    classes: Vec<BondClass<D, M>>,
    /// Per chunk: start of its factors `[class][lower point]`, or [`PLAIN`].
    chunks: Vec<u32>,
    factors: Vec<f64>,
    model: PhantomData<B>,
}

impl<const D: usize, const M: usize, B: BondModel<D, M>> LatticeBonds<D, M, B> {
    /// Bonds of `model` over the given offsets `(step, geometry, weight)`. Bonds that would leave the lattice do not
    /// exist and need no override.
    pub fn new(
        lattice: Lattice,
        model: &B,
        offsets: &[(usize, BondGeometry, f64)],
        overrides: &[Override],
    ) -> Self {
        let classes: Vec<_> = offsets
            .iter()
            .map(|&(step, geometry, weight)| BondClass {
                step,
                geometry,
                weight,
                rows: model.rows(&geometry),
                modulus: model.moduli(&geometry).map(|c| weight * c),
            })
            .collect();
        let mut chunks = vec![PLAIN; lattice.count.div_ceil(CHUNK)];
        let mut factors = Vec::new();
        for o in overrides.iter().filter(|o| o.lower < lattice.count) {
            let chunk = &mut chunks[o.lower / CHUNK];
            if *chunk == PLAIN {
                *chunk = factors.len() as u32;
                factors.resize(factors.len() + classes.len() * CHUNK, 1.0);
            }
            factors[*chunk as usize + o.class * CHUNK + o.lower % CHUNK] = o.factor;
        }
        Self { lattice, classes, chunks, factors, model: PhantomData }
    }

    /// The points the bonds connect.
    pub fn lattice(&self) -> Lattice {
        self.lattice
    }

    /// The offset classes.
    pub fn classes(&self) -> &[BondClass<D, M>] {
        &self.classes
    }

    /// Weight of the bond of a class at a lower point counted from the first lattice point; zero where it does not
    /// exist.
    pub fn weight(&self, class: usize, lower: usize) -> f64 {
        let c = &self.classes[class];
        if lower + c.step >= self.lattice.count {
            return 0.0;
        }
        match self.chunks[lower / CHUNK] {
            PLAIN => c.weight,
            start => c.weight * self.factors[start as usize + class * CHUNK + lower % CHUNK],
        }
    }

    /// Visits the bonds of a class that exist, in runs of equal weight: lower points counted from the first lattice
    /// point, and the weight.
    pub fn for_each_run(&self, class: usize, mut visit: impl FnMut(Range<usize>, f64)) {
        let weight = self.classes[class].weight;
        for chunk in 0..self.chunks.len() {
            match self.bonds_of(class, chunk) {
                (run, None) if run.is_empty() => {}
                (run, None) => visit(run, weight),
                (run, Some(factors)) => {
                    let weighted = run.zip(factors).filter(|(_, g)| **g != 0.0);
                    weighted.for_each(|(lower, g)| visit(lower..lower + 1, weight * g));
                }
            }
        }
    }

    /// Measures of one bond of a class.
    pub fn measure(&self, class: usize, lower: usize, u: &[f64]) -> [f64; M] {
        let mut s = [[0.0; CHUNK]; M];
        self.measures(&self.classes[class], lower..lower + 1, u, &mut s);
        from_fn(|m| s[m][0])
    }

    /// Moduli of one bond of a class, weight not included.
    pub fn moduli(&self, class: usize) -> [f64; M] {
        let c = &self.classes[class];
        c.modulus.map(|v| v / c.weight)
    }

    /// Lower points of one class in one chunk, and their factors if the chunk has any.
    #[inline(always)]
    fn bonds_of(&self, class: usize, chunk: usize) -> (Range<usize>, Option<&[f64]>) {
        let last = self.lattice.count.saturating_sub(self.classes[class].step);
        let begin = (chunk * CHUNK).min(last);
        let end = (begin + CHUNK).min(last);
        let factors = (self.chunks[chunk] != PLAIN)
            .then(|| &self.factors[self.chunks[chunk] as usize + class * CHUNK..][..CHUNK]);
        (begin..end, factors)
    }
}

impl<const D: usize, const M: usize, B: BondModel<D, M>> Term<D> for LatticeBonds<D, M, B> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        for (index, class) in self.classes.iter().enumerate() {
            for lower in 0..self.lattice.count.saturating_sub(class.step) {
                if self.weight(index, lower) != 0.0 {
                    let i = self.lattice.first + lower;
                    visit(i, i + class.step);
                }
            }
        }
    }

    fn reach(&self) -> usize {
        self.classes.iter().map(|c| c.step).max().unwrap_or(0)
    }

    fn join(&self, parts: &mut Parts) {
        let neighbours = self.classes.iter().position(|c| c.step == 1 && c.weight != 0.0);
        for (chunk, &factors) in self.chunks.iter().enumerate() {
            // In a plain chunk the bonds between neighbours already join every point the longer ones would.
            let classes = match neighbours {
                Some(index) if factors == PLAIN => index..index + 1,
                _ => 0..self.classes.len(),
            };
            for index in classes {
                for lower in self.bonds_of(index, chunk).0 {
                    if self.weight(index, lower) != 0.0 {
                        let i = self.lattice.first + lower;
                        parts.join(i, i + self.classes[index].step);
                    }
                }
            }
        }
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        pulp::Arch::new().dispatch(
            #[inline(always)]
            || self.add_force_plain(u, force),
        );
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        pulp::Arch::new().dispatch(
            #[inline(always)]
            || self.survey_plain(u),
        )
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        self.assemble(tangent);
    }

    fn elements(&self) -> usize {
        let inside: usize = self.classes.iter().map(|c| self.lattice.count.saturating_sub(c.step)).sum();
        let absent = (0..self.chunks.len())
            .filter(|&chunk| self.chunks[chunk] != PLAIN)
            .flat_map(|chunk| (0..self.classes.len()).map(move |index| (chunk, index)))
            .flat_map(|(chunk, index)| self.bonds_of(index, chunk).0.map(move |p| (index, p)))
            .filter(|&(index, p)| self.weight(index, p) == 0.0)
            .count();
        inside - absent
    }

    fn stored_factors(&self) -> usize {
        self.factors.len()
    }
}
