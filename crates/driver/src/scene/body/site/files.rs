//! Bodies that a file lists.

use crate::diagnostic::{Faults, JsonPath};
use crate::input::drawing::{self, Drawing};
use crate::input::gmsh::{self, Curve};
use crate::input::surface::SolidFile;
use crate::input::{Folder, ReadError, Refusal, points, solid, stl, table};
use peristat_assembly::body::{Facet, PointBody};

/// The body of a list of points with this number of coordinates, in the plane of this thickness, and the hash of the file.
pub(crate) fn points(
    folder: &Folder,
    file: &str,
    (axes, thickness): (usize, f64),
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(PointBody, blake3::Hash)> {
    let bytes = bytes(folder, file, "points", max_memory, path, faults)?;
    let cloud = points::read(&bytes, axes).and_then(|points| points.cloud(thickness));
    let cloud = cloud.map_err(|error| refuse(file, "points", &error, path, faults)).ok()?;
    Some((PointBody::Cloud(cloud), blake3::hash(&bytes)))
}

/// The body of a mesh, its named curves, and the hash of the file.
pub(crate) fn mesh(
    folder: &Folder,
    file: &str,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(PointBody, Vec<Curve>, blake3::Hash)> {
    let bytes = bytes(folder, file, "mesh", max_memory, path, faults)?;
    let mesh = gmsh::read(&bytes).map_err(|error| refuse(file, "mesh", &error, path, faults)).ok()?;
    Some((PointBody::Cloud(mesh.cloud), mesh.curves, blake3::hash(&bytes)))
}

/// What a drawing bounds, with chords this far from its curves at most, and the hash of the file.
pub(crate) fn drawing(
    folder: &Folder,
    file: &str,
    deviation: f64,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(Drawing, blake3::Hash)> {
    let bytes = bytes(folder, file, "drawing", max_memory, path, faults)?;
    let drawing = drawing::read(&bytes, deviation);
    let drawing = drawing.map_err(|error| refuse(file, "drawing", &error, path, faults)).ok()?;
    Some((drawing, blake3::hash(&bytes)))
}

/// The body in space of a file, and the hash of the file.
pub(crate) fn solid(
    folder: &Folder,
    file: &str,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(SolidFile, blake3::Hash)> {
    let bytes = bytes(folder, file, "solid", max_memory, path, faults)?;
    let solid = solid::read(&bytes).map_err(|error| refuse(file, "solid", &error, path, faults)).ok()?;
    Some((solid, blake3::hash(&bytes)))
}

/// The triangles of a surface, which need not be closed.
pub(crate) fn surface(
    folder: &Folder,
    file: &str,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Vec<Facet>> {
    let bytes = bytes(folder, file, "surface", max_memory, path, faults)?;
    let triangles = stl::read(&bytes).map_err(|error| refuse(file, "surface", &error, path, faults)).ok()?;
    Some(triangles.facets)
}

/// The table of a quantity that varies in a body with these many coordinates.
pub(crate) fn table(
    folder: &Folder,
    file: &str,
    coordinates: usize,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<table::Table> {
    let bytes = bytes(folder, file, "table", max_memory, path, faults)?;
    table::read(&bytes, coordinates).map_err(|error| refuse(file, "table", &error, path, faults)).ok()
}

fn bytes(
    folder: &Folder,
    file: &str,
    what: &str,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Vec<u8>> {
    let refuse = |refusal: Refusal| {
        let fault = faults.error(path.key("file"), format!("the {what} {file} {}", refusal.reason));
        fault.hint(refusal.hint.unwrap_or("the path is relative to the case"));
    };
    folder.read(file, max_memory).map_err(refuse).ok()
}

fn refuse(file: &str, what: &str, error: &ReadError, path: &JsonPath, faults: &mut Faults) {
    let message = match error.line {
        Some(line) => format!("the {what} {file}, line {line}: {}", error.message),
        None => format!("the {what} {file} {}", error.message),
    };
    let fault = faults.error(path.key("file"), message);
    if let Some(hint) = error.hint {
        fault.hint(hint);
    }
}
