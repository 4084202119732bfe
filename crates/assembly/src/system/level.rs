//! A system as one level of a multigrid cycle: its operator, a block diagonal stand-in for it, and smoothing steps that
//! use forces while they are at hand.

use super::System;
use super::in_precision::InPrecision;
use crate::bonds::Mat;
use crate::condition::Row;
use crate::stiffness::planes::for_each_stretch;
use crate::stiffness::{BlockRows, TakeForces};
use peristat_vector::vectorised;
use std::array::from_fn;

/// Inverse of unknowns that depend on others over the largest of all others: what it adds to them tells their residual, and its digits
/// are not to be lost in those of the unknowns, in whatever units these are.
const LAID_BARE: f64 = (1 << 20) as f64;

/// Points that are taken together, the most that a term hands over at once.
const STRETCH: usize = 64;

/// A system with the inverse of its diagonal blocks.
///
/// Its vectors hold, at unknowns that depend on others, what these make of them; only right-hand sides and residuals are
/// zero there.
///
/// Where the elements of all terms but the first, the bonds of a lattice, are few (overlays, springs), these are assembled: that is
/// good enough for a preconditioner. Those of solids, whose elements join dozens of points each, are evaluated one by one.
pub struct Level<'a, const D: usize, R = f64> {
    system: &'a System<D>,
    others: BlockRows<D, R>,
    /// Whether these are too many to be assembled.
    is_wide: bool,
    /// Inverse blocks in planes `[row · D + column][point]`, zero where a component is held, `at_slaves` where it depends on others.
    inverse: Vec<R>,
    /// What a step adds to an unknown that depends on others, per residual, and the inverse of this.
    at_slaves: [R; 2],
}

impl<'a, const D: usize, R: InPrecision> Level<'a, D, R> {
    /// Inverts the diagonal blocks.
    ///
    /// # Errors
    /// The first point whose block is singular: its bonds do not hold it.
    pub fn new(system: &'a System<D>) -> Result<Self, usize> {
        let (level, loose) = Self::with_loose(system);
        loose.map_or(Ok(level), Err)
    }

    /// The same for a coarse level, where points with a singular block stay at rest.
    pub fn coarse(system: &'a System<D>) -> Self {
        Self::with_loose(system).0
    }

    /// The level and the first point whose block is singular.
    fn with_loose(system: &'a System<D>) -> (Self, Option<usize>) {
        let others = &system.terms()[1..];
        let is_wide = others.iter().any(|term| term.joins_many());
        let others = BlockRows::new(system.points(), if is_wide { &[] } else { others });
        let (inverse, loose) = system.inverse_blocks();
        let largest = inverse.iter().fold(f64::MIN_POSITIVE, |largest, v| largest.max(v.abs()));
        let at_slaves = [LAID_BARE * largest, 1.0 / (LAID_BARE * largest)].map(R::of);
        let mut inverse: Vec<R> = inverse.into_iter().map(R::of).collect();
        for row in system.constraints.rows().iter().filter(|row| !row.masters.is_empty()) {
            let (point, c) = (row.unknown % system.points, row.unknown / system.points);
            inverse[(c * D + c) * system.points + point] = at_slaves[0];
        }
        (Self { system, others, is_wide, inverse, at_slaves }, loose)
    }

    /// Makes the stand-in of some unknowns that are free one number, `1/unit`: what a step adds there tells their residual.
    pub fn lay_bare(&mut self, unknowns: &[usize], unit: f64) {
        let n = self.system.points;
        for unknown in unknowns {
            let (point, c) = (unknown % n, unknown / n);
            for other in 0..D {
                self.inverse[(other * D + c) * n + point] = R::default();
                self.inverse[(c * D + other) * n + point] = R::default();
            }
            self.inverse[(c * D + c) * n + point] = R::of(unit);
        }
    }

    /// The system.
    pub fn system(&self) -> &System<D> {
        self.system
    }

    /// `x += scale M⁻¹ r`
    pub fn smooth(&self, scale: f64, r: &[R], x: &mut [R]) {
        for_each_stretch::<D, R>(x, STRETCH, |first, mut own| {
            let mut at = [[R::default(); STRETCH]; D];
            let width = own[0].len();
            (0..D)
                .for_each(|c| at[c][..width].copy_from_slice(&r[c * self.system.points + first..][..width]));
            vectorised(
                #[inline(always)]
                || self.add_inverse(first, R::of(scale), &at, own.each_mut().map(|own| &mut **own)),
            );
        });
        self.expand(x);
    }

