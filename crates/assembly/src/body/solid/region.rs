//! Parts of bodies in space that conditions and probes name.

use super::super::geometry::distance_in_space as distance;
use super::super::lattice::{SquareLattice, minus};
use super::super::region::RegionError;
use super::super::{BORDER, PointBody};
use super::wall::{Side, Wall, WallKind};

/// Which points of a solid. Lengths in m; borders belong to regions, within [`BORDER`] spacings.
#[derive(Clone, Debug, PartialEq)]
pub enum SolidRegion {
    /// Points beside a face of a block, or behind sides of cells of a part of a surface.
    Face {
        /// Name of the face, or of the part.
        name: String,
        /// How far inwards; one spacing if not given, which is the outermost layer.
        depth: Option<f64>,
    },
    /// Points beside the border of a cut.
    Cut {
        /// Name of the cut.
        name: String,
    },
    /// The point nearest to a position; several at the same distance.
    Corner {
        /// The position.
        at: [f64; 3],
    },
    /// Points in a block.
    Box {
        /// One corner.
        from: [f64; 3],
        /// The opposite corner.
        to: [f64; 3],
    },
    /// Points in a ball.
    Ball {
        /// Its middle.
        centre: [f64; 3],
        /// Its radius.
        radius: f64,
    },
    /// Points in a cylinder with flat ends.
    Cylinder {
        /// Middle of one end.
        from: [f64; 3],
        /// Middle of the other.
        to: [f64; 3],
        /// Its radius.
        radius: f64,
    },
    /// Points where `(x − point)·normal ≥ 0`.
    HalfSpace {
        /// A position on the border.
        point: [f64; 3],
        /// Points into the half-space; any length.
        normal: [f64; 3],
    },
}

/// Numbers of the points of a region of a body in space, ascending. Listed points have no walls.
///
/// # Errors
/// [`RegionError`].
pub(in super::super) fn select(
    body: &PointBody,
    walls: &[Wall],
    region: &SolidRegion,
) -> Result<Vec<u32>, RegionError> {
    let slack = BORDER * body.spacing();
    match region {
        SolidRegion::Face { name, depth } => {
            let mut faces = walls.iter().filter(|wall| !matches!(wall.kind, WallKind::Cut { .. }));
            let known = faces.clone().map(|wall| wall.name.clone());
            let unknown =
                || RegionError::Unknown { kind: "face", name: name.clone(), known: known.collect() };
            let wall = faces.find(|wall| wall.name == *name).ok_or_else(unknown)?;
            let depth = positive("depth", depth.unwrap_or(body.spacing()))?;
            let Some(face) = wall.face().filter(|_| wall.patch().is_none()) else {
                let points = body.cells().map(|cells| behind(&wall.sides(cells), depth + slack, cells));
                return Ok(points.unwrap_or_default());
            };
            Ok(inside(body, |at| (at[face.axis] - face.at).abs() <= depth + slack))
        }
        SolidRegion::Cut { name } => {
            let wall = walls.iter().find(|wall| wall.name == *name).ok_or_else(|| RegionError::Unknown {
                kind: "cut",
                name: name.clone(),
                known: walls.iter().filter(|wall| wall.face().is_none()).map(|w| w.name.clone()).collect(),
            })?;
            let sides = body.cells().map(|cells| wall.sides(cells)).unwrap_or_default();
            let mut points: Vec<u32> = sides.iter().map(|side| side.point as u32).collect();
            points.dedup();
            Ok(points)
        }
        SolidRegion::Corner { at } => {
            let at = finite("at", *at)?;
            let mut least = f64::INFINITY;
            body.visit(|other| least = least.min(distance(other, at)));
            Ok(inside(body, |other| distance(other, at) <= least + slack))
        }
        SolidRegion::Box { from, to } => {
            let (from, to) = (finite("from", *from)?, finite("to", *to)?);
            let [low, high] =
                [f64::min, f64::max].map(|of: fn(f64, f64) -> f64| [0, 1, 2].map(|k| of(from[k], to[k])));
            let is_in = |at: [f64; 3], k: usize| low[k] - slack <= at[k] && at[k] <= high[k] + slack;
            Ok(inside(body, |at| (0..3).all(|k| is_in(at, k))))
        }
        SolidRegion::Ball { centre, radius } => {
            let (centre, radius) = (finite("centre", *centre)?, positive("radius", *radius)?);
            Ok(inside(body, |at| distance(at, centre) <= radius + slack))
        }
        SolidRegion::Cylinder { from, to, radius } => {
            let (from, to, radius) =
                (finite("from", *from)?, finite("to", *to)?, positive("radius", *radius)?);
            let (axis, length) =
                direction([0, 1, 2].map(|k| to[k] - from[k])).ok_or(RegionError::NoLength)?;
            Ok(inside(body, |at| {
                let along = above(at, from, axis);
                let foot = [0, 1, 2].map(|k| from[k] + along * axis[k]);
                (-slack..=length + slack).contains(&along) && distance(at, foot) <= radius + slack
            }))
        }
        SolidRegion::HalfSpace { point, normal } => {
            let (point, normal) = (finite("point", *point)?, finite("normal", *normal)?);
            let none = RegionError::Position { what: "normal" };
            let (normal, _) = direction(normal).ok_or(none)?;
            Ok(inside(body, |at| above(at, point, normal) >= -slack))
        }
    }
}

