//! A body with its names, its model and what holds it: what probes, cracks that grow and bonds that soften are resolved on.

use super::conditions::Conditions;
use super::cracks::NamedCrack;
use super::ground::Ground;
use super::interpolate::Interpolation;
use super::model::Recipe;
use super::supports::Held;
use peristat_assembly::body::Outline;
use peristat_assembly::model::plane::PlaneModel;

/// What readings and failure of a body are resolved on.
pub(super) struct Site<'a> {
    /// The body, with every name on it.
    pub(super) ground: &'a Ground<'a>,
    /// The outline; listed points have none.
    pub(super) outline: Option<&'a Outline>,
    /// What numbers the points of the body in the model.
    pub(super) recipe: &'a Recipe,
    /// The discretised body.
    pub(super) model: &'a dyn PlaneModel,
    /// Cracks, images left out.
    pub(super) cracks: &'a [NamedCrack],
    /// How values between points follow from those of points.
    pub(super) interpolation: &'a Interpolation<'a>,
    /// The supports.
    pub(super) held: &'a [Held],
    /// The same by points.
    pub(super) conditions: &'a Conditions,
}
