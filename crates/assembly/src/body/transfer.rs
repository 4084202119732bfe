//! Interpolation between a lattice and the next coarser one.
//!
//! The centre of a fine cell lies a quarter of the coarse spacing from that of its parent along every axis; linear
//! interpolation along each has the weights 3/4 and 1/4, so that the four nearest coarse cells of a plane have 9, 3, 3, 1 over
//! 16, and the eight of a solid 27, 9, 9, 3, 9, 3, 3, 1 over 64. Where some of them do not exist, or a crack hides them, the
//! others share the weight, so that constants stay constants. The restriction is the transpose.

mod build;

use super::lattice::{Cell, SquareLattice};
use build::{candidates, coarse_side, fine_side};
use peristat_vector::Real;
use rayon::prelude::*;
use std::array::from_fn;
use std::ops::Range;

/// Points below which threads cost more than they bring.
const FEW: usize = 8192;
/// Runs that one thread takes at a time.
const PART: usize = 16;

/// Interpolation of vectors of component planes from the points of a coarse level to those of a fine one.
pub trait Interpolation<R> {
    /// Overwrites a vector of the coarse level with what the transpose collects from one of the fine level.
    fn restrict_all(&self, fine: &[R], coarse: &mut [R]);

    /// Adds to a vector of the fine level what is interpolated from one of the coarse level.
    fn prolong_all(&self, coarse: &[R], fine: &mut [R]);
}

/// The same in numbers of 64 and of 32 bits.
pub trait LevelTransfer: Interpolation<f64> + Interpolation<f32> + Send + Sync {}

impl<T: Interpolation<f64> + Interpolation<f32> + Send + Sync> LevelTransfer for T {}

impl<R: Real> Interpolation<R> for Transfer {
    fn restrict_all(&self, fine: &[R], coarse: &mut [R]) {
        let planes = fine.chunks_exact(self.fine.points).zip(coarse.chunks_exact_mut(self.coarse.points));
        planes.for_each(|(fine, coarse)| self.restrict(fine, coarse));
    }

    fn prolong_all(&self, coarse: &[R], fine: &mut [R]) {
        let planes = fine.chunks_exact_mut(self.fine.points).zip(coarse.chunks_exact(self.coarse.points));
        planes.for_each(|(fine, coarse)| self.prolong_add(coarse, fine));
    }
}

/// Interpolation from the points of a coarse lattice to those of a fine one.
#[derive(Clone, Debug)]
pub struct Transfer {
    fine: Side,
    coarse: Side,
}

/// What one lattice gets from the other.
#[derive(Clone, Debug)]
struct Side {
    points: usize,
    runs: Vec<Share>,
    stretches: Vec<Stretch>,
    /// Per stretch, numbers of points in the lines of the other lattice.
    others: Vec<u32>,
    /// How many these are.
    lines: usize,
    /// Points with weights of their own, in order, and the ends of their entries.
    special: Vec<(u32, u32)>,
    entries: Vec<(u32, f64)>,
}

/// What belongs to one run of points.
#[derive(Clone, Debug)]
struct Share {
    points: Range<usize>,
    stretches: Range<usize>,
}

/// Neighbouring cells with the ordinary weights. Of the fine lattice: pairs of cells with one parent, from `first`; its others
/// are the parent of the first pair and the coarse cells beside it in the other row, and in both rows of the other layer. Of
/// the coarse lattice: cells from `first`; its others are the first of the two middle cells in the four fine rows, of a solid in
/// those of four layers.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    first: u32,
    cells: u32,
    /// Where its others begin.
    others: u32,
}

impl Transfer {
    /// Interpolation to `fine` from `coarse`, its coarser lattice. For the fine points that are `near_crack`, coarse
    /// cells that are not `visible` from them (positions, m) take no part unless none is.
    pub fn new(
        fine: &SquareLattice,
        coarse: &SquareLattice,
        near_crack: &dyn Fn(usize) -> bool,
        visible: &dyn Fn([f64; 3], [f64; 3]) -> bool,
    ) -> Self {
        let weights = |point: usize, cell: Cell| -> Vec<(u32, f64)> {
            let known = candidates(cell, fine.is_plane())
                .into_iter()
                .filter_map(|(c, w)| Some((coarse.number(c)? as u32, c, w)));
            let all: Vec<(u32, Cell, f64)> = known.collect();
            let seen = |c: &(u32, Cell, f64)| visible(fine.centre(cell), coarse.centre(c.1));
            let near = near_crack(point);
            let mut kept: Vec<&(u32, Cell, f64)> = all.iter().filter(|c| !near || seen(c)).collect();
            if kept.is_empty() {
                kept = all.iter().collect();
            }
            let sum: f64 = kept.iter().map(|c| c.2).sum();
            kept.iter().map(|c| (c.0, c.2 / sum)).collect()
        };
        let fine_side = fine_side(fine, coarse, near_crack, &weights);
        let mut ordinary = vec![true; fine.points()];
        fine_side.special.iter().for_each(|s| ordinary[s.0 as usize] = false);
        let coarse_side = coarse_side(fine, coarse, &ordinary, &weights);
        Self { fine: fine_side, coarse: coarse_side }
    }

