//! Stresses on round holes, from fields fitted to the points around them.

use super::BodyResult;
use super::of_stress::{Medium, of_stress};
use crate::diagnostic::{Faults, JsonPath, tidy};
use crate::scene::body::{BodyProbe, BodyScene, HoleRing, Quantity, is_on};
use peristat_assembly::recovery::hole::HoleFit;

/// A fit that misses a larger share of the displacements gives a warning: one that misses 0.8 % is 4 % off in the stress, one that misses
/// 0.3 % is 1 % off.
const LARGE: f64 = 5e-3;

/// Spacings per radius of curvature below which stresses that are continued onto a hole miss its peak. In tension the peak at a
/// circle, which an edge cuts so that it has no fit, is 28, 23, 8, 3 % too small with 2, 3, 5, 7 of them.
const SHARP: f64 = 6.0;
/// A probe is on a hole that is no farther away, in spacings.
const BESIDE: f64 = 0.05;

/// Adds a warning for every hole on which a probe asks for a stress that neither fields around it nor the points beside it can tell.
pub(super) fn check_sharp(scene: &BodyScene, rings: &[HoleRing], warnings: &mut Faults) {
    // Polynomials of the local limit know the tractions on the hole, and what they miss.
    let Some(outline) = scene.outline().filter(|_| scene.limit.is_none()) else { return };
    let spacing = scene.body().spacing();
    let asked =
        |probe: &BodyProbe| Some([probe.position?[0], probe.position?[1]]).filter(|_| probe.is_recovered());
    for hole in outline.holes() {
        let is_told = |place: &[f64; 2]| rings.iter().any(|ring| ring.holds(*place));
        let on_it = scene.probes.iter().filter_map(asked);
        let on_it = on_it.filter(|place| hole.shape.distance(*place) <= BESIDE * spacing && !is_told(place));
        let radii = on_it.filter_map(|place| hole.shape.radius_at(place)).map(|radius| radius / spacing);
        let sharpest = radii.fold(f64::INFINITY, f64::min);
        if sharpest < SHARP {
            let radii = tidy((10.0 * sharpest).round() / 10.0);
            let name = hole.name.as_ref().map_or("a hole".to_string(), |name| format!("the hole `{name}`"));
            warnings
                .warning(
                    JsonPath::default().key("probes"),
                    format!("stresses on {name} are continued from the points beside it, {radii} spacings per radius of curvature: a peak there is too small, by 8 % with 5 and by 25 % with 3 of them"),
                )
                .hint("use a smaller spacing; on round and elliptic holes with nothing else near, fields around the hole tell the stress");
        }
    }
}

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
