//! Choices that every model of a body in the plane has.

use serde::{Deserialize, Serialize};

/// Where the stiffness of bonds comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Calibration {
    /// Bonds with which a lattice has the moduli of the material to rounding.
    #[default]
    Matched,
    /// The constants of the continuum, as published; the moduli of a lattice are then off by a few percent.
    Published,
}

/// What is done about the bonds that points near edges lack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Edges {
    /// Bonds that leave the body end on its border, which moves with the points beside it; where the border cuts cells, triangles
    /// have the parts that lie in the body: every uniform stress is in equilibrium. Where single rows stand alone and
    /// with horizons above ten spacings it is the overlay.
    Border,
    /// Triangles with the stiffness of the missing bonds: every point has the right stiffness for every uniform strain.
    Overlay,
    /// Nothing: points near edges are too soft.
    None,
    /// Bonds are stiffened by the ratio of the full family's volume to the mean volume of both families.
    Volume,
    /// Bonds are stiffened so that uniform stretches along x and along y have about the right energy.
    Energy,
}

impl Edges {
    /// Rows or columns of images beyond a line of symmetry that bonds of some reach need.
    pub(in super::super) fn depth(self, reach: i32) -> i32 {
        // Bonds through the line may end on the border, which moves with the next but one column, too; corners of triangles that
        // a border cuts move with points up to five columns away.
        if self == Self::Border { (reach + 2).max(6) } else { reach }
    }

    /// Whether points near edges have exactly the stiffness of the material, if the others have.
    pub fn is_exact(self) -> bool {
        matches!(self, Self::Border | Self::Overlay)
    }
}
