//! Models with their bodies: terms of the energy, relations and rigid motions.

pub mod timoshenko_beam;

use crate::bonds::Point;
use crate::condition::Equation;
use crate::stiffness::Term;

/// A model with its body: terms of the energy and what belongs to every unknown.
pub trait Model<const D: usize> {
    /// Names of the unknowns of a point.
    const UNKNOWNS: [&'static str; D];

    /// Names of the motions that cost no energy, such as `translation along w`.
    const RIGID_MOTIONS: &'static [&'static str];

    /// Number of points, ghosts included.
    fn points(&self) -> usize;

    /// Position of a point.
    fn position(&self, point: usize) -> Point;

    /// The parts of the energy.
    fn terms(&self) -> Vec<Box<dyn Term<D>>>;

    /// Relations among the unknowns that the discretisation brings with it (images, ghosts).
    fn relations(&self) -> Vec<Equation>;

    /// Unknowns of a point under the unit rigid motion of a kind, an index into
    /// [`RIGID_MOTIONS`](Self::RIGID_MOTIONS); rotations are about `centre`.
    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; D];
}