/// The points within a depth of sides of cells, straight behind them.
fn behind(sides: &[Side], depth: f64, lattice: &SquareLattice) -> Vec<u32> {
    // The centre of a cell is half a spacing behind its side.
    let layers = (depth / lattice.spacing() + 0.5).min(f64::from(i32::MAX)) as i32;
    let column = |side: &Side| {
        let (cell, step) = (lattice.cell(side.point), side.outwards());
        let at = move |k: i32| minus(cell, step.map(|s| s * k));
        (0..layers.max(1)).map_while(move |k| lattice.number(at(k))).map(|point| point as u32)
    };
    let mut found: Vec<u32> = sides.iter().flat_map(column).collect();
    found.sort_unstable();
    found.dedup();
    found
}

/// The points of a body at positions of which something is true.
fn inside(body: &PointBody, is_in: impl Fn([f64; 3]) -> bool) -> Vec<u32> {
    let (mut found, mut point) = (Vec::new(), 0);
    body.visit(|at| {
        if is_in(at) {
            found.push(point);
        }
        point += 1;
    });
    found
}

/// How far a position is beyond another one in a direction of length one.
fn above(at: [f64; 3], from: [f64; 3], direction: [f64; 3]) -> f64 {
    (0..3).map(|k| (at[k] - from[k]) * direction[k]).sum()
}

/// A vector as a direction of length one, and its length; none without a length.
fn direction(vector: [f64; 3]) -> Option<([f64; 3], f64)> {
    let length = distance(vector, [0.0; 3]);
    (length > 0.0 && length.is_finite()).then(|| (vector.map(|x| x / length), length))
}

fn finite(what: &'static str, position: [f64; 3]) -> Result<[f64; 3], RegionError> {
    if position.iter().all(|x| x.is_finite()) { Ok(position) } else { Err(RegionError::Position { what }) }
}

fn positive(what: &'static str, found: f64) -> Result<f64, RegionError> {
    if found > 0.0 && found.is_finite() { Ok(found) } else { Err(RegionError::NotPositive { what, found }) }
}

