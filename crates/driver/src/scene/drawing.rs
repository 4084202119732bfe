//! What can be drawn of a case.

use super::Scene;
use crate::case::{Arrows, Body, Case, FieldName, Signs};
use crate::diagnostic::{Faults, root};
use peristat_assembly::body::PointBody;

/// Isolines of a map, at most: more are a grey area.
const MOST_ISOLINES: usize = 50;

/// Adds faults of a drawing that no result of the case has.
pub(super) fn check(case: &Case, faults: &mut Faults) {
    let (drawing, path) = (&case.drawing, root("drawing"));
    if drawing.signs != Signs::Fields && !matches!(case.body, Body::Line(_) | Body::Lines(_) | Body::Frame(_))
    {
        faults
            .error(path.key("signs"), "`signs` are those of section forces, and this body has none")
            .hint("leave `signs` out; maps may have `isolines` and `arrows`");
    }
    if let Some(count) = drawing.isolines.filter(|count| !(1..=MOST_ISOLINES).contains(count)) {
        let message = format!("`isolines` must be from 1 to {MOST_ISOLINES}, found {count}");
        faults.error(path.key("isolines"), message);
    }
}

/// The faults of what is to be drawn on maps of a scene that has no such maps or fields.
pub(super) fn check_maps(scene: &Scene) -> Faults {
    let mut faults = Faults::default();
    let (drawing, path) = (&scene.case().drawing, root("drawing"));
    let is_plane = matches!(scene, Scene::Body(body) if !body.body().is_solid());
    let asked = [("isolines", drawing.isolines.is_some()), ("arrows", drawing.arrows.is_some())];
    for (key, _) in asked.iter().filter(|(_, asked)| *asked && !is_plane) {
        faults
            .error(
                path.key(*key),
                format!("`{key}` are drawn on maps of bodies in the plane, and this is none"),
            )
            .hint("`report.html` and the `.vtu` files show bodies of other kinds");
    }
    let needed: &[FieldName] = match drawing.arrows {
        Some(Arrows::Displacement) => &[FieldName::Ux, FieldName::Uy],
        Some(Arrows::PrincipalStress) => &[FieldName::StressXx, FieldName::StressYy, FieldName::StressXy],
        None => &[],
    };
    if drawing.isolines.is_some()
        && is_plane
        && matches!(scene, Scene::Body(body) if matches!(body.body(), PointBody::Cloud(_)))
    {
        faults
            .error(
                path.key("isolines"),
                "`isolines` run between the points of a lattice, and these points have none",
            )
            .hint("an `outline` fills the border of a mesh or a drawing with a lattice");
    }
    let askable = scene.askable();
    if let Some(missing) = needed.iter().find(|field| is_plane && !askable.contains(field)) {
        let message = format!("these arrows need the field `{}`, which this body has not", missing.name());
        faults.error(path.key("arrows"), message).hint("leave `arrows` out");
    }
    faults
}
