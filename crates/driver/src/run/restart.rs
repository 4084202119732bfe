//! What it takes to go on with a run that was interrupted.

use super::fracture::BreakRestart;
use super::path::PathRestart;
use serde::{Deserialize, Serialize};

/// What it takes to go on from an equilibrium.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Restart {
    /// The case, [`crate::scene::Scene::fingerprint`]; a run leaves it empty, [`crate::Loaded::run`] fills it in.
    pub case: String,
    /// What the summary says of the recorded states; filled in likewise.
    pub summaries: String,
    /// Number of states that were recorded.
    pub recorded: usize,
    /// The equilibrium, and all that was found before.
    pub from: RestartFrom,
}

/// An equilibrium to go on from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum RestartFrom {
    /// Of a body that breaks.
    Break(Box<BreakRestart>),
    /// Of a body that softens.
    Path(Box<PathRestart>),
}

impl Restart {
    /// What a run says of an equilibrium.
    pub(super) fn new(recorded: usize, from: RestartFrom) -> Self {
        Self { case: String::new(), summaries: String::new(), recorded, from }
    }
}
