//! The model that was solved and its derived numbers.

use super::beam::BeamSummary;
use super::body::BodySummary;
use super::plate::PlateSummary;
use serde::Serialize;

/// Model and its derived numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ModelSummary {
    /// A beam or frame.
    Beam(BeamSummary),
    /// A body in the plane.
    Body(BodySummary),
    /// A plate in bending.
    Plate(PlateSummary),
}

impl ModelSummary {
    /// Spacing, of the first line of a beam.
    pub fn spacing(&self) -> f64 {
        match self {
            Self::Beam(beam) => beam.spacing[0],
            Self::Body(plane) => plane.spacing,
            Self::Plate(plate) => plate.spacing,
        }
    }

    /// Horizon, of the first line of a beam.
    pub fn horizon(&self) -> f64 {
        match self {
            Self::Beam(beam) => beam.spacing[0] * beam.horizon_ratio[0],
            Self::Body(plane) => plane.spacing * plane.horizon_ratio,
            Self::Plate(plate) => plate.spacing * plate.horizon_ratio,
        }
    }
}
