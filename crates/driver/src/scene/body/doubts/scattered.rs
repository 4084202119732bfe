//! Doubts about solids of listed points that are unevenly spaced: one stress leaves forces on them, and more of them do not help.

use crate::diagnostic::{Faults, root, tidy};
use crate::scene::body::scene::BodyScene;
use peristat_assembly::body::PointBody;

/// Unevenness of the distances to the nearest points: that of a lattice whose points were moved at random by up to a twentieth of a
/// spacing. A bar of points moved by a tenth is 1.5 % too soft with three spacings per horizon.
const UNEVEN: f64 = 0.02;

/// Mean distance to the nearest point, in spacings, below which volumes are not those of the points. That of points thrown at random is
/// 0.55.
const CROWDED: f64 = 0.4;
/// Pairs of points within two spacings, per point, from which they are so crowded.
const MANY: f64 = 250.0;

/// Adds a warning where they are, and one where their volumes are far too large.
pub(super) fn warn(scene: &BodyScene, faults: &mut Faults) {
    let PointBody::Cloud(cloud) = scene.body() else { return };
    if !scene.body().is_solid() {
        return;
    }
    let radius = scene.horizon().min(2.0 * cloud.spacing());
    let is_crowd = cloud.about_pairs(radius) > MANY * cloud.points() as f64;
    let distances = if is_crowd { None } else { cloud.nearest_distances(radius) };
    let place = root("body").key("points");
    if distances.map_or(is_crowd, |[mean, _]| mean < CROWDED * cloud.spacing()) {
        let message = format!(
            "the volumes are those of cubes that are {} wide, and points are much closer to each other",
            tidy(cloud.spacing())
        );
        faults.warning(place.clone(), message).hint("are volumes and coordinates in the same units?");
    }
    let is_exact = scene.material().about().is_exact_at_edges;
    if is_exact && distances.is_some_and(|[_, deviation]| deviation >= UNEVEN) {
        faults
            .warning(
                place,
                "the points are unevenly spaced, and one stress leaves forces on them: a bar of points moved at random by up to a quarter of a spacing is 6 % too soft with two spacings per horizon, 3 % with three, 2 % with four",
            )
            .hint("more points do not help: use a longer horizon, or fill the body with cells, from an STL file or a mesh");
    }
}
