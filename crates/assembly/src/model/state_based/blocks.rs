//! Dilatations that are means over blocks of two by two points, and what they are at the points.
//!
//! A mean is that of the middle of its block. A point stands half a spacing beside it: there the dilatation is what the means of next
//! blocks say, exact where it is linear. With the mean alone the stress of a bent body is off by the pressure over that half spacing.

use super::super::plane::Mirrors;
use crate::body::{Cell, SquareLattice};
use std::collections::HashMap;

/// A block: its cell on the lattice of twice the spacing, and the number of its material.
pub(super) type Block = (Cell, usize);

/// Sums over the points of a block.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    weight: f64,
    value: f64,
    /// Of the columns and rows.
    place: [f64; 2],
}

impl Sums {
    fn mean(&self) -> f64 {
        self.value / self.weight
    }

    fn middle(&self, axis: usize) -> f64 {
        self.place[axis] / self.weight
    }
}

/// Means of a value over blocks.
pub(super) struct Means<'a> {
    body: (&'a SquareLattice, Mirrors),
    sums: HashMap<Block, Sums>,
}

impl<'a> Means<'a> {
    /// Of values of all points with their weights; points without a weight belong to no block.
    pub(super) fn new(
        (lattice, mirrors): (&'a SquareLattice, Mirrors),
        block: &dyn Fn(usize) -> Block,
        weight: &dyn Fn(usize) -> f64,
        values: &[f64],
    ) -> Self {
        let mut sums: HashMap<Block, Sums> = HashMap::new();
        for (p, value) in values.iter().enumerate() {
            let (own, [column, row, _]) = (weight(p), lattice.cell(p));
            if own <= 0.0 {
                continue;
            }
            let sum = sums.entry(block(p)).or_default();
            sum.weight += own;
            sum.value += own * value;
            (0..2).for_each(|k| sum.place[k] += own * f64::from([column, row][k]));
        }
        Self { body: (lattice, mirrors), sums }
    }

    /// The mean over a block; zero if it has no points.
    pub(super) fn of(&self, block: Block) -> f64 {
        self.sums.get(&block).map_or(0.0, Sums::mean)
    }

    /// What it is at a point of a block, from the means of this and the next blocks of the same material.
    pub(super) fn at(&self, point: usize, block: Block) -> f64 {
        let Some(own) = self.sums.get(&block) else { return 0.0 };
        let cell = self.body.0.cell(point);
        let change = |axis: usize| {
            let slope = |step: i32| {
                let (mean, middle) = self.next(cell, block, (axis, step))?;
                Some((mean - own.mean()) / (middle - own.middle(axis)))
            };
            let slopes: Vec<f64> = [-1, 1].into_iter().filter_map(slope).collect();
            let slope = slopes.iter().sum::<f64>() / slopes.len().max(1) as f64;
            slope * (f64::from(cell[axis]) - own.middle(axis))
        };
        own.mean() + change(0) + change(1)
    }

    /// Mean and middle of the block that follows that of a cell, which may be an image.
    fn next(&self, cell: Cell, (of, number): Block, (axis, step): (usize, i32)) -> Option<(f64, f64)> {
        let mut next = of;
        next[axis] += step;
        if let Some(next) = self.sums.get(&(next, number)) {
            return Some((next.mean(), next.middle(axis)));
        }
        let mirrors = &self.body.1;
        let mut beyond = cell;
        beyond[axis] += 2 * step;
        let (real, _) = mirrors.image(beyond);
        let image = self.sums.get(&(SquareLattice::parent(real), number)).filter(|_| real != beyond)?;
        let [from, to] = [real[axis], beyond[axis]].map(f64::from);
        let middle = match mirrors.joined[axis] {
            true => image.middle(axis) + to - from,
            false => from + to - image.middle(axis),
        };
        Some((image.mean(), middle))
    }
}
