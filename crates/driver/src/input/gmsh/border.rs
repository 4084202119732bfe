//! The border of a mesh in the plane: sides of one element alone.

use super::super::ReadError;
use super::plane::{self, names};
use super::sections::Raw;
use std::collections::{BTreeMap, HashMap};

/// A side of an element on the border.
#[derive(Clone, Debug, PartialEq)]
pub struct BorderSide {
    /// Both ends.
    pub ends: [[f64; 2]; 2],
    /// The line of its element.
    pub line: usize,
    /// The curve that it is a part of, if the mesh tells.
    pub curve: Option<i64>,
    /// Names of the physical curves that it is a part of.
    pub names: Vec<String>,
}

/// A named part of the surface of a mesh by its triangles and quadrilaterals.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Corners of its elements.
    pub elements: Vec<Vec<[f64; 2]>>,
}

/// The border of a mesh, and named parts of its surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Border {
    /// Sides of one element alone.
    pub sides: Vec<BorderSide>,
    /// Physical surfaces.
    pub parts: Vec<Part>,
}

/// Sides of elements on the border, named by physical curves, and physical surfaces.
pub(super) fn border(raw: &Raw) -> Result<Border, ReadError> {
    if !raw.tetrahedra.is_empty() || raw.others.is_some() {
        return Err(ReadError::whole("is a mesh of three dimensions")
            .hint("mesh the face alone, by `gmsh -2`, or take the body `solid`"));
    }
    let corners = plane::corners(raw)?;
    let key = |a: u64, b: u64| [a.min(b), a.max(b)];
    // Every side with the line of its element and how often it occurs, in the order of the file.
    let mut sides: Vec<([u64; 2], usize, [[f64; 2]; 2])> = Vec::new();
    let mut count: HashMap<[u64; 2], usize> = HashMap::new();
    for (face, places) in raw.faces.iter().zip(&corners) {
        for k in 0..face.count {
            let next = (k + 1) % face.count;
            let side = key(face.corners[k], face.corners[next]);
            *count.entry(side).or_default() += 1;
            sides.push((side, face.line, [k, next].map(|c| [places[c][0], places[c][1]])));
        }
    }
    if let Some((_, line, _)) = sides.iter().find(|(side, ..)| count[side] > 2) {
        return Err(ReadError::at(*line, "more than two elements have a side of this one")
            .hint("a mesh in the plane has two elements at a side: remove those that lie over others"));
    }
    let on: HashMap<[u64; 2], i64> =
        raw.pieces.iter().map(|piece| (key(piece.ends[0], piece.ends[1]), piece.curve)).collect();
    let found = sides.iter().filter(|(side, ..)| count[side] == 1);
    let sides = found.map(|(side, line, ends)| {
        let curve = on.get(side).copied();
        let names = curve.into_iter().flat_map(|curve| names(raw, 1, curve)).collect();
        BorderSide { ends: *ends, line: *line, curve, names }
    });
    Ok(Border { sides: sides.collect(), parts: parts(raw, &corners) })
}

fn parts(raw: &Raw, corners: &[Vec<[f64; 3]>]) -> Vec<Part> {
    let mut found: BTreeMap<String, Vec<Vec<[f64; 2]>>> = BTreeMap::new();
    for (face, places) in raw.faces.iter().zip(corners) {
        let flat: Vec<[f64; 2]> = places.iter().map(|p| [p[0], p[1]]).collect();
        for name in names(raw, 2, face.surface) {
            found.entry(name).or_default().push(flat.clone());
        }
    }
    found.into_iter().map(|(name, elements)| Part { name, elements }).collect()
}
