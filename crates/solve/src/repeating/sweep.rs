//! The two streaming sweeps.

use super::table::{LANES, Table, add};
use super::{RepeatingCholesky, Run, Tables};
use peristat_vector::vectorised;

/// Unknowns, about, that are worked on at once, next to the window of results.
const CHUNK: usize = 512;
/// Equal columns of a run that are worth the tables.
const WORTHWHILE: usize = 8 * LANES;

/// The sweep `L y = r` from the first unknown to the last.
#[derive(Debug, Clone)]
pub struct Forward<'a> {
    factor: &'a RepeatingCholesky,
    /// Unknowns that are done.
    done: usize,
    /// Current run.
    run: usize,
    /// Unknowns of it that are done.
    at: usize,
    /// The last results, then room for the next.
    values: Vec<f64>,
}

/// The sweep `L^T x = D^-1 y` from the last unknown to the first.
#[derive(Debug, Clone)]
pub struct Backward<'a> {
    factor: &'a RepeatingCholesky,
    /// Unknowns that are not done.
    rest: usize,
    /// Runs up to the current one.
    runs: usize,
    /// Unknowns of the current run that are not done.
    left: usize,
    /// Room for the next results, then the last.
    values: Vec<f64>,
}

impl Tables {
    /// The tables of a run, unless it is too short for them to pay.
    pub(super) fn new(factor: &RepeatingCholesky, run: &Run) -> Option<Self> {
        if run.columns - run.kept < WORTHWHILE {
            return None;
        }
        let (b, period) = (factor.half_bandwidth, factor.period);
        let kept = |at: usize| run.kept(run.kept + at, period);
        let forward = Table::new(period, b + LANES, b, |phase, values| {
            for i in 0..LANES {
                forward_one(factor.row(kept(phase + i)), &mut values[i..=b + i]);
            }
        });
        let backward = Table::new(period, b + LANES, 0, |phase, values| {
            for i in (0..LANES).rev() {
                backward_one(factor.column(kept(phase + i)), &mut values[i..=b + i]);
            }
        });
        Some(Self { forward, backward })
    }
}

impl<'a> Forward<'a> {
    pub(super) fn new(factor: &'a RepeatingCholesky) -> Self {
        let values = vec![0.0; factor.half_bandwidth + factor.chunk()];
        Self { factor, done: 0, run: 0, at: 0, values }
    }

    /// Overwrites the next `block.len()` unknowns of `r` by those of `y`.
    ///
    /// # Panics
    ///
    /// If the length is not a multiple of the period, or past the last unknown.
    pub fn sweep(&mut self, block: &mut [f64]) {
        assert!(block.len().is_multiple_of(self.factor.period), "whole groups");
        assert!(block.len() <= self.factor.order - self.done, "no more unknowns than there are");
        self.done += block.len();
        let b = self.factor.half_bandwidth;
        for chunk in block.chunks_mut(self.factor.chunk()) {
            let end = b + chunk.len();
            self.values[b..end].copy_from_slice(chunk);
            vectorised(
                #[inline(always)]
                || self.advance(end),
            );
            chunk.copy_from_slice(&self.values[b..end]);
            self.values.copy_within(end - b..end, 0);
        }
    }

    /// Goes on up to `end` in the values.
    #[inline(always)]
    fn advance(&mut self, end: usize) {
        let (b, period) = (self.factor.half_bandwidth, self.factor.period);
        let mut next = b;
        while next < end {
            let run = &self.factor.runs[self.run];
            if let Some(tables) = &run.tables
                && self.at >= run.kept
            {
                let mut phase = self.at % period;
                let count = (end - next).min(run.columns - self.at) / LANES;
                for _ in 0..count {
                    let (known, unknowns) = self.values[next - b..next + LANES].split_at_mut(b);
                    let (of_known, of_unknowns) = tables.forward.at(phase).split_at(b);
                    let mut sum = [0.0; LANES];
                    add(&mut sum, of_unknowns.iter().zip(&*unknowns));
                    add(&mut sum, of_known.iter().zip(&*known));
                    unknowns.copy_from_slice(&sum);
                    phase = (phase + LANES) % period;
                    next += LANES;
                }
                self.at += count * LANES;
            }
            let before_next = if self.at < run.kept { run.kept } else { run.columns };
            let count = (end - next).min(before_next - self.at);
            for _ in 0..count {
                let row = self.factor.row(run.kept(self.at, period));
                forward_one(row, &mut self.values[next - b..=next]);
                self.at += 1;
                next += 1;
            }
            if self.at == run.columns {
                (self.run, self.at) = (self.run + 1, 0);
            }
        }
    }
}

