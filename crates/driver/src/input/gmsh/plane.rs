//! Points and groups from the elements of a mesh.

use super::super::ReadError;
use super::sections::{Face, Raw};
use super::{Curve, Mesh, Side};
use peristat_assembly::body::{Cloud, CloudError, Group};
use std::collections::{BTreeMap, HashMap};

pub(super) fn mesh(raw: &Raw) -> Result<Mesh, ReadError> {
    let corners = corners(raw)?;
    let mut positions = Vec::new();
    let mut areas = Vec::new();
    let mut turned = Vec::new();
    for corners in &corners {
        let (centroid, area) = centroid(corners);
        positions.push(centroid);
        areas.push(area.abs());
        turned.push(area < 0.0);
    }
    let surfaces = surfaces(raw);
    let curves = curves(raw, &corners, &turned);
    if let Some(name) = surfaces.keys().find(|name| curves.contains_key(*name)) {
        return Err(ReadError::whole(format!(
            "a physical curve and a physical surface have the name `{name}`"
        ))
        .hint("give them different names"));
    }
    let of_curves = curves.iter().map(|(name, sides)| (name, sides.iter().map(|s| s.point).collect()));
    let groups = surfaces.iter().map(|(name, points)| (name, points.clone())).chain(of_curves);
    let groups = groups.map(|(name, points)| Group { name: name.clone(), points }).collect();
    let cloud = Cloud::in_plane(positions, areas, groups).map_err(|error| explain(raw, &error))?;
    Ok(Mesh { cloud, curves: curves.into_iter().map(|(name, sides)| Curve { name, sides }).collect() })
}

/// Corners of all elements, which are in a plane.
pub(super) fn corners(raw: &Raw) -> Result<Vec<Vec<[f64; 3]>>, ReadError> {
    if raw.faces.is_empty() {
        return Err(ReadError::whole("has no triangles or quadrilaterals")
            .hint("mesh in two dimensions, by `gmsh -2`, and save elements of all physical surfaces"));
    }
    let corners: Vec<Vec<[f64; 3]>> = raw.faces.iter().map(|f| places(raw, f)).collect::<Result<_, _>>()?;
    flat(raw, &corners)?;
    Ok(corners)
}

fn explain(raw: &Raw, error: &CloudError) -> ReadError {
    let line = |element: usize| raw.faces[element].line;
    match *error {
        CloudError::Size { point, found } => {
            ReadError::at(line(point), format!("the element has no area: {found}"))
        }
        CloudError::NotFinite { point } => ReadError::at(line(point), "the element has no area"),
        CloudError::Coincident { first, second } => {
            let first = line(first);
            ReadError::at(line(second), format!("the element is at the place of the one in line {first}"))
        }
        ref other => ReadError::whole(other.to_string()),
    }
}

fn places(raw: &Raw, face: &Face) -> Result<Vec<[f64; 3]>, ReadError> {
    face.corners[..face.count].iter().map(|&tag| raw.place(tag, face.line)).collect()
}

/// Refuses meshes that are not in a plane of constant z.
fn flat(raw: &Raw, corners: &[Vec<[f64; 3]>]) -> Result<(), ReadError> {
    let all = || corners.iter().flatten();
    let extent = |k: usize| {
        let fold = |start: f64, pick: fn(f64, f64) -> f64| all().map(|c| c[k]).fold(start, pick);
        fold(f64::NEG_INFINITY, f64::max) - fold(f64::INFINITY, f64::min)
    };
    let height = corners[0][0][2];
    let slack = 1e-9 * extent(0).max(extent(1));
    let off = |c: &&[f64; 3]| (c[2] - height).abs() > slack;
    match corners.iter().zip(&raw.faces).find_map(|(c, face)| Some((c.iter().find(off)?, face))) {
        None => Ok(()),
        Some((corner, face)) => {
            let message =
                format!("the element has a corner at z = {}, others are at z = {height}", corner[2]);
            Err(ReadError::at(face.line, message).hint("a plane body needs a mesh in a plane of constant z"))
        }
    }
}

/// Centroid, and area with the sign of the direction of the corners.
fn centroid(corners: &[[f64; 3]]) -> ([f64; 2], f64) {
    let o = corners[0];
    let mut area = 0.0;
    let mut moment = [0.0; 2];
    for pair in corners[1..].windows(2) {
        let [a, b] = [[pair[0][0] - o[0], pair[0][1] - o[1]], [pair[1][0] - o[0], pair[1][1] - o[1]]];
        let part = 0.5 * (a[0] * b[1] - a[1] * b[0]);
        area += part;
        for k in 0..2 {
            moment[k] += part * (a[k] + b[k]) / 3.0;
        }
    }
    ([o[0] + moment[0] / area, o[1] + moment[1] / area], area)
}

/// Names of the physical groups of a curve, surface or volume.
pub(super) fn names<'a>(raw: &'a Raw, dimension: u64, entity: i64) -> impl Iterator<Item = String> + 'a {
    let tags = raw.physical.get(&(dimension, entity)).map_or(&[][..], Vec::as_slice);
    let kind = ["point", "curve", "surface", "volume"][dimension.min(3) as usize];
    tags.iter().map(move |tag| {
        let name = raw.names.get(&(dimension, *tag));
        name.cloned().unwrap_or_else(|| format!("{kind}_{tag}"))
    })
}

fn surfaces(raw: &Raw) -> BTreeMap<String, Vec<u32>> {
    let mut found: BTreeMap<String, Vec<u32>> = BTreeMap::new();
    let mut members: BTreeMap<i64, Vec<u32>> = BTreeMap::new();
    for (point, face) in (0..).zip(&raw.faces) {
        members.entry(face.surface).or_default().push(point);
    }
    for (surface, points) in members {
        for name in names(raw, 2, surface) {
            found.entry(name).or_default().extend(&points);
        }
    }
    found
}

fn curves(raw: &Raw, corners: &[Vec<[f64; 3]>], turned: &[bool]) -> BTreeMap<String, Vec<Side>> {
    let key = |a: u64, b: u64| [a.min(b), a.max(b)];
    let mut on: HashMap<[u64; 2], Vec<i64>> = HashMap::new();
    for piece in &raw.pieces {
        let curves = on.entry(key(piece.ends[0], piece.ends[1])).or_default();
        if !curves.contains(&piece.curve) {
            curves.push(piece.curve);
        }
    }
    let mut found: BTreeMap<String, Vec<Side>> = BTreeMap::new();
    for (point, face) in raw.faces.iter().enumerate() {
        for k in 0..face.count {
            let next = (k + 1) % face.count;
            let Some(curves) = on.get(&key(face.corners[k], face.corners[next])) else { continue };
            let [a, b] = [k, next].map(|c| [corners[point][c][0], corners[point][c][1]]);
            let (from, to) = if turned[point] { (b, a) } else { (a, b) };
            for name in curves.iter().flat_map(|curve| names(raw, 1, *curve)) {
                let sides = found.entry(name).or_default();
                let side = Side { point: point as u32, from, to };
                if sides.last() != Some(&side) {
                    sides.push(side);
                }
            }
        }
    }
    found
}
