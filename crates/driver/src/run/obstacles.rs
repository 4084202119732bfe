//! What is known of a scene that stands in the way of a solution.

use super::error::RunError;
use crate::scene::Scene;

/// Whether there is no such thing.
///
/// # Errors
/// [`RunError::Case`] with what there is.
pub(crate) fn can_be_solved(scene: &Scene) -> Result<(), RunError> {
    scene.warnings().obstacles().map_or(Ok(()), |faults| Err(RunError::Case(faults)))
}
