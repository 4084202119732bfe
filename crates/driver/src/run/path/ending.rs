//! When a path ends.

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ending {
    /// The path is where it was asked to go.
    Arrived,
    /// The load fell below a part of its peak.
    LoadGone,
    /// As many steps as were asked for.
    MostSteps,
    /// No equilibrium was found.
    Stuck,
    /// Somebody asked for it.
    Interrupted,
}

impl Ending {
    /// Whether the last state is the one that was meant.
    pub(super) fn is_goal(self) -> bool {
        self == Self::Arrived
    }

    /// In words.
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::Arrived => "the path is where it was asked to go",
            Self::LoadGone => "the load fell below its part of the peak",
            Self::MostSteps => "as many steps as allowed were made",
            Self::Stuck => "no equilibrium was found beyond this state",
            Self::Interrupted => "the run was interrupted",
        }
    }
}
