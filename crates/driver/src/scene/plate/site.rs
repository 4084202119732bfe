//! The points of a plate, and what has a name on it.

use super::border::{Border, Side};
use crate::case::{At, Case};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::site::ground::{Ground, NamedPoints};
use peristat_assembly::body::Outline;
use peristat_assembly::model::plate_bending::PlateNodes;

/// A plate with everything on it that has a name.
pub(super) struct Site<'a> {
    pub(super) case: &'a Case,
    pub(super) outline: &'a Outline,
    pub(super) nodes: &'a PlateNodes,
    /// Names on points.
    pub(super) ground: &'a Ground<'a>,
    /// Names on cells.
    pub(super) cells: &'a Ground<'a>,
    pub(super) border: &'a Border,
}

impl Site<'_> {
    /// Sides of cells on the parts of the border that a name calls; none if it calls no such parts.
    pub(super) fn sides(&self, name: &str) -> Option<Vec<Side>> {
        Some(self.border.of(&self.outline.members(name)?))
    }

    /// The place that `at` names: points of its sides, of a part of the border; `what` is what is placed.
    pub(super) fn spot(
        &self,
        at: &At,
        path: &JsonPath,
        what: &str,
        faults: &mut Faults,
    ) -> Option<NamedPoints> {
        let extrapolated = [("inward", at.inward.is_some()), ("edge", at.edge.is_some())];
        if let Some((key, _)) = extrapolated.into_iter().find(|key| key.1) {
            faults
                .error(
                    path.key(key),
                    format!("`{key}` is for bodies whose points lie in the middle of cells"),
                )
                .hint("a plate in bending has points on its edges: name them by `region`");
            return None;
        }
        let sides = at.region.as_ref().and_then(|name| self.sides(name));
        match sides {
            Some(sides) => {
                self.ground.region_name(at, path, faults)?;
                let name = at.region.as_deref().unwrap_or_default();
                let points = points_of(&sides);
                if points.is_empty() {
                    faults.error(path.key("region"), format!("no point is on `{name}`"));
                    return None;
                }
                Some(NamedPoints { points, words: format!("the region `{name}`") })
            }
            None => self.ground.spot(at, path, what, faults),
        }
    }
}

/// Points of sides, ascending.
pub(super) fn points_of(sides: &[Side]) -> Vec<u32> {
    let mut points: Vec<u32> = sides.iter().flat_map(|side| side.segment.points).collect();
    points.sort_unstable();
    points.dedup();
    points
}
