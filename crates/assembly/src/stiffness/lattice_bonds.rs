//! Bonds of a uniform lattice: one class per offset, so that geometry and moduli are stored once.

use super::{BlockMatrix, Parts, Survey, Term};
use crate::bonds::{BondGeometry, BondModel, Mat, Rows, block};
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

    /// Visits the bonds of a class that exist: lower point counted from the first lattice point, and weight.
    #[inline]
    pub fn for_each(&self, class: usize, mut visit: impl FnMut(usize, f64)) {
        let weight = self.classes[class].weight;
        for chunk in 0..self.chunks.len() {
            match self.bonds_of(class, chunk) {
                (bonds, None) => bonds.for_each(|lower| visit(lower, weight)),
                (bonds, Some(factors)) => {
                    let weighted = bonds.zip(factors).filter(|(_, g)| **g != 0.0);
                    weighted.for_each(|(lower, g)| visit(lower, weight * g));
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

    /// Measures of the bonds with the given lower points, at most one chunk of them.
    #[inline(always)]
    fn measures(&self, class: &BondClass<D, M>, lower: Range<usize>, u: &[f64], s: &mut [[f64; CHUNK]; M]) {
        let (n, width) = (self.lattice.points, lower.len());
        let base = self.lattice.first + lower.start;
        let lo: [&[f64]; D] = from_fn(|c| &u[c * n + base..][..width]);
        let hi: [&[f64]; D] = from_fn(|c| &u[c * n + base + class.step..][..width]);
        for m in 0..M {
            let out = &mut s[m][..width];
            out.fill(0.0);
            for c in 0..D {
                let (lo, hi) = (lo[c], hi[c]);
                if B::DIFFERENCE[m][c] {
                    let b = class.rows.difference[m][c];
                    (0..width).for_each(|k| out[k] += b * (hi[k] - lo[k]));
                }
                if B::MEAN[m][c] {
                    let b = class.rows.mean[m][c];
                    (0..width).for_each(|k| out[k] += b * (0.5 * (lo[k] + hi[k])));
                }
            }
        }
    }

    /// Measures turned into conjugate forces `σ = α factor C s`.
    #[inline(always)]
    fn stress(class: &BondClass<D, M>, factors: Option<&[f64]>, s: &mut [[f64; CHUNK]; M]) {
        for m in 0..M {
            s[m].iter_mut().for_each(|v| *v *= class.modulus[m]);
            if let Some(factors) = factors {
                s[m].iter_mut().zip(factors).for_each(|(v, g)| *v *= g);
            }
        }
    }

    /// Visits every class of every chunk with its measures and its conjugate forces.
    #[inline(always)]
    fn sweep(
        &self,
        u: &[f64],
        mut visit: impl FnMut(&BondClass<D, M>, Range<usize>, &[[f64; CHUNK]; M], &[[f64; CHUNK]; M]),
    ) {
        let mut s = [[0.0; CHUNK]; M];
        for chunk in 0..self.chunks.len() {
            for (index, class) in self.classes.iter().enumerate() {
                let (lower, factors) = self.bonds_of(index, chunk);
                if lower.is_empty() {
                    continue;
                }
                self.measures(class, lower.clone(), u, &mut s);
                let mut sigma = s;
                Self::stress(class, factors, &mut sigma);
                visit(class, lower, &s, &sigma);
            }
        }
    }

    #[inline(always)]
    fn add_force_plain(&self, u: &[f64], force: &mut [f64]) {
        let (n, first) = (self.lattice.points, self.lattice.first);
        self.sweep(u, |class, lower, _, sigma| {
            let (base, width) = (first + lower.start, lower.len());
            for c in 0..D {
                let mut difference = [0.0; CHUNK];
                let mut mean = [0.0; CHUNK];
                for m in 0..M {
                    if B::DIFFERENCE[m][c] {
                        let b = class.rows.difference[m][c];
                        (0..CHUNK).for_each(|k| difference[k] += b * sigma[m][k]);
                    }
                    if B::MEAN[m][c] {
                        let b = 0.5 * class.rows.mean[m][c];
                        (0..CHUNK).for_each(|k| mean[k] += b * sigma[m][k]);
                    }
                }
                let lo = &mut force[c * n + base..][..width];
                (0..width).for_each(|k| lo[k] += mean[k] - difference[k]);
                let hi = &mut force[c * n + base + class.step..][..width];
                (0..width).for_each(|k| hi[k] += mean[k] + difference[k]);
            }
        });
    }

    #[inline(always)]
    fn survey_plain(&self, u: &[f64]) -> Survey<D> {
        let mut energy = 0.0;
        let mut largest = [[0.0; CHUNK]; D];
        self.sweep(u, |class, lower, s, sigma| {
            // Summed lane by lane and chunk by chunk: the error of a long sum grows with its number of terms.
            let mut part = [0.0; CHUNK];
            for m in 0..M {
                (0..CHUNK).for_each(|k| part[k] += s[m][k] * sigma[m][k]);
            }
            energy += 0.5 * part[..lower.len()].iter().sum::<f64>();
            for b in [class.rows.first(), class.rows.second()] {
                for (c, largest) in largest.iter_mut().enumerate() {
                    let mut action = [0.0; CHUNK];
                    for m in 0..M {
                        if B::DIFFERENCE[m][c] || B::MEAN[m][c] {
                            (0..CHUNK).for_each(|k| action[k] += b[m][c] * sigma[m][k]);
                        }
                    }
                    for k in 0..lower.len() {
                        let size = f64::abs(action[k]);
                        largest[k] = if size > largest[k] { size } else { largest[k] };
                    }
                }
            }
        });
        Survey { energy, largest_action: largest.map(|lanes| lanes.into_iter().fold(0.0, f64::max)) }
    }

    /// Ranges of points all of whose bonds, as lower and as upper point, exist with factor one.
    fn is_plain(&self, point: usize) -> bool {
        self.classes.iter().enumerate().all(|(index, class)| {
            point >= class.step
                && self.weight(index, point) == class.weight
                && self.weight(index, point - class.step) == class.weight
        })
    }

    /// Points `begin..` that are all plain, tested by chunks where that is enough.
    fn plain_run(&self, begin: usize) -> Range<usize> {
        let longest = self.classes.iter().map(|c| c.step).max().unwrap_or(0);
        let mut end = begin;
        while end < self.lattice.count {
            let chunk = end / CHUNK;
            let whole = end.is_multiple_of(CHUNK)
                && end >= longest.max(CHUNK)
                && end + CHUNK + longest <= self.lattice.count
                && longest <= CHUNK
                && self.chunks[chunk] == PLAIN
                && self.chunks[chunk - 1] == PLAIN;
            if whole {
                end += CHUNK;
            } else if self.is_plain(end) {
                end += 1;
            } else {
                break;
            }
        }
        begin..end
    }

    /// Blocks `B_iᵀCB_i`, `B_iᵀCB_j`, `B_jᵀCB_j` of every class.
    fn blocks(&self) -> Vec<[Mat<D, D>; 3]> {
        let of = |c: &BondClass<D, M>| {
            let (i, j) = (c.rows.first(), c.rows.second());
            [block(&i, &c.modulus, &i), block(&i, &c.modulus, &j), block(&j, &c.modulus, &j)]
        };
        self.classes.iter().map(of).collect()
    }

    /// Diagonal block of a point and the blocks to its upper neighbours, one per class.
    fn row(&self, point: usize, blocks: &[[Mat<D, D>; 3]]) -> Vec<Mat<D, D>> {
        let mut row = vec![[[0.0; D]; D]; 1 + blocks.len()];
        for (index, class) in self.classes.iter().enumerate() {
            let above = self.weight(index, point) / class.weight;
            let below = match point.checked_sub(class.step) {
                Some(lower) => self.weight(index, lower) / class.weight,
                None => 0.0,
            };
            for r in 0..D {
                for c in 0..D {
                    row[0][r][c] += above * blocks[index][0][r][c] + below * blocks[index][2][r][c];
                    row[1 + index][r][c] = above * blocks[index][1][r][c];
                }
            }
        }
        row
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
        let blocks = self.blocks();
        let steps: Vec<usize> = std::iter::once(0).chain(self.classes.iter().map(|c| c.step)).collect();
        let first = self.lattice.first;
        let mut point = 0;
        while point < self.lattice.count {
            let run = self.plain_run(point);
            let row = self.row(point, &blocks);
            if run.len() > 1 {
                tangent.add_repeated(first + run.start..first + run.end, &steps, &row);
                point = run.end;
            } else {
                for (index, (&step, block)) in steps.iter().zip(&row).enumerate() {
                    if index == 0 || self.weight(index - 1, point) != 0.0 {
                        tangent.add(first + point, first + point + step, block);
                    }
                }
                point += 1;
            }
        }
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
