//! The body of a case.

use super::{
    BlockBody, CentreCrackedPanel, CompactTension, Frame, Grading, MeshBody, OutlineBody, PointsBody,
    RectangleBody, SingleEdgeBend, SolidBody,
};
use peristat_assembly::model::timoshenko_beam::Grid;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The region that points fill.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Body {
    /// One straight line along x.
    Line(Line),
    /// Several straight lines along x that do not overlap; only links join them.
    Lines(Vec<Line>),
    /// Straight members between joints in the plane of x and y.
    Frame(Frame),
    /// A rectangle in the plane.
    Rectangle(RectangleBody),
    /// A polygon in the plane.
    Outline(OutlineBody),
    /// Points that a file lists, in the plane or in space.
    Points(PointsBody),
    /// A mesh in the plane.
    Mesh(MeshBody),
    /// A block in space.
    Block(BlockBody),
    /// A body in space from a file.
    Solid(SolidBody),
    /// A compact tension specimen with its pins and its crack.
    CompactTension(CompactTension),
    /// A bend specimen with its rollers and its edge crack.
    SingleEdgeBend(SingleEdgeBend),
    /// A panel with a crack in its middle.
    CentreCrackedPanel(CentreCrackedPanel),
}

/// A straight line along x.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// Position of the left end.
    #[serde(default)]
    pub from: f64,
    /// Length, > 0.
    pub length: f64,
    /// Number of cells, >= 1.
    pub cells: usize,
    /// `nodes`: points on the ends and between cells; `cells`: points in the middle of cells.
    #[serde(default)]
    pub grid: Grid,
    /// Cells of different lengths; all the same if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub grading: Option<Grading>,
}

impl Body {
    /// The lines; frames, bodies in the plane and solids have none.
    pub fn lines(&self) -> &[Line] {
        match self {
            Self::Line(line) => std::slice::from_ref(line),
            Self::Lines(lines) => lines,
            _ => &[],
        }
    }
}
