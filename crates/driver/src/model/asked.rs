//! What a model needs of a case beside its own keys.

use crate::diagnostic::JsonPath;

/// What a case asks of a model beside the model's own keys.
#[derive(Clone, Debug)]
pub struct Asked<'a> {
    /// How the body is given.
    pub body: BodyKind,
    /// Where it is given.
    pub body_path: JsonPath,
    /// Whether bonds break.
    pub breaks: bool,
    /// Whether bonds soften.
    pub softens: bool,
    /// Whether cracks are drawn.
    pub has_cracks: bool,
    /// Sides that are lines of symmetry, by name.
    pub symmetry: &'a [String],
    /// Pairs of sides that are joined, in the order of the case.
    pub joined: Vec<JoinedSides>,
}

/// How a body is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BodyKind {
    /// By its points, listed or those of a mesh.
    Points,
    /// As a rectangle.
    Rectangle {
        /// Lengths along x and y.
        size: [f64; 2],
        /// Side of a cell.
        spacing: f64,
        /// Whether holes are cut out of it.
        has_holes: bool,
    },
    /// Otherwise.
    Other,
}

/// A pair of opposite sides that are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JoinedSides {
    /// Along which axis one lies behind the other: 0 for x, 1 for y.
    pub axis: usize,
    /// Whether the body stretches along it.
    pub stretches: bool,
}

/// A key of a case that has no meaning for a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refused {
    /// The key; `rigid.bearing` is that of a rigid region.
    pub key: &'static str,
    /// Why.
    pub message: &'static str,
    /// What to do about it.
    pub hint: &'static str,
}
