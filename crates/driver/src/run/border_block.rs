//! The unknowns beside a border that cuts cells, solved together in every step of the smoother.
//!
//! Corners beyond the border move as points inside do, continued quadratically, which couples points beside it far more than
//! points inside: steps by blocks of single points leave much of an error there. The stiffness of a strip along the border has
//! a small factor.

use super::solve_failure::SolveFailure;
use peristat_assembly::system::{InPrecision, Level, System};
use peristat_solve::{Ordering, Preconditioner, SparseCholesky};
use peristat_vector::Real;
use std::sync::{Mutex, MutexGuard};

/// The factor of the stiffness of a strip.
pub(super) struct BorderBlock {
    unknowns: Vec<usize>,
    /// The stand-in for the factor that the level has there.
    unit: f64,
    room: Mutex<Room>,
}

struct Room {
    factor: SparseCholesky,
    /// Values before a step, forces, and what the factor makes of them.
    before: Vec<f64>,
    forces: Vec<f64>,
    moved: Vec<f64>,
}

impl BorderBlock {
    /// That of some points of a system.
    pub(super) fn new<const D: usize>(system: &System<D>, points: &[usize]) -> Result<Self, SolveFailure> {
        let (unknowns, matrix) = system.assemble_among(points);
        let mut factor =
            SparseCholesky::analyse(&matrix, Ordering::MinimumDegree).map_err(SolveFailure::Factor)?;
        factor.refactor(&matrix).map_err(SolveFailure::Factor)?;
        let trace: f64 = matrix.diag().iter().map(|(_, value)| *value).sum();
        let none = vec![0.0; unknowns.len()];
        let room = Room { factor, before: none.clone(), forces: none.clone(), moved: none };
        Ok(Self { unit: unknowns.len() as f64 / trace, unknowns, room: Mutex::new(room) })
    }

    /// Entries of the factor.
    pub(super) fn entries(&self) -> usize {
        self.room().factor.fill()
    }

    fn room(&self) -> MutexGuard<'_, Room> {
        self.room.lock().expect("no holder of the lock panics")
    }

    /// Leaves the strip of a level to the factor.
    pub(super) fn lay_bare<const D: usize, R: InPrecision>(&self, level: &mut Level<D, R>) {
        level.lay_bare(&self.unknowns, self.unit);
    }

    /// `step` adds `scale M⁻¹ r` to what `before` says of an unknown, with the stand-in of the level in the strip; puts what
    /// the factor has in its place.
    pub(super) fn take<R: Real>(
        &self,
        before: &dyn Fn(usize, R) -> R,
        x: &mut [R],
        step: impl FnOnce(&mut [R]),
    ) {
        let mut room = self.room();
        let Room { factor, before: kept, forces, moved } = &mut *room;
        kept.iter_mut().zip(&self.unknowns).for_each(|(kept, &k)| *kept = before(k, x[k]).into());
        step(x);
        for ((force, kept), &k) in forces.iter_mut().zip(&*kept).zip(&self.unknowns) {
            *force = (x[k].into() - kept) / self.unit;
        }
        factor.apply(forces, moved);
        for ((moved, kept), &k) in moved.iter().zip(&*kept).zip(&self.unknowns) {
            x[k] = R::of(kept + moved);
        }
    }
}
