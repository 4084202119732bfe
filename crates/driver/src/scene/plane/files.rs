//! Bodies that a file lists.

use crate::diagnostic::{Faults, JsonPath};
use crate::input::gmsh::{self, Curve};
use crate::input::{ReadError, points};
use crate::memory;
use peristat_assembly::body::PlaneBody;
use std::fs;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// The body of a list of points, of this thickness, and the hash of the file.
pub(super) fn points(
    folder: &Path,
    file: &str,
    thickness: f64,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(PlaneBody, blake3::Hash)> {
    let bytes = bytes(folder, file, "points", max_memory, path, faults)?;
    let cloud = points::read(&bytes).and_then(|points| points.cloud(thickness));
    let cloud = cloud.map_err(|error| refuse(file, "points", &error, path, faults)).ok()?;
    Some((PlaneBody::Cloud(cloud), blake3::hash(&bytes)))
}

/// The body of a mesh, its named curves, and the hash of the file.
pub(super) fn mesh(
    folder: &Path,
    file: &str,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(PlaneBody, Vec<Curve>, blake3::Hash)> {
    let bytes = bytes(folder, file, "mesh", max_memory, path, faults)?;
    let mesh = gmsh::read(&bytes).map_err(|error| refuse(file, "mesh", &error, path, faults)).ok()?;
    Some((PlaneBody::Cloud(mesh.cloud), mesh.curves, blake3::hash(&bytes)))
}

fn bytes(
    folder: &Path,
    file: &str,
    what: &str,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Vec<u8>> {
    let most = memory::allowed(max_memory).unwrap_or(u64::MAX - 1);
    let (reason, hint) = match read(&folder.join(file), most) {
        Ok(bytes) => return Some(bytes),
        Err(Unread::Folder) => ("is a folder".to_string(), RELATIVE),
        Err(Unread::NoFile) => ("is no regular file".into(), "name a file that lies on a disk"),
        Err(Unread::TooLarge) => (
            format!("is larger than the {} of memory that may be used", memory::words(most)),
            "raise `--max-memory`",
        ),
        Err(Unread::Other(error)) if error.kind() == ErrorKind::NotFound => {
            ("does not exist".into(), RELATIVE)
        }
        Err(Unread::Other(error)) => (format!("cannot be read: {error}"), RELATIVE),
    };
    faults.error(path.key("file"), format!("the {what} {file} {reason}")).hint(hint);
    None
}

const RELATIVE: &str = "the path is relative to the case";

/// Why a file gives no bytes.
enum Unread {
    Folder,
    /// A device or a pipe, which may have no end.
    NoFile,
    TooLarge,
    Other(io::Error),
}

/// The bytes of a regular file with `most` bytes at most.
fn read(file: &Path, most: u64) -> Result<Vec<u8>, Unread> {
    let kind = fs::metadata(file).map_err(Unread::Other)?;
    match (kind.is_dir(), kind.is_file()) {
        (true, _) => return Err(Unread::Folder),
        (_, false) => return Err(Unread::NoFile),
        _ if kind.len() > most => return Err(Unread::TooLarge),
        _ => {}
    }
    let mut bytes = Vec::new();
    let mut some = fs::File::open(file).map_err(Unread::Other)?.take(most.saturating_add(1));
    some.read_to_end(&mut bytes).map_err(Unread::Other)?;
    if bytes.len() as u64 > most { Err(Unread::TooLarge) } else { Ok(bytes) }
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
