//! One level of a cycle.

use super::Planes;
use super::border::Border;
use super::build::{self, Blocks};
use super::cells::{Cells, SOLID};
use super::finish::{Apply, Relax, Residual};
use super::followers::Followers;
use super::gaps::Gaps;
use super::grid::Grid;
use super::kernel::{Bonds, Finish, LayerSweep};
use super::stencil::Stencil;
use crate::bonds::Mat;
use crate::system::inverse_of;
use pulp::Arch;
use rayon::prelude::*;
use std::array::from_fn;

/// Points below which threads cost more than they bring.
const FEW: usize = 4096;

/// What points of a kind have, in 32 bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    pub(super) stiffness: Mat32,
    pub(super) inverse: Mat32,
    pub(super) free: [f32; 3],
}

pub(super) type Mat32 = [[f32; 3]; 3];

/// A row of a block times a vector. Written out, as what iterators call need not be inlined into kernels for wide registers.
#[inline(always)]
pub(super) fn row_times(row: &[f32; 3], v: [f32; 3]) -> f32 {
    row[0] * v[0] + row[1] * v[1] + row[2] * v[2]
}

/// The stiffness `Â` of a level, its diagonal blocks, and smoothing with their inverses.
///
/// Vectors are those of the scaled unknowns `v = s u`, in three planes of the [`size`](Self::size) that the level tells, with zeros
/// where no points are. Where the body goes on behind planes of symmetry they hold the images, too.
#[derive(Clone, Debug)]
pub struct CubicLevel {
    pub(super) cells: Cells,
    pub(super) stencil: Stencil,
    bonds: Bonds,
    /// Per place: number into the table.
    pub(super) of: Vec<u32>,
    pub(super) table: Vec<Block>,
    /// Per place: `1/s`.
    pub(super) inverse_scale: Vec<f32>,
    /// Entries of vectors that rest, of points.
    held: Vec<u32>,
    border: Option<Border>,
    followers: Followers,
    /// Bonds that are not there.
    pub(super) gaps: Gaps,
}

impl CubicLevel {
    /// A level whose points beside faces have stiffer bonds.
    pub(super) fn stiffened(cells: Cells, stencil: Stencil) -> Self {
        let blocks = build::blocks(&cells, &stencil, false);
        Self::of_blocks(cells, stencil, blocks)
    }

    /// A level whose bonds are as they are.
    pub(super) fn bare(cells: Cells, stencil: Stencil) -> Self {
        let blocks = build::blocks(&cells, &stencil, true);
        Self::of_blocks(cells, stencil, blocks)
    }

    /// Adds bonds on the border, and components that follow others.
    pub(super) fn with(self, border: Option<Border>, followers: Followers) -> Self {
        Self { border, followers, ..self }
    }

    /// Takes bonds away.
    pub(super) fn without(self, gaps: Gaps) -> Self {
        Self { gaps, ..self }
    }

    fn of_blocks(cells: Cells, stencil: Stencil, blocks: Blocks) -> Self {
        let to_32 = |mat: &Mat<3, 3>| mat.map(|row| row.map(|x| x as f32));
        let table = blocks.table.iter().map(|block| {
            let rests = [0, 1, 2].map(|c| block.free[c] == 0.0 || block.follows[c]);
            let mut inverse = inverse_of(block.smoother, &rests).unwrap_or([[0.0; 3]; 3]);
            // What is added there tells the force on what follows.
            (0..3).filter(|&c| block.follows[c]).for_each(|c| inverse[c][c] = 1.0);
            Block {
                stiffness: to_32(&block.stiffness),
                inverse: to_32(&inverse),
                free: block.free.map(|x| x as f32),
            }
        });
        let table = table.collect();
        let scale = |number: &u32| blocks.table[*number as usize].inverse_scale as f32;
        let mut inverse_scale: Vec<f32> = blocks.of.iter().map(scale).collect();
        cells.grid.mirror(&mut inverse_scale, |scale, _| scale);
        let bonds = Bonds::new(&stencil, &cells.grid);
        let mut held = Vec::new();
        cells.grid.for_each(|_, place| {
            let rests = |c: &usize| cells.state[place] & SOLID != 0 && cells.state[place] & 1 << c != 0;
            held.extend((0..3).filter(rests).map(|c| (c * cells.grid.len() + place) as u32));
        });
        Self {
            cells,
            stencil,
            bonds,
            of: blocks.of,
            table,
            inverse_scale,
            held,
            border: None,
            followers: Followers::default(),
            gaps: Gaps::default(),
        }
    }

    /// Length of its vectors.
    pub fn size(&self) -> usize {
        3 * self.grid().len()
    }

    /// Number of cells of its box.
    pub fn count(&self) -> usize {
        self.grid().count()
    }

    /// Number of its points.
    pub fn points(&self) -> usize {
        let mut points = 0;
        self.grid().for_each(|_, place| points += usize::from(self.cells.is_solid(place)));
        points
    }

    pub(super) fn grid(&self) -> &Grid {
        &self.cells.grid
    }

    /// `D̂` of a point and what of it is free.
    pub(super) fn block(&self, place: usize) -> (Mat32, [f32; 3]) {
        let block = &self.table[self.of[place] as usize];
        (block.stiffness, block.free)
    }

