//! Forces on chunks whose neighbours at an offset follow each other, if they are there at all.
//!
//! What a chunk at a straight edge lacks are whole lines beside it, or the ends of those that it has, all alike: it is evaluated as
//! those inside are.

use super::chunk_forces::{ChunkForces, Sides};
use super::chunks::{Beside, Chunk};
use super::gather::{Forces, one_side};
use super::precision::Precision;
use super::{Class, GridBonds};
use crate::bonds::BondModel;
use std::array::from_fn;
use std::marker::PhantomData;
use std::ops::Range;

impl<const D: usize, const M: usize, B: BondModel<D, M>> GridBonds<D, M, B> {
    /// Forces on a chunk without exceptions; `all` is room for its bonds.
    #[inline(always)]
    pub(super) fn beside<R: Precision>(
        &self,
        chunk: &Chunk,
        beside: &Beside,
        u: &[&[R]; D],
        all: &mut Vec<Sides>,
        forces: &mut Forces<D, R>,
    ) {
        let sides = |(number, class): (usize, &Class<D, M>)| {
            let [above, below] = self.chunks.lines_at(beside, class.step);
            let along = class.step[0];
            let above = above.map(|line| line as i64 + i64::from(along));
            let below = below.map(|line| line as i64 - i64::from(along));
            let class = number as u32;
            (above.is_some() || below.is_some()).then_some(Sides { class, along, above, below })
        };
        all.clear();
        all.extend(self.offsets().iter().enumerate().filter_map(sides));
        let is_done = pulp::Arch::new().dispatch(ChunkForces::<D, M, B, R> {
            classes: R::classes_of(self, chunk),
            sides: all,
            u,
            first: chunk.first as usize,
            width: chunk.width as usize,
            clip: beside.clip,
            reach: self.chunks.reach(),
            forces,
            model: PhantomData,
        });
        if !is_done {
            self.few(chunk, beside.clip, all, u, forces);
        }
    }

    /// The same of a few points.
    fn few<R: Precision>(
        &self,
        chunk: &Chunk,
        [left, right]: [i32; 2],
        sides: &[Sides],
        u: &[&[R]; D],
        forces: &mut Forces<D, R>,
    ) {
        let (width, first) = (chunk.width as i32, chunk.first as i64);
        // Points from which a step along the row is in a line.
        let there = |step: i32| (-left - step).max(0)..(width + right - step).min(width);
        let at = |number: i64, range: &Range<i32>| -> [&[R]; D] {
            let from = (number + i64::from(range.start)) as usize;
            from_fn(|c| &u[c][from..from + range.len()])
        };
        for sides in sides {
            let class = &R::classes_of(self, chunk)[sides.class as usize];
            let above = sides.above.map(|number| (number, there(sides.along)));
            if let Some((number, range)) = above.filter(|of| !of.1.is_empty()) {
                let ends = [&at(first, &range), &at(number, &range)];
                one_side::<D, M, B, R, false>(class, ends, [None; M], range.start as usize, forces);
            }
            let below = sides.below.map(|number| (number, there(-sides.along)));
            if let Some((number, range)) = below.filter(|of| !of.1.is_empty()) {
                let ends = [&at(number, &range), &at(first, &range)];
                one_side::<D, M, B, R, true>(class, ends, [None; M], range.start as usize, forces);
            }
        }
    }
}
