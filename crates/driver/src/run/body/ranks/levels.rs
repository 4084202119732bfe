//! The levels of a multigrid cycle of which several processes share the finest one.

use super::part::Part;
use crate::run::multigrid::Levels;
use peristat_solve::{Hierarchy, Multigrid, Preconditioner, Ranks, Relaxation};

/// Levels whose finest one has the points of a part: what is read of it has the unknowns of others as they are, and residuals
/// are zero there. Coarser levels are whole, and the same with all processes.
pub(super) struct SharedLevels<'a, const D: usize> {
    pub(super) levels: Levels<'a, D>,
    pub(super) part: &'a Part<'a, D>,
    pub(super) ranks: &'a dyn Ranks,
}

impl<const D: usize> Hierarchy for SharedLevels<'_, D> {
    type Real = f64;

    fn depth(&self) -> usize {
        self.levels.depth()
    }

    fn size(&self, level: usize) -> usize {
        self.levels.size(level)
    }

    fn dot(&self, level: usize, a: &[f64], b: &[f64]) -> f64 {
        if level > 0 {
            return self.levels.dot(level, a, b);
        }
        let (points, own) = (self.part.system.points(), self.part.own());
        let of_plane =
            |c: usize| own.iter().map(move |&p| a[c * points + p as usize] * b[c * points + p as usize]);
        let mut sum = [(0..D).flat_map(of_plane).sum()];
        self.ranks.sum(&mut sum);
        sum[0]
    }

    fn apply(&self, level: usize, x: &[f64], y: &mut [f64]) {
        if level > 0 {
            return self.levels.apply(level, x, y);
        }
        let mut x = x.to_vec();
        self.part.refresh(&mut x);
        self.levels.apply(level, &x, y);
        self.part.mute(y);
    }

    fn smooth(&self, level: usize, scale: f64, r: &[f64], x: &mut [f64]) {
        self.levels.smooth(level, scale, r, x);
        if level == 0 {
            self.part.refresh(x);
        }
    }

    fn residual(&self, level: usize, b: &[f64], x: &[f64], r: &mut [f64]) {
        self.levels.residual(level, b, x, r);
        if level == 0 {
            self.part.mute(r);
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
        self.levels.relax(level, step, b, x, previous, scratch);
        if level == 0 {
            self.part.refresh(previous);
        }
    }

    fn restrict(&self, level: usize, fine: &[f64], coarse: &mut [f64]) {
        self.levels.restrict(level, fine, coarse);
        if level == 0 {
            self.ranks.sum(coarse);
        }
    }

    fn prolong_add(&self, level: usize, coarse: &[f64], fine: &mut [f64]) {
        self.levels.prolong_add(level, coarse, fine);
        if level == 0 {
            self.part.refresh(fine);
        }
    }
}

/// The cycle as a preconditioner of own unknowns.
pub(super) struct SharedCycle<'a, const D: usize> {
    pub(super) multigrid: Multigrid<SharedLevels<'a, D>>,
    /// Right-hand side and solution, of the part.
    pub(super) vectors: [Vec<f64>; 2],
}

impl<const D: usize> Preconditioner for SharedCycle<'_, D> {
    fn size(&self) -> usize {
        D * self.multigrid.hierarchy().part.own().len()
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let Self { multigrid, vectors: [b, x] } = self;
        multigrid.hierarchy().part.put(r, b);
        multigrid.apply(b, x);
        multigrid.hierarchy().part.take(x, z);
    }
}
