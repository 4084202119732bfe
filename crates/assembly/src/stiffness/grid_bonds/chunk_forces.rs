//! Forces on a stretch of a row, in vector registers: those of all bonds of a few points are summed before the next.
//!
//! At the ends of a row some points lack bonds. They are evaluated as if their other ends were where they would be in memory, and
//! then count nothing.

use super::Class;
use super::gather::Forces;
use crate::bonds::BondModel;
use peristat_vector::Lanes;
use pulp::{Simd, WithSimd};
use std::marker::PhantomData;

/// Registers of a component that are summed at once: with those of three components and their own values all are in use.
const VECTORS: usize = 2;
/// The most numbers that these are.
const MOST: usize = 32;

/// A few points at once.
type Few<R, S> = [<R as Lanes>::Of<S>; VECTORS];

/// Bonds of an offset of the points of a chunk: numbers of the points at their other ends, from the first point of the chunk on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sides {
    pub(super) class: u32,
    /// Columns from a point to the other end above.
    pub(super) along: i32,
    pub(super) above: Option<i64>,
    pub(super) below: Option<i64>,
}

/// A chunk, beside which all lines go as far.
pub(super) struct ChunkForces<'a, const D: usize, const M: usize, B, R> {
    pub(super) classes: &'a [Class<D, M, R>],
    pub(super) sides: &'a [Sides],
    pub(super) u: &'a [&'a [R]; D],
    /// First point of the chunk, and how many it has.
    pub(super) first: usize,
    pub(super) width: usize,
    /// Cells of the lines before the first point and behind the last one.
    pub(super) clip: [i32; 2],
    /// Largest offset along the row.
    pub(super) reach: i32,
    pub(super) forces: &'a mut Forces<D, R>,
    pub(super) model: PhantomData<B>,
}

impl<const D: usize, const M: usize, B: BondModel<D, M>, R: Lanes> WithSimd for ChunkForces<'_, D, M, B, R> {
    /// Whether there are enough points.
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let few = VECTORS * R::count::<S>();
        if self.width < few || !self.is_within() {
            return false;
        }
        let mut from = 0;
        loop {
            let sums = self.sums(simd, from, few);
            for c in 0..D {
                self.forces[c][from..from + few].copy_from_slice(R::lanes::<S>(&sums[c]));
            }
            if from + few == self.width {
                return true;
            }
            // The last points are taken with some of those before.
            from = (from + few).min(self.width - few);
        }
    }
}

