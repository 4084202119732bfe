//! From strains to displacements.

use super::sums::{FEW, dot, largest};
use super::{StrainAction, StrainChecks, StrainForm};
use crate::model::timoshenko_beam::{ChainLoads, PHI, W};
use crate::sum::Sum;
use peristat_vector::vectorised;
use std::ops::Range;

/// The displacements, block by block from the left end:
///
/// ```text
/// φ_{c+1} = φ_c + θ_c            w_{c+1} = w_c + g_c + h (φ_c + φ_{c+1})/2
/// ```
pub struct FromLeft<'a> {
    form: &'a StrainForm<'a>,
    loads: Option<&'a ChainLoads<'a>>,
    /// From the left.
    actions: Vec<StrainAction>,
    /// Cells that are done.
    done: usize,
    w: Sum,
    phi: Sum,
    shear: Sum,
    moment: Sum,
    /// Strains of the last 2 (m − 1) cells before the block, the block, room for m − 1 cells beyond the end.
    strain: [Vec<f64>; 2],
    /// Right-hand sides of the last m − 1 cells before the block, and the block.
    right: [Vec<f64>; 2],
    rows: [Vec<f64>; 2],
    force: [Vec<f64>; 2],
    width: Vec<f64>,
    energy: Sum,
    work: Sum,
    checks: StrainChecks,
}

impl<'a> FromLeft<'a> {
    /// Starts at the left end with the displacements (w, φ) of the first point. `actions` come on top of the loads.
    pub fn new(
        form: &'a StrainForm<'a>,
        loads: Option<&'a ChainLoads<'a>>,
        actions: &[StrainAction],
        start: [f64; 2],
    ) -> Self {
        let mut actions = actions.to_vec();
        actions.sort_by_key(|action| action.point);
        let back = form.reach() - 1;
        let block = form.block();
        let room = |more: usize| [vec![0.0; block + more], vec![0.0; block + more]];
        let [w, phi] = start.map(Sum::of);
        Self {
            form,
            loads,
            actions,
            done: 0,
            w,
            phi,
            shear: Sum::default(),
            moment: Sum::default(),
            strain: room(3 * back),
            right: room(back),
            rows: room(back),
            force: room(0),
            width: vec![0.0; block],
            energy: Sum::default(),
            work: Sum::default(),
            checks: StrainChecks::default(),
        }
    }

    /// Takes the strains `(θ, g)` of the next cells, one to [`STRAIN_BLOCK`](super::STRAIN_BLOCK) of them, in the order of the matrix, and
    /// writes the displacements of their left points.
    pub fn sweep(&mut self, v: &[f64], [w, phi]: [&mut [f64]; 2]) {
        let (count, back) = (w.len(), self.form.reach() - 1);
        let start = self.done;
        for (k, [theta, g]) in v.as_chunks::<2>().0.iter().rev().enumerate() {
            (self.strain[0][2 * back + k], self.strain[1][2 * back + k]) = (*theta, *g);
        }
        self.load(start, count);
        self.form.widths(start, &mut self.width[..count]);
        while self.done < start + count {
            self.act(self.done, self.done - start);
            let next = self.actions.iter().map(|a| a.point).find(|&p| p > self.done);
            let to = next.filter(|&p| p < start + count).unwrap_or(start + count);
            let cells = self.done - start..to - start;
            vectorised(
                #[inline(always)]
                || self.cells(cells.clone(), &mut w[cells.clone()], &mut phi[cells.clone()]),
            );
            self.done = to;
        }
        self.measure(w, phi);
        self.check(start, self.done.saturating_sub(back));
        self.shift(count);
    }

    /// Takes the last point and returns its displacements and the checks.
    pub fn finish(mut self) -> ([f64; 2], StrainChecks) {
        let (cells, back) = (self.form.cells(), self.form.reach() - 1);
        self.load(cells, 1);
        self.act(cells, 0);
        let left_over = [(&self.shear, self.force[W][0]), (&self.moment, self.force[PHI][0])];
        self.checks.closure = left_over.map(|(sum, load)| sum.with(-load));
        let last = [self.w.total(), self.phi.total()];
        self.measure(&[last[0]], &[last[1]]);
        // Nothing is strained beyond the end.
        self.strain.iter_mut().for_each(|s| s[2 * back..].fill(0.0));
        self.check(cells, cells);
        self.checks.energy = 0.5 * self.energy.total();
        self.checks.work = 0.5 * self.work.total();
        (last, self.checks)
    }

    fn load(&mut self, first: usize, count: usize) {
        if let Some(loads) = self.loads.filter(|loads| !loads.is_empty()) {
            let [force, couple] = &mut self.force;
            self.form.forces(loads, first, [&mut force[..count], &mut couple[..count]]);
        }
    }

