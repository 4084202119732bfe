//! A multigrid cycle whose levels are coarser along lines only: the finest goes from point to point, all others are matrices.

use super::Counters;
use super::solve_failure::SolveFailure;
use peristat_assembly::system::{Level, System};
use peristat_solve::{Hierarchy, LinePlace, Multigrid, MultigridOptions, Relaxation, Semicoarsening};

/// Stations that the coarsest level has at most: of 1e5 points its factor takes as long as the levels that it spares, and a cycle of
/// 24 twice as long.
pub(super) const COARSEST: u32 = 64;

/// All levels.
pub(super) struct Lines<'a, const D: usize> {
    finest: Level<'a, D>,
    below: Semicoarsening,
}

/// The cycle as a preconditioner of `system`; also the entries of its matrices and factors.
///
/// # Errors
/// [`SolveFailure`] if a point is not held by its bonds, or a matrix has no factor.
pub(super) fn cycle<'a, const D: usize>(
    system: &'a System<D>,
    places: &[Option<LinePlace>],
    counters: &mut Counters,
) -> Result<(Multigrid<Lines<'a, D>>, usize), SolveFailure> {
    let finest = Level::new(system).map_err(|point| SolveFailure::Loose { point })?;
    let (below, factor) =
        Semicoarsening::new(system.assemble_sparse(), places, COARSEST).map_err(SolveFailure::Factor)?;
    counters.analyses += 1;
    counters.factorisations += 1;
    let entries = below.entries() + factor.fill();
    // No two levels have the same stencil.
    let options = MultigridOptions { measured_size: usize::MAX, ..MultigridOptions::STANDARD };
    Ok((Multigrid::new(Lines { finest, below }, Box::new(factor), &options), entries))
}

impl<const D: usize> Hierarchy for Lines<'_, D> {
    type Real = f64;

    fn depth(&self) -> usize {
        1 + self.below.depth()
    }

    fn size(&self, level: usize) -> usize {
        if level == 0 { self.finest.system().size() } else { self.below.size(level - 1) }
    }

    fn apply(&self, level: usize, x: &[f64], y: &mut [f64]) {
        if level == 0 { self.finest.system().product(x, y) } else { self.below.apply(level - 1, x, y) }
    }

    fn smooth(&self, level: usize, scale: f64, r: &[f64], x: &mut [f64]) {
        if level == 0 { self.finest.smooth(scale, r, x) } else { self.below.smooth(level - 1, scale, r, x) }
    }

    fn residual(&self, level: usize, b: &[f64], x: &[f64], r: &mut [f64]) {
        match level {
            0 => self.finest.residual(b, x, r),
            _ => self.below.residual(level - 1, b, x, r),
        }
    }

    fn relax(
        &self,
        level: usize,
        step: Relaxation,
        b: &[f64],
        x: &[f64],
        previous: &mut [f64],
        scratch: &mut [f64],
    ) {
        match level {
            0 => self.finest.relax([step.keep, step.scale], b, x, previous, scratch),
            _ => self.below.relax(level - 1, step, b, x, previous, scratch),
        }
    }

    fn restrict(&self, level: usize, fine: &[f64], coarse: &mut [f64]) {
        match level {
            0 => self.below.restrict_finest(fine, coarse),
            _ => self.below.restrict(level - 1, fine, coarse),
        }
    }

    fn prolong_add(&self, level: usize, coarse: &[f64], fine: &mut [f64]) {
        if level > 0 {
            return self.below.prolong_add(level - 1, coarse, fine);
        }
        self.below.prolong_add_finest(coarse, fine);
        // What is held stays at zero, what depends on others follows them.
        self.finest.system().constraints().expand(0.0, fine);
    }
}
