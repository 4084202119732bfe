//! Moment and shear force of the cantilever that is clamped at the first point, summed from the last.

use super::sums::{FEW, dot};
use super::{StrainAction, StrainForm};
use crate::model::timoshenko_beam::{ChainLoads, PHI, W};
use crate::sum::Sum;
use peristat_vector::vectorised;
use std::ops::Range;

/// What all forces on the points come to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resultant {
    /// Force, N, and moment about the first point, N m.
    pub sum: [f64; 2],
    /// Sums of the magnitudes of what went into them.
    pub size: [f64; 2],
}

/// The right-hand side of the strain form, block by block from the right end:
///
/// ```text
/// Q_c = Q_{c+1} + F_{c+1}        M_c = M_{c+1} + C_{c+1} + Q_{c+1} h_{c+1}/2 + Q_c h_c/2
/// ```
pub struct FromRight<'a> {
    form: &'a StrainForm<'a>,
    loads: Option<&'a ChainLoads<'a>>,
    /// From the right.
    actions: Vec<StrainAction>,
    /// Cells that are done lie right of this one.
    end: usize,
    shear: Sum,
    moment: Sum,
    size: [f64; 2],
    force: Vec<f64>,
    couple: Vec<f64>,
    width: Vec<f64>,
    /// Magnitudes of the forces.
    absolute: Vec<f64>,
    /// Distances of the points from the first one.
    arms: Vec<f64>,
    one: Vec<f64>,
}

impl<'a> FromRight<'a> {
    /// Starts at the right end. `actions` come on top of the loads.
    pub fn new(
        form: &'a StrainForm<'a>,
        loads: Option<&'a ChainLoads<'a>>,
        actions: &[StrainAction],
    ) -> Self {
        let mut actions = actions.to_vec();
        actions.sort_by_key(|action| std::cmp::Reverse(action.point));
        let block = form.block();
        let room = || vec![0.0; block];
        Self {
            form,
            loads,
            actions,
            end: form.cells(),
            shear: Sum::default(),
            moment: Sum::default(),
            size: [0.0; 2],
            force: room(),
            couple: room(),
            width: room(),
            absolute: room(),
            arms: room(),
            one: vec![1.0; block],
        }
    }

    /// Writes `(M_c, Q_c)` of the next cells on the left, one to [`STRAIN_BLOCK`](super::STRAIN_BLOCK) of them, in the order of the matrix.
    pub fn sweep(&mut self, r: &mut [f64]) {
        let count = r.len() / 2;
        let start = self.end - count;
        self.load(start + 1, count);
        self.form.widths(start, &mut self.width[..count]);
        let mut rest = r;
        while self.end > start {
            self.act(self.end, self.end - start - 1);
            // Reactions inside the block go into the running sums at their points, where nothing is lost of them.
            let next = self.actions.iter().map(|a| a.point).find(|&p| p < self.end);
            let to = next.filter(|&p| p > start).unwrap_or(start);
            let (part, after) = rest.split_at_mut(2 * (self.end - to));
            let cells = to - start..self.end - start;
            vectorised(
                #[inline(always)]
                || self.cells(cells.clone(), part),
            );
            (rest, self.end) = (after, to);
        }
    }

    /// Resultant of all loads and actions, those on the first point included.
    pub fn finish(mut self) -> Resultant {
        self.load(0, 1);
        self.act(0, 0);
        self.moment.add(self.couple[0]);
        self.shear.add(self.force[0]);
        Resultant { sum: [self.shear.total(), self.moment.total()], size: self.size }
    }

    /// Forces of the loads on points.
    fn load(&mut self, first: usize, count: usize) {
        let Some(loads) = self.loads.filter(|loads| !loads.is_empty()) else { return };
        let (force, couple) = (&mut self.force[..count], &mut self.couple[..count]);
        self.form.forces(loads, first, [&mut *force, &mut *couple]);
        let (arms, absolute) = (&mut self.arms[..count], &mut self.absolute[..count]);
        let start = self.form.distance(first);
        match &self.form.chain().line().stations {
            None => {
                let h = self.form.chain().spacing;
                arms.iter_mut().enumerate().for_each(|(k, arm)| *arm = start + k as f64 * h);
            }
            Some(_) => arms.iter_mut().enumerate().for_each(|(k, arm)| *arm = self.form.distance(first + k)),
        }
        absolute.iter_mut().zip(&*force).for_each(|(a, f)| *a = f.abs());
        self.size[0] += dot(absolute, &self.one[..count]);
        self.size[1] += dot(absolute, arms);
        self.size[1] += couple.iter().map(|c| c.abs()).sum::<f64>();
    }

    /// Adds the actions on a point, and with them its loads, of which place `at` holds the forces: a reaction cancels a load
    /// on its own point to the last bit.
    fn act(&mut self, point: usize, at: usize) {
        for action in self.actions.iter().filter(|a| a.point == point) {
            let size = action.value.total().abs();
            if action.component == W {
                self.shear.add(std::mem::take(&mut self.force[at]));
                self.shear.join(action.value);
                self.size[W] += size;
                self.size[PHI] += size * self.form.distance(point);
            } else {
                self.moment.add(std::mem::take(&mut self.couple[at]));
                self.moment.join(action.value);
                self.size[PHI] += size;
            }
        }
    }

    /// Goes over cells of the block, from the right; actions are done.
    #[inline(always)]
    fn cells(&mut self, cells: Range<usize>, r: &mut [f64]) {
        let (mut shear, mut moment) = (self.shear, self.moment);
        let (force, couple) = (&self.force[cells.clone()], &self.couple[cells.clone()]);
        let width = &self.width[cells];
        let parts =
            force.rchunks(FEW).zip(couple.rchunks(FEW)).zip(width.rchunks(FEW)).zip(r.chunks_mut(2 * FEW));
        for (((force, couple), width), r) in parts {
            let (mut q, mut m, mut arm) = (0.0, 0.0, 0.0);
            let base = shear.total();
            for (((f, c), h), r) in force.iter().zip(couple).zip(width).rev().zip(r.as_chunks_mut::<2>().0) {
                q += f;
                m += c;
                let half = 0.5 * h;
                *r = [moment.with(m + (half * q + (arm + half) * base)), shear.with(q)];
                m += q * h;
                arm += h;
            }
            moment.add(m + arm * base);
            shear.add(q);
        }
        (self.shear, self.moment) = (shear, moment);
    }
}
