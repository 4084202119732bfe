//! Interpolation between a plate and the one of cells twice as large.
//!
//! Points of the coarse plate are points of the fine one, every second along both axes. Between two of them, A and B,
//! `φ = (φ_A + φ_B)/2` and `w = (w_A + w_B)/2 − (x_B − x_A)·(φ_B − φ_A)/8`, exact for every quadratic w with its gradient: a coarse
//! plate that bends without shear makes a fine one that does so, where linear interpolation of w would shear it with a stiffness
//! that grows with S.

use super::{PHI_X, PHI_Y, PlateBending, PlateError, PlateNodes, W};
use crate::body::Interpolation;
use peristat_vector::Real;
use rayon::prelude::*;
use std::sync::Arc;

/// No point.
const NONE: u32 = u32::MAX;
/// Points that one thread takes at a time.
const PART: usize = 4096;

impl PlateBending {
    /// The plate of cells twice as large, which has a cell wherever this one has any of the four in it.
    ///
    /// # Errors
    /// [`PlateError`].
    pub fn coarser(&self) -> Result<Self, PlateError> {
        let coarse = PlateNodes::new(Arc::new(self.nodes().cells().coarser()))?;
        let sections = self.sections().coarser(self.nodes(), &coarse, &self.parameters().section);
        Self::on(coarse, *self.parameters(), sections)
    }
}

/// Interpolation to the points of a plate from those of its [`coarser`](PlateBending::coarser) one.
#[derive(Clone, Debug)]
pub struct PlateTransfer {
    /// Spacing of the coarse plate, m.
    spacing: f64,
    /// Coarse points around every fine one: lower left, lower right, upper left, upper right; the same where it lies on a line
    /// between two, or on one.
    parents: Vec<[u32; 4]>,
    /// Fine points around every coarse one, row by row.
    children: Vec<[u32; 9]>,
}

impl PlateTransfer {
    /// Between the points of a plate and of its coarser one.
    pub fn new(fine: &PlateNodes, coarse: &PlateNodes) -> Self {
        let number = |nodes: &PlateNodes, node: [i32; 2]| nodes.number(node).map_or(NONE, |p| p as u32);
        let parents = |point: usize| {
            let [i, j] = fine.node(point);
            let [left, right] = [i.div_euclid(2), (i + 1).div_euclid(2)];
            let [lower, upper] = [j.div_euclid(2), (j + 1).div_euclid(2)];
            [[left, lower], [right, lower], [left, upper], [right, upper]].map(|node| number(coarse, node))
        };
        let children = |point: usize| {
            let [i, j] = coarse.node(point);
            std::array::from_fn(|k| number(fine, [2 * i + k as i32 % 3 - 1, 2 * j + k as i32 / 3 - 1]))
        };
        Self {
            spacing: coarse.spacing(),
            parents: (0..fine.points()).map(parents).collect(),
            children: (0..coarse.points()).map(children).collect(),
        }
    }

    /// Coarse points around a fine one and their shares in its rotations.
    pub fn shares(&self, point: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.parents[point].iter().map(|&parent| (parent as usize, 0.25))
    }

    /// What an unknown of a fine point is, as a sum of unknowns of coarse points: components, points and coefficients.
    pub fn row(&self, component: usize, point: usize) -> Vec<(usize, usize, f64)> {
        /// How the rotations of the parents bend the deflection between them.
        const BOW: [[f64; 2]; 4] = [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]];
        let mut row: Vec<(usize, usize, f64)> = Vec::with_capacity(12);
        let mut add = |component: usize, point: usize, share: f64| match row
            .iter_mut()
            .find(|term| (term.0, term.1) == (component, point))
        {
            Some(term) => term.2 += share,
            None => row.push((component, point, share)),
        };
        self.shares(point).for_each(|(parent, share)| add(component, parent, share));
        if component == W {
            for (&parent, [x, y]) in self.parents[point].iter().zip(BOW) {
                add(PHI_X, parent as usize, x * self.spacing / 16.0);
                add(PHI_Y, parent as usize, y * self.spacing / 16.0);
            }
        }
        row.retain(|term| term.2 != 0.0);
        row
    }

    /// `[w, φ_x, φ_y]` of a fine point.
    #[inline(always)]
    fn at<R: Real>(&self, parents: &[u32; 4], coarse: &[R]) -> [f64; 3] {
        let n = self.children.len();
        let of = |c: usize| parents.map(|p| -> f64 { coarse[c * n + p as usize].into() });
        let mean = |v: [f64; 4]| 0.25 * (v[0] + v[1] + v[2] + v[3]);
        let (x, y) = (of(PHI_X), of(PHI_Y));
        let bow = (x[1] - x[0]) + (x[3] - x[2]) + (y[2] - y[0]) + (y[3] - y[1]);
        [mean(of(W)) - self.spacing / 16.0 * bow, mean(x), mean(y)]
    }

    /// What a coarse point collects.
    #[inline(always)]
    fn collected<R: Real>(&self, children: &[u32; 9], fine: &[R]) -> [f64; 3] {
        let n = self.parents.len();
        let mut sum = [0.0; 3];
        for (k, &child) in children.iter().enumerate().filter(|child| *child.1 != NONE) {
            let [a, b] = [(k % 3) as f64 - 1.0, (k / 3) as f64 - 1.0];
            let [along, across] = [1.0 - 0.5 * a.abs(), 1.0 - 0.5 * b.abs()];
            let [w, x, y] = [W, PHI_X, PHI_Y].map(|c| -> f64 { fine[c * n + child as usize].into() });
            let bow = self.spacing / 8.0 * w;
            sum[W] += along * across * w;
            sum[PHI_X] += along * across * x + a * across * bow;
            sum[PHI_Y] += along * across * y + b * along * bow;
        }
        sum
    }
}

impl<R: Real> Interpolation<R> for PlateTransfer {
    fn restrict_all(&self, fine: &[R], coarse: &mut [R]) {
        let own = self.children.par_chunks(PART);
        let parts = planes(coarse, self.children.len());
        own.zip(parts).for_each(|(children, [w, x, y])| {
            for (k, children) in children.iter().enumerate() {
                [w[k], x[k], y[k]] = self.collected(children, fine).map(R::of);
            }
        });
    }

    fn prolong_all(&self, coarse: &[R], fine: &mut [R]) {
        let own = self.parents.par_chunks(PART);
        let parts = planes(fine, self.parents.len());
        own.zip(parts).for_each(|(parents, [w, x, y])| {
            for (k, parents) in parents.iter().enumerate() {
                let [dw, dx, dy] = self.at(parents, coarse).map(R::of);
                (w[k], x[k], y[k]) = (w[k] + dw, x[k] + dx, y[k] + dy);
            }
        });
    }
}

/// The three planes of a vector, part by part.
fn planes<R: Real>(vector: &mut [R], points: usize) -> impl IndexedParallelIterator<Item = [&mut [R]; 3]> {
    let (w, rest) = vector.split_at_mut(points);
    let (x, y) = rest.split_at_mut(points);
    let parts = w.par_chunks_mut(PART).zip(x.par_chunks_mut(PART)).zip(y.par_chunks_mut(PART));
    parts.map(|((w, x), y)| [w, x, y])
}
