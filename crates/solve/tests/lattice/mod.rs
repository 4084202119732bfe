//! A clamped plate of cells whose points pull at all others within three spacings, as levels of a multigrid cycle.
//!
//! Two unknowns per cell, side by side. Coarser levels are the same plate in cells twice as wide, with the same 28
//! neighbours; in two dimensions the stiffness of a bond does not depend on the spacing. A coarse cell is in the plate
//! if any of its four children is. Cells outside and clamped ones keep their unknowns, held at zero.

mod transfer;

use peristat_solve::{BandCholesky, BandMatrix, Hierarchy, LinearOperator, Preconditioner};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};
use transfer::sources;

/// What is missing from a plate of height 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Flaw {
    Nothing,
    /// A hole of this radius in the middle.
    Hole(f64),
    /// A cut across bonds in the middle, from below to this height.
    Cut(f64),
}

/// One bond of every point: offset and stiffness `[xx, xy, yy]`.
type Bond = ([isize; 2], [f64; 3]);

struct Level {
    width: usize,
    spacing: f64,
    flaw: Flaw,
    /// Neither outside nor clamped.
    free: Vec<bool>,
    inside: Vec<bool>,
    /// Bit `k`: bond `k` of the cell is there.
    bonds: Vec<u32>,
    inverse: Vec<[f64; 3]>,
}

/// The levels, and how often each has been multiplied with.
pub(crate) struct Plate {
    stencil: Vec<Bond>,
    levels: Vec<Level>,
    products: Vec<AtomicUsize>,
}

/// Bonds within three spacings; the outermost count by the part of their cell that is within.
fn stencil() -> Vec<Bond> {
    let mut bonds = Vec::new();
    for dj in -3_isize..=3 {
        for di in -3_isize..=3 {
            let length = ((di * di + dj * dj) as f64).sqrt();
            if length > 0.0 && length < 3.015 {
                let k = (3.515 - length).min(1.0) / length.powi(3);
                let (x, y) = (di as f64, dj as f64);
                bonds.push(([di, dj], [k * x * x, k * x * y, k * y * y]));
            }
        }
    }
    bonds
}

impl Plate {
    /// `width` by `height` cells; the left 16th of the height is clamped; coarsened down to `coarsest` rows or less.
    pub(crate) fn new(width: usize, height: usize, flaw: Flaw, coarsest: usize) -> Self {
        let stencil = stencil();
        let spacing = 1.0 / height as f64;
        let middle = 0.5 * width as f64 * spacing;
        let inside = (0..width * height)
            .map(|p| {
                let x = ((p % width) as f64 + 0.5) * spacing - middle;
                let y = ((p / width) as f64 + 0.5) * spacing - 0.5;
                !matches!(flaw, Flaw::Hole(radius) if x.hypot(y) < radius)
            })
            .collect();
        let mut levels = vec![Level::new(&stencil, width, spacing, inside, flaw)];
        while levels.last().is_some_and(|l| l.height() > coarsest) {
            let next = levels[levels.len() - 1].coarser(&stencil, flaw);
            levels.push(next);
        }
        let products = levels.iter().map(|_| AtomicUsize::new(0)).collect();
        Self { stencil, levels, products }
    }

    /// A shear load with some pull on the right edge, four cells deep.
    pub(crate) fn load(&self) -> Vec<f64> {
        let level = &self.levels[0];
        let mut load = vec![0.0; 2 * level.free.len()];
        for (p, f) in load.chunks_exact_mut(2).enumerate() {
            if level.free[p] && p % level.width + 4 >= level.width {
                f.copy_from_slice(&[0.3, 1.0]);
            }
        }
        load
    }

    /// The factor of the coarsest level.
    pub(crate) fn coarsest(&self) -> Box<dyn Preconditioner + Send> {
        let last = self.levels.len() - 1;
        let level = &self.levels[last];
        let (order, half_bandwidth) = (2 * level.free.len(), 2 * (3 * level.width + 3) + 1);
        let half_bandwidth = half_bandwidth.min(order - 1);
        let mut values = vec![0.0; order * (half_bandwidth + 1)];
        let (mut unit, mut column) = (vec![0.0; order], vec![0.0; order]);
        for j in 0..order {
            unit[j] = 1.0;
            level.apply(&self.stencil, &unit, &mut column);
            unit[j] = 0.0;
            let rows = half_bandwidth.min(order - 1 - j) + 1;
            let target = &mut values[j * (half_bandwidth + 1)..][..rows];
            target.copy_from_slice(&column[j..j + rows]);
            if !level.free[j / 2] {
                target[0] = 1.0;
            }
        }
        Box::new(
            BandCholesky::factor(BandMatrix { order, half_bandwidth, values }, 1).expect("positive definite"),
        )
    }

