//! A multigrid cycle as preconditioner.
//!
//! On the way down every level is smoothed, its residual restricted, and the correction of the next level
//! interpolated; on the way up it is smoothed again, by the same polynomial, which makes the cycle a symmetric operator
//! as conjugate gradients need it. The coarsest level is solved by whatever the caller hands over.
//!
//! A cycle whose smoother takes `k` steps costs `2 k` products with the finest level: `k - 1` before, since the first
//! step from zero needs none, one for the residual, `k` after. Coarser levels may be visited twice, the second time
//! starting from the result of the first.
//!
//! The cycle is positive definite with any positive definite coarse operators where every level is visited once. Two
//! visits ask more of them: the eigenvalues of a cycle times its operator must be below 2, so that no correction
//! overshoots by its own length. Interpolation between unknowns that no chain of short couplings joins breaks this.

mod chebyshev;
mod spectrum;

use crate::hierarchy::{Hierarchy, Relaxation};
use crate::operator::Preconditioner;

/// How a cycle is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MultigridOptions {
    /// Steps of the smoother before and after the coarser levels, at least 1.
    pub degree: usize,
    /// The smoother damps the eigenvalues of `M^-1 A` from the largest down to this part of it.
    pub range: f64,
    /// The finest levels, this many of them, have one cycle of the next coarser level in each of their cycles, all others
    /// two (but the coarsest level is solved once): 0 makes a W-cycle, [`usize::MAX`] a V-cycle.
    pub single_visits: usize,
    /// Levels of more unknowns take the largest eigenvalue of the coarser ones instead of finding their own, in
    /// [`Self::lanczos_steps`] products. That is right where all levels have the same stencil.
    pub measured_size: usize,
    /// Products per level that find the largest eigenvalue.
    pub lanczos_steps: usize,
    /// Factor on the largest eigenvalue found, which is always too small. A fifth too much costs no iteration. Eigenvalues beyond the bound that it gives are
    /// amplified, and the cycle is not positive definite if one of them is beyond `1 + 1 / range` times the bound.
    pub margin: f64,
}

impl MultigridOptions {
    /// Found on lattices of 28 neighbours, where 11 to 15 cycles leave 1e-10 of the residual. Three steps of the smoother
    /// in a V-cycle need 11 to 16, and half as many products again on the finest level; one step in a W-cycle needs a
    /// third fewer products, but is not always positive definite where a cut runs through the lattice.
    pub const STANDARD: Self = Self {
        degree: 2,
        range: 4.0,
        single_visits: 1,
        measured_size: 1 << 16,
        lanczos_steps: 10,
        margin: 1.1,
    };
}

impl Default for MultigridOptions {
    fn default() -> Self {
        Self::STANDARD
    }
}

/// One cycle from zero: an approximate inverse of the finest operator of a [`Hierarchy`].
pub struct Multigrid<H: Hierarchy> {
    hierarchy: H,
    coarsest: Box<dyn Preconditioner<H::Real> + Send>,
    /// All but the coarsest, finest first.
    levels: Vec<Level<H::Real>>,
    single: usize,
}

/// What the cycle keeps of a level.
struct Level<R> {
    largest: f64,
    steps: Vec<Relaxation>,
    /// The iterate before the last, or the one after the next.
    other: Vec<R>,
    residual: Vec<R>,
    /// Right-hand side and solution of the next coarser level.
    coarse_residual: Vec<R>,
    correction: Vec<R>,
}

impl<H: Hierarchy> Multigrid<H> {
    /// Finds the largest eigenvalues and allocates all vectors. `coarsest` solves the last level.
    ///
    /// # Panics
    ///
    /// If there is no level, the size of `coarsest` is not that of the last one, or the degree is 0.
    #[must_use]
    pub fn new(
        hierarchy: H,
        coarsest: Box<dyn Preconditioner<H::Real> + Send>,
        options: &MultigridOptions,
    ) -> Self {
        let depth = hierarchy.depth();
        assert!(depth > 0 && options.degree > 0, "a level and a step");
        assert_eq!(coarsest.size(), hierarchy.size(depth - 1), "a solver for the last level");
        let levels = spectrum::largest_eigenvalues(&hierarchy, options)
            .into_iter()
            .enumerate()
            .map(|(l, largest)| {
                let (size, coarse) = (hierarchy.size(l), hierarchy.size(l + 1));
                Level {
                    largest,
                    steps: chebyshev::steps(largest, options.range, options.degree),
                    other: vec![H::Real::default(); size],
                    residual: vec![H::Real::default(); size],
                    coarse_residual: vec![H::Real::default(); coarse],
                    correction: vec![H::Real::default(); coarse],
                }
            })
            .collect();
        Self { hierarchy, coarsest, levels, single: options.single_visits }
    }

    /// The levels.
    pub fn hierarchy(&self) -> &H {
        &self.hierarchy
    }

    /// The bounds on the eigenvalues of `M^-1 A` that the smoother uses, finest level first, without the coarsest.
    pub fn bounds(&self) -> impl Iterator<Item = f64> {
        self.levels.iter().map(|l| l.largest)
    }
}

impl<H: Hierarchy> Preconditioner<H::Real> for Multigrid<H> {
    fn size(&self) -> usize {
        self.hierarchy.size(0)
    }

    fn apply(&mut self, r: &[H::Real], z: &mut [H::Real]) {
        let Self { hierarchy, coarsest, levels, single } = self;
        Cycle { hierarchy, coarsest: coarsest.as_mut(), single: *single }.run(0, levels, Start::Zero, r, z);
    }
}

/// What all levels of a cycle share.
struct Cycle<'a, H: Hierarchy> {
    hierarchy: &'a H,
    coarsest: &'a mut dyn Preconditioner<H::Real>,
    single: usize,
}

/// What a cycle improves.
#[derive(Clone, Copy, PartialEq)]
enum Start {
    /// Zero, whatever is in the vector.
    Zero,
    /// What is in the vector.
    Current,
}

impl<H: Hierarchy> Cycle<'_, H> {
    /// Improves `x` as solution for `b` by a cycle from level `index` on, with which `levels` begin.
    fn run(
        &mut self,
        index: usize,
        levels: &mut [Level<H::Real>],
        start: Start,
        b: &[H::Real],
        x: &mut [H::Real],
    ) {
        let Some((level, coarser)) = levels.split_first_mut() else {
            return self.coarsest.apply(b, x);
        };
        let Level { steps, other, residual, coarse_residual, correction, .. } = level;
        // Every product swaps the two iterates; the last one is to be in `x`.
        let (mut x, mut other) = (x, other.as_mut_slice());
        let mut before = steps.as_slice();
        if start == Start::Zero {
            (x, other) = (other, x);
            x.fill(H::Real::default());
            other.fill(H::Real::default());
            self.hierarchy.smooth(index, steps[0].scale, b, x);
            before = &steps[1..];
        }
        for step in before {
            self.hierarchy.relax(index, *step, b, x, other, residual);
            (x, other) = (other, x);
        }
        self.hierarchy.residual(index, b, x, residual);
        self.hierarchy.restrict(index, residual, coarse_residual);
        self.run(index + 1, coarser, Start::Zero, coarse_residual, correction);
        if index >= self.single && !coarser.is_empty() {
            self.run(index + 1, coarser, Start::Current, coarse_residual, correction);
        }
        self.hierarchy.prolong_add(index, correction, x);
        for step in steps.iter() {
            self.hierarchy.relax(index, *step, b, x, other, residual);
            (x, other) = (other, x);
        }
    }
}
