//! How a shell membrane is made.

use super::super::plane::Calibration;
use serde::{Deserialize, Serialize};

/// What the elongation of a bond is on a cylinder.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum ShellKinematics {
    /// That of the straight line between its points: exact for all six rigid motions.
    #[default]
    Chord,
    /// As published, in the developed plane: rigid motions across the axis cost a little energy.
    Published,
}

/// What is done about the bonds that leave a membrane at its ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum ShellEnds {
    /// They end on the border, which moves with the points beside it: free, held and loaded ends are exact in a uniform stress.
    #[default]
    Border,
    /// They are missing, and the points have other weights. Such ends are held at their outermost points.
    Weights,
}

/// Material, radius and bonds of a shell membrane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShellParameters {
    /// Young's modulus E, Pa, > 0.
    pub youngs_modulus: f64,
    /// Thickness h, m, > 0.
    pub thickness: f64,
    /// Radius R of the middle surface, m, > 0.
    pub radius: f64,
    /// Horizon per spacing.
    pub horizon_ratio: f64,
    /// Elongations.
    pub kinematics: ShellKinematics,
    /// Where the stiffness comes from.
    pub calibration: Calibration,
    /// Ends; of the published calibration bonds are missing there whatever this is.
    pub ends: ShellEnds,
    /// Whether rows of bending resist changes of curvature.
    pub bending: bool,
}

/// The Poisson ratio of every shell membrane.
pub(super) const POISSON_RATIO: f64 = 1.0 / 3.0;

impl ShellParameters {
    /// Bending stiffness `E h³/(12 (1 − ν²))`, N m.
    pub fn bending_stiffness(&self) -> f64 {
        self.youngs_modulus * self.thickness.powi(3) / (12.0 * (1.0 - POISSON_RATIO * POISSON_RATIO))
    }
}
