//! A body with its names, its model and what holds it: what probes, cracks that grow and bonds that soften are resolved on.

use super::conditions::Conditions;
use super::supported::BodySupport;
use super::supports::HeldSupport;
use crate::scene::body::site::cracks::NamedCrack;
use crate::scene::body::site::ground::Ground;
use crate::scene::body::site::interpolate::Interpolation;
use crate::scene::body::site::model_inputs::ModelInputs;
use peristat_assembly::body::Outline;
use peristat_assembly::model::BodyModel;

/// What readings and failure of a body are resolved on.
pub(crate) struct HeldBody<'a> {
    /// The body, with every name on it.
    pub(crate) ground: &'a Ground<'a>,
    /// The outline; listed points have none.
    pub(crate) outline: Option<&'a Outline>,
    /// What numbers the points of the body in the model.
    pub(crate) inputs: &'a ModelInputs,
    /// The discretised body.
    pub(crate) model: &'a dyn BodyModel,
    /// Cracks, images left out.
    pub(crate) cracks: &'a [NamedCrack],
    /// How values between points follow from those of points.
    pub(crate) interpolation: &'a Interpolation<'a>,
    /// The supports.
    pub(crate) held: &'a [HeldSupport],
    /// The same by points.
    pub(crate) conditions: &'a Conditions,
    /// Which of these belong to which support.
    pub(crate) supports: &'a [BodySupport],
}
