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
    /// Poisson's ratios of the materials of regions, where these give any; none where all of the body is of the base material.
    pub materials: Option<Vec<f64>>,
    /// Angles of the fibres of materials of regions that give one, degrees.
    pub fibre_angles: Vec<f64>,
    /// Sides that are lines of symmetry, by name.
    pub symmetry: &'a [String],
    /// Pairs of sides that are joined, in the order of the case.
    pub joined: Vec<JoinedSides>,
}

/// Horizon per spacing of bodies with cracks or bonds that fail, if nothing else is given: the usual one of the literature.
pub const USUAL_HORIZON_RATIO: f64 = 3.0;

impl Asked<'_> {
    /// Whether the body stays whole and elastic.
    pub fn stays_whole(&self) -> bool {
        !(self.breaks || self.softens || self.has_cracks)
    }

    /// The largest Poisson's ratio of a body whose base material has one.
    pub fn most_poisson_ratio(&self, base: f64) -> f64 {
        self.materials.iter().flatten().copied().fold(base, f64::max)
    }

    /// Horizon per spacing, if nothing else is given, of a plate whose bonds are exact at its edges. On a lattice that stays whole a
    /// horizon of two spacings has half of the error of three, or less, at half of its cost; cracks want three (`bench/defaults.md`).
    pub fn usual_horizon_ratio(&self) -> f64 {
        if self.stays_whole() && self.body != BodyKind::Points { 2.0 } else { USUAL_HORIZON_RATIO }
    }
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