    /// Takes the actions on a point, and with them its loads, of which place `at` holds the forces: section forces fall by
    /// them, and they do work.
    fn act(&mut self, point: usize, at: usize) {
        for action in self.actions.iter().filter(|a| a.point == point) {
            let component = action.component;
            let (sum, u) =
                if component == W { (&mut self.shear, self.w) } else { (&mut self.moment, self.phi) };
            let load = std::mem::take(&mut self.force[component][at]);
            sum.add(-load);
            sum.join(-action.value);
            self.work.add(action.value.with(load) * u.total());
        }
    }

    /// Goes over cells of the block; actions are done.
    #[inline(always)]
    fn cells(&mut self, cells: Range<usize>, w_out: &mut [f64], phi_out: &mut [f64]) {
        let back = self.form.reach() - 1;
        let (mut w, mut phi, mut shear, mut moment) = (self.w, self.phi, self.shear, self.moment);
        let shifted = |by: usize| cells.start + by..cells.end + by;
        let [theta, g] = [0, 1].map(|p| &self.strain[p][shifted(2 * back)]);
        let [force, couple] = [0, 1].map(|p| &self.force[p][cells.clone()]);
        let width = &self.width[cells.clone()];
        let [moments, shears] = &mut self.right;
        let (moments, shears) = (&mut moments[shifted(back)], &mut shears[shifted(back)]);
        for start in (0..width.len()).step_by(FEW) {
            let few = start..(start + FEW).min(width.len());
            let (mut p, mut d, mut q, mut m, mut arm) = (0.0, 0.0, 0.0, 0.0, 0.0);
            let (turn, base) = (phi.total(), shear.total());
            for k in few {
                let (h, half) = (width[k], 0.5 * width[k]);
                phi_out[k] = phi.with(p);
                w_out[k] = w.with(d + arm * turn);
                q -= force[k];
                m -= couple[k];
                moments[k] = moment.with(m - (half * q + (arm + half) * base));
                shears[k] = shear.with(q);
                d += g[k] + h * (p + 0.5 * theta[k]);
                p += theta[k];
                m -= q * h;
                arm += h;
            }
            w.add(d + arm * turn);
            phi.add(p);
            moment.add(m - arm * base);
            shear.add(q);
        }
        (self.w, self.phi, self.shear, self.moment) = (w, phi, shear, moment);
    }

    /// Work of the loads on the points of a block, and largest displacements.
    fn measure(&mut self, w: &[f64], phi: &[f64]) {
        let count = w.len();
        vectorised(
            #[inline(always)]
            || {
                if self.loads.is_some() {
                    self.work.add(dot(w, &self.force[W][..count]));
                    self.work.add(dot(phi, &self.force[PHI][..count]));
                }
                let most = &mut self.checks.largest;
                *most = [most[W].max(largest(w)), most[PHI].max(largest(phi))];
            },
        );
    }

    /// Compares the rows of cells: from m − 1 before the start of a block, which now have all they couple with, to `end`.
    fn check(&mut self, block: usize, end: usize) {
        let back = self.form.reach() - 1;
        let mut start = block.saturating_sub(back);
        for rows in self.form.pieces(start, end.saturating_sub(start)) {
            self.check_rows(start, rows, start + back - block);
            start += rows;
        }
    }

    /// Compares some rows; what they couple with begins at place `skip` among the strains.
    fn check_rows(&mut self, start: usize, rows: usize, skip: usize) {
        let (end, back) = (start + rows, self.form.reach() - 1);
        let [r_0, r_1] = &mut self.rows;
        let v = [0, 1].map(|p| &self.strain[p][skip..skip + rows + 2 * back]);
        let diagonal = self.form.product(start, end, v, [&mut r_0[..rows], &mut r_1[..rows]]);
        let v = [0, 1].map(|p| &self.strain[p][skip + back..][..rows]);
        let right = [0, 1].map(|p| &self.right[p][skip..][..rows]);
        vectorised(
            #[inline(always)]
            || {
                let rows = self.rows.each_mut().map(|r| &mut r[..rows]);
                self.energy.add(self.checks.take(&diagonal, rows, right, v));
            },
        );
    }

    /// Keeps what the next block needs of this one.
    fn shift(&mut self, count: usize) {
        let back = self.form.reach() - 1;
        self.strain.iter_mut().for_each(|s| s.copy_within(count..count + 2 * back, 0));
        self.right.iter_mut().for_each(|r| r.copy_within(count..count + back, 0));
    }
}
