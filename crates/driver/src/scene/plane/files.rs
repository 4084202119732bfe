//! Bodies that a file lists.

use crate::diagnostic::{Faults, JsonPath};
use crate::input::gmsh::{self, Curve};
use crate::input::{ReadError, points};
use peristat_assembly::body::PlaneBody;
use std::io::ErrorKind;
use std::path::Path;

/// The body of a list of points, of this thickness.
pub(super) fn points(
    folder: &Path,
    file: &str,
    thickness: f64,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<PlaneBody> {
    let bytes = bytes(folder, file, "points", path, faults)?;
    let cloud = points::read(&bytes).and_then(|points| points.cloud(thickness));
    cloud.map_err(|error| refuse(file, "points", &error, path, faults)).ok().map(PlaneBody::Cloud)
}

/// The body of a mesh, and its named curves.
pub(super) fn mesh(
    folder: &Path,
    file: &str,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(PlaneBody, Vec<Curve>)> {
    let bytes = bytes(folder, file, "mesh", path, faults)?;
    let mesh = gmsh::read(&bytes).map_err(|error| refuse(file, "mesh", &error, path, faults)).ok()?;
    Some((PlaneBody::Cloud(mesh.cloud), mesh.curves))
}

fn bytes(folder: &Path, file: &str, what: &str, path: &JsonPath, faults: &mut Faults) -> Option<Vec<u8>> {
    let full = folder.join(file);
    match std::fs::read(&full) {
        Ok(bytes) => Some(bytes),
        Err(error) => {
            let reason = match error.kind() {
                _ if full.is_dir() => "is a folder".into(),
                ErrorKind::NotFound => "does not exist".into(),
                _ => format!("cannot be read: {error}"),
            };
            faults
                .error(path.key("file"), format!("the {what} {file} {reason}"))
                .hint("the path is relative to the case");
            None
        }
    }
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
