//! Regions: parts of a body that conditions and probes name.

use super::convex::Convex;
use super::geometry::{dot, left_normal, moved};
use super::hole::Shape;
use super::named::BorderMember;
use super::outline::{Edge, Outline};
use super::select::{nearest, points_in};
use super::solid::{self, SolidRegion, Wall};
use super::{BORDER, Group, PointBody};
use std::collections::{BTreeMap, BTreeSet};
use thiserror::Error;

/// Which points of a body. Lengths in m; borders belong to regions, within [`BORDER`].
#[derive(Clone, Debug, PartialEq)]
pub enum Region {
    /// Points beside straight edges of the outline, between their ends, and around holes that have the same name.
    Edge {
        /// Name of the edge, or of several parts of the border.
        name: String,
        /// How far inwards; one spacing if not given, which is the outermost layer.
        depth: Option<f64>,
    },
    /// The point nearest to a position; several at the same distance.
    Corner {
        /// The position.
        at: [f64; 2],
    },
    /// Points in a box.
    Box {
        /// One corner.
        from: [f64; 2],
        /// The opposite corner.
        to: [f64; 2],
    },
    /// Points in a disc.
    Disc {
        /// Its middle.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
    },
    /// Points where `(x − point)·normal ≥ 0`.
    HalfPlane {
        /// A position on the border.
        point: [f64; 2],
        /// Points into the half-plane; any length.
        normal: [f64; 2],
    },
    /// Points of a group of a mesh, or of a part of a solid that has a name.
    Group {
        /// Its name.
        name: String,
    },
    /// Points around a hole.
    Hole {
        /// Its name.
        name: String,
        /// How far from its edge; one spacing if not given.
        depth: Option<f64>,
    },
    /// Points of a solid.
    Solid(SolidRegion),
    /// Points of any of some named regions.
    Union {
        /// Their names.
        of: Vec<String>,
    },
}

/// Why a region cannot be found.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RegionError {
    /// No such edge, hole, group or region.
    #[error("there is no {kind} `{name}`{}", known_text(.known))]
    Unknown {
        /// `edge`, `hole`, `group` or `region`.
        kind: &'static str,
        /// The name looked for.
        name: String,
        /// The names there are.
        known: Vec<String>,
    },
    /// A union contains itself.
    #[error("region `{name}` contains itself")]
    Cycle {
        /// Its name.
        name: String,
    },
    /// Unions name unions that name unions, too often.
    #[error("unions are nested more than {DEEPEST} deep")]
    Deep,
    /// A length is not above zero.
    #[error("`{what}` must be above zero, found {found}")]
    NotPositive {
        /// `depth` or `radius`.
        what: &'static str,
        /// What was given.
        found: f64,
    },
    /// A position is infinite or no number, or a normal has no length.
    #[error("`{what}` must be finite{}", if *.what == "normal" { " and not zero" } else { "" })]
    Position {
        /// Which position.
        what: &'static str,
    },
    /// The ends of a cylinder are at one position.
    #[error("a cylinder has a length: `from` and `to` must differ")]
    NoLength,
}

fn known_text(known: &[String]) -> String {
    if known.is_empty() { String::new() } else { format!(", only {}", known.join(", ")) }
}

/// Unions within unions, at most.
const DEEPEST: usize = 64;

/// What was met on the way through unions within unions.
#[derive(Default)]
struct Unions<'r> {
    /// Names from the outermost one inwards.
    open: Vec<&'r str>,
    /// All names: a region counts once, however often it is named.
    met: BTreeSet<&'r str>,
}

/// What regions are found on.
#[derive(Clone, Copy, Debug)]
pub struct Regions<'a> {
    /// The points.
    pub body: &'a PointBody,
    /// The outline with its edges and holes; listed points have none.
    pub outline: Option<&'a Outline>,
    /// The walls of a solid.
    pub walls: &'a [Wall],
    /// Parts of a solid that have names; those of listed points are their own.
    pub parts: &'a [Group],
    /// Regions that unions name.
    pub named: &'a BTreeMap<String, Region>,
}

