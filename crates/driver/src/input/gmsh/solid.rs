//! The border of tetrahedra.

use super::super::ReadError;
use super::super::surface::{SolidFile, Triangles};
use super::plane::names;
use super::sections::{Raw, Tetrahedron};
use peristat_assembly::body::Facet;
use std::collections::{BTreeMap, HashMap};

/// Sides of a tetrahedron of positive volume, seen from outside counter-clockwise.
const SIDES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

/// Tags of the corners of a triangle, ascending.
type Key = [u64; 3];

/// A tetrahedron with the places of its corners, in the order of positive volume.
struct Placed {
    line: usize,
    tags: [u64; 4],
    places: [[f64; 3]; 4],
}

pub(super) fn border(raw: &Raw) -> Result<SolidFile, ReadError> {
    if let Some((line, kind)) = raw.others {
        return Err(ReadError::at(line, format!("elements of type {kind} are not read"))
            .hint("in space tetrahedra of first and second order are: leave out recombination and extrusion of layers"));
    }
    if raw.tetrahedra.is_empty() {
        return Err(ReadError::whole("has no tetrahedra")
            .hint("mesh in three dimensions, by `gmsh -3`, and save elements of all physical volumes"));
    }
    let placed: Vec<Placed> = raw.tetrahedra.iter().map(|t| place(raw, t)).collect::<Result<_, _>>()?;
    let (of_triangles, names) = surfaces(raw)?;
    let whole = around(placed.iter(), &of_triangles)?;
    let mut parts: BTreeMap<String, Vec<&Placed>> = BTreeMap::new();
    for (tetrahedron, placed) in raw.tetrahedra.iter().zip(&placed) {
        for name in self::names(raw, 3, tetrahedron.volume) {
            parts.entry(name).or_default().push(placed);
        }
    }
    if let Some(name) = names.iter().find(|name| parts.contains_key(*name)) {
        let message = format!("a physical surface and a physical volume have the name `{name}`");
        return Err(ReadError::whole(message).hint("give them different names"));
    }
    let part = |(name, own): (String, Vec<&Placed>)| Ok((name, around(own.into_iter(), &HashMap::new())?));
    let parts = parts.into_iter().map(part).collect::<Result<_, _>>()?;
    Ok(SolidFile { surface: Triangles { facets: whole, names }, parts })
}

fn place(raw: &Raw, tetrahedron: &Tetrahedron) -> Result<Placed, ReadError> {
    let (line, mut tags) = (tetrahedron.line, tetrahedron.corners);
    let mut places = [[0.0; 3]; 4];
    for (place, &tag) in places.iter_mut().zip(&tags) {
        *place = raw.place(tag, line)?;
    }
    let [a, b, c] = [1, 2, 3].map(|k| [0, 1, 2].map(|i| places[k][i] - places[0][i]));
    let volume = a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0]);
    if volume == 0.0 || !volume.is_finite() {
        return Err(ReadError::at(line, "the element has no volume"));
    }
    if volume < 0.0 {
        tags.swap(2, 3);
        places.swap(2, 3);
    }
    Ok(Placed { line, tags, places })
}

/// Names of physical surfaces, and which of them triangles have.
fn surfaces(raw: &Raw) -> Result<(HashMap<Key, u32>, Vec<String>), ReadError> {
    let mut of_triangles = HashMap::new();
    let mut known: Vec<String> = Vec::new();
    for face in raw.faces.iter().filter(|face| face.count == 3) {
        let mut names = names(raw, 2, face.surface);
        let Some(name) = names.next() else { continue };
        let number = known.iter().position(|other| *other == name).unwrap_or_else(|| {
            known.push(name.clone());
            known.len() - 1
        });
        let other = names.next().or_else(|| {
            let before =
                of_triangles.insert(key(face.corners[0], face.corners[1], face.corners[2]), number as u32)?;
            (before != number as u32).then(|| known[before as usize].clone())
        });
        if let Some(other) = other {
            let message = format!("the triangle is in the physical surfaces `{name}` and `{other}`");
            return Err(
                ReadError::at(face.line, message).hint("loads need to know which: leave it in one of them")
            );
        }
    }
    Ok((of_triangles, known))
}

fn key(a: u64, b: u64, c: u64) -> Key {
    let mut key = [a, b, c];
    key.sort_unstable();
    key
}

/// Sides of tetrahedra that belong to one of them alone, in their order.
fn around<'a>(
    all: impl Iterator<Item = &'a Placed> + Clone,
    names: &HashMap<Key, u32>,
) -> Result<Vec<Facet>, ReadError> {
    let side = |t: &Placed, [a, b, c]: [usize; 3]| key(t.tags[a], t.tags[b], t.tags[c]);
    let mut times: HashMap<Key, u8> = HashMap::new();
    for t in all.clone() {
        for corners in SIDES {
            let times = times.entry(side(t, corners)).or_default();
            *times += 1;
            if *times > 2 {
                return Err(ReadError::at(t.line, "a side of the element belongs to two others")
                    .hint("tetrahedra overlap: mesh the body again"));
            }
        }
    }
    let outer = |t: &'a Placed| {
        let own = SIDES.into_iter().filter(|&corners| times.get(&side(t, corners)) == Some(&1));
        own.map(|corners| Facet {
            corners: corners.map(|c| t.places[c]),
            name: names.get(&side(t, corners)).copied(),
        })
        .collect::<Vec<_>>()
    };
    Ok(all.flat_map(outer).collect())
}
