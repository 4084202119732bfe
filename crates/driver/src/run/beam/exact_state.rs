//! States of the exact beam beside one that is not.

use crate::case::FieldName;
use crate::run::ProbeResult;

/// What a state of the exact beam has for probes, largest displacements and energy.
#[derive(Clone, Debug)]
pub struct ExactState {
    /// The probes.
    pub probes: Vec<ProbeResult>,
    /// The largest magnitudes of displacements and rotations, where there are no probes.
    pub largest: Vec<(FieldName, f64)>,
    /// Stored energy.
    pub energy: f64,
}
