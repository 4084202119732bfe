//! Forces on a stretch of a row, in vector registers: those of all bonds of a few points are summed before the next.
//!
//! At the ends of a row some points lack bonds. They are evaluated as if their other ends were where they would be in memory, and
//! then count nothing.

use super::Class;
use super::gather::Forces;
use crate::bonds::BondModel;
use pulp::{Simd, WithSimd, bytemuck};
use std::marker::PhantomData;

/// Registers of a component that are summed at once: with those of three components and their own values all are in use.
const VECTORS: usize = 2;
/// The most numbers that these are.
const MOST: usize = 16;

/// A few points at once.
type Lanes<S> = [<S as Simd>::f64s; VECTORS];

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
pub(super) struct ChunkForces<'a, const D: usize, const M: usize, B> {
    pub(super) classes: &'a [Class<D, M>],
    pub(super) sides: &'a [Sides],
    pub(super) u: &'a [&'a [f64]; D],
    /// First point of the chunk, and how many it has.
    pub(super) first: usize,
    pub(super) width: usize,
    /// Cells of the lines before the first point and behind the last one.
    pub(super) clip: [i32; 2],
    /// Largest offset along the row.
    pub(super) reach: i32,
    pub(super) forces: &'a mut Forces<D>,
    pub(super) model: PhantomData<B>,
}

impl<const D: usize, const M: usize, B: BondModel<D, M>> WithSimd for ChunkForces<'_, D, M, B> {
    /// Whether there are enough points.
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let few = VECTORS * S::F64_LANES;
        if self.width < few || !self.is_within() {
            return false;
        }
        let mut from = 0;
        loop {
            let sums = self.sums(simd, from, few);
            for c in 0..D {
                let lanes: &[f64] = bytemuck::cast_slice(&sums[c]);
                self.forces[c][from..from + few].copy_from_slice(lanes);
            }
            if from + few == self.width {
                return true;
            }
            // The last points are taken with some of those before.
            from = (from + few).min(self.width - few);
        }
    }
}

impl<const D: usize, const M: usize, B: BondModel<D, M>> ChunkForces<'_, D, M, B> {
    /// Whether the other ends of all bonds are in memory, also of those that there are not.
    fn is_within(&self) -> bool {
        let ends = self.sides.iter().flat_map(|sides| [sides.above, sides.below]).flatten();
        let last = self.u[0].len() as i64 - self.width as i64;
        ends.into_iter().all(|number| (0..=last).contains(&number))
    }

    /// One for the bonds of some points, from the k-th on, whose other ends along the row are there, else zero; none if all are.
    #[inline(always)]
    fn there(&self, k: usize, few: usize, along: i32) -> Option<[f64; MOST]> {
        let [before, behind] = self.clip;
        let (first, end) = (-before - along - k as i32, self.width as i32 + behind - along - k as i32);
        if first <= 0 && few as i32 <= end {
            return None;
        }
        let mut there = [0.0; MOST];
        for column in first.clamp(0, few as i32)..end.clamp(0, few as i32) {
            there[column as usize] = 1.0;
        }
        Some(there)
    }

    /// Forces on a few points, from the k-th of the chunk on.
    #[inline(always)]
    fn sums<S: Simd>(&self, simd: S, k: usize, few: usize) -> [Lanes<S>; D] {
        let zero = simd.splat_f64s(0.0);
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
                pull::<S, D, M, B>(simd, class, [&own, &other], &mut pulls[0]);
                if is_end && let Some(there) = self.there(k, few, sides.along) {
                    leave_out::<S, M>(simd, &mut pulls[0], &there);
                }
            }
            if let Some(number) = sides.below {
                let other = self.load(simd, (number + k as i64) as usize);
                pull::<S, D, M, B>(simd, class, [&other, &own], &mut pulls[1]);
                if is_end && let Some(there) = self.there(k, few, -sides.along) {
                    leave_out::<S, M>(simd, &mut pulls[1], &there);
                }
            }
            for m in 0..M {
                for v in 0..VECTORS {
                    let (above, below) = (pulls[0][m][v], pulls[1][m][v]);
                    for c in 0..D {
                        if B::DIFFERENCE[m][c] {
                            let row = class.difference[m][c];
                            add(simd, &mut sums[c][v], row, simd.sub_f64s(below, above));
                        }
                        if B::MEAN[m][c] {
                            let row = class.half_mean[m][c];
                            add(simd, &mut sums[c][v], row, simd.add_f64s(below, above));
                        }
                    }
                }
            }
        }
        sums
    }

    /// Displacements of points, from a number on.
    #[inline(always)]
    fn load<S: Simd>(&self, simd: S, number: usize) -> [Lanes<S>; D] {
        let mut lanes = [[simd.splat_f64s(0.0); VECTORS]; D];
        for c in 0..D {
            for v in 0..VECTORS {
                let at = number + v * S::F64_LANES;
                lanes[c][v] =
                    bytemuck::pod_read_unaligned(bytemuck::cast_slice(&self.u[c][at..at + S::F64_LANES]));
            }
        }
        lanes
    }
}

/// What bonds with these lower and upper points pull with. No closures here: what is not inlined is compiled for old processors.
#[inline(always)]
fn pull<S: Simd, const D: usize, const M: usize, B: BondModel<D, M>>(
    simd: S,
    class: &Class<D, M>,
    [lower, upper]: [&[Lanes<S>; D]; 2],
    pulls: &mut [Lanes<S>; M],
) {
    for m in 0..M {
        for v in 0..VECTORS {
            let mut s = simd.splat_f64s(0.0);
            for c in 0..D {
                if B::DIFFERENCE[m][c] {
                    add(simd, &mut s, class.difference[m][c], simd.sub_f64s(upper[c][v], lower[c][v]));
                }
                if B::MEAN[m][c] {
                    add(simd, &mut s, class.half_mean[m][c], simd.add_f64s(lower[c][v], upper[c][v]));
                }
            }
            pulls[m][v] = simd.mul_f64s(s, simd.splat_f64s(class.modulus[m]));
        }
    }
}

/// Takes out the pulls of bonds that there are not.
#[inline(always)]
fn leave_out<S: Simd, const M: usize>(simd: S, pulls: &mut [Lanes<S>; M], there: &[f64; MOST]) {
    for m in 0..M {
        for v in 0..VECTORS {
            let at = v * S::F64_LANES;
            let lanes = bytemuck::pod_read_unaligned(bytemuck::cast_slice(&there[at..at + S::F64_LANES]));
            pulls[m][v] = simd.mul_f64s(pulls[m][v], lanes);
        }
    }
}

/// Adds a product, not fused, so that all processors get the same bits.
#[inline(always)]
fn add<S: Simd>(simd: S, sum: &mut S::f64s, factor: f64, number: S::f64s) {
    *sum = simd.add_f64s(*sum, simd.mul_f64s(simd.splat_f64s(factor), number));
}