    /// Writes what dependent unknowns are over them.
    pub fn expand(&self, x: &mut [R]) {
        if self.system.constraints.has_slaves() {
            self.system.constraints.expand(0.0, x);
        }
    }

    /// Writes `b − A x` over `r`.
    pub fn residual(&self, b: &[R], x: &[R], r: &mut [R]) {
        let fused = self.sweep(x, r, &|first, forces, own| {
            let at = vectorised(
                #[inline(always)]
                || self.residual_at(first, b, x, forces),
            );
            own.into_iter().zip(&at).for_each(|(own, r)| own.copy_from_slice(&r[..own.len()]));
        });
        if fused {
            self.system.constraints.restrict(r);
        } else {
            R::multiply(self.system, x, r);
            r.iter_mut().zip(b).for_each(|(r, b)| *r = *b - *r);
        }
    }

    /// Writes `x + keep (x − previous) + scale M⁻¹ (b − A x)` over `previous`.
    pub fn relax(&self, [keep, scale]: [f64; 2], b: &[R], x: &[R], previous: &mut [R], scratch: &mut [R]) {
        let n = self.system.points;
        let [keep, scale] = [keep, scale].map(R::of);
        let finish = |first: usize, r: &[[R; STRETCH]; D], mut own: [&mut [R]; D]| {
            for (c, own) in own.iter_mut().enumerate() {
                let x = &x[c * n + first..][..own.len()];
                own.iter_mut().zip(x).for_each(|(own, x)| *own = *x + keep * (*x - *own));
            }
            self.add_inverse(first, scale, r, own);
        };
        let slaves: Vec<&Row> = self.slaves().collect();
        let moved: Vec<R> =
            slaves.iter().map(|s| x[s.unknown] + keep * (x[s.unknown] - previous[s.unknown])).collect();
        let fused = self.sweep(x, previous, &|first, forces, mut own| {
            vectorised(
                #[inline(always)]
                || {
                    let own = own.each_mut().map(|own| &mut **own);
                    finish(first, &self.residual_at(first, b, x, forces), own);
                },
            );
        });
        if fused {
            // What was added to a slave tells its residual: that of its masters.
            for (slave, moved) in slaves.iter().zip(moved) {
                let residual = self.at_slaves[1] * (previous[slave.unknown] - moved);
                slave.masters.iter().for_each(|&(m, share)| {
                    let (point, column) = (m % n, m / n);
                    for row in 0..D {
                        previous[row * n + point] +=
                            self.inverse[(row * D + column) * n + point] * R::of(share) * residual;
                    }
                });
            }
        } else {
            self.residual(b, x, scratch);
            for_each_stretch::<D, R>(previous, STRETCH, |first, own| {
                let mut r = [[R::default(); STRETCH]; D];
                let width = own[0].len();
                (0..D).for_each(|c| r[c][..width].copy_from_slice(&scratch[c * n + first..][..width]));
                finish(first, &r, own);
            });
        }
        self.expand(previous);
    }

    /// Hands the forces of the first term to `take`, where those of all others are at hand.
    fn sweep(&self, x: &[R], out: &mut [R], take: TakeForces<'_, D, R>) -> bool {
        !self.is_wide && R::sweep(self.system.terms[0].as_ref(), x, out, take)
    }

