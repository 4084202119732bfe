//! Models with their bodies: terms of the energy, relations and rigid motions.

pub mod timoshenko_beam;

use crate::bonds::Point;
use crate::condition::Equation;
use crate::stiffness::Term;

/// A way a body moves without straining.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidMotion<const D: usize> {
    /// What it is, such as `translation along w`.
    pub name: &'static str,
    /// Unknowns of the point under the unit motion.
    pub values: [f64; D],
}

/// A model with its body: terms of the energy and what belongs to every unknown.
pub trait Model<const D: usize> {
    /// Names of the unknowns of a point.
    const UNKNOWNS: [&'static str; D];

    /// Number of points, ghosts included.
    fn points(&self) -> usize;

    /// Position of a point.
    fn position(&self, point: usize) -> Point;

    /// The parts of the energy.
    fn terms(&self) -> Vec<Box<dyn Term<D>>>;

    /// Relations among the unknowns that the discretisation brings with it (images, ghosts).
    fn relations(&self) -> Vec<Equation>;

    /// The motions that cost no energy, at a position.
    fn rigid_motions(&self, position: Point) -> Vec<RigidMotion<D>>;
}
