//! A multigrid cycle in numbers of 32 bits: as good a preconditioner as one of 64 bits, half as long to read and write.

use super::Counters;
use super::coarser::CoarserModels;
use super::multigrid::{Levels, options};
use super::solve_failure::SolveFailure;
use peristat_assembly::system::{Level, System};
use peristat_solve::{Multigrid, Preconditioner, SparseCholesky};

/// Points from which it is worth it.
const FEWEST: usize = 1 << 16;

/// Longer side, squared, over the area from which bending is so soft that rounding disturbs it. A cantilever thirty times as long as high
/// takes 27 iterations in place of 21, one of a hundred times 79 in place of 37; a square takes 13 either way.
const SLENDER: usize = 16;

/// Whether a body is slender: a strip, or a ring, from the numbers of columns and rows that it covers and of its points.
pub(super) fn is_slender(sides: [usize; 2], points: usize) -> bool {
    let longer = sides[0].max(sides[1]);
    longer * longer > SLENDER * points
}

/// Whether a system is large enough and not slender, and all of its levels go from point to point in these numbers.
pub(super) fn suits<const D: usize>(system: &System<D>, coarser: &CoarserModels<D>) -> bool {
    system.points() >= FEWEST
        && !coarser.is_soft
        && system.sweeps_in_single()
        && coarser.systems.iter().all(System::sweeps_in_single)
}

/// The cycle as a preconditioner of conjugate gradients in 64 bits.
pub(super) struct SingleCycle<'a, const D: usize> {
    system: &'a System<D>,
    multigrid: Multigrid<Levels<'a, D, f32>>,
    /// Right-hand side and solution of the finest level.
    vectors: [Vec<f32>; 2],
}

/// Sets it up; also the entries of the factor of the coarsest level.
///
/// # Errors
/// [`SolveFailure`] if a point of the finest level is not held by its bonds, or the coarsest level has no factor.
pub(super) fn cycle<'a, const D: usize>(
    system: &'a System<D>,
    coarser: &'a CoarserModels<D>,
    counters: &mut Counters,
) -> Result<(SingleCycle<'a, D>, usize), SolveFailure> {
    let finest = Level::new(system).map_err(|point| SolveFailure::Loose { point })?;
    let (levels, factor, entries) = Levels::below(finest, coarser, &coarser.beside_border, counters)?;
    let numbers = [0; 2].map(|_| vec![0.0; factor.size()]);
    let multigrid = Multigrid::new(levels, Box::new(Coarsest { factor, numbers }), &options(coarser));
    Ok((SingleCycle { system, multigrid, vectors: [0; 2].map(|_| vec![0.0; system.size()]) }, entries))
}

impl<const D: usize> Preconditioner for SingleCycle<'_, D> {
    fn size(&self) -> usize {
        self.vectors[0].len()
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let Self { system, multigrid, vectors: [b, x] } = self;
        // Residuals of all sizes are numbers around one, which do not underflow.
        let largest = r.iter().fold(0.0, |largest: f64, r| largest.max(r.abs()));
        if largest == 0.0 {
            return z.fill(0.0);
        }
        b.iter_mut().zip(r).for_each(|(b, r)| *b = (r / largest) as f32);
        multigrid.apply(b, x);
        z.iter_mut().zip(x.iter()).for_each(|(z, x)| *z = largest * f64::from(*x));
        // What depends on others follows them to the last bit.
        system.constraints().expand(0.0, z);
    }
}

/// The factor of the coarsest level, in 64 bits.
struct Coarsest {
    factor: Box<SparseCholesky>,
    /// Right-hand side and solution.
    numbers: [Vec<f64>; 2],
}

impl Preconditioner<f32> for Coarsest {
    fn size(&self) -> usize {
        self.numbers[0].len()
    }

    fn apply(&mut self, r: &[f32], z: &mut [f32]) {
        let [b, x] = &mut self.numbers;
        b.iter_mut().zip(r).for_each(|(b, r)| *b = f64::from(*r));
        self.factor.apply(b, x);
        z.iter_mut().zip(x.iter()).for_each(|(z, x)| *z = *x as f32);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_and_rings_are_slender() {
        assert!(!is_slender([300, 300], 90_000) && !is_slender([1600, 100], 160_000));
        assert!(is_slender([1700, 100], 170_000));
        // A square ring of two cells.
        assert!(is_slender([200, 200], 4 * 198 * 2));
    }
}
