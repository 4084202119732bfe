//! Regions as the mechanics knows them.

use crate::case::{self, Vector};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::body::{PointBody, Region, SolidRegion};

/// A region of a case on a body; none with a fault where it is for bodies of another kind.
pub(crate) fn converted(
    region: &case::Region,
    body: &PointBody,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Region> {
    let is_solid = body.axes() > 2;
    let (key, of_solid, instead) = match region {
        case::Region::Edge(_) => ("edge", Some(false), "faces of a solid are regions with a `face`"),
        case::Region::Disc(_) => ("disc", Some(false), "use a `cylinder` or a `ball`"),
        case::Region::HalfPlane(_) => ("half_plane", Some(false), "use a `half_space`"),
        case::Region::Hole(_) => ("hole", Some(false), "use a `cylinder` or a `ball`"),
        case::Region::Face(_) => ("face", Some(true), "use an `edge`"),
        case::Region::Ball(_) => ("ball", Some(true), "use a `disc`"),
        case::Region::Cylinder(_) => ("cylinder", Some(true), "use a `disc` or a `box`"),
        case::Region::HalfSpace(_) => ("half_space", Some(true), "use a `half_plane`"),
        case::Region::Corner(_) | case::Region::Box(_) | case::Region::Group(_) | case::Region::Union(_) => {
            ("", None, "")
        }
    };
    if of_solid.is_some_and(|of_solid| of_solid != is_solid) {
        let whose = if is_solid { "bodies in the plane" } else { "solids" };
        faults.error(path.key(key), format!("`{key}` is for {whose}")).hint(instead);
        return None;
    }
    let at = |vector: Vector, path: JsonPath, faults: &mut Faults| position(vector, body, path, faults);
    let flat = |[x, y, _]: [f64; 3]| [x, y];
    Some(match region.clone() {
        case::Region::Edge(r) => Region::Edge { name: r.name.to_string(), depth: r.depth },
        case::Region::Face(r) => Region::Solid(SolidRegion::Face { name: r.name, depth: r.depth }),
        case::Region::Corner(given) => {
            let at = at(given, path.key("corner"), faults)?;
            if is_solid { Region::Solid(SolidRegion::Corner { at }) } else { Region::Corner { at: flat(at) } }
        }
        case::Region::Box(r) => {
            let from = at(r.from, path.key("box").key("from"), faults)?;
            let to = at(r.to, path.key("box").key("to"), faults)?;
            match is_solid {
                true => Region::Solid(SolidRegion::Box { from, to }),
                false => Region::Box { from: flat(from), to: flat(to) },
            }
        }
        case::Region::Disc(r) => Region::Disc { centre: r.centre, radius: r.radius },
        case::Region::Ball(r) => Region::Solid(SolidRegion::Ball { centre: r.centre, radius: r.radius }),
        case::Region::Cylinder(r) => {
            Region::Solid(SolidRegion::Cylinder { from: r.from, to: r.to, radius: r.radius })
        }
        case::Region::HalfPlane(r) => Region::HalfPlane { point: r.point, normal: r.normal },
        case::Region::HalfSpace(r) => {
            Region::Solid(SolidRegion::HalfSpace { point: r.point, normal: r.normal })
        }
        case::Region::Hole(r) => Region::Hole { name: r.name, depth: r.depth },
        case::Region::Group(name) => Region::Group { name },
        case::Region::Union(of) => Region::Union { of },
    })
}

/// A position that a case gives by as many numbers as the body has axes; a fault where they are others.
pub(crate) fn position(
    given: Vector,
    body: &PointBody,
    path: JsonPath,
    faults: &mut Faults,
) -> Option<[f64; 3]> {
    let (position, count) = given.parts();
    if count == body.axes() {
        return Some(position);
    }
    let s = if count == 1 { "" } else { "s" };
    let needed = match body.axes() {
        2 => "positions in the plane have 2, along x and y",
        _ => "positions in a solid have 3, along x, y and z",
    };
    faults.error(path, format!("this position has {count} number{s}, and {needed}"));
    None
}
