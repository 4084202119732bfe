//! How the bonds of a body in the plane soften, and how it is followed.

use super::fracture::{check_load, refuse_reduced};
use crate::case::{PATH_FACTS, Path};
use crate::diagnostic::Faults;
use crate::model::hints;
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::path::{self, PathScene, Softening};
use crate::scene::{fracture, root};

/// The path of a case, with its defaults filled in.
pub(crate) fn resolve(
    path: &mut Path,
    site: &HeldBody,
    probes: &[&str],
    faults: &mut Faults,
) -> Option<PathScene> {
    let (case, place) = (site.ground.case, root("path"));
    if !case.model.softens() {
        faults
            .error(place, "`path` is for bonds that soften, and these are elastic")
            .hint(format!("give \"bond_law\": {{ \"bilinear\": … }} in the model `{}`", hints::SOFTENING));
        return None;
    }
    if !site.conditions.springs.is_empty() {
        faults
            .error(root("supports"), "springs to the ground do not go with `path`")
            .hint("prescribe motions, or hold the place");
        return None;
    }
    let mut exempt = vec![false; site.ground.body.points()];
    for (k, name) in path.no_damage.iter().enumerate() {
        let points = site.ground.region(name, &place.key("no_damage").index(k), faults).unwrap_or_default();
        points.iter().for_each(|&p| exempt[p as usize] = true);
    }
    // A path in a body with images, whose points have other numbers, is refused.
    let gripped = site.conditions.gripped_points().filter(|&p| p < site.ground.body.points());
    gripped.for_each(|p| exempt[p] = true);
    check_load(&path.load, case, &place.key("load"), faults);
    if let Some(opening) = &path.opening {
        refuse_reduced(opening, "opening", case, &place.key("opening"), faults);
    }
    let bonds = site.inputs.material.soften(&site.inputs.on_ground(case), faults)?;
    fracture::check_probes(case, &PATH_FACTS, faults);
    path::resolve(path, Softening { bonds, exempt }, probes, faults)
}
