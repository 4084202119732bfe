//! What is made of the pulls on a tile of points: products, residuals and steps of the smoother.

use super::Planes;
use super::build::WHOLE;
use super::kernel::{Finish, TILE};
use super::level::{Block, CubicLevel, row_times};
use std::array::from_fn;

impl CubicLevel {
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
                        let sum = row_times(&stiffness[c], [own[0][k], own[1][k], own[2][k]]);
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

pub(super) struct Apply<'a> {
    pub(super) level: &'a CubicLevel,
    pub(super) v: Planes<'a>,
}

impl Finish for Apply<'_> {
    #[inline(always)]
    fn finish(&self, at: usize, pulls: &Pulls, out: [&mut [f32]; 3]) {
        let width = out[0].len();
        let forces = self.level.forces(at, width, self.v, pulls);
        out.into_iter().zip(&forces).for_each(|(out, f)| out.copy_from_slice(&f[..width]));
    }
}

pub(super) struct Residual<'a> {
    pub(super) level: &'a CubicLevel,
    pub(super) v: Planes<'a>,
    pub(super) b: Planes<'a>,
}

impl Finish for Residual<'_> {
    #[inline(always)]
    fn finish(&self, at: usize, pulls: &Pulls, out: [&mut [f32]; 3]) {
        let width = out[0].len();
        let r = self.level.residuals(at, width, [self.b, self.v], pulls);
        out.into_iter().zip(&r).for_each(|(out, r)| out.copy_from_slice(&r[..width]));
    }
}

pub(super) struct Relax<'a> {
    pub(super) level: &'a CubicLevel,
    pub(super) v: Planes<'a>,
    pub(super) b: Planes<'a>,
    pub(super) step: [f32; 2],
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
                        let sum = row_times(&inverse[c], [r[0][k], r[1][k], r[2][k]]);
                        out[c][k] += scale * sum;
                    }
                }
            }
        }
    }
}
