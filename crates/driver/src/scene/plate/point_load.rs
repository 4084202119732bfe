//! Forces and moments at places of a plate.

use super::plate_loads::PlateLoads;
use super::site::Site;
use super::statics;
use crate::case::PointLoad;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::site::interpolate::{Interpolation, Weights};

/// Adds a force or moments at a place: shared by the four points around it, so that they have their resultant, or alike by the
/// points of a region.
pub(super) fn add(load: &PointLoad, site: &Site, path: &JsonPath, to: &mut PlateLoads, faults: &mut Faults) {
    let foreign = [
        ("axial", load.axial != 0.0),
        ("force_x", load.force_x != 0.0),
        ("force_y", load.force_y != 0.0),
        ("force_z", load.force_z != 0.0),
        ("moment", load.moment != 0.0),
        ("moment_z", load.moment_z != 0.0),
        ("spread", load.spread),
    ];
    for (key, _) in foreign.iter().filter(|key| key.1) {
        faults
            .error(path.key(*key), format!("`{key}` does not act on plates in bending"))
            .hint("give `force`, `moment_x` or `moment_y`");
    }
    let acting = [load.force, load.moment_x, load.moment_y];
    if acting == [0.0; 3] && !foreign.iter().any(|key| key.1) {
        faults.error(path.clone(), "this load is zero").hint("give `force`, `moment_x` or `moment_y`");
    }
    let Some(spot) = site.spot(&load.at, &path.key("at"), "the load", faults) else { return };
    let shares: Weights = match (load.at.x, load.at.y, &spot.points[..]) {
        (Some(x), Some(y), &[nearest]) => {
            Interpolation { body: site.ground.body, cracks: &[], reach: 1 }.at([x, y, 0.0], nearest)
        }
        (.., points) => points.iter().map(|&p| (p, 1.0 / points.len() as f64)).collect(),
    };
    let n = site.nodes.points();
    let mut middle = [0.0; 2];
    for &(point, share) in &shares {
        let place = site.nodes.place(point as usize);
        (0..2).for_each(|k| middle[k] += share * place[k]);
        for (component, part) in acting.into_iter().enumerate() {
            to.force[component * n + point as usize] += share * part;
        }
    }
    let asked = [load.at.x.unwrap_or(middle[0]), load.at.y.unwrap_or(middle[1])];
    statics::act(&mut to.asked, acting, asked);
}
