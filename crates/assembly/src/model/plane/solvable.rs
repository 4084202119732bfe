//! Bodies that are solved with a number of unknowns per point.

use super::{CriticalStretch, FindCuts};
use crate::model::{BodyModel, Breakable, Model};
use crate::stiffness::{EndedBond, HistoryBond};

/// A body with `D` unknowns per point.
pub trait Solvable<const D: usize>: Model<D> + BodyModel + AsSolvable<D> {
    /// The same body on a lattice of twice the spacing with the same horizon ratio; none of a cloud. `cuts` finds the cuts
    /// on a lattice, given the offsets. None either where joined sides or
    /// a single layer leave no lattice for it. A mirror through coarse cells moves outwards.
    fn coarser(&self, cuts: &FindCuts) -> Option<Box<dyn Solvable<D>>>;

    /// A copy whose bonds can break; none where the model has no such bonds.
    fn breaking(&self) -> Option<Box<dyn BreakingModel<D>>> {
        None
    }

    /// A copy whose bonds can soften; none where the model has no such bonds.
    fn softening(&self) -> Option<Box<dyn SofteningModel<D>>> {
        None
    }
}

/// A body as an object, whatever its type.
pub trait AsSolvable<const D: usize> {
    /// The body.
    fn as_solvable(&self) -> &dyn Solvable<D>;

    /// A copy of it.
    fn boxed(&self) -> Box<dyn Solvable<D>>;
}

impl<const D: usize, T: Solvable<D> + Clone + 'static> AsSolvable<D> for T {
    fn as_solvable(&self) -> &dyn Solvable<D> {
        self
    }

    fn boxed(&self) -> Box<dyn Solvable<D>> {
        Box::new(self.clone())
    }
}

impl<const D: usize> Clone for Box<dyn Solvable<D>> {
    fn clone(&self) -> Self {
        self.boxed()
    }
}

/// A body whose bonds break at critical stretches.
pub trait BreakingModel<const D: usize>: Solvable<D> + Breakable<D, Critical = CriticalStretch> {}

impl<const D: usize, T: Solvable<D> + Breakable<D, Critical = CriticalStretch>> BreakingModel<D> for T {}

/// A body of bonds that can have a memory.
pub trait SofteningModel<const D: usize>: Solvable<D> {
    /// All bonds between points as ones with memory; `law` chooses that of a bond between two points, none leaves the bond out.
    fn history_bonds(&self, law: &dyn Fn([usize; 2]) -> Option<usize>) -> Vec<HistoryBond<D>>;

    /// The bonds that end on the border as ones with memory. `law` chooses that of a bond by the points that move it and the
    /// part that it is of a whole one; none leaves it out.
    fn ended_bonds(&self, law: &mut dyn FnMut(&[u32], f64) -> Option<usize>) -> Vec<EndedBond<D>>;

    /// Volume that a point stands for in stresses, m³.
    fn stress_volume(&self, point: usize) -> f64;
}
