//! Cracks of a body.

use super::files;
use super::model_inputs::ModelInputs;
use crate::case::{Case, CrackDisc, GivenCrack};
use crate::diagnostic::{Faults, JsonPath, root};
use crate::input::Folder;
use peristat_assembly::body::{Crack, CrackError, CrackSurface, CrackSurfaceError, Outline};

/// A crack with its name.
#[derive(Clone, Debug)]
pub struct NamedCrack {
    /// Name; its number if the case gives none.
    pub name: String,
    /// Where it is.
    pub crack: Crack,
}

/// Cracks of the case, in a solid or in the plane; `None` if one of them has a fault.
pub(crate) fn cracks(
    (case, is_solid): (&Case, bool),
    folder: &Folder,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<Vec<NamedCrack>> {
    let mut cracks: Vec<NamedCrack> = Vec::new();
    for (k, given) in case.cracks.iter().enumerate() {
        let path = root("cracks").index(k);
        let name = given.name.clone().unwrap_or_else(|| (k + 1).to_string());
        if cracks.iter().any(|c| c.name == name) {
            faults
                .error(path.key("name"), format!("there are two cracks `{name}`"))
                .hint("a crack without a name is called by its number, the first is 1");
        }
        let crack = match is_solid {
            true => surface(given, folder, max_memory, &path, faults),
            false => line(given, &path, faults),
        };
        cracks.extend(crack.map(|crack| NamedCrack { name, crack }));
    }
    (cracks.len() == case.cracks.len()).then_some(cracks)
}

/// A crack in the plane.
fn line(given: &GivenCrack, path: &JsonPath, faults: &mut Faults) -> Option<Crack> {
    let surfaces = [
        ("disc", given.disc.is_some()),
        ("polygon", given.polygon.is_some()),
        ("file", given.file.is_some()),
    ];
    if let Some((key, _)) = surfaces.into_iter().find(|surface| surface.1) {
        faults
            .error(path.key(key), "a surface is a crack in a solid")
            .hint("give the `path` of the crack in the plane, from end to end");
        return None;
    }
    let Some(vertices) = &given.path else {
        faults
            .error(path.clone(), "`path` is missing")
            .hint("positions from end to end, such as [[0, 5], [3, 5]]");
        return None;
    };
    let refuse = |error: CrackError| {
        let place = path.key("path");
        let place = match &error {
            CrackError::TooFewVertices { .. } => place,
            CrackError::NotFinite { vertex } | CrackError::Repeated { vertex } => place.index(vertex - 1),
        };
        faults.error(place, error.to_string());
    };
    Crack::new(vertices.clone()).map_err(refuse).ok()
}

/// A crack in a solid.
fn surface(
    given: &GivenCrack,
    folder: &Folder,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Crack> {
    const HINT: &str = "give a `disc`, a `polygon`, or the `file` of a surface";
    if given.path.is_some() {
        faults.error(path.key("path"), "a `path` is a crack in the plane").hint(HINT);
        return None;
    }
    let (key, made) = match (&given.disc, &given.polygon, &given.file) {
        (Some(disc), None, None) => {
            let CrackDisc { centre, normal, radius, inner_radius } = disc.clone();
            ("disc", CrackSurface::disc(centre, normal, [inner_radius.unwrap_or(0.0), radius]))
        }
        (None, Some(corners), None) => ("polygon", CrackSurface::polygon(corners)),
        (None, None, Some(file)) => {
            let facets = files::surface(folder, file, max_memory, path, faults)?;
            ("file", CrackSurface::triangles(facets.into_iter().map(|facet| facet.corners)))
        }
        (None, None, None) => {
            faults.error(path.clone(), "this crack is nowhere").hint(HINT);
            return None;
        }
        _ => {
            faults.error(path.clone(), "a crack is one surface").hint("make two cracks of it");
            return None;
        }
    };
    let refuse = |error: CrackSurfaceError| {
        let place = path.key(key);
        let (place, hint) = match error {
            CrackSurfaceError::NoNormal => (place.key("normal"), "such as [0, 0, 1]"),
            CrackSurfaceError::NoRadius => {
                (place.key("radius"), "`inner_radius` is that of what stays whole")
            }
            CrackSurfaceError::NotFlat { corner } => (
                place.index(corner - 1),
                "make several cracks of it, each in a plane, or give the `file` of a surface",
            ),
            _ => (place, "corners follow each other around the crack"),
        };
        faults.error(place, error.to_string()).hint(hint);
    };
    made.map(Crack::from).map_err(refuse).ok()
}

/// Faults of cracks that are nowhere near the body, and warnings of those that cut nothing.
pub(crate) fn check(
    cracks: &[NamedCrack],
    outline: Option<&Outline>,
    (inputs, is_built): (&ModelInputs, bool),
    faults: &mut Faults,
) {
    let [low, high] = match outline {
        Some(outline) => outline.bounds(),
        None => {
            let points = (0..inputs.body.points()).map(|p| inputs.body.place(p));
            points.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], p| {
                [[0, 1].map(|k| low[k].min(p[k])), [0, 1].map(|k| high[k].max(p[k]))]
            })
        }
    };
    let as_cut = inputs.as_cut(&cracks.iter().map(|named| named.crack.clone()).collect::<Vec<Crack>>());
    for (k, named) in cracks.iter().enumerate() {
        let path = root("cracks").index(k);
        let path = if named.crack.surface().is_none() { path.key("path") } else { path };
        let vertices = named.crack.vertices();
        let beyond = |axis: usize| {
            vertices.iter().all(|v| v[axis] < low[axis]) || vertices.iter().all(|v| v[axis] > high[axis])
        };
        if named.crack.surface().is_none() && (0..2).any(beyond) {
            faults.error(path, format!("the crack `{}` is outside of the body", named.name)).hint(format!(
                "the body reaches from ({}, {}) to ({}, {})",
                low[0], low[1], high[0], high[1]
            ));
        } else if is_built && !inputs.is_cut_by(&as_cut[k]) {
            faults
                .warning(path, format!("the crack `{}` cuts no bond", named.name))
                .hint("a crack smaller than the spacing, in a hole or outside of the body does nothing");
        } else if inputs.is_cut_by_image_of(&named.crack) {
            faults
                .error(
                    path,
                    format!(
                        "the crack `{}` reaches beyond a mirror, so that its image cuts the body",
                        named.name
                    ),
                )
                .hint("end it on the mirror: the other half is its image");
        }
    }
}
