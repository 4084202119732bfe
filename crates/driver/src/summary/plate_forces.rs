//! What holds a plate in bending, as the record of a run has it.

use crate::run::plate::PlateReaction;
use serde::{Deserialize, Serialize};

/// Forces of what holds a plate in bending.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlateForces {
    /// Forces of supports on the plate, in the order of the case, lines of symmetry last.
    pub reactions: Vec<PlateReaction>,
}
