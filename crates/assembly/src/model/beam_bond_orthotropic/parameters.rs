//! How beam bonds are made.

use super::super::plane::{Calibration, Edges};
use super::OrthotropicMaterial;
use serde::{Deserialize, Serialize};

/// From where the calibration `matched` looks for the closest bonds that have the moduli of the material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Start {
    /// Bonds that lie exactly on the fibres carry what the fibres add: the only ones with which cracks run right.
    Aligned,
    /// The closer bonds are to the fibres, the more of it they carry: for elasticity at any angle.
    Oblique,
}

/// Material and bonds of a body of beam bonds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrthotropicParameters {
    /// Material and thickness.
    pub material: OrthotropicMaterial,
    /// Angle of the fibres from x, counter-clockwise, rad.
    pub fibre_angle: f64,
    /// Angle of the rows of the lattice from x, counter-clockwise, rad.
    pub lattice_angle: f64,
    /// Horizon per spacing.
    pub horizon_ratio: f64,
    /// Where the stiffness comes from.
    pub calibration: Calibration,
    /// Start of the calibration `matched`; without one `aligned` where it exists.
    pub start: Option<Start>,
    /// Treatment of edges.
    pub edges: Edges,
}

impl OrthotropicParameters {
    /// Angle of the fibres from the rows of the lattice, rad.
    pub fn relative_angle(&self) -> f64 {
        self.fibre_angle - self.lattice_angle
    }
}
