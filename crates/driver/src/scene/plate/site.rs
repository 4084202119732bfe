//! The points of a plate, and what has a name on it.

use super::border::{Border, Side};
use crate::case::{At, Case};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::site::ground::{Ground, NamedPoints};
use peristat_assembly::body::Outline;
use peristat_assembly::model::plate_bending::{PHI_X, PHI_Y, PlateNodes};

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

    /// Points next to each other among some that are in one row or one column, with the component of the rotation along it; none of
    /// others.
    pub(super) fn steps_of_line(&self, points: &[u32]) -> Vec<(usize, [u32; 2])> {
        let node = |point: u32| self.nodes.node(point as usize);
        let mut steps = Vec::new();
        for (axis, along) in [(0, PHI_X), (1, PHI_Y)] {
            let across = 1 - axis;
            if !points.windows(2).all(|pair| node(pair[0])[across] == node(pair[1])[across]) {
                continue;
            }
            for &from in points {
                let mut next = node(from);
                next[axis] += 1;
                let to = self.nodes.number(next).map(|to| to as u32);
                let to = to.filter(|to| points.binary_search(to).is_ok());
                let to = to.filter(|_| self.nodes.is_joined(node(from), axis));
                steps.extend(to.map(|to| (along, [from, to])));
            }
        }
        steps
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
