//! What the models of state-based families have in common.

mod critical;
mod material;
mod section;
mod warn;
mod words;

use super::{Model, Place, Refusal};
use crate::diagnostic::{Faults, JsonPath, tidy};
use peristat_assembly::model::state_based::{StateError, StateParameters};

/// Poisson's ratio above which bodies lock unless changes of volume are means over blocks.
pub(super) const LOCKS: f64 = 0.45;

/// Families and the keys that they come from.
#[derive(Clone, Debug)]
pub(super) struct Families<K> {
    /// Name of the model.
    pub(super) name: &'static str,
    /// Its keys, defaults filled in.
    pub(super) keys: K,
    /// What they mean.
    pub(super) parameters: StateParameters,
    /// Horizon per spacing of a case that gives none.
    pub(super) usual_horizon_ratio: f64,
    /// Whether bonds end on the border only where it cuts cells.
    pub(super) ends_where_cut: bool,
    /// The keys with what the body left of its parameters.
    pub(super) filled: fn(&StateParameters, &K) -> Model,
}

/// Whether Poisson's ratio is that of a stable material; `path` is that of what has it.
pub(crate) fn admissible(nu: f64, path: &JsonPath, faults: &mut Faults) -> bool {
    let fine = -1.0 < nu && nu < 0.5;
    if !fine {
        faults
            .error(
                path.key("poisson_ratio"),
                format!("Poisson's ratio must lie between -1 and 1/2, found {}", tidy(nu)),
            )
            .hint("for a material that keeps its volume take 0.4999: it does not lock");
    }
    fine
}

impl From<StateError> for Refusal {
    fn from(error: StateError) -> Self {
        let at = match error {
            StateError::NoNeighbours(_) => Place::Horizon,
            StateError::NegativeWeights(_) | StateError::NoBorder | StateError::MaterialsNeedGhosts => {
                Place::Key("edges")
            }
            StateError::NegativeAxis => Place::Key("influence"),
            StateError::AxisNeedsGhosts | StateError::AxisNeedsSection => Place::Key("axis"),
            StateError::OffAxis => Place::Body,
        };
        Self::new(&error, at)
    }
}
