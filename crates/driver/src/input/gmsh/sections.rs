//! Sections of MSH 4.1 files.

use super::super::ReadError;
use super::super::lines::{Fields, Lines};
use super::FORMAT;
use std::collections::HashMap;

/// A triangle or quadrilateral.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    pub(super) line: usize,
    pub(super) surface: i64,
    /// Tags of its corners.
    pub(super) corners: [u64; 4],
    /// 3 or 4.
    pub(super) count: usize,
}

/// A piece of a curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) curve: i64,
    /// Tags of its ends.
    pub(super) ends: [u64; 2],
}

/// A tetrahedron.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tetrahedron {
    pub(super) line: usize,
    pub(super) volume: i64,
    /// Tags of its corners.
    pub(super) corners: [u64; 4],
}

/// What a file says.
#[derive(Debug, Default)]
pub(super) struct Raw {
    /// Names of physical groups by dimension and tag.
    pub(super) names: HashMap<(u64, i64), String>,
    /// Tags of physical groups of curves (1), surfaces (2) and volumes (3) by dimension and tag.
    pub(super) physical: HashMap<(u64, i64), Vec<i64>>,
    /// Coordinates by tag.
    pub(super) nodes: HashMap<u64, [f64; 3]>,
    pub(super) faces: Vec<Face>,
    pub(super) pieces: Vec<Piece>,
    pub(super) tetrahedra: Vec<Tetrahedron>,
    /// Line and type of the first elements in space that are no tetrahedra.
    pub(super) others: Option<(usize, u64)>,
}

/// `$MeshFormat`: version, 0 for ASCII, size of numbers in binary files.
pub(super) fn format(lines: &mut Lines) -> Result<(), ReadError> {
    let text = lines.text("the version of the format").map_err(|e| e.hint(FORMAT))?;
    let refused = |reason: String| Err(ReadError::at(lines.number(), reason).hint(FORMAT));
    let mut parts = text.split_ascii_whitespace();
    match (parts.next(), parts.next()) {
        (Some("4.1"), Some("0")) => {}
        (Some("4.1"), Some("1")) => return refused("the mesh is binary, ASCII is read".into()),
        (Some(version), Some("0" | "1")) if version.parse::<f64>().is_ok() => {
            return refused(format!("the mesh has format {version}, 4.1 is read"));
        }
        _ => return refused("expected `4.1 0 8`: version, kind of file, size of numbers".into()),
    }
    end(lines, "$EndMeshFormat")
}

fn end(lines: &mut Lines, name: &str) -> Result<(), ReadError> {
    let found = lines.text(name)?;
    let found_short: String = found.chars().take(40).collect();
    let fault = || ReadError::at(lines.number(), format!("expected {name}, found `{found_short}`"));
    if found == name { Ok(()) } else { Err(fault()) }
}

/// A count that the section says at its start and what it has.
fn agree(line: usize, what: &str, said: u64, found: u64) -> Result<(), ReadError> {
    let fault = || ReadError::at(line, format!("the section says {said} {what} and has {found}"));
    if said == found { Ok(()) } else { Err(fault()) }
}

impl Raw {
    /// Where a node of the element of a line is, m.
    pub(super) fn place(&self, tag: u64, line: usize) -> Result<[f64; 3], ReadError> {
        let missing = || ReadError::at(line, format!("the element has a node {tag}, which does not exist"));
        self.nodes.get(&tag).copied().ok_or_else(missing)
    }

    pub(super) fn physical_names(&mut self, lines: &mut Lines) -> Result<(), ReadError> {
        let count = lines.fields("names")?.count("their number")?;
        for _ in 0..count {
            let text = lines.text("dimension, tag and name of a physical group")?;
            let fault = || ReadError::at(lines.number(), "expected dimension, tag and name in quotes");
            let (numbers, name) = text.split_once('"').ok_or_else(fault)?;
            let name = name.strip_suffix('"').ok_or_else(fault)?;
            let mut numbers = numbers.split_ascii_whitespace();
            let dimension = numbers.next().and_then(|n| n.parse().ok()).ok_or_else(fault)?;
            let tag = numbers.next().and_then(|n| n.parse().ok()).ok_or_else(fault)?;
            self.names.insert((dimension, tag), name.into());
        }
        end(lines, "$EndPhysicalNames")
    }

    pub(super) fn entities(&mut self, lines: &mut Lines) -> Result<(), ReadError> {
        let mut header = lines.fields("numbers of entities")?;
        let mut counts = [0; 4];
        for (count, name) in counts.iter_mut().zip(["points", "curves", "surfaces", "volumes"]) {
            *count = header.count(&format!("the number of {name}"))?;
        }
        for (dimension, count) in (0..).zip(counts) {
            for _ in 0..count {
                let mut fields = lines.fields("an entity")?;
                let tag = fields.integer("its tag")?;
                let tags = physical_tags(&mut fields, if dimension == 0 { 3 } else { 6 })?;
                if dimension > 0 {
                    self.physical.insert((dimension, tag), tags);
                }
            }
        }
        end(lines, "$EndEntities")
    }

