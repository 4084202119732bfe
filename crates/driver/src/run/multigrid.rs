//! A multigrid cycle over the levels of a lattice: where the algebra of the cycle meets the mechanics of its levels.

use super::Counters;
use super::border_block::BorderBlock;
use super::coarser::CoarserModels;
use super::factor::lifted;
use super::solve_failure::SolveFailure;
use peristat_assembly::body::{Interpolation, LevelTransfer};
use peristat_assembly::system::{InPrecision, Level, System};
use peristat_solve::{Hierarchy, Multigrid, MultigridOptions, Ordering, Relaxation, SparseCholesky};

/// All levels of a problem.
pub(super) struct Levels<'a, const D: usize, R = f64> {
    levels: Vec<Level<'a, D, R>>,
    transfers: &'a [Box<dyn LevelTransfer>],
    /// What smooths beside a border that cuts cells.
    block: Option<BorderBlock>,
}

/// Relative lifts of the diagonal of the coarsest level, all but the first where supports that fall together, or points
/// that cracks leave a bond or two, make it singular.
const LIFTS: [f64; 3] = [0.0, 1e-6, 1e-4];

/// The cycle as a preconditioner of `system`; also the entries of the factor of the coarsest level.
///
/// # Errors
/// [`SolveFailure`] if a point of the finest level is not held by its bonds, or the coarsest level has no factor.
pub(super) fn cycle<'a, const D: usize>(
    system: &'a System<D>,
    coarser: &'a CoarserModels<D>,
    counters: &mut Counters,
) -> Result<(Multigrid<Levels<'a, D>>, usize), SolveFailure> {
    let finest = Level::new(system).map_err(|point| SolveFailure::Loose { point })?;
    let (levels, factor, entries) = Levels::below(finest, coarser, &coarser.beside_border, counters)?;
    Ok((Multigrid::new(levels, factor, &options(coarser)), entries))
}

/// How a cycle over the levels is made.
pub(super) fn options<const D: usize>(coarser: &CoarserModels<D>) -> MultigridOptions {
    let mut options = MultigridOptions::STANDARD;
    if coarser.is_unlike {
        options.measured_size = usize::MAX;
    }
    if coarser.visits_once {
        options.single_visits = usize::MAX;
    }
    options
}

impl<'a, const D: usize, R: InPrecision> Levels<'a, D, R> {
    /// The levels below a finest one, whose points `beside` a border are smoothed together; with the factor of the coarsest level,
    /// and the entries of all factors.
    ///
    /// # Errors
    /// [`SolveFailure`] if the coarsest level or the points beside the border have no factor.
    pub(super) fn below(
        mut finest: Level<'a, D, R>,
        coarser: &'a CoarserModels<D>,
        beside: &[usize],
        counters: &mut Counters,
    ) -> Result<(Self, Box<SparseCholesky>, usize), SolveFailure> {
        let block = (!beside.is_empty()).then(|| BorderBlock::new(finest.system(), beside)).transpose()?;
        block.iter().for_each(|block| block.lay_bare(&mut finest));
        let mut levels = vec![finest];
        levels.extend(coarser.systems.iter().map(Level::coarse));
        let mut coarsest = levels.last().expect("there is a finest level").system().assemble_sparse();
        let mut factor =
            SparseCholesky::analyse(&coarsest, Ordering::MinimumDegree).map_err(SolveFailure::Factor)?;
        let diagonal = coarsest.diag();
        counters.analyses += 1;
        lifted(&LIFTS[usize::from(coarser.is_loose)..], counters, |lift| {
            diagonal.iter().for_each(|(k, value)| coarsest.set(k, k, value * (1.0 + lift)));
            factor.refactor(&coarsest)
        })
        .map_err(SolveFailure::Factor)?;
        let entries = factor.fill() + block.as_ref().map_or(0, BorderBlock::entries);
        Ok((Levels { levels, transfers: &coarser.transfers, block }, Box::new(factor), entries))
    }
}

impl<'a, const D: usize, R: InPrecision> Hierarchy for Levels<'a, D, R>
where
    dyn LevelTransfer + 'a: Interpolation<R>,
{
    type Real = R;

    fn depth(&self) -> usize {
        self.levels.len()
    }

    fn size(&self, level: usize) -> usize {
        self.levels[level].system().size()
    }

    fn apply(&self, level: usize, x: &[R], y: &mut [R]) {
        R::multiply(self.levels[level].system(), x, y);
    }

    fn smooth(&self, level: usize, scale: f64, r: &[R], x: &mut [R]) {
        match &self.block {
            Some(block) if level == 0 => {
                block.take(&|_, x| x, x, |x| self.levels[0].smooth(scale, r, x));
                self.levels[0].expand(x);
            }
            _ => self.levels[level].smooth(scale, r, x),
        }
    }

    fn residual(&self, level: usize, b: &[R], x: &[R], r: &mut [R]) {
        self.levels[level].residual(b, x, r);
    }

    fn relax(&self, level: usize, step: Relaxation, b: &[R], x: &[R], previous: &mut [R], scratch: &mut [R]) {
        let mut take = |previous: &mut [R]| {
            self.levels[level].relax([step.keep, step.scale], b, x, previous, scratch);
        };
        match &self.block {
            Some(block) if level == 0 => {
                let keep = R::of(step.keep);
                let moved = |k: usize, previous: R| x[k] + keep * (x[k] - previous);
                block.take(&moved, previous, take);
                self.levels[0].expand(previous);
            }
            _ => take(previous),
        }
    }

    fn restrict(&self, level: usize, fine: &[R], coarse: &mut [R]) {
        self.transfers[level].restrict_all(fine, coarse);
        self.levels[level + 1].system().constraints().restrict(coarse);
    }

    fn prolong_add(&self, level: usize, coarse: &[R], fine: &mut [R]) {
        // The factor of the coarsest level leaves dependent unknowns at zero; the smoother of the others does not.
        let mut expanded = Vec::new();
        if level + 2 == self.depth() && self.levels[level + 1].system().constraints().has_slaves() {
            expanded.extend_from_slice(coarse);
            self.levels[level + 1].expand(&mut expanded);
        }
        let coarse = if expanded.is_empty() { coarse } else { &expanded };
        self.transfers[level].prolong_all(coarse, fine);
        // What is held stays at zero, what depends on others follows them.
        self.levels[level].system().constraints().expand(0.0, fine);
    }
}
