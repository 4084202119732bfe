//! How bonds are made: their stiffness over length and its calibration.

use super::super::plane::{Calibration, Edges};
use super::PlaneMaterial;
use serde::{Deserialize, Serialize};

/// How the stiffness of bonds depends on their length ξ: the influence function ω; δ is the horizon.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Influence {
    /// `ω = 1`.
    #[default]
    Constant,
    /// `ω = δ/ξ`.
    Inverse,
    /// `ω = 1 − ξ/δ`.
    Linear,
}

impl Influence {
    /// ω at `ratio = ξ/δ`.
    pub fn at(self, ratio: f64) -> f64 {
        match self {
            Self::Constant => 1.0,
            Self::Inverse => 1.0 / ratio,
            Self::Linear => (1.0 - ratio).max(0.0),
        }
    }

    /// `∫₀¹ ω(r) r² dr`.
    pub fn second_moment(self) -> f64 {
        match self {
            Self::Constant => 1.0 / 3.0,
            Self::Inverse => 0.5,
            Self::Linear => 1.0 / 12.0,
        }
    }

    /// `∫₀¹ ω(r) r³ dr`.
    pub fn third_moment(self) -> f64 {
        match self {
            Self::Constant => 0.25,
            Self::Inverse => 1.0 / 3.0,
            Self::Linear => 0.05,
        }
    }

    /// `∫₀¹ ω(r) r⁴ dr`.
    pub fn fourth_moment(self) -> f64 {
        match self {
            Self::Constant => 0.2,
            Self::Inverse => 0.25,
            Self::Linear => 1.0 / 30.0,
        }
    }
}

/// Which of all bonds with the exact moduli are taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Weights {
    /// Those nearest to the influence function.
    #[default]
    Nearest,
    /// Those of them whose moments of the sixth order have no direction, in the plane from a horizon ratio of 3 on those of the eighth,
    /// too. Inside a body that no body force loads displacements have an error of the fourth order in the spacing, those of `nearest`
    /// of the second.
    Isotropic,
}

/// Part of the volume of a neighbour that is taken to lie inside the horizon, for the calibration `published`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum VolumeFactor {
    /// All of it where its centre is inside.
    Full,
    /// As `ramp`, but nothing where its centre is outside: 13 % too soft at a horizon ratio of 3.
    Clip,
    /// `(δ + h/2 − ξ)/h` between 0 and 1.
    #[default]
    Ramp,
    /// The exact overlap of its cell with the disc.
    Area,
}

/// Material and bonds of a body in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneParameters {
    /// Material and thickness.
    pub material: PlaneMaterial,
    /// Horizon per spacing.
    pub horizon_ratio: f64,
    /// Stiffness over length.
    pub influence: Influence,
    /// Where the stiffness comes from.
    pub calibration: Calibration,
    /// Which of all exact bonds are taken, by the calibration `matched`.
    pub weights: Weights,
    /// Parts of neighbours inside the horizon; the calibration `matched` needs none.
    pub volume_factor: VolumeFactor,
    /// Treatment of edges.
    pub edges: Edges,
}

impl PlaneParameters {
    /// Whether published formulas of critical stretches, which are those of ω = 1, speak of these bonds: isotropic ones dissipate an
    /// eighth less than such a formula says.
    pub fn suits_published_formulas(&self) -> bool {
        self.influence == Influence::Constant && self.weights == Weights::Nearest
    }
}
