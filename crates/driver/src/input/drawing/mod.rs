//! Outlines that were drawn elsewhere: meshes of Gmsh, DXF and SVG.
//!
//! Readers find strokes: straight lines, and the chords of curves. Strokes whose ends meet form loops; the largest one is the border,
//! all others are holes in it.

pub(crate) mod curve;
mod dxf;
mod ends;
mod loops;
mod pairs;
mod strokes;
mod svg;
mod svg_shape;

#[cfg(test)]
mod tests;

use super::ReadError;
use super::gmsh::{self, Part};
use curve::Arc;
use peristat_assembly::body::BorderMember;
use strokes::{Stroke, Strokes, UNTOLD};

/// A closed line.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// Its vertices, counter-clockwise.
    pub vertices: Vec<[f64; 2]>,
    /// How many edges each of its sides has.
    pub sides: Vec<usize>,
}

/// A hole that is drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum DrawnHole {
    /// A circle.
    Circle {
        /// Its middle.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
    },
    /// Any other.
    Loop(Loop),
}

/// What a drawing bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// The border.
    pub border: Loop,
    /// What is left out.
    pub holes: Vec<DrawnHole>,
    /// Names with the parts of the border that have them.
    pub names: Vec<(String, Vec<BorderMember>)>,
    /// Named parts of the surface.
    pub parts: Vec<Part>,
}

/// Reads a drawing. Chords of its curves are this far from them at most, in lengths of the file.
///
/// # Errors
/// [`ReadError`]: something else than what belongs in a line, lines that do not close, more than one outline.
pub fn read(bytes: &[u8], deviation: f64) -> Result<Drawing, ReadError> {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    let (mut strokes, parts) = match text {
        _ if gmsh::is_mesh(bytes) => of_mesh(gmsh::read_border(bytes)?)?,
        [b'<', ..] => (svg::read(bytes, deviation)?, Vec::new()),
        _ if text.starts_with(b"AutoCAD Binary DXF") => {
            return Err(
                ReadError::whole("is a binary DXF file, ASCII is read").hint("save it as DXF in ASCII")
            );
        }
        [b'0' | b'9', ..] => (dxf::read(bytes, deviation)?, Vec::new()),
        _ => {
            return Err(ReadError::at(1, "is no Gmsh mesh, no DXF file and no SVG file")
                .hint("a mesh starts with $MeshFormat, DXF with 0 and SECTION, SVG with <"));
        }
    };
    // A circle that is the whole border is a polygon, like all others.
    if let Some(k) = loops::round_border(&strokes) {
        let circle = strokes.circles.remove(k);
        let points = Arc::circle(circle.centre, circle.radius).chords(deviation);
        strokes.add(Stroke { points, names: circle.names, line: circle.line, curve: None })?;
    }
    let mut drawing = loops::drawing(strokes)?;
    drawing.parts = parts;
    Ok(drawing)
}

/// The sides of a mesh as strokes.
fn of_mesh(border: gmsh::Border) -> Result<(Strokes, Vec<Part>), ReadError> {
    let mut strokes = Strokes::default();
    for gmsh::BorderSide { ends, line, curve, names } in border.sides {
        let curve = curve.or(Some(UNTOLD));
        strokes.add(Stroke { points: ends.to_vec(), names, line, curve })?;
    }
    Ok((strokes, border.parts))
}

impl Drawing {
    /// With all lengths multiplied.
    #[must_use]
    pub fn scaled(mut self, scale: f64) -> Self {
        let stretch = |points: &mut Vec<[f64; 2]>| points.iter_mut().flatten().for_each(|x| *x *= scale);
        stretch(&mut self.border.vertices);
        for hole in &mut self.holes {
            match hole {
                DrawnHole::Circle { centre, radius } => {
                    centre.iter_mut().for_each(|x| *x *= scale);
                    *radius *= scale;
                }
                DrawnHole::Loop(hole) => stretch(&mut hole.vertices),
            }
        }
        self.parts.iter_mut().flat_map(|part| &mut part.elements).for_each(stretch);
        self
    }
}
