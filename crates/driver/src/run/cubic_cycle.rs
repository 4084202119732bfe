//! A multigrid cycle of 32 bits over cubes with one stencil.

use super::Counters;
use super::factor::lifted;
use super::solve_failure::SolveFailure;
use peristat_assembly::cubic::{CoarsestMatrix, CubicLevel, CubicLevels};
use peristat_assembly::system::System;
use peristat_solve::{
    Hierarchy, Multigrid, MultigridOptions, Ordering, Preconditioner, Relaxation, SparseCholesky,
};
use std::borrow::Borrow;

/// Relative lifts of the diagonal of the coarsest level, all but the first where supports that fall together make it singular.
const LIFTS: [f64; 3] = [0.0, 1e-6, 1e-4];
/// Levels of more numbers take the largest eigenvalue of a coarser one.
const MEASURED: usize = 100_000;

/// With two steps down to a quarter of the eigenvalues there are two fifths more cycles, which take as long in all.
const SMOOTHER: MultigridOptions = MultigridOptions { degree: 3, range: 8.0, ..MultigridOptions::STANDARD };

/// The cycle as a preconditioner of a system.
pub(super) struct CubicCycle<'a, const D: usize> {
    system: &'a System<D>,
    cubes: Cubes<&'a CubicLevels>,
}

/// A cycle over levels.
pub(super) struct Cubes<L: Borrow<CubicLevels> + Sync> {
    multigrid: Multigrid<Levels<L>>,
    /// Right-hand side and solution of the finest level.
    vectors: [Vec<f32>; 2],
}

/// Sets it up for a system; also the entries of the factor of the coarsest level.
///
/// # Errors
/// [`SolveFailure`] if the coarsest level has no factor.
pub(super) fn cycle<'a, const D: usize>(
    system: &'a System<D>,
    levels: &'a CubicLevels,
    counters: &mut Counters,
) -> Result<(CubicCycle<'a, D>, usize), SolveFailure> {
    let (cubes, fill) = cubes(levels, counters)?;
    Ok((CubicCycle { system, cubes }, fill))
}

/// The same by itself.
///
/// # Errors
/// [`SolveFailure`] if the coarsest level has no factor.
pub(super) fn cubes<L: Borrow<CubicLevels> + Sync>(
    of: L,
    counters: &mut Counters,
) -> Result<(Cubes<L>, usize), SolveFailure> {
    let levels = of.borrow();
    let CoarsestMatrix { mut matrix, entries, images } = levels.coarsest();
    let mut factor =
        SparseCholesky::analyse(&matrix, Ordering::MinimumDegree).map_err(SolveFailure::Factor)?;
    counters.analyses += 1;
    let diagonal = matrix.diag();
    lifted(&LIFTS, counters, |lift| {
        diagonal.iter().for_each(|(k, value)| matrix.set(k, k, value * (1.0 + lift)));
        factor.refactor(&matrix)
    })
    .map_err(SolveFailure::Factor)?;
    let fill = factor.fill();
    let numbers = [0; 2].map(|_| vec![0.0; entries.len()]);
    let size = levels.levels().last().map_or(0, CubicLevel::size);
    let coarsest = Coarsest { size, factor, entries, images, numbers };
    let measured_size = if levels.levels()[0].is_unlike() { usize::MAX } else { MEASURED };
    let options = MultigridOptions { measured_size, ..SMOOTHER };
    let size = levels.levels()[0].size();
    let multigrid = Multigrid::new(Levels(of), Box::new(coarsest), &options);
    Ok((Cubes { multigrid, vectors: [0; 2].map(|_| vec![0.0; size]) }, fill))
}

impl<L: Borrow<CubicLevels> + Sync> Cubes<L> {
    /// Writes what a cycle makes of the forces `r` over `z`; what depends on others does not follow them.
    pub(super) fn correct(&mut self, r: &[f64], z: &mut [f64]) {
        let Self { multigrid, vectors: [b, v] } = self;
        let levels = multigrid.hierarchy().0.borrow();
        let norm = levels.enter(r, b);
        multigrid.apply(b, v);
        multigrid.hierarchy().0.borrow().leave(v, norm, z);
    }
}

impl<const D: usize> Preconditioner for CubicCycle<'_, D> {
    fn size(&self) -> usize {
        self.system.size()
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        self.cubes.correct(r, z);
        // What is held stays at zero, what depends on others follows them.
        self.system.constraints().expand(0.0, z);
    }
}

/// The levels, as a cycle asks for them.
pub(super) struct Levels<L>(L);

impl<L: Borrow<CubicLevels> + Sync> Levels<L> {
    fn level(&self, level: usize) -> &CubicLevel {
        &self.0.borrow().levels()[level]
    }
}

impl<L: Borrow<CubicLevels> + Sync> Hierarchy for Levels<L> {
    type Real = f32;

    fn depth(&self) -> usize {
        self.0.borrow().levels().len()
    }

    fn size(&self, level: usize) -> usize {
        self.level(level).size()
    }

    fn dot(&self, level: usize, a: &[f32], b: &[f32]) -> f64 {
        self.level(level).dot(a, b)
    }

    fn apply(&self, level: usize, x: &[f32], y: &mut [f32]) {
        self.level(level).apply(x, y);
    }

    fn smooth(&self, level: usize, scale: f64, r: &[f32], x: &mut [f32]) {
        self.level(level).smooth(scale, r, x);
    }

    fn residual(&self, level: usize, b: &[f32], x: &[f32], r: &mut [f32]) {
        self.level(level).residual(b, x, r);
    }

    fn relax(
        &self,
        level: usize,
        step: Relaxation,
        b: &[f32],
        x: &[f32],
        previous: &mut [f32],
        _scratch: &mut [f32],
    ) {
        self.level(level).relax([step.keep, step.scale], b, x, previous);
    }

    fn restrict(&self, level: usize, fine: &[f32], coarse: &mut [f32]) {
        self.0.borrow().restrict(level, fine, coarse);
    }

    fn prolong_add(&self, level: usize, coarse: &[f32], fine: &mut [f32]) {
        self.0.borrow().prolong_add(level, coarse, fine);
    }
}

/// The factor of the coarsest level.
struct Coarsest {
    /// Length of its vectors.
    size: usize,
    factor: SparseCholesky,
    /// Entries of vectors that are unknowns.
    entries: Vec<u32>,
    /// Entries that are images of unknowns, with signs.
    images: Vec<(u32, u32, f32)>,
    /// Right-hand side and solution.
    numbers: [Vec<f64>; 2],
}

impl Preconditioner<f32> for Coarsest {
    fn size(&self) -> usize {
        self.size
    }

    fn apply(&mut self, r: &[f32], z: &mut [f32]) {
        let [b, x] = &mut self.numbers;
        self.entries.iter().zip(b.iter_mut()).for_each(|(&entry, b)| *b = f64::from(r[entry as usize]));
        self.factor.apply(b, x);
        z.fill(0.0);
        self.entries.iter().zip(x.iter()).for_each(|(&entry, x)| z[entry as usize] = *x as f32);
        let image =
            |&(entry, unknown, sign): &(u32, u32, f32)| z[entry as usize] = sign * x[unknown as usize] as f32;
        self.images.iter().for_each(image);
    }
}
