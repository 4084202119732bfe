//! Forces on the short rows of solids: chunks whose neighbours at an offset follow each other, if they are there at all.
//!
//! Rows of a cube are no longer than a chunk, so that hardly any chunk has all of its neighbours. What one lacks are whole lines
//! beside it, and the ends of those that it has, all alike.

use super::chunks::{Beside, Chunk};
use super::gather::{Forces, one_side};
use super::{Class, GridBonds};
use crate::bonds::BondModel;
use std::array::from_fn;
use std::ops::Range;

impl<const D: usize, const M: usize, B: BondModel<D, M>> GridBonds<D, M, B> {
    /// Forces on a chunk without exceptions.
    #[inline(always)]
    pub(super) fn beside(&self, chunk: &Chunk, beside: &Beside, u: &[&[f64]; D], forces: &mut Forces<D>) {
        let (width, first, [left, right]) = (chunk.width as i32, chunk.first as usize, beside.clip);
        // Points of the chunk from some step along the row is in a line.
        let there = |step: i32| (-left - step).max(0)..(width + right - step).min(width);
        for class in &self.classes {
            let along = class.step[0];
            let [above, below] = self.chunks.lines_at(beside, class.step);
            let above = above.map(|line| (there(along), line as i64 + i64::from(along)));
            let below = below.map(|line| (there(-along), line as i64 - i64::from(along)));
            let [up, down] = [&above, &below].map(|side| side.as_ref().map_or(0..0, |side| side.0.clone()));
            let both = up.start.max(down.start)..up.end.min(down.end);
            let both = if both.is_empty() { 0..0 } else { both };
            let at = |side: &Option<(Range<i32>, i64)>, range: &Range<i32>| -> [&[f64]; D] {
                let from = side.as_ref().map_or(0, |side| (side.1 + i64::from(range.start)) as usize);
                from_fn(|c| &u[c][from..from + range.len()])
            };
            let own = |range: &Range<i32>| -> [&[f64]; D] {
                let from = first + range.start as usize;
                from_fn(|c| &u[c][from..from + range.len()])
            };
            if !both.is_empty() {
                let k = both.start as usize;
                both_sides::<D, M, B>(class, [at(&below, &both), own(&both), at(&above, &both)], k, forces);
            }
            for rest in rests(&up, &both) {
                let k = rest.start as usize;
                one_side::<D, M, B, false>(class, [&own(&rest), &at(&above, &rest)], None, k, forces);
            }
            for rest in rests(&down, &both) {
                let k = rest.start as usize;
                one_side::<D, M, B, true>(class, [&at(&below, &rest), &own(&rest)], None, k, forces);
            }
        }
    }
}

/// What of a range is before and behind a part of it.
#[inline(always)]
fn rests(all: &Range<i32>, part: &Range<i32>) -> impl Iterator<Item = Range<i32>> {
    let two = if part.is_empty() { [all.clone(), 0..0] } else { [all.start..part.start, part.end..all.end] };
    two.into_iter().filter(|range| !range.is_empty())
}

/// Forces on some points of a chunk, from the k-th on, with bonds on both sides: those below, their own and those above.
#[inline(always)]
fn both_sides<const D: usize, const M: usize, B: BondModel<D, M>>(
    class: &Class<D, M>,
    [down, own, up]: [[&[f64]; D]; 3],
    k: usize,
    forces: &mut Forces<D>,
) {
    let width = own[0].len();
    let [down, own, up] = [down, own, up].map(|side| side.map(|u| &u[..width]));
    let forces: [&mut [f64]; D] = forces.each_mut().map(|plane| &mut plane[k..k + width]);
    for l in 0..width {
        for m in 0..M {
            let (mut above, mut below) = (0.0, 0.0);
            for c in 0..D {
                if B::DIFFERENCE[m][c] {
                    above += class.difference[m][c] * (up[c][l] - own[c][l]);
                    below += class.difference[m][c] * (own[c][l] - down[c][l]);
                }
                if B::MEAN[m][c] {
                    above += class.half_mean[m][c] * (own[c][l] + up[c][l]);
                    below += class.half_mean[m][c] * (down[c][l] + own[c][l]);
                }
            }
            above *= class.modulus[m];
            below *= class.modulus[m];
            for c in 0..D {
                if B::DIFFERENCE[m][c] {
                    forces[c][l] += class.difference[m][c] * (below - above);
                }
                if B::MEAN[m][c] {
                    forces[c][l] += class.half_mean[m][c] * (below + above);
                }
            }
        }
    }
}
