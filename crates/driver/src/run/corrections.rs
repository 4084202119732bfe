//! How displacements were corrected.

use serde::{Deserialize, Serialize};

/// The corrections of a state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Corrections {
    /// The largest displacement of each one that was taken over the largest of all.
    pub sizes: Vec<f64>,
    /// Whether a further one had more than half of the one before it, in energy norm, and was not taken.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub stalled: bool,
}
