//! Meshes of Gmsh: MSH 4.1 in ASCII.
//!
//! In a plane, every triangle and quadrilateral becomes a point at its centroid, with its area; physical surfaces and curves become
//! groups of points. In space, tetrahedra have a border, with physical surfaces as its parts; physical volumes are parts of the body.
//! Elements of second order are read as if their sides were straight.
//!
//! Source of the format: Gmsh reference manual, "MSH file format".

mod border;
mod plane;
mod sections;
mod solid;

#[cfg(test)]
mod tests;

use super::ReadError;
use super::lines::Lines;
use super::surface::SolidFile;
pub use border::{Border, BorderSide, Part};
use peristat_assembly::body::Cloud;
use sections::Raw;

/// A side of an element on a curve; the element is on its left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// The point of the element.
    pub point: u32,
    /// First end, m.
    pub from: [f64; 2],
    /// Second end, m.
    pub to: [f64; 2],
}

/// A physical curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Its name.
    pub name: String,
    /// Sides of elements on it, in the order of the elements; a curve inside the body has those of both sides.
    pub sides: Vec<Side>,
}

/// A mesh as points.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// A point per element in the order of the file, with a group per physical surface and curve; those of a curve are the
    /// points whose elements have a side on it. Physical groups without names are called `surface_1` and `curve_1` after
    /// their tags.
    pub cloud: Cloud,
    /// Physical curves.
    pub curves: Vec<Curve>,
}

const FORMAT: &str = "write the mesh by `gmsh -2 -format msh41 -bin 0`, or set `Mesh.MshFileVersion = 4.1` and `Mesh.Binary = 0`";

/// Reads a mesh.
///
/// # Errors
/// [`ReadError`]: another format, something else than what belongs in a line, a mesh that is not in a plane of constant z,
/// elements of more than second order, elements without area or at the same place.
pub fn read(bytes: &[u8]) -> Result<Mesh, ReadError> {
    plane::mesh(&raw(bytes)?)
}

/// Reads the border of a mesh of tetrahedra, with physical surfaces as its parts and physical volumes as parts of the body.
///
/// # Errors
/// [`ReadError`]: another format, something else than what belongs in a line, elements in space that are no tetrahedra or have no
/// volume, more than two tetrahedra at a side, surfaces in several groups.
pub fn read_solid(bytes: &[u8]) -> Result<SolidFile, ReadError> {
    solid::border(&raw(bytes)?)
}

/// Reads the border of a mesh in the plane, its sides named by physical curves, and its physical surfaces.
///
/// # Errors
/// [`ReadError`], as [`read`] has it; a mesh of three dimensions, more than two elements at a side.
pub fn read_border(bytes: &[u8]) -> Result<Border, ReadError> {
    border::border(&raw(bytes)?)
}

/// Whether a file is a mesh of Gmsh.
pub fn is_mesh(bytes: &[u8]) -> bool {
    Lines::new(bytes).raw() == Some(b"$MeshFormat")
}

fn raw(bytes: &[u8]) -> Result<Raw, ReadError> {
    let mut lines = Lines::new(bytes);
    if lines.raw() != Some(b"$MeshFormat") {
        return Err(ReadError::at(1, "is no Gmsh mesh: expected $MeshFormat").hint(FORMAT));
    }
    sections::format(&mut lines)?;
    let mut raw = Raw::default();
    while let Some(line) = lines.raw() {
        let number = lines.number();
        match line {
            b"$PhysicalNames" => raw.physical_names(&mut lines)?,
            b"$Entities" => raw.entities(&mut lines)?,
            b"$Nodes" => raw.nodes(&mut lines)?,
            b"$Elements" => raw.elements(&mut lines)?,
            b"$PartitionedEntities" => {
                return Err(
                    ReadError::at(number, "the mesh is partitioned").hint("save it without partitions")
                );
            }
            [b'$', name @ ..] if !name.starts_with(b"End") => skip(&mut lines, name)?,
            _ => {
                let found: String = String::from_utf8_lossy(line).chars().take(40).collect();
                return Err(ReadError::at(
                    number,
                    format!("expected the start of a section, found `{found}`"),
                ));
            }
        }
    }
    Ok(raw)
}

/// Passes over a section that nothing is read from.
fn skip(lines: &mut Lines, name: &[u8]) -> Result<(), ReadError> {
    let number = lines.number();
    while let Some(line) = lines.raw() {
        if line.strip_prefix(b"$End") == Some(name) {
            return Ok(());
        }
    }
    Err(ReadError::at(number, "the section that starts here has no end"))
}
