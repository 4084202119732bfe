//! Bodies in space and what is cut out of them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A block of cubic cells with a point in the middle of each. Its faces are `left` and `right` across x, `bottom` and `top` across
/// y, `back` and `front` across z.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BlockBody {
    /// Lowest corner; the origin if not given.
    #[serde(default)]
    pub from: [f64; 3],
    /// Lengths along x, y and z, whole multiples of the spacing.
    pub size: [f64; 3],
    /// Side of a cell, > 0.
    pub spacing: f64,
    /// Parts that are cut out of it. Cells whose centres are in one are left out, so that slanted and round borders are stairs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cuts: Vec<SolidCut>,
}

/// What a closed surface bounds, filled with cubic cells, a point in the middle of each whose centre is inside or on it. Sides of the
/// box around it lie on sides of cells where they are whole multiples of the spacing; else the cells are in its middle, as many as come
/// nearest.
///
/// Its faces are the named parts of the surface: `solid` sections of an STL file in ASCII that has several, physical surfaces of a
/// mesh. Parts without a name that lie flat on sides of the box are `left`, `right`, `bottom`, `top`, `back` and `front`, all others
/// together are `rest`. Physical volumes are regions.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolidBody {
    /// STL file, binary or ASCII, or Gmsh file of tetrahedra (MSH 4.1, ASCII), relative to the case, in its folder or below.
    pub file: String,
    /// Side of a cell, > 0.
    pub spacing: f64,
    /// What lengths of the file are multiplied by, > 0; 1 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scale: Option<f64>,
}

/// A part that is cut out of a block.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SolidCut {
    /// A block.
    Block(BlockCut),
    /// A ball.
    Ball(BallCut),
    /// A round bore along an axis, through all of the block.
    Bore(BoreCut),
    /// All but a ball, so that a ball is left.
    OutsideBall(BallCut),
    /// All but a cylinder along an axis, so that a cylinder is left.
    OutsideCylinder(BoreCut),
}

/// A block that is cut out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BlockCut {
    /// Name of its border, for tractions and as a region of the points beside it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Its lowest corner.
    pub from: [f64; 3],
    /// Its lengths along x, y and z, > 0.
    pub size: [f64; 3],
}

/// A ball that is cut out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallCut {
    /// Name of its border, for tractions and as a region of the points beside it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Its middle.
    pub centre: [f64; 3],
    /// Its radius, > 0.
    pub radius: f64,
}

/// An axis of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SpaceAxis {
    /// From `left` to `right`.
    X,
    /// From `bottom` to `top`.
    Y,
    /// From `back` to `front`.
    Z,
}

impl SolidCut {
    /// Its name.
    pub fn name(&self) -> Option<&String> {
        match self {
            Self::Block(cut) => cut.name.as_ref(),
            Self::Ball(cut) | Self::OutsideBall(cut) => cut.name.as_ref(),
            Self::Bore(cut) | Self::OutsideCylinder(cut) => cut.name.as_ref(),
        }
    }
}

impl SpaceAxis {
    /// 0 for x, 1 for y, 2 for z.
    pub fn number(self) -> usize {
        self as usize
    }
}

/// A round bore.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoreCut {
    /// Name of its border, for tractions and as a region of the points beside it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The axis along which it runs.
    pub along: SpaceAxis,
    /// A position in its middle.
    pub centre: [f64; 3],
    /// Its radius, > 0.
    pub radius: f64,
}
