//! Regions: parts of a body that conditions and probes name.

use super::convex::Convex;
use super::geometry::{dot, left_normal, moved};
use super::outline::{Outline, Shape};
use super::select::{nearest, points_in};
use super::{BORDER, PlaneBody};
use std::collections::BTreeMap;
use thiserror::Error;

/// Which points of a body. Lengths in m; borders belong to regions, within [`BORDER`].
#[derive(Clone, Debug, PartialEq)]
pub enum Region {
    /// Points beside a straight edge of the outline, between its ends.
    Edge {
        /// Name of the edge.
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
    /// Points of a group of a mesh.
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
}

fn known_text(known: &[String]) -> String {
    if known.is_empty() { String::new() } else { format!(", only {}", known.join(", ")) }
}

/// What regions are found on.
#[derive(Clone, Copy, Debug)]
pub struct Regions<'a> {
    /// The points.
    pub body: &'a PlaneBody,
    /// The outline with its edges and holes; listed points have none.
    pub outline: Option<&'a Outline>,
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
        self.inside(region, &mut Vec::new())
    }

    fn inside<'r>(&'r self, region: &'r Region, open: &mut Vec<&'r str>) -> Result<Vec<u32>, RegionError> {
        let parts = match region {
            Region::Union { of } => return self.union(of, open),
            Region::Group { name } => return self.group(name),
            Region::Corner { at } => return Ok(nearest(self.body, finite("at", *at)?)),
            Region::Edge { name, depth } => vec![self.edge(name, *depth)?],
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

    fn union<'r>(&'r self, of: &'r [String], open: &mut Vec<&'r str>) -> Result<Vec<u32>, RegionError> {
        let mut found = Vec::new();
        for name in of {
            let Some(region) = self.named.get(name) else {
                return Err(unknown("region", name, self.named.keys().map(String::as_str)));
            };
            if open.contains(&name.as_str()) {
                return Err(RegionError::Cycle { name: name.clone() });
            }
            open.push(name);
            found.push(self.inside(region, open)?);
            open.pop();
        }
        Ok(sorted(found.into_iter()))
    }

    fn group(&self, name: &str) -> Result<Vec<u32>, RegionError> {
        let groups = match self.body {
            PlaneBody::Lattice(_) => &[],
            PlaneBody::Cloud(cloud) => cloud.groups(),
        };
        let found = groups.iter().find(|g| g.name == name);
        let missing = || unknown("group", name, groups.iter().map(|g| g.name.as_str()));
        found.map(|g| g.points.clone()).ok_or_else(missing)
    }

    fn edge(&self, name: &str, depth: Option<f64>) -> Result<Convex, RegionError> {
        let edges = self.outline.map_or(&[][..], Outline::edges);
        let found = edges.iter().find(|e| e.name == name);
        let edge = found.ok_or_else(|| unknown("edge", name, edges.iter().map(|e| e.name.as_str())))?;
        let (depth, by) = (self.depth(depth)?, self.slack());
        // The inside is on the left of the edge if its normal points to the right.
        let left = left_normal(edge.from, edge.to);
        let turned = dot(left, edge.normal) > 0.0;
        let (from, to) = if turned { (edge.to, edge.from) } else { (edge.from, edge.to) };
        Ok(Convex::beside(from, to, by, [-by, depth + by]))
    }

    fn hole(&self, name: &str, depth: Option<f64>) -> Result<Vec<Convex>, RegionError> {
        let holes = self.outline.map_or(&[][..], Outline::holes);
        let known = holes.iter().filter_map(|h| h.name.as_deref());
        let found = holes.iter().find(|h| h.name.as_deref() == Some(name));
        let hole = found.ok_or_else(|| unknown("hole", name, known))?;
        let depth = self.depth(depth)? + self.slack();
        Ok(match &hole.shape {
            Shape::Circle { centre, radius } => {
                vec![Convex::Stadium { from: *centre, to: *centre, radius: radius + depth }]
            }
            Shape::Slot { from, to, radius } => {
                vec![Convex::Stadium { from: *from, to: *to, radius: radius + depth }]
            }
            Shape::Polygon(polygon) => {
                polygon.edges().map(|[from, to]| Convex::Stadium { from, to, radius: depth }).collect()
            }
        })
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
mod tests {
    use super::super::geometry::{distance, to_segment};
    use super::super::outline::Hole;
    use super::super::polygon::Polygon;
    use super::super::{Cloud, Group};
    use super::*;
    use proptest::prelude::*;

    fn plate() -> (Outline, PlaneBody) {
        let mut outline = Outline::rectangle([0.0; 2], [2.0, 1.0]).unwrap();
        let shape = Shape::Circle { centre: [0.5, 0.5], radius: 0.2 };
        outline.cut(Hole { name: Some("pin".into()), shape }).unwrap();
        let square = vec![[1.4, 0.4], [1.6, 0.4], [1.6, 0.6], [1.4, 0.6]];
        let shape = Shape::Polygon(Polygon::new(square).unwrap());
        outline.cut(Hole { name: Some("window".into()), shape }).unwrap();
        let lattice = outline.fill(0.1).unwrap();
        (outline, PlaneBody::Lattice(lattice))
    }

    fn as_cloud(body: &PlaneBody) -> PlaneBody {
        let all = 0..body.points();
        let positions = all.clone().map(|p| body.position(p)).collect();
        let group = Group { name: "some".into(), points: vec![7, 3, 3] };
        PlaneBody::Cloud(Cloud::new(positions, all.map(|p| body.area(p)).collect(), vec![group]).unwrap())
    }

    fn select(region: &Region) -> Result<Vec<u32>, RegionError> {
        let (outline, body) = plate();
        let named = BTreeMap::from([
            ("corners".into(), Region::Union { of: vec!["a".into(), "b".into()] }),
            ("a".into(), Region::Corner { at: [0.0, 0.0] }),
            ("b".into(), Region::Corner { at: [9.0, 0.5] }),
            ("loop".into(), Region::Union { of: vec!["a".into(), "loop".into()] }),
        ]);
        let regions = Regions { body: &body, outline: Some(&outline), named: &named };
        let found = regions.select(region);
        // Listed points give the same answer, though another code finds it.
        let cloud = as_cloud(&body);
        if !matches!(region, Region::Group { .. }) {
            let listed = Regions { body: &cloud, ..regions };
            assert_eq!(found, listed.select(region));
            return found;
        }
        Regions { body: &cloud, ..regions }.select(region)
    }

    fn edge(name: &str, depth: Option<f64>) -> Region {
        Region::Edge { name: name.into(), depth }
    }

    #[test]
    fn edges_corners_and_holes() {
        let count = |region: &Region| select(region).unwrap().len();
        for (name, cells) in [("left", 10), ("right", 10), ("bottom", 20), ("top", 20)] {
            assert_eq!(count(&edge(name, None)), cells, "{name}");
            assert_eq!(count(&edge(name, Some(0.25))), 3 * cells, "{name}");
            assert_eq!(count(&edge(name, Some(0.049))), 0, "{name}");
        }
        assert_eq!(select(&edge("bottom", None)).unwrap(), (0..20).collect::<Vec<u32>>());
        assert_eq!(select(&Region::Corner { at: [2.0, 0.0] }).unwrap(), [19]);
        // Amid four cells, and on the line between two.
        assert_eq!(count(&Region::Corner { at: [1.0, 0.5] }), 4);
        assert_eq!(count(&Region::Corner { at: [1.0, -3.0] }), 2);
        // Between circles of radius 2 and 3 around a corner of cells: 32 − 12 centres of cells.
        assert_eq!(count(&Region::Hole { name: "pin".into(), depth: None }), 20);
        // The layer of cells around a square of 2 × 2: the nearest centres are half a spacing off.
        assert_eq!(count(&Region::Hole { name: "window".into(), depth: Some(0.08) }), 12);
    }

    #[test]
    fn boxes_discs_half_planes_and_groups() {
        let count = |region: &Region| select(region).unwrap().len();
        // Centres of cells as corners: borders count.
        let on_centres = Region::Box { from: [0.35, 0.15], to: [0.05, 0.05] };
        assert_eq!(select(&on_centres).unwrap(), [0, 1, 2, 3, 20, 21, 22, 23]);
        assert_eq!(count(&Region::Box { from: [1.05, 0.0], to: [1.05, 1.0] }), 10);
        assert_eq!(count(&Region::Disc { centre: [1.05, 0.45], radius: 0.2 }), 13);
        assert_eq!(count(&Region::HalfPlane { point: [1.95, 0.0], normal: [3.0, 0.0] }), 10);
        assert_eq!(count(&Region::HalfPlane { point: [0.0, 0.95], normal: [0.0, 2.0] }), 20);
        // x + y ≤ 0.3 through centres.
        assert_eq!(count(&Region::HalfPlane { point: [0.15, 0.15], normal: [-1.0, -1.0] }), 6);
        assert_eq!(select(&Region::Group { name: "some".into() }).unwrap(), [3, 7]);
        assert_eq!(select(&Region::Union { of: vec!["corners".into(), "a".into()] }).unwrap().len(), 3);
    }

    #[test]
    fn faults_are_named() {
        let unknown = select(&edge("lefft", None)).unwrap_err();
        assert_eq!(unknown.to_string(), "there is no edge `lefft`, only bottom, right, top, left");
        assert!(matches!(
            select(&Region::Hole { name: "x".into(), depth: None }),
            Err(RegionError::Unknown { kind: "hole", .. })
        ));
        let looped = Region::Union { of: vec!["loop".into()] };
        assert_eq!(select(&looped), Err(RegionError::Cycle { name: "loop".into() }));
        assert_eq!(
            select(&edge("left", Some(-1.0))),
            Err(RegionError::NotPositive { what: "depth", found: -1.0 })
        );
        let flat = Region::HalfPlane { point: [0.0; 2], normal: [0.0; 2] };
        assert_eq!(select(&flat), Err(RegionError::Position { what: "normal" }));
    }

    proptest! {
        #[test]
        fn edges_of_polygons_are_measured_along_their_normal(
            turn in 0.0..6.3f64, depth in 0.3..3.0f64, reverse: bool, which in 0..4usize,
        ) {
            let place = |x: f64, y: f64| [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()];
            let mut vertices = vec![place(0.0, 0.0), place(7.0, 0.0), place(6.0, 5.0), place(1.0, 4.0)];
            if reverse {
                vertices.reverse();
            }
            let outline = Outline::polygon(vertices).unwrap();
            let body = PlaneBody::Lattice(outline.fill(0.31).unwrap());
            let regions = Regions { body: &body, outline: Some(&outline), named: &BTreeMap::new() };
            let found = regions.select(&edge(&format!("edge_{}", which + 1), Some(depth))).unwrap();
            let e = &outline.edges()[which];
            for p in 0..body.points() {
                let at = body.position(p);
                let along = super::super::geometry::dot(
                    super::super::geometry::minus(at, e.from), super::super::geometry::minus(e.to, e.from),
                ) / distance(e.from, e.to);
                let inside = to_segment(at, e.from, e.to) <= depth && (0.0..=distance(e.from, e.to)).contains(&along);
                prop_assert_eq!(found.binary_search(&(p as u32)).is_ok(), inside, "{:?}", at);
            }
        }
    }
}
