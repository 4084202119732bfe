//! Reading bodies in space: a closed surface of triangles, or tetrahedra with their border.

use super::surface::SolidFile;
use super::{ReadError, gmsh, stl};

/// Reads a body: a mesh of Gmsh, which says so at its start, or an STL file.
///
/// # Errors
/// [`ReadError`] of [`gmsh::read_solid`] and [`stl::read`].
pub fn read(bytes: &[u8]) -> Result<SolidFile, ReadError> {
    match gmsh::is_mesh(bytes) {
        true => gmsh::read_solid(bytes),
        false => Ok(SolidFile { surface: stl::read(bytes)?, parts: Vec::new() }),
    }
}
