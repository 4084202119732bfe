//! A multigrid V-cycle as preconditioner.
//!
//! On the way down every level is smoothed from zero, its residual restricted, and the correction of the next level
//! interpolated; on the way up it is smoothed again, by the same polynomial, which makes the cycle a symmetric operator
//! as conjugate gradients need it. The coarsest level is solved by whatever the caller hands over.
//!
//! A cycle of degree `k` costs `2 k` products on every level but the coarsest: `k - 1` before, since the first step
//! from zero needs none, one for the residual, `k` after.

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
    /// Levels of more unknowns take the largest eigenvalue of the coarser ones instead of finding their own, in
    /// [`Self::lanczos_steps`] products. That is right where all levels have the same stencil.
    pub measured_size: usize,
    /// Products per level that find the largest eigenvalue.
    pub lanczos_steps: usize,
    /// Factor on the largest eigenvalue found, which is always too small. Eigenvalues beyond the bound that it gives are
    /// amplified, and the cycle is not positive definite if one of them is beyond `1 + 1 / range` times the bound.
    pub margin: f64,
}

impl Default for MultigridOptions {
    fn default() -> Self {
        Self { degree: 3, range: 8.0, measured_size: 1 << 17, lanczos_steps: 12, margin: 1.03 }
    }
}

/// One V-cycle from zero: an approximate inverse of the finest operator of a [`Hierarchy`].
pub struct Multigrid<H> {
    hierarchy: H,
    coarsest: Box<dyn Preconditioner + Send>,
    /// All but the coarsest, finest first.
    levels: Vec<Level>,
}

/// What the cycle keeps of a level.
struct Level {
    largest: f64,
    steps: Vec<Relaxation>,
    /// The iterate before the last, or the one after the next.
    other: Vec<f64>,
    residual: Vec<f64>,
    /// Right-hand side and solution of the next coarser level.
    coarse_residual: Vec<f64>,
    correction: Vec<f64>,
}

impl<H: Hierarchy> Multigrid<H> {
    /// Finds the largest eigenvalues and allocates all vectors. `coarsest` solves the last level.
    ///
    /// # Panics
    ///
    /// If there is no level, the size of `coarsest` is not that of the last one, or the degree is 0.
    #[must_use]
    pub fn new(hierarchy: H, coarsest: Box<dyn Preconditioner + Send>, options: &MultigridOptions) -> Self {
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
                    other: vec![0.0; size],
                    residual: vec![0.0; size],
                    coarse_residual: vec![0.0; coarse],
                    correction: vec![0.0; coarse],
                }
            })
            .collect();
        Self { hierarchy, coarsest, levels }
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

impl<H: Hierarchy> Preconditioner for Multigrid<H> {
    fn size(&self) -> usize {
        self.hierarchy.size(0)
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        cycle(&self.hierarchy, 0, &mut self.levels, self.coarsest.as_mut(), r, z);
    }
}

/// Writes the result of a cycle for `b` from zero over `x`. `levels` begins with the present one.
fn cycle<H: Hierarchy>(
    hierarchy: &H,
    index: usize,
    levels: &mut [Level],
    coarsest: &mut dyn Preconditioner,
    b: &[f64],
    x: &mut [f64],
) {
    let Some((level, coarser)) = levels.split_first_mut() else {
        return coarsest.apply(b, x);
    };
    let Level { steps, other, residual, coarse_residual, correction, .. } = level;
    // Every step but the first swaps the two iterates, an odd number in all.
    let (mut x, mut other) = (other.as_mut_slice(), x);
    x.fill(0.0);
    other.fill(0.0);
    hierarchy.smooth(index, steps[0].scale, b, x);
    for step in &steps[1..] {
        hierarchy.relax(index, *step, b, x, other, residual);
        (x, other) = (other, x);
    }
    hierarchy.residual(index, b, x, residual);
    hierarchy.restrict(index, residual, coarse_residual);
    cycle(hierarchy, index + 1, coarser, coarsest, coarse_residual, correction);
    hierarchy.prolong_add(index, correction, x);
    for step in steps.iter() {
        hierarchy.relax(index, *step, b, x, other, residual);
        (x, other) = (other, x);
    }
}
