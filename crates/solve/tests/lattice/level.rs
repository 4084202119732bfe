//! One level: the cells, their bonds, the product.

use super::{Bond, Flaw};
use rayon::prelude::*;

pub(super) struct Level {
    pub(super) width: usize,
    spacing: f64,
    flaw: Flaw,
    /// Neither outside nor clamped.
    pub(super) free: Vec<bool>,
    pub(super) inside: Vec<bool>,
    /// Bit `k`: bond `k` of the cell is there.
    bonds: Vec<u32>,
    pub(super) inverse: Vec<[f64; 3]>,
}

impl Level {
    pub(super) fn new(stencil: &[Bond], width: usize, spacing: f64, inside: Vec<bool>, flaw: Flaw) -> Self {
        let height = inside.len() / width;
        let free = |p: usize| inside[p] && ((p % width) as f64 + 0.5) * spacing > 1.0 / 16.0;
        let free = (0..inside.len()).map(free).collect();
        let mut level = Self { width, spacing, flaw, free, inside, bonds: Vec::new(), inverse: Vec::new() };
        for p in 0..level.inside.len() {
            let (i, j) = (p % width, p / width);
            let (mut bonds, mut own) = (0, [0.0; 3]);
            for (k, (offset, stiffness)) in stencil.iter().enumerate() {
                let there = i.checked_add_signed(offset[0]).filter(|i| *i < width);
                let there = there.zip(j.checked_add_signed(offset[1]).filter(|j| *j < height));
                let there = there.is_some_and(|(i, j)| level.inside[j * width + i]);
                if level.inside[p]
                    && there
                    && !level.cut(
                        level.centre(p),
                        level.centre(p.wrapping_add_signed(offset[0] + offset[1] * width as isize)),
                    )
                {
                    bonds |= 1 << k;
                    (0..3).for_each(|c| own[c] += stiffness[c]);
                }
            }
            let determinant = own[0] * own[2] - own[1] * own[1];
            let free = level.free[p] && determinant > 0.0;
            level.free[p] = free;
            let inverse = [own[2], -own[1], own[0]].map(|v| if free { v / determinant } else { 0.0 });
            level.bonds.push(bonds);
            level.inverse.push(inverse);
        }
        level
    }

    pub(super) fn height(&self) -> usize {
        self.free.len() / self.width
    }

    /// Of a cell, measured from the middle of the lower edge.
    pub(super) fn centre(&self, p: usize) -> [f64; 2] {
        let x = (p % self.width) as f64 + 0.5 - 0.5 * self.width as f64;
        [x * self.spacing, ((p / self.width) as f64 + 0.5) * self.spacing]
    }

    /// Whether the cut runs between these points.
    pub(super) fn cut(&self, [x, y]: [f64; 2], [to_x, to_y]: [f64; 2]) -> bool {
        let Flaw::Cut(top) = self.flaw else { return false };
        (x < 0.0) != (to_x < 0.0) && y + x / (x - to_x) * (to_y - y) < top
    }

    pub(super) fn coarser(&self, stencil: &[Bond], flaw: Flaw) -> Self {
        let (width, height) = (self.width.div_ceil(2), self.height().div_ceil(2));
        let mut inside = vec![false; width * height];
        for p in 0..self.inside.len() {
            inside[p / self.width / 2 * width + p % self.width / 2] |= self.inside[p];
        }
        Self::new(stencil, width, 2.0 * self.spacing, inside, flaw)
    }

    pub(super) fn apply(&self, stencil: &[Bond], x: &[f64], y: &mut [f64]) {
        let width = self.width;
        y.par_chunks_mut(2 * width).enumerate().for_each(|(j, y)| {
            for (i, y) in y.chunks_exact_mut(2).enumerate() {
                let p = j * width + i;
                y.fill(0.0);
                if !self.free[p] {
                    continue;
                }
                let (mut a, mut b) = (0.0, 0.0);
                for (k, ([di, dj], stiffness)) in stencil.iter().enumerate() {
                    if self.bonds[p] >> k & 1 == 1 {
                        let q = (p as isize + dj * width as isize + di) as usize;
                        // The clamped cells do not move.
                        let moves = if self.free[q] { 1.0 } else { 0.0 };
                        let u = x[2 * p] - moves * x[2 * q];
                        let v = x[2 * p + 1] - moves * x[2 * q + 1];
                        a += stiffness[0] * u + stiffness[1] * v;
                        b += stiffness[1] * u + stiffness[2] * v;
                    }
                }
                y.copy_from_slice(&[a, b]);
            }
        });
    }
}
