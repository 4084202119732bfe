//! A clamped plate of cells whose points pull at all others within three spacings, as levels of a multigrid cycle.
//!
//! Two unknowns per cell, side by side. Coarser levels are the same plate in cells twice as wide, with the same 28
//! neighbours; in two dimensions the stiffness of a bond does not depend on the spacing. A coarse cell is in the plate
//! if any of its four children is. Cells outside and clamped ones keep their unknowns, held at zero.

mod level;
mod transfer;

use level::Level;
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

impl Hierarchy for Plate {
    type Real = f64;

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
