//! Regions and places of a body by the names that a case gives them.

use super::border_names::{self, List};
use super::regions;
use crate::case::{At, Case, Names};
use crate::diagnostic::{Faults, JsonPath, root, suggest};
use crate::scene::words;
use peristat_assembly::body::{
    Group, Outline, PointBody, Region, RegionError, Regions, SolidRegion, Wall, WallKind, in_space,
};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::SQRT_2;

/// A body with everything on it that has a name.
pub(crate) struct Ground<'a> {
    /// The case.
    pub(crate) case: &'a Case,
    /// The points.
    pub(crate) body: &'a PointBody,
    /// The outline; listed points have none.
    pub(crate) outline: Option<&'a Outline>,
    /// The walls of a solid.
    pub(crate) walls: &'a [Wall],
    /// Parts of a solid that have names.
    parts: &'a [Group],
    /// Regions of the case, and edges, faces, holes and groups as regions.
    named: BTreeMap<String, Region>,
    /// Names among them that no hint tells: chords, lists and the whole border.
    aside: BTreeSet<String>,
    /// Lists that have their faults already.
    refused: BTreeSet<String>,
}

/// A place that was found.
#[derive(Clone, Debug)]
pub(crate) struct NamedPoints {
    /// Its points, ascending.
    pub(crate) points: Vec<u32>,
    /// What messages call it, such as `the region `left`` or `(1, 2)`.
    pub(crate) words: String,
}

/// A place is on a border that is no farther from it, in spacings: places are written with three or four digits, and arcs are chords.
const ON_BORDER: f64 = 1e-3;

/// How a place in the plane is written, for hints.
pub(crate) const PLACE: &str =
    r#"a place in the plane is written { "x": 1.0, "y": 0.5 } or { "region": "left" }"#;

/// The same in space.
const PLACE_IN_SPACE: &str =
    r#"a place in a solid is written { "x": 1.0, "y": 0.5, "z": 0.2 } or { "region": "left" }"#;

impl<'a> Ground<'a> {
    /// The names of a body; faults of all regions of the case.
    pub(crate) fn new(
        case: &'a Case,
        body: &'a PointBody,
        (outline, walls, parts): (Option<&'a Outline>, &'a [Wall], &'a [Group]),
        faults: &mut Faults,
    ) -> Self {
        let mut named = BTreeMap::new();
        let mut kinds = BTreeMap::new();
        let mut take = |name: &str, kind: &'static str, region: Region| {
            named.insert(name.to_string(), region);
            kinds.insert(name.to_string(), kind);
        };
        let mut aside = BTreeMap::new();
        let on_border = |name: &str| Region::Edge { name: name.into(), depth: None };
        for edge in outline.map_or(&[][..], Outline::edges) {
            match edge.is_chord {
                true => drop(aside.insert(edge.name.clone(), on_border(&edge.name))),
                false => take(&edge.name, "an edge", on_border(&edge.name)),
            }
        }
        for group in outline.map_or(&[][..], Outline::groups) {
            match group.is_known {
                true => take(&group.name, "an edge", on_border(&group.name)),
                false => drop(aside.insert(group.name.clone(), on_border(&group.name))),
            }
        }
        for name in outline.map_or(&[][..], Outline::holes).iter().filter_map(|h| h.name.as_ref()) {
            take(name, "a hole", Region::Hole { name: name.clone(), depth: None });
        }
        for Wall { name, kind, .. } in walls {
            let (kind, region) = match kind {
                WallKind::Face(_) | WallKind::Surface => {
                    ("a face", SolidRegion::Face { name: name.clone(), depth: None })
                }
                WallKind::Cut { .. } => ("a cut", SolidRegion::Cut { name: name.clone() }),
            };
            take(name, kind, Region::Solid(region));
        }
        let groups = if let PointBody::Cloud(cloud) = body { cloud.groups() } else { parts };
        for group in groups {
            take(&group.name, "a group of the mesh", Region::Group { name: group.name.clone() });
        }
        for (name, region) in &case.regions {
            if let Some(kind) = kinds.get(name) {
                faults.error(root("regions").key(name), format!("the name `{name}` is that of {kind}")).hint(
                    "edges, faces, holes, cuts and groups are regions already: give this one another name",
                );
                continue;
            }
            if let Some(region) = regions::converted(region, body, &root("regions").key(name), faults) {
                named.insert(name.clone(), region);
            }
        }
        let hidden = aside.keys().cloned().collect();
        named.extend(aside);
        let mut ground =
            Self { case, body, outline, walls, parts, named, aside: hidden, refused: BTreeSet::new() };
        ground.join_lists(faults);
        for name in case.regions.keys().filter(|name| !kinds.contains_key(*name)) {
            ground.define(name, &root("regions").key(name), faults);
        }
        ground
    }