    /// Adds to one value per fine point what is interpolated from one per coarse point.
    pub fn prolong_add<R: Real>(&self, coarse: &[R], fine: &mut [R]) {
        match self.fine.lines {
            2 => self.prolong_pairs(coarse, fine, [0.75, 0.25]),
            _ => self.prolong_pairs(coarse, fine, [9.0, 3.0, 3.0, 1.0].map(|w| w / 16.0)),
        }
        self.fine.add_special(coarse, fine);
    }

    /// What pairs of cells with the ordinary weights get, from lines with these.
    fn prolong_pairs<const LINES: usize, R: Real>(
        &self,
        coarse: &[R],
        fine: &mut [R],
        weights: [f64; LINES],
    ) {
        let (weights, near, far) = (weights.map(R::of), R::of(0.75), R::of(0.25));
        self.fine.each(fine, |first, own, stretch, others| {
            let cells = stretch.cells as usize;
            let lines: [&[R]; LINES] = from_fn(|k| &coarse[others[k] as usize - 1..][..cells + 2]);
            let own = &mut own[stretch.first as usize - first..][..2 * cells];
            for (k, pair) in own.chunks_exact_mut(2).enumerate() {
                let more = |sum: R, line: usize, k: usize| sum + weights[line] * lines[line][k];
                let at = |k: usize| (1..LINES).fold(weights[0] * lines[0][k], |sum, line| more(sum, line, k));
                let middle = near * at(k + 1);
                pair[0] += middle + far * at(k);
                pair[1] += middle + far * at(k + 2);
            }
        });
    }

    /// Overwrites one value per coarse point with what the transpose collects from one per fine point.
    pub fn restrict<R: Real>(&self, fine: &[R], coarse: &mut [R]) {
        coarse.fill(R::default());
        const ROWS: [f64; 4] = [0.25, 0.75, 0.75, 0.25];
        let of_layer = |layer: f64| ROWS.map(|row| layer * row);
        let weights = if self.coarse.lines == 4 { ROWS.to_vec() } else { ROWS.map(of_layer).concat() };
        let (near, far) = (R::of(0.75), R::of(0.25));
        self.coarse.each(coarse, |first, own, stretch, others| {
            let own = &mut own[stretch.first as usize - first..][..stretch.cells as usize];
            for (&other, weight) in others.iter().zip(&weights) {
                let weight = R::of(*weight);
                let row = &fine[other as usize - 1..][..2 * stretch.cells as usize + 2];
                for (k, sum) in own.iter_mut().enumerate() {
                    let f = &row[2 * k..2 * k + 4];
                    *sum += weight * (far * (f[0] + f[3]) + near * (f[1] + f[2]));
                }
            }
        });
        self.coarse.add_special(fine, coarse);
    }
}

impl Side {
    /// Calls `work` with the first point and the values of a part of the points, and with every stretch in it and its others.
    fn each<R: Real>(&self, values: &mut [R], work: impl Fn(usize, &mut [R], &Stretch, &[u32]) + Sync) {
        let mut rest = &mut values[..self.points];
        let mut parts = Vec::new();
        for runs in self.runs.chunks(PART) {
            let count = runs.iter().map(|r| r.points.len()).sum();
            let (own, left) = std::mem::take(&mut rest).split_at_mut(count);
            rest = left;
            parts.push((runs, own));
        }
        let part = |(runs, own): (&[Share], &mut [R])| {
            let first = runs[0].points.start;
            let stretches = runs.iter().flat_map(|run| &self.stretches[run.stretches.clone()]);
            let others = |stretch: &Stretch| &self.others[stretch.others as usize..][..self.lines];
            stretches.for_each(|stretch| work(first, own, stretch, others(stretch)));
        };
        match self.points < FEW {
            true => parts.into_iter().for_each(part),
            false => parts.into_par_iter().for_each(part),
        }
    }

    /// Adds what the points with weights of their own take.
    fn add_special<R: Real>(&self, from: &[R], to: &mut [R]) {
        let mut begin = 0;
        for &(point, end) in &self.special {
            let entries = &self.entries[begin as usize..end as usize];
            to[point as usize] += R::of(entries.iter().map(|&(p, w)| w * from[p as usize].into()).sum());
            begin = end;
        }
    }
}

#[cfg(test)]
mod tests;
