//! Interpolation between the cells of two levels.
//!
//! Along every axis a cell has 3/4 of its parent and 1/4 of the cell beside it. Where some of the eight do not belong to the body
//! the others share the weight. Unknowns are scaled on both levels, and so is what goes between them.

use super::across::{Apart, apart};
use super::grid::Grid;
use super::level::CubicLevel;
use peristat_vector::vectorised;
use rayon::prelude::*;
use std::array::from_fn;

/// Points below which threads cost more than they bring.
const FEW: usize = 8192;

/// Interpolation from a level to the next finer one, and its transpose.
#[derive(Clone, Debug)]
pub(super) struct Transfer {
    /// Per place of the finer level: what interpolated values are multiplied with, zero outside of the body.
    weights: Vec<f32>,
    /// Points beside cracks, which have weights of their own.
    apart: Vec<Apart>,
}

impl Transfer {
    pub(super) fn new(fine: &CubicLevel, coarse: &CubicLevel) -> Self {
        let (grid, shift) = (fine.grid(), fine.cells.shift);
        let mut weights = vec![0.0; grid.len()];
        grid.for_each(|cell, place| {
            if !fine.cells.is_solid(place) {
                return;
            }
            let along: [[(i64, f32); 2]; 3] = from_fn(|k| parents(cell[k], shift[k]));
            let mut sum = 0.0;
            for corner in 0..8 {
                let part = |k: usize| along[k][corner >> k & 1];
                if coarse.cells.is_solid(coarse.grid().at([0, 1, 2].map(|k| part(k).0))) {
                    sum += (0..3).map(|k| part(k).1).product::<f32>();
                }
            }
            if sum > 0.0 {
                weights[place] = 1.0 / (sum * fine.inverse_scale[place]);
            }
        });
        let apart = apart(fine, coarse);
        apart.iter().for_each(|of| weights[of.place] = 0.0);
        grid.mirror(&mut weights, |weight, _| weight);
        Self { weights, apart }
    }

    /// Adds to `out`, of the finer level, what is interpolated from `v`.
    pub(super) fn prolong_add(&self, [fine, coarse]: [&CubicLevel; 2], v: &[f32], out: &mut [f32]) {
        let (grid, coarse_grid, shift) = (fine.grid(), coarse.grid(), fine.cells.shift);
        let (columns, half) = (grid.cells[0], coarse_grid.cells[0]);
        let work = |(layer, out): (usize, [&mut [f32]; 3])| {
            let mut line = vec![0.0; half + 2];
            let layers = parents(layer, shift[2]);
            let first = grid.row(0, layer);
            for (c, out) in out.into_iter().enumerate() {
                let v = &v[c * coarse_grid.len()..][..coarse_grid.len()];
                for row in 0..grid.cells[1] {
                    line.fill(0.0);
                    let rows = parents(row, shift[1]);
                    for (k, of_layer) in layers {
                        for (j, of_row) in rows {
                            let from = coarse_grid.at([-1, j, k]);
                            add_scaled(
                                &mut line,
                                of_layer * of_row,
                                &v[from..],
                                &coarse.inverse_scale[from..],
                            );
                        }
                    }
                    let place = grid.row(row, layer);
                    let (own, weights) = (&mut out[place - first..][..columns], &self.weights[place..]);
                    for (i, (own, weight)) in own.iter_mut().zip(weights).enumerate() {
                        let at = (i + shift[0]) / 2 + 1;
                        let beside = if (i + shift[0]) % 2 == 0 { at - 1 } else { at + 1 };
                        *own += weight * (0.75 * line[at] + 0.25 * line[beside]);
                    }
                }
            }
        };
        each_layer(grid, out, work);
        for Apart { place, parents } in &self.apart {
            for c in 0..3 {
                let v = &v[c * coarse_grid.len()..];
                out[c * grid.len() + place] +=
                    parents.iter().map(|(at, weight)| weight * v[*at]).sum::<f32>();
            }
        }
        fine.complete(out);
    }

    /// Writes the transpose of `r`, of the finer level, over `out`.
    pub(super) fn restrict(&self, [fine, coarse]: [&CubicLevel; 2], r: &[f32], out: &mut [f32]) {
        const WEIGHTS: [f32; 4] = [0.25, 0.75, 0.75, 0.25];
        let (grid, coarse_grid, shift) = (fine.grid(), coarse.grid(), fine.cells.shift);
        let wide = 2 * coarse_grid.cells[0] + 2;
        // The first of the four children along an axis.
        let child = |parent: usize, axis: usize| 2 * parent as i64 - shift[axis] as i64 - 1;
        let work = |(layer, out): (usize, [&mut [f32]; 3])| {
            let mut line = vec![0.0; wide];
            let first = coarse_grid.row(0, layer);
            for (c, out) in out.into_iter().enumerate() {
                let r = &r[c * grid.len()..][..grid.len()];
                for row in 0..coarse_grid.cells[1] {
                    line.fill(0.0);
                    for (k, of_layer) in WEIGHTS.iter().enumerate() {
                        for (j, of_row) in WEIGHTS.iter().enumerate() {
                            let cell = [child(0, 0), child(row, 1) + j as i64, child(layer, 2) + k as i64];
                            let from = grid.at(cell);
                            add_scaled(&mut line, of_layer * of_row, &r[from..], &self.weights[from..]);
                        }
                    }
                    let place = coarse_grid.row(row, layer);
                    for (i, own) in out[place - first..][..coarse_grid.cells[0]].iter_mut().enumerate() {
                        let of = &line[2 * i..2 * i + 4];
                        let sum = 0.25 * (of[0] + of[3]) + 0.75 * (of[1] + of[2]);
                        *own = coarse.inverse_scale[place + i] * sum;
                    }
                }
            }
        };
        each_layer(coarse_grid, out, work);
        for Apart { place, parents } in &self.apart {
            for c in 0..3 {
                let r = r[c * grid.len() + place];
                parents.iter().for_each(|(at, weight)| out[c * coarse_grid.len() + at] += weight * r);
            }
        }
        coarse.hand_over(out);
    }
}

/// The parent of a cell and the cell beside it, with their weights.
pub(super) fn parents(cell: usize, shift: usize) -> [(i64, f32); 2] {
    let (parent, is_upper) = (((cell + shift) / 2) as i64, (cell + shift) % 2 == 1);
    [(parent, 0.75), (if is_upper { parent + 1 } else { parent - 1 }, 0.25)]
}

/// Adds `factor · a · b` to a line.
fn add_scaled(line: &mut [f32], factor: f32, a: &[f32], b: &[f32]) {
    vectorised(
        #[inline(always)]
        || line.iter_mut().zip(a.iter().zip(b)).for_each(|(sum, (a, b))| *sum += factor * a * b),
    );
}

fn each_layer(grid: &Grid, out: &mut [f32], work: impl Fn((usize, [&mut [f32]; 3])) + Sync + Send) {
    let layers: Vec<_> = grid.layers_mut(out).into_iter().enumerate().collect();
    match grid.count() < FEW {
        true => layers.into_iter().for_each(work),
        false => layers.into_par_iter().for_each(work),
    }
}
