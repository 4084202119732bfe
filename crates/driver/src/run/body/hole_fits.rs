//! Stresses on round holes, from fields fitted to the points around them.

use super::BodyResult;
use super::of_stress::{Medium, of_stress};
use crate::diagnostic::{Faults, JsonPath, tidy};
use crate::scene::body::{BodyProbe, BodyScene, Quantity, is_on};
use peristat_assembly::recovery::hole::HoleFit;

/// A fit that misses a larger share of the displacements gives a warning: one that misses 0.8 % is 4 % off in the stress, one that misses
/// 0.3 % is 1 % off.
const LARGE: f64 = 5e-3;

/// The fit whose hole a place is on.
fn at(result: &BodyResult, place: [f64; 2]) -> Option<&HoleFit> {
    result.hole_fits.iter().find(|fit| is_on(fit.ellipse(), place))
}

/// What a probe of a stress, or of what follows from it, finds on a hole, and the misfit.
pub(super) fn read(scene: &BodyScene, result: &BodyResult, probe: &BodyProbe) -> Option<(f64, f64)> {
    let (Quantity::Field { field, .. }, place) = (&probe.quantity, probe.position?) else { return None };
    let place = [place[0], place[1]];
    let fit = at(result, place)?;
    let [x, y, shear] = fit.at(place).stress;
    let stress = [x, y, shear, 0.0, 0.0, 0.0];
    let point = if scene.materials().is_one() { 0 } else { scene.nearest(place)? };
    let across = scene.model.across_at(point, stress);
    Some((of_stress(field.about().origin, Medium::of(scene), (point, stress), across)?, fit.residual()))
}

/// Adds a warning for every hole whose fields miss much of the displacements around it.
pub(super) fn check(result: &BodyResult, warnings: &mut Faults) {
    for fit in result.hole_fits.iter().filter(|fit| fit.residual() > LARGE) {
        let [x, y] = fit.ellipse().centre.map(tidy);
        let percent = tidy((1000.0 * fit.residual()).round() / 10.0);
        warnings
            .warning(
                JsonPath::default().key("probes"),
                format!("stresses on the hole at ({x}, {y}) are uncertain: the fields around it miss {percent} % of the displacements"),
            )
            .hint("use a smaller spacing");
    }
}