    /// Rows of unknowns that depend on others.
    fn slaves(&self) -> impl Iterator<Item = &'a Row> {
        self.system.constraints.rows().iter().filter(|row| !row.masters.is_empty())
    }

    /// `b − A x` on a stretch of points, given the forces of the first term.
    #[inline(always)]
    fn residual_at(&self, first: usize, b: &[R], x: &[R], forces: [&[R]; D]) -> [[R; STRETCH]; D] {
        let (n, width) = (self.system.points, forces[0].len());
        let mut r = [[R::default(); STRETCH]; D];
        for c in 0..D {
            let b = &b[c * n + first..][..width];
            r[c].iter_mut().zip(b.iter().zip(forces[c])).for_each(|(r, (b, f))| *r = *b - *f);
        }
        self.others.subtract_product(first..first + width, x, &mut r);
        r
    }

    /// Adds `scale M⁻¹ r` on a stretch of points.
    #[inline(always)]
    fn add_inverse(&self, first: usize, scale: R, r: &[[R; STRETCH]; D], own: [&mut [R]; D]) {
        let n = self.system.points;
        for (row, own) in own.into_iter().enumerate() {
            for column in 0..D {
                let inverse = &self.inverse[(row * D + column) * n + first..][..own.len()];
                let entries = own.iter_mut().zip(inverse.iter().zip(&r[column]));
                entries.for_each(|(own, (inverse, r))| *own += scale * (*inverse * *r));
            }
        }
    }
}

impl<const D: usize> System<D> {
    /// Whether a level of it in numbers of 32 bits goes from point to point.
    pub fn sweeps_in_single(&self) -> bool {
        let [first, others @ ..] = self.terms() else { return false };
        first.sweeps_in_single() && !others.iter().any(|term| term.joins_many())
    }

    /// Diagonal blocks of the constrained stiffness, without what a master shares with its slaves.
    pub fn diagonal_blocks(&self) -> Vec<Mat<D, D>> {
        let mut blocks = vec![[[0.0; D]; D]; self.points];
        self.terms.iter().for_each(|t| t.add_diagonal(&mut blocks));
        let place = |unknown: usize| (unknown % self.points, unknown / self.points);
        for row in self.constraints.rows() {
            let (point, c) = place(row.unknown);
            let own = blocks[point][c][c];
            for &(master, share) in &row.masters {
                let (point, c) = place(master);
                blocks[point][c][c] += share * share * own;
            }
        }
        for row in self.constraints.rows() {
            let (point, c) = place(row.unknown);
            (0..D).for_each(|k| (blocks[point][c][k], blocks[point][k][c]) = (0.0, 0.0));
        }
        blocks
    }

    /// Their inverses on the components that are free, in planes, zero where a block is singular; the first such point.
    fn inverse_blocks(&self) -> (Vec<f64>, Option<usize>) {
        let n = self.points;
        let mut constrained = vec![[false; D]; n];
        self.constraints.rows().iter().for_each(|row| constrained[row.unknown % n][row.unknown / n] = true);
        let mut inverse = vec![0.0; D * D * n];
        let mut loose = None;
        let mut last = ([[0.0; D]; D], [[0.0; D]; D]);
        for (point, block) in self.diagonal_blocks().into_iter().enumerate() {
            // Inside a body all blocks are the same.
            if block != last.0 || constrained[point].contains(&true) {
                let inverse = inverse_of(block, &constrained[point]);
                loose = loose.or(inverse.is_none().then_some(point));
                last = (block, inverse.unwrap_or([[0.0; D]; D]));
            }
            for (k, value) in last.1.as_flattened().iter().enumerate() {
                inverse[k * n + point] = *value;
            }
        }
        (inverse, loose)
    }
}

/// Inverse of a symmetric positive definite block on the components that are not constrained, by elimination.
pub fn inverse_of<const D: usize>(block: Mat<D, D>, constrained: &[bool; D]) -> Option<Mat<D, D>> {
    /// Pivots below this part of the diagonal are rounding.
    const ROUNDING: f64 = 1e-12;
    let mut a = block;
    let mut inverse: Mat<D, D> = from_fn(|r| from_fn(|c| if r == c { 1.0 } else { 0.0 }));
    for k in (0..D).filter(|&k| !constrained[k]) {
        let pivot = a[k][k];
        if !(pivot > ROUNDING * block[k][k] && pivot.is_finite()) {
            return None;
        }
        for c in 0..D {
            (a[k][c], inverse[k][c]) = (a[k][c] / pivot, inverse[k][c] / pivot);
        }
        for r in (0..D).filter(|&r| r != k) {
            let factor = a[r][k];
            for c in 0..D {
                a[r][c] -= factor * a[k][c];
                inverse[r][c] -= factor * inverse[k][c];
            }
        }
    }
    (0..D).filter(|&k| constrained[k]).for_each(|k| inverse[k] = [0.0; D]);
    Some(inverse)
}
