//! What the result of a state is, whatever the model.

use super::certificate::Certificate;
use super::fracture::Facts;

/// What the result of a state is, whatever the model.
#[derive(Clone, Debug)]
pub struct StateRecord {
    /// Index among the states of the scene.
    pub index: usize,
    /// Name.
    pub name: String,
    /// Load factor.
    pub load_factor: f64,
    /// Unknowns, one plane per component over all points, ghosts included.
    pub u: Vec<f64>,
    /// Certificate.
    pub certificate: Certificate,
    /// What is known of a body that breaks.
    pub facts: Option<Facts>,
}
