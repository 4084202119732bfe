//! Modes at the tips and fronts of cracks.

use crate::case::TipQuantity;
use crate::scene::body::read::front::FrontJump;
use crate::scene::body::{BodyScene, Intensity};

/// A stress along x alone.
pub(super) const ALONG_X: [f64; 6] = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];

/// What is reported of a tip in a state: `whole`, or the part of this `√(E' G)` that is of one mode. `u` are the unknowns.
///
/// `K_I² + K_II² = E' G`, and their ratio is that of how the faces part.
pub(super) fn reported(scene: &BodyScene, intensity: &Intensity, whole: f64, u: &[f64]) -> f64 {
    if let Some(front) = &intensity.front {
        return at_front(scene, front, intensity.quantity, u);
    }
    let own = match intensity.quantity {
        TipQuantity::KI => 0,
        TipQuantity::KII => 1,
        TipQuantity::K | TipQuantity::KIII | TipQuantity::EnergyReleaseRate => return whole,
    };
    let Some(jump) = &intensity.jump else { return f64::NAN };
    let points = scene.model.points();
    let planes = [0, 1].map(|axis| scene.model.along(axis).unwrap_or(axis) * points);
    let parts = jump.parts(|p| planes.map(|plane| u[plane + p as usize]));
    let size = parts[0].hypot(parts[1]);
    if size > 0.0 { whole * parts[own] / size } else { 0.0 }
}

/// What is reported of a place of a front: `E' G = K_I² + K_II² + K_III² E'/(2 G)`, with the shear modulus on the right.
fn at_front(scene: &BodyScene, front: &FrontJump, quantity: TipQuantity, u: &[f64]) -> f64 {
    let [first, second, third] = of_front(scene, front, u);
    let modulus = stiffness(scene);
    let square = first * first + second * second + third * third * modulus / (2.0 * shear_modulus(scene));
    match quantity {
        TipQuantity::K => square.sqrt(),
        TipQuantity::KI => first,
        TipQuantity::KII => second,
        TipQuantity::KIII => third,
        TipQuantity::EnergyReleaseRate => square / modulus,
    }
}

/// K_I, K_II and K_III at a place of a front.
pub(super) fn of_front(scene: &BodyScene, front: &FrontJump, u: &[f64]) -> [f64; 3] {
    let points = scene.model.points();
    let planes = [0, 1, 2].map(|axis| scene.model.along(axis).unwrap_or(axis) * points);
    let moduli = [stiffness(scene), shear_modulus(scene)];
    front.modes(moduli, |p| planes.map(|plane| u[plane + p as usize]))
}

/// E' of an isotropic material, and 2 G of one in antiplane shear, Pa.
pub(super) fn stiffness(scene: &BodyScene) -> f64 {
    let [along, across, ..] = scene.model.strains_of(ALONG_X, 0.0);
    let modulus = 1.0 / along;
    if scene.model.as_solid().is_some() {
        // The front of a crack in a solid does not stretch along itself.
        modulus / (1.0 - (across / along).powi(2))
    } else if scene.model.along(0).is_some() {
        modulus
    } else {
        2.0 * modulus
    }
}

/// Shear modulus of an isotropic material, Pa.
fn shear_modulus(scene: &BodyScene) -> f64 {
    let [along, across, ..] = scene.model.strains_of(ALONG_X, 0.0);
    0.5 / (along - across)
}
