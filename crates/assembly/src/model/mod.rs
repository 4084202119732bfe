//! Models with their bodies: terms of the energy, relations and rigid motions.

pub mod beam_bond_orthotropic;
mod body;
pub mod bond_antiplane;
pub mod bond_plane;
pub mod bond_solid;
mod breaking;
mod cloud;
pub mod plane;
pub mod plate_bending;
mod points;
pub mod shell_membrane;
pub mod solid;
pub mod state_based;
pub mod state_solid;
pub mod timoshenko_beam;

pub use body::{BodyFields, BodyModel};
pub use breaking::Breakable;
pub use points::{Component, Points, RigidMotion};

use crate::bonds::Point;
use crate::condition::Equation;
use crate::stiffness::{ConnectedParts, NumberedParts, Term};

/// Sizes of the terms of a model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ModelSizes {
    /// Largest difference of the numbers of two coupled points.
    pub reach: usize,
    /// Elements, such as bonds.
    pub elements: usize,
    /// Entries of one triangle of the stiffness that can be other than zero, those of several elements counted each.
    pub entries: usize,
    /// Memory of all that is kept per element, bytes.
    pub bytes: usize,
}

impl ModelSizes {
    /// Sizes of a term that couples so many pairs of points, those of several elements counted each.
    pub(crate) fn of<const D: usize>(term: &dyn Term<D>, couplings: usize) -> Self {
        Self {
            reach: term.reach(),
            elements: term.elements(),
            entries: D * D * couplings,
            bytes: size_of::<f64>() * term.stored_factors(),
        }
    }

    /// Sizes of both together.
    pub fn join(self, other: Self) -> Self {
        Self {
            reach: self.reach.max(other.reach),
            elements: self.elements + other.elements,
            entries: self.entries + other.entries,
            bytes: self.bytes + other.bytes,
        }
    }
}

/// A model with its body: terms of the energy and what belongs to every unknown.
pub trait Model<const D: usize>: Points {
    /// The motions that cost no energy.
    fn rigid_motions(&self) -> &'static [RigidMotion];

    /// The parts of the energy.
    fn terms(&self) -> Vec<Box<dyn Term<D>>>;

    /// Parts of the body that hang together.
    fn connected(&self) -> NumberedParts {
        let mut parts = ConnectedParts::new(self.points());
        self.terms().iter().for_each(|term| term.join(&mut parts));
        parts.numbered()
    }

    /// Sizes of the terms. A model whose terms take much memory says them without building any.
    fn sizes(&self) -> ModelSizes {
        let terms = self.terms();
        let sizes = terms.iter().map(|term| ModelSizes::of(&**term, term.elements()));
        sizes.fold(ModelSizes::default(), ModelSizes::join)
    }

    /// Relations among the unknowns that the discretisation brings with it (images, ghosts).
    fn relations(&self) -> Vec<Equation>;

    /// Number of unknowns that nothing reads.
    fn idle(&self) -> usize {
        0
    }

    /// Whether nothing reads an unknown.
    fn is_idle(&self, _component: usize, _point: usize) -> bool {
        false
    }

    /// Unknowns of a point under the unit rigid motion of a kind, an index into
    /// [`rigid_motions`](Self::rigid_motions); rotations are about `centre`.
    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; D];

    /// The same of consecutive points, of which `first` is the first.
    fn rigid_motions_from(&self, kind: usize, first: usize, centre: Point, out: &mut [[f64; D]]) {
        out.iter_mut()
            .enumerate()
            .for_each(|(k, motion)| *motion = self.rigid_motion(kind, first + k, centre));
    }

    /// Relative error of the numbers that the model is made of, such as weights that were found by solving; what no residual
    /// shows.
    fn calibration_error(&self) -> f64 {
        8.0 * f64::EPSILON
    }

    /// Root of the largest ratio of the moduli of two strains, at least 1: errors that are small in energy norm may be larger
    /// by as much in the softer strain, and in the stress of the stiffer one.
    fn contrast(&self) -> f64 {
        1.0
    }

    /// Root of the largest over the smallest modulus of points of several materials.
    fn contrast_of_points(&self) -> f64 {
        1.0
    }

    /// How far a unit rigid motion moves a point: m, or m per rad. Unlike unknowns, this compares motions of all kinds.
    fn displacement(&self, kind: usize, point: usize, centre: Point) -> f64 {
        let motion = self.rigid_motion(kind, point, centre).into_iter().zip(self.components());
        motion.filter(|(_, of)| !of.is_rotation).fold(0.0, |sum, (value, _)| value.hypot(sum))
    }
}