    /// Names of all regions.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.named.keys().filter(|name| !self.aside.contains(*name)).map(String::as_str)
    }

    /// The name of a region, if there is such a one.
    pub(crate) fn own_name(&self, name: &str) -> Option<&str> {
        self.named.get_key_value(name).map(|(own, _)| own.as_str())
    }

    /// As [`border_names::edges_of`].
    pub(crate) fn edges_of(&self, names: &Names) -> Vec<String> {
        border_names::edges_of(self.outline, names)
    }

    /// Lists of places as regions, where they are no parts of the border alone.
    fn join_lists(&mut self, faults: &mut Faults) {
        for List { path, names, is_place } in border_names::lists(self.case) {
            if !is_place || self.named.contains_key(&**names) {
                continue;
            }
            let mut is_fine = true;
            for (k, name) in names.each().iter().enumerate() {
                if !self.named.contains_key(name) {
                    is_fine = false;
                    if !self.case.regions.contains_key(name) {
                        faults
                            .error(path.index(k), format!("there is no region `{name}`"))
                            .hint(suggest(name, self.names()));
                    }
                }
            }
            match is_fine {
                true => {
                    self.named.insert(names.to_string(), Region::Union { of: names.each().to_vec() });
                    self.aside.insert(names.to_string());
                }
                false => drop(self.refused.insert(names.to_string())),
            }
        }
    }

    /// Number of points of the region of a name; none where it cannot be made.
    pub(crate) fn count(&self, name: &str) -> usize {
        let region = self.named.get(name);
        region.and_then(|region| self.select(region).ok()).map_or(0, |points| points.len())
    }

    /// Points of a region that a case defines, with its faults.
    fn define(&self, name: &str, path: &JsonPath, faults: &mut Faults) {
        let Some(region) = self.named.get(name) else { return };
        match self.select(region) {
            Ok(points) if points.is_empty() => {
                let fault = faults
                    .error(path.clone(), format!("none of {} points is in this region", self.body.points()));
                if let Some(hint) = self.nearest_to(region) {
                    fault.hint(hint);
                }
            }
            Ok(_) => {}
            Err(error) => self.refuse(&error, name, path, faults),
        }
    }

    fn select(&self, region: &Region) -> Result<Vec<u32>, RegionError> {
        let Self { body, outline, walls, parts, .. } = *self;
        Regions { body, outline, walls, parts, named: &self.named }.select(region)
    }

    /// `the nearest point is at (1, 2)`.
    fn nearest_to(&self, region: &Region) -> Option<String> {
        let (at, from) = match region {
            Region::Box { from, to } => (in_space([0, 1].map(|k| 0.5 * (from[k] + to[k]))), "its middle"),
            Region::Disc { centre, .. } => (in_space(*centre), "its middle"),
            Region::HalfPlane { point, .. } => (in_space(*point), "its `point`"),
            Region::Solid(SolidRegion::Box { from, to } | SolidRegion::Cylinder { from, to, .. }) => {
                ([0, 1, 2].map(|k| 0.5 * (from[k] + to[k])), "its middle")
            }
            Region::Solid(SolidRegion::Ball { centre, .. }) => (*centre, "its middle"),
            Region::Solid(SolidRegion::HalfSpace { point, .. }) => (*point, "its `point`"),
            _ => return None,
        };
        let nearest = self.body.position(self.nearest(at)? as usize);
        Some(format!("the point nearest to {from} is at {}", words::place(nearest, self.body)))
    }

    /// Points of the region of a name.
    pub(crate) fn region(&self, name: &str, path: &JsonPath, faults: &mut Faults) -> Option<Vec<u32>> {
        let Some(region) = self.named.get(name) else {
            // A region that could not be made has its fault already.
            if !self.case.regions.contains_key(name) && !self.refused.contains(name) {
                faults
                    .error(path.clone(), format!("there is no region `{name}`"))
                    .hint(suggest(name, self.names()));
            }
            return None;
        };
        match self.select(region) {
            Ok(points) if !points.is_empty() => Some(points),
            Ok(_) if self.case.regions.contains_key(name) => None,
            Ok(_) => {
                faults.error(path.clone(), format!("no point is in the region `{name}`"));
                None
            }
            // Regions of the case have been refused before.
            Err(_) => None,
        }
    }

    /// The place that `at` names; `what` is what is placed.
    pub(crate) fn spot(
        &self,
        at: &At,
        path: &JsonPath,
        what: &str,
        faults: &mut Faults,
    ) -> Option<NamedPoints> {
        if let Some(name) = self.region_name(at, path, faults)? {
            let points = self.region(name, &path.key("region"), faults)?;
            return Some(NamedPoints { points, words: format!("the region `{name}`") });
        }
        let position = self.position(at, path, faults)?;
        let words = words::place(position, self.body);
        let point = self.point_at(position, path, what, faults)?;
        Some(NamedPoints { points: vec![point], words })
    }

    /// The name of a region if `at` gives one; `None` where it is not a place in the plane.
    pub(crate) fn region_name<'b>(
        &self,
        at: &'b At,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<Option<&'b str>> {
        for (key, given) in [("joint", at.joint.is_some()), ("member", at.member.is_some())] {
            if given {
                faults.error(path.key(key), format!("`{key}` is for frames")).hint(self.place_hint());
                return None;
            }
        }
        if let Some(edge) = &at.edge {
            faults
                .error(path.key("edge"), "`edge` is for probes of a field without `of`")
                .hint(format!("write {{ \"region\": \"{edge}\" }}"));
            return None;
        }
        let Some(name) = &at.region else { return Some(None) };
        let beside = [
            ("x", at.x.is_some()),
            ("y", at.y.is_some()),
            ("z", at.z.is_some()),
            ("inward", at.inward.is_some()),
        ];
        for (key, given) in beside {
            if given {
                faults
                    .error(path.key(key), format!("`region` and `{key}` are both given"))
                    .hint(self.place_hint());
                return None;
            }
        }
        Some(Some(name))
    }

    /// How a place on the body is written, for hints.
    pub(crate) fn place_hint(&self) -> &'static str {
        if self.body.axes() > 2 { PLACE_IN_SPACE } else { PLACE }
    }

    /// The position that `at` gives.
    pub(crate) fn position(&self, at: &At, path: &JsonPath, faults: &mut Faults) -> Option<[f64; 3]> {
        let given = [at.x, at.y, at.z];
        let needed = self.body.axes();
        match given[..needed].iter().position(Option::is_none) {
            None => return Some(given.map(|x| x.unwrap_or(0.0))),
            Some(_) if given[..needed].iter().all(Option::is_none) => {
                faults.error(path.clone(), "no place is given").hint(self.place_hint());
            }
            Some(axis) => {
                let message = format!("`{}` is missing", ["x", "y", "z"][axis]);
                faults.error(path.clone(), message).hint(self.place_hint());
            }
        }
        None
    }

    /// A point that is nearest to a position.
    fn nearest(&self, at: [f64; 3]) -> Option<u32> {
        let [x, y, _] = at;
        let flat = Region::Corner { at: [x, y] };
        let region = if self.body.is_solid() { Region::Solid(SolidRegion::Corner { at }) } else { flat };
        self.select(&region).ok()?.first().copied()
    }

    /// The point at a position: the one whose cell it is in, else the nearest within half a diagonal of a cell, a whole one where rows
    /// are turned, on a border but for rounding and, with the limit `local`, in the body, a spacing of listed points in space.
    pub(crate) fn point_at(
        &self,
        position: [f64; 3],
        path: &JsonPath,
        what: &str,
        faults: &mut Faults,
    ) -> Option<u32> {
        let own = match self.body {
            PointBody::Lattice(lattice) => lattice.number(lattice.cell_at([position[0], position[1]])),
            PointBody::Solid(lattice) => lattice.number(lattice.cell_around(position)),
            PointBody::Cloud(_) => None,
        };
        if let Some(point) = own {
            return Some(point as u32);
        }
        let nearest = self.nearest(position)?;
        let at = self.body.position(nearest as usize);
        let distance = (0..3).map(|k| (at[k] - position[k]).powi(2)).sum::<f64>().sqrt();
        let (place, slack) = ([position[0], position[1]], ON_BORDER * self.body.spacing());
        let is_told = |o: &Outline| o.borders(place, slack) || self.case.is_corrected() && o.contains(place);
        let most = match self.body {
            PointBody::Lattice(lattice) if lattice.is_turned() || self.outline.is_some_and(is_told) => SQRT_2,
            PointBody::Cloud(cloud) if self.body.is_solid() => cloud.width(nearest as usize).max(1.0),
            body => 0.5 * (body.axes() as f64).sqrt(),
        };
        if distance <= most * self.body.spacing() * (1.0 + 1e-6) {
            return Some(nearest);
        }
        let [given, nearest] = [position, at].map(|at| words::place(at, self.body));
        faults
            .error(path.clone(), format!("{what} at {given} is outside of the body"))
            .hint(format!("the nearest point is at {nearest}{}", words::far(distance, self.body)));
        None
    }
}