impl Regions<'_> {
    /// Numbers of the points of a region, ascending; there may be none.
    ///
    /// On a lattice only the rows of the region are visited.
    ///
    /// # Errors
    /// [`RegionError`].
    pub fn select(&self, region: &Region) -> Result<Vec<u32>, RegionError> {
        self.inside(region, &mut Unions::default())
    }

    fn inside<'r>(&'r self, region: &'r Region, unions: &mut Unions<'r>) -> Result<Vec<u32>, RegionError> {
        let parts = match region {
            Region::Union { of } => return self.union(of, unions),
            Region::Group { name } => return self.group(name),
            Region::Solid(_) if !self.body.is_solid() => return Ok(Vec::new()),
            Region::Solid(region) => return solid::select(self.body, self.walls, region),
            Region::Corner { at } => return Ok(nearest(self.body, finite("at", *at)?)),
            Region::Edge { name, depth } => self.named(name, *depth)?,
            Region::Hole { name, depth } => self.hole(name, *depth)?,
            Region::Box { from, to } => {
                let (from, to, by) = (finite("from", *from)?, finite("to", *to)?, self.slack());
                let [x, y] = [0, 1].map(|k| [from[k].min(to[k]) - by, from[k].max(to[k]) + by]);
                vec![Convex::Polygon(vec![[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]])]
            }
            Region::Disc { centre, radius } => {
                let centre = finite("centre", *centre)?;
                let radius = positive("radius", *radius)? + self.slack();
                vec![Convex::Stadium { from: centre, to: centre, radius }]
            }
            Region::HalfPlane { point, normal } => {
                let (point, normal) = (finite("point", *point)?, finite("normal", *normal)?);
                let length = normal[0].hypot(normal[1]);
                if !(length > 0.0 && length.is_finite()) {
                    return Err(RegionError::Position { what: "normal" });
                }
                let normal = normal.map(|n| n / length);
                let point = moved(point, -self.slack(), normal);
                vec![Convex::HalfPlane { point, normal }]
            }
        };
        Ok(sorted(parts.iter().map(|part| points_in(self.body, part))))
    }

    fn slack(&self) -> f64 {
        BORDER * self.body.spacing()
    }

    fn depth(&self, depth: Option<f64>) -> Result<f64, RegionError> {
        positive("depth", depth.unwrap_or(self.body.spacing()))
    }

    fn union<'r>(&'r self, of: &'r [String], unions: &mut Unions<'r>) -> Result<Vec<u32>, RegionError> {
        if unions.open.len() >= DEEPEST {
            return Err(RegionError::Deep);
        }
        let mut found = Vec::new();
        for name in of {
            let Some(region) = self.named.get(name) else {
                return Err(unknown("region", name, self.named.keys().map(String::as_str)));
            };
            if unions.open.contains(&name.as_str()) {
                return Err(RegionError::Cycle { name: name.clone() });
            }
            if unions.met.insert(name) {
                unions.open.push(name);
                found.push(self.inside(region, unions)?);
                unions.open.pop();
            }
        }
        Ok(sorted(found.into_iter()))
    }

    fn group(&self, name: &str) -> Result<Vec<u32>, RegionError> {
        let groups = match self.body {
            PointBody::Cloud(cloud) => cloud.groups(),
            _ => self.parts,
        };
        let found = groups.iter().find(|g| g.name == name);
        let missing = || unknown("group", name, groups.iter().map(|g| g.name.as_str()));
        found.map(|g| g.points.clone()).ok_or_else(missing)
    }

    /// What is beside the parts of the border that a name has.
    fn named(&self, name: &str, depth: Option<f64>) -> Result<Vec<Convex>, RegionError> {
        let known = || self.outline.into_iter().flat_map(Outline::border_names);
        let found = self.outline.and_then(|outline| Some((outline, outline.members(name)?)));
        let (outline, members) = found.ok_or_else(|| unknown("edge", name, known()))?;
        let (depth, by) = (self.depth(depth)?, self.slack());
        let straight: Vec<Edge> = members.iter().filter_map(|m| outline.straight(*m)).collect();
        let mut parts: Vec<Convex> = straight.iter().map(|edge| beside(edge, depth, by)).collect();
        // Where the border turns inwards, strips leave a wedge between them.
        let next = straight.iter().skip(1).chain(straight.first());
        let joints = straight.iter().zip(next).filter(|(a, b)| a.to == b.from && straight.len() > 1);
        parts.extend(joints.map(|(a, _)| Convex::Stadium { from: a.to, to: a.to, radius: depth + by }));
        for member in members {
            if let BorderMember::Hole(k) = member {
                parts.extend(around(&outline.holes()[k].shape, depth + by));
            }
        }
        Ok(parts)
    }

    fn hole(&self, name: &str, depth: Option<f64>) -> Result<Vec<Convex>, RegionError> {
        let holes = self.outline.map_or(&[][..], Outline::holes);
        let known = holes.iter().filter_map(|h| h.name.as_deref());
        let found = holes.iter().find(|h| h.name.as_deref() == Some(name));
        let hole = found.ok_or_else(|| unknown("hole", name, known))?;
        Ok(around(&hole.shape, self.depth(depth)? + self.slack()))
    }
}

/// What is beside an edge, on the side of the body.
fn beside(edge: &Edge, depth: f64, by: f64) -> Convex {
    // The inside is on the left of the edge if its normal points to the right.
    let left = left_normal(edge.from, edge.to);
    let turned = dot(left, edge.normal) > 0.0;
    let (from, to) = if turned { (edge.to, edge.from) } else { (edge.from, edge.to) };
    Convex::beside(from, to, by, [-by, depth + by])
}

/// What is near the border of a hole, and in it.
fn around(hole: &Shape, depth: f64) -> Vec<Convex> {
    match hole {
        Shape::Circle { centre, radius } => {
            vec![Convex::Stadium { from: *centre, to: *centre, radius: radius + depth }]
        }
        Shape::Slot { from, to, radius } => {
            vec![Convex::Stadium { from: *from, to: *to, radius: radius + depth }]
        }
        Shape::Polygon(polygon) | Shape::Ellipse { chords: polygon, .. } => {
            polygon.edges().map(|[from, to]| Convex::Stadium { from, to, radius: depth }).collect()
        }
    }
}

fn unknown<'n>(kind: &'static str, name: &str, known: impl Iterator<Item = &'n str>) -> RegionError {
    RegionError::Unknown { kind, name: name.into(), known: known.map(String::from).collect() }
}

fn finite(what: &'static str, position: [f64; 2]) -> Result<[f64; 2], RegionError> {
    if position.iter().all(|x| x.is_finite()) { Ok(position) } else { Err(RegionError::Position { what }) }
}

fn positive(what: &'static str, found: f64) -> Result<f64, RegionError> {
    if found > 0.0 && found.is_finite() { Ok(found) } else { Err(RegionError::NotPositive { what, found }) }
}

fn sorted(mut lists: impl ExactSizeIterator<Item = Vec<u32>>) -> Vec<u32> {
    if lists.len() == 1 {
        return lists.next().unwrap_or_default();
    }
    let mut all: Vec<u32> = lists.flatten().collect();
    all.sort_unstable();
    all.dedup();
    all
}

#[cfg(test)]
mod tests;