    /// Products with a level since the last call.
    pub(crate) fn products(&self, level: usize) -> usize {
        self.products[level].swap(0, Ordering::Relaxed)
    }
}

impl Level {
    fn new(stencil: &[Bond], width: usize, spacing: f64, inside: Vec<bool>, flaw: Flaw) -> Self {
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

    fn height(&self) -> usize {
        self.free.len() / self.width
    }

    /// Of a cell, measured from the middle of the lower edge.
    fn centre(&self, p: usize) -> [f64; 2] {
        let x = (p % self.width) as f64 + 0.5 - 0.5 * self.width as f64;
        [x * self.spacing, ((p / self.width) as f64 + 0.5) * self.spacing]
    }

    /// Whether the cut runs between these points.
    fn cut(&self, [x, y]: [f64; 2], [to_x, to_y]: [f64; 2]) -> bool {
        let Flaw::Cut(top) = self.flaw else { return false };
        (x < 0.0) != (to_x < 0.0) && y + x / (x - to_x) * (to_y - y) < top
    }

    fn coarser(&self, stencil: &[Bond], flaw: Flaw) -> Self {
        let (width, height) = (self.width.div_ceil(2), self.height().div_ceil(2));
        let mut inside = vec![false; width * height];
        for p in 0..self.inside.len() {
            inside[p / self.width / 2 * width + p % self.width / 2] |= self.inside[p];
        }
        Self::new(stencil, width, 2.0 * self.spacing, inside, flaw)
    }

    fn apply(&self, stencil: &[Bond], x: &[f64], y: &mut [f64]) {
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

impl Hierarchy for Plate {
    fn depth(&self) -> usize {
        self.levels.len()
    }

    fn size(&self, level: usize) -> usize {
        2 * self.levels[level].free.len()
    }

    fn apply(&self, level: usize, x: &[f64], y: &mut [f64]) {
        self.products[level].fetch_add(1, Ordering::Relaxed);
        self.levels[level].apply(&self.stencil, x, y);
    }

    fn smooth(&self, level: usize, scale: f64, r: &[f64], x: &mut [f64]) {
        let inverse = &self.levels[level].inverse;
        x.par_chunks_mut(2).zip(r.par_chunks(2)).zip(inverse).for_each(|((x, r), m)| {
            x[0] += scale * (m[0] * r[0] + m[1] * r[1]);
            x[1] += scale * (m[1] * r[0] + m[2] * r[1]);
        });
    }

    fn restrict(&self, level: usize, fine: &[f64], coarse: &mut [f64]) {
        let (here, there) = (&self.levels[level], &self.levels[level + 1]);
        coarse.fill(0.0);
        for (p, f) in fine.chunks_exact(2).enumerate().filter(|(p, _)| here.free[*p]) {
            let (cells, shares) = sources(here, there, p);
            for (q, share) in cells.into_iter().zip(shares).filter(|(q, _)| there.free[*q]) {
                coarse[2 * q] += share * f[0];
                coarse[2 * q + 1] += share * f[1];
            }
        }
    }

    fn prolong_add(&self, level: usize, coarse: &[f64], fine: &mut [f64]) {
        let (here, there) = (&self.levels[level], &self.levels[level + 1]);
        for (p, f) in fine.chunks_exact_mut(2).enumerate().filter(|(p, _)| here.free[*p]) {
            let (cells, shares) = sources(here, there, p);
            for (q, share) in cells.into_iter().zip(shares).filter(|(q, _)| there.free[*q]) {
                f[0] += share * coarse[2 * q];
                f[1] += share * coarse[2 * q + 1];
            }
        }
    }
}

/// The finest level as the operator of a solve.
pub(crate) struct Finest<'a>(pub(crate) &'a Plate);

impl LinearOperator for Finest<'_> {
    fn size(&self) -> usize {
        Hierarchy::size(self.0, 0)
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        Hierarchy::apply(self.0, 0, x, y);
    }
}