impl<'a> Backward<'a> {
    pub(super) fn new(factor: &'a RepeatingCholesky) -> Self {
        let values = vec![0.0; factor.half_bandwidth + factor.chunk()];
        let left = factor.runs.last().map_or(0, |run| run.columns);
        Self { factor, rest: factor.order, runs: factor.runs.len(), left, values }
    }

    /// Overwrites the `block.len()` unknowns of `y` before those already done, in
    /// the order of the matrix, by those of `x`.
    ///
    /// # Panics
    ///
    /// If the length is not a multiple of the period, or past the first unknown.
    pub fn sweep(&mut self, block: &mut [f64]) {
        assert!(block.len().is_multiple_of(self.factor.period), "whole groups");
        assert!(block.len() <= self.rest, "no more unknowns than there are");
        self.rest -= block.len();
        let (b, room) = (self.factor.half_bandwidth, self.factor.chunk());
        for chunk in block.rchunks_mut(room) {
            let start = room - chunk.len();
            self.values[start..room].copy_from_slice(chunk);
            vectorised(
                #[inline(always)]
                || self.advance(start),
            );
            chunk.copy_from_slice(&self.values[start..room]);
            self.values.copy_within(start..start + b, room);
        }
    }

    /// Goes on down to `start` in the values.
    #[inline(always)]
    fn advance(&mut self, start: usize) {
        let (b, period) = (self.factor.half_bandwidth, self.factor.period);
        let mut next = self.factor.chunk();
        while next > start {
            let run = &self.factor.runs[self.runs - 1];
            if let Some(tables) = &run.tables
                && self.left > run.kept
            {
                let count = (next - start).min(self.left - run.kept) / LANES;
                for _ in 0..count {
                    next -= LANES;
                    self.left -= LANES;
                    let (unknowns, known) = self.values[next..next + LANES + b].split_at_mut(LANES);
                    let (of_unknowns, of_known) = tables.backward.at(self.left % period).split_at(LANES);
                    let mut sum = [0.0; LANES];
                    add(&mut sum, of_unknowns.iter().zip(&*unknowns));
                    add(&mut sum, of_known.iter().zip(&*known).rev());
                    unknowns.copy_from_slice(&sum);
                }
            }
            let down_to = if self.left > run.kept { run.kept } else { 0 };
            for _ in 0..(next - start).min(self.left - down_to) {
                next -= 1;
                self.left -= 1;
                let column = self.factor.column(run.kept(self.left, period));
                backward_one(column, &mut self.values[next..=next + b]);
            }
            if self.left == 0 {
                self.runs -= 1;
                self.left = self.runs.checked_sub(1).map_or(0, |before| self.factor.runs[before].columns);
            }
        }
    }
}

impl RepeatingCholesky {
    /// Unknowns of a chunk: whole groups.
    fn chunk(&self) -> usize {
        CHUNK.div_ceil(self.period) * self.period
    }
}

/// The last of the values from those before it; the newest is subtracted last, so
/// that its term is the only one that waits for it.
#[inline(always)]
fn forward_one(row: &[f64], values: &mut [f64]) {
    let (before, value) = values.split_at_mut(row.len());
    for (entry, earlier) in row.iter().zip(before) {
        value[0] -= entry * *earlier;
    }
}

/// The first of the values from those after it, the newest last again.
#[inline(always)]
fn backward_one(column: &[f64], values: &mut [f64]) {
    let mut value = values[0] * column[0];
    for (entry, later) in column[1..].iter().zip(&values[1..]).rev() {
        value -= entry * later;
    }
    values[0] = value;
}
