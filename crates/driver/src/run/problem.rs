//! What a run needs of a scene, whatever its model.

use super::coarser::Coarser;
use super::corrections::Corrections;
use crate::case::Solver;
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::stiffness::Spring;
use peristat_assembly::system::{FreeMotion, System};
use peristat_solve::SmoothVectors;

/// Points beyond which a factor takes more memory than most machines have.
pub(crate) const TOO_MANY_POINTS: usize = 500_000;

/// A model with its conditions and right-hand sides.
pub trait Problem<const D: usize> {
    /// The model with its body.
    fn model(&self) -> &dyn Model<D>;

    /// Springs to the ground.
    fn springs(&self) -> &[Spring];

    /// Equations of supports and links; their origins are paths into the case.
    fn equations(&self) -> &[Equation];

    /// The solver that is asked for.
    fn solver(&self) -> Solver;

    /// Number of right-hand sides.
    fn states(&self) -> usize;

    /// Whether bonds break: a factor is kept to the end.
    fn breaks(&self) -> bool {
        false
    }

    /// Adds the loads of a state to `force`, `D` planes, and returns the factor on prescribed motions.
    fn add_load(&self, state: usize, force: &mut [f64]) -> f64;

    /// Right-hand sides of the equations in a state whose motions are no multiple of these; none where they are, by the factor of
    /// [`add_load`](Self::add_load).
    fn motions(&self, _state: usize) -> Option<Vec<f64>> {
        None
    }

    /// How its points lie.
    fn spread(&self) -> Spread {
        Spread::Chain
    }

    /// Points beyond which a factor takes more than it gives.
    fn most_factored(&self) -> usize {
        TOO_MANY_POINTS
    }

    /// Memory that a solid on a lattice takes, bytes, with its factor or solved by iterations; none of other bodies.
    fn solid_bytes(&self, _with_factor: bool) -> Option<usize> {
        None
    }

    /// Whether the coarser levels of a cycle are assembled.
    fn has_matrices(&self) -> bool {
        false
    }

    /// Memory that the coarsest level of a cycle takes and its allocator keeps for the rest of a run, bytes.
    fn kept_bytes(&self) -> usize {
        0
    }

    /// Points of the coarsest level of a cycle, where its factor takes memory.
    fn coarsest_points(&self) -> usize {
        0
    }

    /// Positions of the points, where they spread in a plane: their factor is ordered by them.
    fn positions(&self) -> Option<Vec<[f64; 2]>> {
        None
    }

    /// The coarser levels of a multigrid cycle, where the points are those of a lattice.
    fn coarser(&self, _system: &System<D>) -> Option<Coarser<D>> {
        None
    }

    /// Motions so soft that the rounding of a factor hides them, where there are such.
    fn soft_motions(&self, _system: &System<D>) -> Option<Box<dyn SmoothVectors>> {
        None
    }

    /// Whether displacements are corrected.
    fn is_corrected(&self) -> bool {
        false
    }

    /// What displacements of a state become that are corrected by their residual in equilibrium, at most so many times; `solve` finds
    /// the displacement of a load, in `D` planes, without prescribed motions. None where they stay as they are.
    fn corrected(
        &self,
        _state: usize,
        _from: (&[f64], usize),
        _solve: &mut dyn FnMut(&[f64]) -> Vec<f64>,
    ) -> Option<(Vec<f64>, Corrections)> {
        None
    }

    /// A free motion in words, such as `the beam from x = 0 to 1 is free to move along w: no support or link prevents it`.
    fn describe(&self, motion: &FreeMotion) -> String;

    /// The part that moves in words, where nothing holds it at all and it is not everything: one fault then tells all of its
    /// motions.
    fn describe_loose(&self, _motion: &FreeMotion) -> Option<String> {
        None
    }

    /// What would hold a free motion, for a hint.
    fn remedy(&self) -> &'static str;
}

/// How the points of a problem lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spread {
    /// Along lines.
    Chain,
    /// In a plane.
    Plane,
    /// In space.
    Solid,
    /// In a plane or in space, on a lattice that has coarser ones.
    Lattice,
}