impl<const D: usize, const M: usize, B: BondModel<D, M>, R: Lanes> ChunkForces<'_, D, M, B, R> {
    /// Whether the other ends of all bonds are in memory, also of those that there are not.
    fn is_within(&self) -> bool {
        let ends = self.sides.iter().flat_map(|sides| [sides.above, sides.below]).flatten();
        let last = self.u[0].len() as i64 - self.width as i64;
        ends.into_iter().all(|number| (0..=last).contains(&number))
    }

    /// One for the bonds of some points, from the k-th on, whose other ends along the row are there, else zero; none if all are.
    #[inline(always)]
    fn there(&self, k: usize, few: usize, along: i32) -> Option<[R; MOST]> {
        let [before, behind] = self.clip;
        let (first, end) = (-before - along - k as i32, self.width as i32 + behind - along - k as i32);
        if first <= 0 && few as i32 <= end {
            return None;
        }
        let mut there = [R::default(); MOST];
        for column in first.clamp(0, few as i32)..end.clamp(0, few as i32) {
            there[column as usize] = R::of(1.0);
        }
        Some(there)
    }

    /// Forces on a few points, from the k-th of the chunk on.
    #[inline(always)]
    fn sums<S: Simd>(&self, simd: S, k: usize, few: usize) -> [Few<R, S>; D] {
        let zero = R::splat(simd, R::default());
        let own = self.load(simd, self.first + k);
        let mut sums = [[zero; VECTORS]; D];
        let [before, behind] = self.clip;
        let is_end =
            before + (k as i32) < self.reach || self.width as i32 + behind < (k + few) as i32 + self.reach;
        for sides in self.sides {
            let class = &self.classes[sides.class as usize];
            let mut pulls = [[[zero; VECTORS]; M]; 2];
            if let Some(number) = sides.above {
                let other = self.load(simd, (number + k as i64) as usize);
                pull::<S, D, M, B, R>(simd, class, [&own, &other], &mut pulls[0]);
                if is_end && let Some(there) = self.there(k, few, sides.along) {
                    leave_out::<S, M, R>(simd, &mut pulls[0], &there);
                }
            }
            if let Some(number) = sides.below {
                let other = self.load(simd, (number + k as i64) as usize);
                pull::<S, D, M, B, R>(simd, class, [&other, &own], &mut pulls[1]);
                if is_end && let Some(there) = self.there(k, few, -sides.along) {
                    leave_out::<S, M, R>(simd, &mut pulls[1], &there);
                }
            }
            for m in 0..M {
                for v in 0..VECTORS {
                    let (above, below) = (pulls[0][m][v], pulls[1][m][v]);
                    for c in 0..D {
                        if B::DIFFERENCE[m][c] {
                            let row = class.difference[m][c];
                            add::<S, R>(simd, &mut sums[c][v], row, R::difference(simd, below, above));
                        }
                        if B::MEAN[m][c] {
                            let row = class.half_mean[m][c];
                            add::<S, R>(simd, &mut sums[c][v], row, R::sum(simd, below, above));
                        }
                    }
                }
            }
        }
        sums
    }

    /// Displacements of points, from a number on.
    #[inline(always)]
    fn load<S: Simd>(&self, simd: S, number: usize) -> [Few<R, S>; D] {
        let mut lanes = [[R::splat(simd, R::default()); VECTORS]; D];
        for c in 0..D {
            for v in 0..VECTORS {
                lanes[c][v] = R::load(simd, self.u[c], number + v * R::count::<S>());
            }
        }
        lanes
    }
}

/// What bonds with these lower and upper points pull with. No closures here: what is not inlined is compiled for old processors.
#[inline(always)]
fn pull<S: Simd, const D: usize, const M: usize, B: BondModel<D, M>, R: Lanes>(
    simd: S,
    class: &Class<D, M, R>,
    [lower, upper]: [&[Few<R, S>; D]; 2],
    pulls: &mut [Few<R, S>; M],
) {
    for m in 0..M {
        for v in 0..VECTORS {
            let mut s = R::splat(simd, R::default());
            for c in 0..D {
                if B::DIFFERENCE[m][c] {
                    add::<S, R>(
                        simd,
                        &mut s,
                        class.difference[m][c],
                        R::difference(simd, upper[c][v], lower[c][v]),
                    );
                }
                if B::MEAN[m][c] {
                    add::<S, R>(simd, &mut s, class.half_mean[m][c], R::sum(simd, lower[c][v], upper[c][v]));
                }
            }
            pulls[m][v] = R::product(simd, s, R::splat(simd, class.modulus[m]));
        }
    }
}

/// Takes out the pulls of bonds that there are not.
#[inline(always)]
fn leave_out<S: Simd, const M: usize, R: Lanes>(simd: S, pulls: &mut [Few<R, S>; M], there: &[R; MOST]) {
    for m in 0..M {
        for v in 0..VECTORS {
            let lanes = R::load(simd, there, v * R::count::<S>());
            pulls[m][v] = R::product(simd, pulls[m][v], lanes);
        }
    }
}

/// Adds a product, not fused, so that all processors get the same bits.
#[inline(always)]
fn add<S: Simd, R: Lanes>(simd: S, sum: &mut R::Of<S>, factor: R, number: R::Of<S>) {
    *sum = R::sum(simd, *sum, R::product(simd, R::splat(simd, factor), number));
}