    /// `Σ a·b` over the points.
    pub fn dot(&self, a: &[f32], b: &[f32]) -> f64 {
        let grid = self.grid();
        let mut sum = 0.0;
        for (a, b) in a.chunks_exact(grid.len()).zip(b.chunks_exact(grid.len())) {
            for layer in 0..grid.cells[2] {
                for row in 0..grid.cells[1] {
                    let first = grid.row(row, layer);
                    let ends = a[first..][..grid.cells[0]].iter().zip(&b[first..]);
                    sum += ends.map(|(a, b)| f64::from(a * b)).sum::<f64>();
                }
            }
        }
        sum
    }

    /// Writes `Â v` over `out`.
    pub fn apply(&self, v: &[f32], out: &mut [f32]) {
        self.sweep(v, out, &Apply { level: self, v: self.planes(v) });
        self.correct(v, out, |block, f| [0, 1, 2].map(|c| block.free[c] * f[c]));
        self.hand_over(out);
    }

    /// Writes `b − Â v` over `out`.
    pub fn residual(&self, b: &[f32], v: &[f32], out: &mut [f32]) {
        self.sweep(v, out, &Residual { level: self, v: self.planes(v), b: self.planes(b) });
        self.correct(v, out, |block, f| [0, 1, 2].map(|c| -block.free[c] * f[c]));
        self.hand_over(out);
    }

    /// Writes `v + keep (v − previous) + scale D̂⁻¹ (b − Â v)` over `previous`.
    pub fn relax(&self, [keep, scale]: [f64; 2], b: &[f32], v: &[f32], previous: &mut [f32]) {
        let step = [keep as f32, scale as f32];
        let moved =
            self.followers.entries().map(|k| v[k] + step[0] * (v[k] - previous[k])).collect::<Vec<_>>();
        self.sweep(v, previous, &Relax { level: self, v: self.planes(v), b: self.planes(b), step });
        self.correct(v, previous, |block, f| {
            [0, 1, 2].map(|c| -step[1] * (0..3).map(|d| block.inverse[c][d] * f[d]).sum::<f32>())
        });
        let len = self.grid().len();
        self.followers.for_each_change(previous, &moved, |v, leader, change| {
            let (c, place) = (leader / len, leader % len);
            let inverse = &self.table[self.of[place] as usize].inverse;
            (0..3).for_each(|row| v[row * len + place] += inverse[row][c] * change);
        });
        self.complete(previous);
    }

    /// `v += scale D̂⁻¹ r`
    pub fn smooth(&self, scale: f64, r: &[f32], v: &mut [f32]) {
        let (r, scale) = (self.planes(r), scale as f32);
        let work = |(layer, out): (usize, [&mut [f32]; 3])| {
            for (k, place) in self.grid().layer(layer).enumerate() {
                let inverse = &self.table[self.of[place] as usize].inverse;
                for c in 0..3 {
                    let sum = row_times(&inverse[c], [r[0][place], r[1][place], r[2][place]]);
                    out[c][k] += scale * sum;
                }
            }
        };
        self.each_layer(v, work);
        self.complete(v);
    }

    /// Lays at rest what rests, lets follow what follows others, and completes the images.
    pub(super) fn complete(&self, v: &mut [f32]) {
        self.held.iter().for_each(|&entry| v[entry as usize] = 0.0);
        self.followers.follow(v);
        self.grid().mirror_vector(v);
    }

    /// The same of forces: those on what follows others are handed over.
    pub(super) fn hand_over(&self, force: &mut [f32]) {
        self.held.iter().for_each(|&entry| force[entry as usize] = 0.0);
        self.followers.hand_over(force);
        self.grid().mirror_vector(force);
    }

    fn planes<'a>(&self, v: &'a [f32]) -> Planes<'a> {
        let len = self.grid().len();
        from_fn(|c| &v[c * len..][..len])
    }

    /// Hands the pulls on all points to `finish`, which writes `out`.
    fn sweep<F: Finish>(&self, v: &[f32], out: &mut [f32], finish: &F) {
        let v = self.planes(v);
        let work = |(layer, out): (usize, [&mut [f32]; 3])| {
            let places = self.grid().layer(layer);
            Arch::new().dispatch(LayerSweep { bonds: &self.bonds, v, places, out, finish });
        };
        self.each_layer(out, work);
    }

    /// Adds what `part` makes of the forces of the border, less those of bonds that are not there.
    fn correct(&self, v: &[f32], out: &mut [f32], part: impl Fn(&Block, [f32; 3]) -> [f32; 3]) {
        let grid = self.grid();
        if let Some(border) = &self.border {
            border.for_each_force(grid, v, |place, force| {
                let part = part(&self.table[self.of[place] as usize], force);
                (0..3).for_each(|c| out[c * grid.len() + place] += part[c]);
            });
        }
        self.gaps.for_each_force(grid.len(), (v, &self.inverse_scale), |place, force| {
            let part = part(&self.table[self.of[place] as usize], force);
            (0..3).for_each(|c| out[c * grid.len() + place] -= part[c]);
        });
    }

    /// Whether its eigenvalues are not those of coarser levels.
    pub fn is_unlike(&self) -> bool {
        self.border.is_some()
    }

    fn each_layer(&self, out: &mut [f32], work: impl Fn((usize, [&mut [f32]; 3])) + Sync + Send) {
        let layers: Vec<_> = self.grid().layers_mut(out).into_iter().enumerate().collect();
        match self.count() < FEW {
            true => layers.into_iter().for_each(work),
            false => layers.into_par_iter().for_each(work),
        }
    }
}