    pub(super) fn nodes(&mut self, lines: &mut Lines) -> Result<(), ReadError> {
        let mut header = lines.fields("numbers of blocks and nodes")?;
        let start = lines.number();
        let (blocks, said) = (header.count("the number of blocks")?, header.count("the number of nodes")?);
        let mut found = 0u64;
        for _ in 0..blocks {
            let mut block = lines.fields("a block of nodes")?;
            for name in ["the dimension of its entity", "the tag of its entity", "0 or 1 for parameters"] {
                block.integer(name)?;
            }
            let mut tags = Vec::new();
            for _ in 0..block.count("the number of its nodes")? {
                tags.push(lines.fields("a node")?.count("its tag")?);
            }
            for tag in tags {
                let mut fields = lines.fields("coordinates of a node")?;
                let place = [fields.real("x")?, fields.real("y")?, fields.real("z")?];
                if self.nodes.insert(tag, place).is_some() {
                    return Err(ReadError::at(lines.number(), format!("there are two nodes {tag}")));
                }
                found += 1;
            }
        }
        agree(start, "nodes", said, found)?;
        end(lines, "$EndNodes")
    }

    pub(super) fn elements(&mut self, lines: &mut Lines) -> Result<(), ReadError> {
        let mut header = lines.fields("numbers of blocks and elements")?;
        let start = lines.number();
        let (blocks, said) = (header.count("the number of blocks")?, header.count("the number of elements")?);
        let mut found = 0u64;
        for _ in 0..blocks {
            let mut block = lines.fields("a block of elements")?;
            let dimension = block.count("the dimension of its entity")?;
            let entity = block.integer("the tag of its entity")?;
            let kind = block.count("the type of its elements")?;
            let count = block.count("the number of its elements")?;
            let nodes = match dimension {
                2 => Some(corners_and_nodes(kind, lines.number())?),
                3 => of_tetrahedra(kind),
                _ => None,
            };
            if dimension == 3 && nodes.is_none() {
                self.others.get_or_insert((lines.number(), kind));
            }
            for _ in 0..count {
                let mut fields = lines.fields("an element")?;
                match (dimension, nodes) {
                    (2, Some(nodes)) => {
                        let (corners, count) = corners(&mut fields, nodes, lines.number())?;
                        self.faces.push(Face { line: lines.number(), surface: entity, corners, count });
                    }
                    (3, Some(nodes)) => {
                        let (corners, _) = corners(&mut fields, nodes, lines.number())?;
                        self.tetrahedra.push(Tetrahedron { line: lines.number(), volume: entity, corners });
                    }
                    (1, _) => {
                        fields.count("its tag")?;
                        let ends = [fields.count("its first node")?, fields.count("its second node")?];
                        self.pieces.push(Piece { curve: entity, ends });
                    }
                    _ => {}
                }
                found += 1;
            }
        }
        agree(start, "elements", said, found)?;
        end(lines, "$EndElements")
    }
}

/// Tags of the physical groups of an entity, behind its coordinates; a negative one says that its direction is reversed.
fn physical_tags(fields: &mut Fields, coordinates: usize) -> Result<Vec<i64>, ReadError> {
    for _ in 0..coordinates {
        fields.real("a coordinate")?;
    }
    let mut tags = Vec::new();
    for _ in 0..fields.count("the number of its physical groups")? {
        tags.push(fields.integer("the tag of a physical group")?.saturating_abs());
    }
    Ok(tags)
}

/// Numbers of corners and nodes of a type of elements in the plane; corners come first.
fn corners_and_nodes(kind: u64, line: usize) -> Result<(usize, usize), ReadError> {
    match kind {
        2 => Ok((3, 3)),
        9 => Ok((3, 6)),
        3 => Ok((4, 4)),
        16 => Ok((4, 8)),
        10 => Ok((4, 9)),
        _ => Err(ReadError::at(line, format!("elements of type {kind} are not read"))
            .hint("triangles and quadrilaterals of first and second order are: `Mesh.ElementOrder = 1`")),
    }
}

/// The same of tetrahedra; none for other elements in space.
fn of_tetrahedra(kind: u64) -> Option<(usize, usize)> {
    match kind {
        4 => Some((4, 4)),
        11 => Some((4, 10)),
        _ => None,
    }
}

/// Corners of an element, and how many it has.
fn corners(
    fields: &mut Fields,
    (count, nodes): (usize, usize),
    line: usize,
) -> Result<([u64; 4], usize), ReadError> {
    fields.count("its tag")?;
    let mut corners = [0; 4];
    for k in 0..nodes {
        let tag = fields.count("the tag of a node")?;
        if k < count {
            corners[k] = tag;
        }
    }
    if !fields.at_end() {
        return Err(ReadError::at(line, format!("an element: expected {nodes} nodes, found more")));
    }
    Ok((corners, count))
}
