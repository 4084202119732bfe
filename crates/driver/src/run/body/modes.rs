//! K_I and K_II of the tips of cracks.

use crate::case::TipQuantity;
use crate::scene::body::{BodyScene, Intensity};

/// What is reported of a tip in a state: `whole`, or the part of this `√(E' G)` that is of one mode. `u` are the unknowns.
///
/// `K_I² + K_II² = E' G`, and their ratio is that of how the faces part.
pub(super) fn reported(scene: &BodyScene, intensity: &Intensity, whole: f64, u: &[f64]) -> f64 {
    let own = match intensity.quantity {
        TipQuantity::K | TipQuantity::EnergyReleaseRate => return whole,
        TipQuantity::KI => 0,
        TipQuantity::KII => 1,
    };
    let Some(jump) = &intensity.jump else { return f64::NAN };
    let points = scene.model.points();
    let planes = [0, 1].map(|axis| scene.model.along(axis).unwrap_or(axis) * points);
    let parts = jump.parts(|p| planes.map(|plane| u[plane + p as usize]));
    let size = parts[0].hypot(parts[1]);
    if size > 0.0 { whole * parts[own] / size } else { 0.0 }
}