#[cfg(test)]
mod tests {
    use super::super::super::{Cloud, Group, Region, Regions};
    use super::super::SolidShape;
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn regions_of_solids_have_their_points() {
        let shape = SolidShape::block([0.0; 3], [4.0, 3.0, 2.0]).unwrap();
        let (body, faces) = (PointBody::Solid(shape.fill(1.0).unwrap()), shape.walls());
        let positions: Vec<[f64; 3]> = (0..body.points()).map(|p| body.position(p)).collect();
        let cloud = PointBody::Cloud(Cloud::in_space(positions, vec![1.0; 24], Vec::new()).unwrap());
        let count = |region: SolidRegion| {
            let found = select(&body, &faces, &region);
            if !matches!(region, SolidRegion::Face { .. }) {
                // Listed points give the same answer.
                assert_eq!(found, select(&cloud, &[], &region));
            }
            found.map(|points| points.len())
        };
        let face = |name: &str, depth| SolidRegion::Face { name: name.into(), depth };
        assert_eq!(count(face("right", None)), Ok(6));
        assert_eq!(count(face("back", Some(2.0))), Ok(24));
        assert_eq!(count(face("top", Some(1.5))), Ok(2 * 8));
        assert!(matches!(count(face("edge_1", None)), Err(RegionError::Unknown { kind: "face", .. })));
        assert_eq!(count(SolidRegion::Corner { at: [0.0; 3] }), Ok(1));
        // Midway between eight points.
        assert_eq!(count(SolidRegion::Corner { at: [1.0, 1.0, 1.0] }), Ok(8));
        assert_eq!(count(SolidRegion::Box { from: [2.0, 3.0, 0.0], to: [0.0, 0.0, 1.0] }), Ok(6));
        assert_eq!(count(SolidRegion::Ball { centre: [0.5; 3], radius: 1.0 }), Ok(4));
        let cylinder = |from, to, radius| {
            count(SolidRegion::Cylinder { from: [from, 0.5, 0.5], to: [to, 0.5, 0.5], radius })
        };
        // One row; with neighbours beside it; ends are flat and may be given in any order.
        assert_eq!(cylinder(0.0, 4.0, 0.5), Ok(4));
        assert_eq!(cylinder(3.0, 1.0, 1.0), Ok(2 * 3));
        assert_eq!(cylinder(1.0, 1.0, 1.0), Err(RegionError::NoLength));
        assert!(cylinder(0.0, 1.0, 0.0).is_err());
        let half = SolidRegion::HalfSpace { point: [2.0, 0.0, 0.0], normal: [-3.0, 0.0, 0.0] };
        assert_eq!(count(half), Ok(12));
        let none = SolidRegion::HalfSpace { point: [0.0; 3], normal: [0.0; 3] };
        assert_eq!(count(none), Err(RegionError::Position { what: "normal" }));
    }
    #[test]
    fn listed_points_in_space_have_groups_and_no_walls() {
        let group = Group { name: "some".into(), points: vec![1] };
        let positions = vec![[0.0; 3], [0.0, 0.0, 1.0]];
        let cloud = Cloud::in_space(positions.clone(), vec![8.0; 2], vec![group]).unwrap();
        let body = PointBody::Cloud(cloud);
        assert!(body.is_solid() && body.axes() == 3);
        assert_eq!((body.position(1), body.measure(1), body.spacing()), ([0.0, 0.0, 1.0], 8.0, 2.0));
        let (parts, named) = ([], BTreeMap::new());
        let regions = Regions { body: &body, outline: None, walls: &[], parts: &parts, named: &named };
        assert_eq!(regions.select(&Region::Group { name: "some".into() }), Ok(vec![1]));
        let corner = Region::Solid(SolidRegion::Corner { at: [0.0, 3.0, 0.9] });
        assert_eq!(regions.select(&corner), Ok(vec![1]));
        // Parts of the plane are none of bodies in space.
        assert_eq!(regions.select(&Region::Disc { centre: [0.0; 2], radius: 1.0 }), Ok(vec![]));
        let face = Region::Solid(SolidRegion::Face { name: "top".into(), depth: None });
        assert!(matches!(regions.select(&face), Err(RegionError::Unknown { kind: "face", .. })));
        // Nor are those of space of bodies in the plane.
        let flat = PointBody::Cloud(Cloud::in_plane(vec![[0.0; 2]], vec![1.0], Vec::new()).unwrap());
        assert_eq!(Regions { body: &flat, ..regions }.select(&corner), Ok(vec![]));
    }
}
