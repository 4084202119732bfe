//! Results of single states.

use super::beam::BeamResult;
use super::body::BodyResult;
use super::plate::PlateResult;
use super::state_record::StateRecord;

/// The result of one state.
#[derive(Clone, Debug)]
pub enum StateResult {
    /// Of a beam or frame.
    Beam(BeamResult),
    /// Of a body in the plane.
    Body(BodyResult),
    /// Of a plate in bending.
    Plate(PlateResult),
}

impl StateResult {
    /// What it is, whatever the model.
    pub fn record(&self) -> &StateRecord {
        match self {
            Self::Beam(result) => &result.record,
            Self::Body(result) => &result.record,
            Self::Plate(result) => &result.record,
        }
    }

    /// What it is, whatever the model, to be changed.
    pub(super) fn record_mut(&mut self) -> &mut StateRecord {
        match self {
            Self::Beam(result) => &mut result.record,
            Self::Body(result) => &mut result.record,
            Self::Plate(result) => &mut result.record,
        }
    }
}
