//! Lines of symmetry of a plate: it does not turn across them.

use super::restraints::{Place, Restraints};
use super::site::{Site, points_of};
use crate::diagnostic::{Faults, JsonPath, root, suggest};
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::plate_bending::{PHI_X, PHI_Y};

/// The sides that a case may name.
const SIDES: [(&str, usize); 4] = [("left", PHI_X), ("right", PHI_X), ("bottom", PHI_Y), ("top", PHI_Y)];

/// Adds what lines of symmetry hold.
pub(super) fn hold(site: &Site, held: &mut Restraints, faults: &mut Faults) {
    for (k, name) in site.case.symmetry.iter().enumerate() {
        let path = root("symmetry").index(k);
        let Some(&(_, component)) = SIDES.iter().find(|side| side.0 == name) else {
            faults
                .error(path, format!("there is no side `{name}`"))
                .hint(suggest(name, SIDES.iter().map(|side| side.0)));
            continue;
        };
        let Some(sides) = site.sides(name).filter(|sides| sides.iter().all(|side| side.is_true)) else {
            faults
                .error(path, format!("`{name}` is no straight side of this plate"))
                .hint("lines of symmetry are sides of a rectangle");
            continue;
        };
        let equation = |point: u32| Equation {
            terms: vec![(Unknown { component, point: point as usize }, 1.0)],
            value: 0.0,
            origin: path.to_string(),
        };
        let points = points_of(&sides);
        let equations = points.iter().map(|&point| (equation(point), Vec::new())).collect();
        let place = Place { name: format!("symmetry `{name}`"), points, sides, is_mirror: true };
        held.take(place, equations, Vec::new());
    }
}

/// A fault for an edge that is a line of symmetry.
pub(super) fn not_mirrored(site: &Site, edge: &str, path: &JsonPath, faults: &mut Faults) {
    if site.case.symmetry.iter().any(|name| name == edge) {
        faults
            .error(path.clone(), format!("the edge `{edge}` is a line of symmetry, no edge of the plate"))
            .hint("the other half goes on behind it, and holds its rotation across: remove one of both");
    }
}
