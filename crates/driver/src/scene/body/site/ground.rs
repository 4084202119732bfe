//! Regions and places of a body in the plane by the names that a case gives them.

use crate::case::{self, At, Case};
use crate::diagnostic::{Faults, JsonPath, root, suggest, tidy};
use peristat_assembly::body::{Outline, PlaneBody, Region, RegionError, Regions};
use std::collections::BTreeMap;

/// A body with everything on it that has a name.
pub(crate) struct Ground<'a> {
    /// The case.
    pub(crate) case: &'a Case,
    /// The points.
    pub(crate) body: &'a PlaneBody,
    /// The outline; listed points have none.
    pub(crate) outline: Option<&'a Outline>,
    /// Regions of the case, and edges, holes and groups as regions.
    named: BTreeMap<String, Region>,
}

/// A place that was found.
#[derive(Clone, Debug)]
pub(crate) struct Spot {
    /// Its points, ascending.
    pub(crate) points: Vec<u32>,
    /// What messages call it, such as `the region `left`` or `(1, 2)`.
    pub(crate) words: String,
}

/// How a place in the plane is written, for hints.
pub(crate) const PLACE: &str =
    r#"a place in the plane is written { "x": 1.0, "y": 0.5 } or { "region": "left" }"#;

impl<'a> Ground<'a> {
    /// The names of a body; faults of all regions of the case.
    pub(crate) fn new(
        case: &'a Case,
        body: &'a PlaneBody,
        outline: Option<&'a Outline>,
        faults: &mut Faults,
    ) -> Self {
        let mut named = BTreeMap::new();
        let mut kinds = BTreeMap::new();
        let mut take = |name: &str, kind: &'static str, region: Region| {
            named.insert(name.to_string(), region);
            kinds.insert(name.to_string(), kind);
        };
        for edge in outline.map_or(&[][..], Outline::edges) {
            take(&edge.name, "an edge", Region::Edge { name: edge.name.clone(), depth: None });
        }
        for name in outline.map_or(&[][..], Outline::holes).iter().filter_map(|h| h.name.as_ref()) {
            take(name, "a hole", Region::Hole { name: name.clone(), depth: None });
        }
        if let PlaneBody::Cloud(cloud) = body {
            for group in cloud.groups() {
                take(&group.name, "a group of the mesh", Region::Group { name: group.name.clone() });
            }
        }
        for (name, region) in &case.regions {
            if let Some(kind) = kinds.get(name) {
                faults
                    .error(root("regions").key(name), format!("the name `{name}` is that of {kind}"))
                    .hint("edges, holes and groups are regions already: give this one another name");
                continue;
            }
            named.insert(name.clone(), converted(region));
        }
        let ground = Self { case, body, outline, named };
        for name in case.regions.keys().filter(|name| !kinds.contains_key(*name)) {
            ground.define(name, &root("regions").key(name), faults);
        }
        ground
    }

    /// Names of all regions.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.named.keys().map(String::as_str)
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

    fn refuse(&self, error: &RegionError, name: &str, path: &JsonPath, faults: &mut Faults) {
        let place = match (&self.case.regions[name], error) {
            (case::Region::Edge(_), RegionError::Unknown { .. }) => path.key("edge").key("name"),
            (case::Region::Hole(_), RegionError::Unknown { .. }) => path.key("hole").key("name"),
            (case::Region::Group(_), _) => path.key("group"),
            (case::Region::Union(_), _) => path.key("union"),
            (case::Region::Edge(_), _) => path.key("edge").key("depth"),
            (case::Region::Hole(_), _) => path.key("hole").key("depth"),
            (case::Region::Disc(_), RegionError::NotPositive { .. }) => path.key("disc").key("radius"),
            (case::Region::HalfPlane(_), RegionError::Position { what }) => path.key("half_plane").key(*what),
            _ => path.clone(),
        };
        match error {
            RegionError::Unknown { kind, name, known } => {
                let hint = match (*kind, known.is_empty()) {
                    ("edge", true) => "edges are those of the bodies `rectangle` and `outline`".to_string(),
                    ("hole", true) => "no hole of the body has a name".into(),
                    ("group", true) => "groups are those of a body `mesh` with named physical groups".into(),
                    _ => suggest(name, known.iter().map(String::as_str)),
                };
                faults.error(place, format!("there is no {kind} `{name}`")).hint(hint);
            }
            RegionError::NotPositive { what, found } => {
                faults.error(place, format!("`{what}` must be greater than zero, found {found}"));
            }
            error => {
                faults.error(place, error.to_string());
            }
        }
    }

    fn select(&self, region: &Region) -> Result<Vec<u32>, RegionError> {
        Regions { body: self.body, outline: self.outline, named: &self.named }.select(region)
    }

    /// `the nearest point is at (1, 2)`.
    fn nearest_to(&self, region: &Region) -> Option<String> {
        let at = match region {
            Region::Box { from, to } => [0, 1].map(|k| 0.5 * (from[k] + to[k])),
            Region::Disc { centre, .. } => *centre,
            Region::HalfPlane { point, .. } => *point,
            _ => return None,
        };
        let nearest = *self.select(&Region::Corner { at }).ok()?.first()?;
        let [x, y] = self.body.position(nearest as usize);
        let from = if matches!(region, Region::HalfPlane { .. }) { "its `point`" } else { "its middle" };
        Some(format!("the point nearest to {from} is at ({}, {})", tidy(x), tidy(y)))
    }

    /// Points of the region of a name.
    pub(crate) fn region(&self, name: &str, path: &JsonPath, faults: &mut Faults) -> Option<Vec<u32>> {
        let Some(region) = self.named.get(name) else {
            // A region that could not be made has its fault already.
            if !self.case.regions.contains_key(name) {
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
    pub(crate) fn spot(&self, at: &At, path: &JsonPath, what: &str, faults: &mut Faults) -> Option<Spot> {
        if let Some(name) = self.region_name(at, path, faults)? {
            let points = self.region(name, &path.key("region"), faults)?;
            return Some(Spot { points, words: format!("the region `{name}`") });
        }
        let position = self.position(at, path, faults)?;
        let words = format!("({}, {})", tidy(position[0]), tidy(position[1]));
        let point = self.point_at(position, path, what, faults)?;
        Some(Spot { points: vec![point], words })
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
                faults.error(path.key(key), format!("`{key}` is for frames")).hint(PLACE);
                return None;
            }
        }
        let Some(name) = &at.region else { return Some(None) };
        for (key, given) in [("x", at.x.is_some()), ("y", at.y.is_some()), ("inward", at.inward.is_some())] {
            if given {
                faults.error(path.key(key), format!("`region` and `{key}` are both given")).hint(PLACE);
                return None;
            }
        }
        Some(Some(name))
    }

    /// The position that `at` gives.
    pub(crate) fn position(&self, at: &At, path: &JsonPath, faults: &mut Faults) -> Option<[f64; 2]> {
        let missing = match (at.x, at.y) {
            (Some(x), Some(y)) => return Some([x, y]),
            (None, None) => "no place is given",
            (None, _) => "`x` is missing",
            (_, None) => "`y` is missing",
        };
        faults.error(path.clone(), missing).hint(PLACE);
        None
    }

    /// The point at a position: the one whose cell it is in, else the nearest within half a diagonal of a cell, or a whole
    /// one where rows are turned: at an oblique edge and its corners cells have their centres outside.
    pub(crate) fn point_at(
        &self,
        position: [f64; 2],
        path: &JsonPath,
        what: &str,
        faults: &mut Faults,
    ) -> Option<u32> {
        if let PlaneBody::Lattice(lattice) = self.body
            && let Some(point) = lattice.number(lattice.cell_at(position))
        {
            return Some(point as u32);
        }
        let nearest = *self.select(&Region::Corner { at: position }).ok()?.first()?;
        let [x, y] = self.body.position(nearest as usize);
        let distance = (x - position[0]).hypot(y - position[1]);
        let turned = matches!(self.body, PlaneBody::Lattice(lattice) if lattice.is_turned());
        let most = if turned { std::f64::consts::SQRT_2 } else { std::f64::consts::FRAC_1_SQRT_2 };
        if distance <= most * self.body.spacing() * (1.0 + 1e-6) {
            return Some(nearest);
        }
        let [a, b] = position.map(tidy);
        faults.error(path.clone(), format!("{what} at ({a}, {b}) is outside of the body")).hint(format!(
            "the nearest point is at ({}, {})",
            tidy(x),
            tidy(y)
        ));
        None
    }
}

/// A region of a case as the mechanics knows it.
fn converted(region: &case::Region) -> Region {
    match region.clone() {
        case::Region::Edge(r) => Region::Edge { name: r.name, depth: r.depth },
        case::Region::Corner(at) => Region::Corner { at },
        case::Region::Box(r) => Region::Box { from: r.from, to: r.to },
        case::Region::Disc(r) => Region::Disc { centre: r.centre, radius: r.radius },
        case::Region::HalfPlane(r) => Region::HalfPlane { point: r.point, normal: r.normal },
        case::Region::Hole(r) => Region::Hole { name: r.name, depth: r.depth },
        case::Region::Group(name) => Region::Group { name },
        case::Region::Union(of) => Region::Union { of },
    }
}
