//! Cracks of a body in the plane.

use crate::case::Case;
use crate::diagnostic::{Faults, root};
use peristat_assembly::body::{Crack, CrackError, Outline, PointBody};

/// A crack with its name.
#[derive(Clone, Debug)]
pub struct NamedCrack {
    /// Name; its number if the case gives none.
    pub name: String,
    /// Its path.
    pub crack: Crack,
}

/// Cracks of the case; `None` if one of them has a fault.
pub(crate) fn cracks(case: &Case, faults: &mut Faults) -> Option<Vec<NamedCrack>> {
    let mut cracks: Vec<NamedCrack> = Vec::new();
    for (k, given) in case.cracks.iter().enumerate() {
        let path = root("cracks").index(k);
        let name = given.name.clone().unwrap_or_else(|| (k + 1).to_string());
        if cracks.iter().any(|c| c.name == name) {
            faults
                .error(path.key("name"), format!("there are two cracks `{name}`"))
                .hint("a crack without a name is called by its number, the first is 1");
        }
        match Crack::new(given.path.clone()) {
            Ok(crack) => cracks.push(NamedCrack { name, crack }),
            Err(error) => {
                let place = path.key("path");
                let place = match &error {
                    CrackError::TooFewVertices { .. } => place,
                    CrackError::NotFinite { vertex } | CrackError::Repeated { vertex } => {
                        place.index(vertex - 1)
                    }
                };
                faults.error(place, error.to_string());
            }
        }
    }
    (cracks.len() == case.cracks.len()).then_some(cracks)
}

/// Faults of cracks that are nowhere near the body, and warnings of those that cut nothing.
pub(crate) fn check(
    cracks: &[NamedCrack],
    body: &PointBody,
    outline: Option<&Outline>,
    cuts_any: &dyn Fn(&Crack) -> bool,
    faults: &mut Faults,
) {
    let [low, high] = match outline {
        Some(outline) => outline.bounds(),
        None => {
            let points = (0..body.points()).map(|p| body.place(p));
            points.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], p| {
                [[0, 1].map(|k| low[k].min(p[k])), [0, 1].map(|k| high[k].max(p[k]))]
            })
        }
    };
    for (k, named) in cracks.iter().enumerate() {
        let path = root("cracks").index(k).key("path");
        let vertices = named.crack.vertices();
        let outside = (0..2).any(|axis| {
            vertices.iter().all(|v| v[axis] < low[axis]) || vertices.iter().all(|v| v[axis] > high[axis])
        });
        if outside {
            faults.error(path, format!("the crack `{}` is outside of the body", named.name)).hint(format!(
                "the body reaches from ({}, {}) to ({}, {})",
                low[0], low[1], high[0], high[1]
            ));
        } else if !cuts_any(&named.crack) {
            faults
                .warning(path, format!("the crack `{}` cuts no bond", named.name))
                .hint("a crack shorter than the spacing, or in a hole, does nothing");
        }
    }
}
