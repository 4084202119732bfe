//! Means over blocks of two by two cells, in several layers of eight.

use super::GridFamily;
use crate::body::SquareLattice;

/// Points by blocks.
#[derive(Clone, Debug)]
pub(super) struct Blocks {
    /// Points that have a family, block by block.
    points: Vec<u32>,
    /// Start of every block in them; one more at the end.
    start: Vec<u32>,
}

impl Blocks {
    pub(super) fn new<const D: usize>(lattice: &SquareLattice, family: &GridFamily<D>) -> Self {
        let mut placed: Vec<([i32; 3], u32)> = Vec::new();
        for run in lattice.runs() {
            for column in run.columns.clone() {
                let point = run.number(column);
                if family.set_of[point].is_some() {
                    let [column, row, layer] = SquareLattice::parent(run.cell(column));
                    placed.push(([layer, row, column], point as u32));
                }
            }
        }
        placed.sort_unstable();
        let mut blocks = Self { points: Vec::with_capacity(placed.len()), start: vec![0] };
        for block in placed.chunk_by(|a, b| a.0 == b.0) {
            blocks.points.extend(block.iter().map(|p| p.1));
            blocks.start.push(blocks.points.len() as u32);
        }
        blocks
    }

    /// The points of every block.
    pub(super) fn iter(&self) -> impl Iterator<Item = &[u32]> {
        self.start.windows(2).map(|ends| &self.points[ends[0] as usize..ends[1] as usize])
    }

    /// Calls `take` with every point and the mean of a value over its block, weighted by volume.
    pub(super) fn for_each_mean(
        &self,
        volume: &[f64],
        value: impl Fn(usize) -> f64,
        mut take: impl FnMut(usize, f64),
    ) {
        for block in self.iter() {
            let whole: f64 = block.iter().map(|&k| volume[k as usize]).sum();
            let sum: f64 = block.iter().map(|&k| volume[k as usize] * value(k as usize)).sum();
            // A block can have given all of its volume away.
            let mean = if whole > 0.0 { sum / whole } else { 0.0 };
            block.iter().for_each(|&k| take(k as usize, mean));
        }
    }
}
