//! One level of a cycle.

use super::Planes;
use super::border::Border;
use super::build::{self, WHOLE};
use super::cells::{Cells, SOLID};
use super::followers::Followers;
use super::grid::Grid;
use super::kernel::{Bonds, Finish, LayerSweep, TILE};
use super::stencil::Stencil;
use crate::bonds::Mat;
use crate::system::inverse_of;
use pulp::Arch;
use rayon::prelude::*;
use std::array::from_fn;

/// Points below which threads cost more than they bring.
const FEW: usize = 4096;

/// What is done about the bonds that points beside faces lack.
#[derive(Clone, Debug)]
pub(super) enum Faces {
    /// Nothing.
    Bare,
    /// Their other bonds are stiffer.
    Stiffer,
    /// Bonds end on the border.
    Border(Border),
}

/// What points of a kind have, in 32 bits.
#[derive(Clone, Copy, Debug)]
struct Block {
    stiffness: Mat32,
    inverse: Mat32,
    free: [f32; 3],
}

type Mat32 = [[f32; 3]; 3];

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
    of: Vec<u32>,
    table: Vec<Block>,
    /// Per place: `1/s`.
    pub(super) inverse_scale: Vec<f32>,
    /// Entries of vectors that rest, of points.
    held: Vec<u32>,
    border: Option<Border>,
    followers: Followers,
}

impl CubicLevel {
    pub(super) fn new(cells: Cells, stencil: Stencil, faces: Faces, followers: Followers) -> Self {
        let blocks = build::blocks(&cells, &stencil, !matches!(faces, Faces::Stiffer));
        let border = if let Faces::Border(border) = faces { Some(border) } else { None };
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
        Self { cells, stencil, bonds, of: blocks.of, table, inverse_scale, held, border, followers }
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
        self.on_border(v, out, |block, f| [0, 1, 2].map(|c| block.free[c] * f[c]));
        self.hand_over(out);
    }

    /// Writes `b − Â v` over `out`.
    pub fn residual(&self, b: &[f32], v: &[f32], out: &mut [f32]) {
        self.sweep(v, out, &Residual { level: self, v: self.planes(v), b: self.planes(b) });
        self.on_border(v, out, |block, f| [0, 1, 2].map(|c| -block.free[c] * f[c]));
        self.hand_over(out);
    }

    /// Writes `v + keep (v − previous) + scale D̂⁻¹ (b − Â v)` over `previous`.
    pub fn relax(&self, [keep, scale]: [f64; 2], b: &[f32], v: &[f32], previous: &mut [f32]) {
        let step = [keep as f32, scale as f32];
        let moved =
            self.followers.entries().map(|k| v[k] + step[0] * (v[k] - previous[k])).collect::<Vec<_>>();
        self.sweep(v, previous, &Relax { level: self, v: self.planes(v), b: self.planes(b), step });
        self.on_border(v, previous, |block, f| {
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
                    let sum: f32 = (0..3).map(|d| inverse[c][d] * r[d][place]).sum();
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

    /// Adds what `part` makes of the forces of the border.
    fn on_border(&self, v: &[f32], out: &mut [f32], part: impl Fn(&Block, [f32; 3]) -> [f32; 3]) {
        let grid = self.grid();
        if let Some(border) = &self.border {
            border.for_each_force(grid, v, |place, force| {
                let part = part(&self.table[self.of[place] as usize], force);
                (0..3).for_each(|c| out[c * grid.len() + place] += part[c]);
            });
        }
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

    /// The block that all points of a tile have.
    #[inline(always)]
    fn whole(&self, at: usize, width: usize) -> Option<&Block> {
        let is_whole = self.of[at..at + width].iter().fold(true, |all, number| all & (*number == WHOLE));
        is_whole.then(|| &self.table[WHOLE as usize])
    }

    /// `Â v` at some points, from the pulls of their bonds.
    #[inline(always)]
    fn forces(&self, at: usize, width: usize, v: Planes<'_>, pulls: &Pulls) -> Pulls {
        let own: [&[f32]; 3] = from_fn(|c| &v[c][at..at + width]);
        let mut forces = [[0.0; TILE]; 3];
        match self.whole(at, width) {
            // By symmetry its other entries are zero.
            Some(block) => {
                for c in 0..3 {
                    for k in 0..width {
                        forces[c][k] = block.stiffness[c][c] * own[c][k] - pulls[c][k];
                    }
                }
            }
            None => {
                for k in 0..width {
                    let Block { stiffness, free, .. } = &self.table[self.of[at + k] as usize];
                    for c in 0..3 {
                        let sum: f32 = (0..3).map(|d| stiffness[c][d] * own[d][k]).sum();
                        forces[c][k] = free[c] * (sum - pulls[c][k]);
                    }
                }
            }
        }
        forces
    }

    /// `b − Â v` at some points.
    #[inline(always)]
    fn residuals(&self, at: usize, width: usize, [b, v]: [Planes<'_>; 2], pulls: &Pulls) -> Pulls {
        let mut r = self.forces(at, width, v, pulls);
        for c in 0..3 {
            let b = &b[c][at..at + width];
            r[c].iter_mut().zip(b).for_each(|(r, b)| *r = b - *r);
        }
        r
    }
}

type Pulls = [[f32; TILE]; 3];

struct Apply<'a> {
    level: &'a CubicLevel,
    v: Planes<'a>,
}

impl Finish for Apply<'_> {
    #[inline(always)]
    fn finish(&self, at: usize, pulls: &Pulls, out: [&mut [f32]; 3]) {
        let width = out[0].len();
        let forces = self.level.forces(at, width, self.v, pulls);
        out.into_iter().zip(&forces).for_each(|(out, f)| out.copy_from_slice(&f[..width]));
    }
}

struct Residual<'a> {
    level: &'a CubicLevel,
    v: Planes<'a>,
    b: Planes<'a>,
}

impl Finish for Residual<'_> {
    #[inline(always)]
    fn finish(&self, at: usize, pulls: &Pulls, out: [&mut [f32]; 3]) {
        let width = out[0].len();
        let r = self.level.residuals(at, width, [self.b, self.v], pulls);
        out.into_iter().zip(&r).for_each(|(out, r)| out.copy_from_slice(&r[..width]));
    }
}

struct Relax<'a> {
    level: &'a CubicLevel,
    v: Planes<'a>,
    b: Planes<'a>,
    step: [f32; 2],
}

impl Finish for Relax<'_> {
    #[inline(always)]
    fn finish(&self, at: usize, pulls: &Pulls, mut out: [&mut [f32]; 3]) {
        let (width, [keep, scale]) = (out[0].len(), self.step);
        let r = self.level.residuals(at, width, [self.b, self.v], pulls);
        for (c, out) in out.iter_mut().enumerate() {
            let v = &self.v[c][at..at + width];
            out.iter_mut().zip(v).for_each(|(out, v)| *out = v + keep * (v - *out));
        }
        match self.level.whole(at, width) {
            Some(block) => {
                for (c, out) in out.iter_mut().enumerate() {
                    let factor = scale * block.inverse[c][c];
                    out.iter_mut().zip(&r[c]).for_each(|(out, r)| *out += factor * r);
                }
            }
            None => {
                for k in 0..width {
                    let inverse = &self.level.table[self.level.of[at + k] as usize].inverse;
                    for c in 0..3 {
                        let sum: f32 = (0..3).map(|d| inverse[c][d] * r[d][k]).sum();
                        out[c][k] += scale * sum;
                    }
                }
            }
        }
    }
}
