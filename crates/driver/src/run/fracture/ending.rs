//! When a body that breaks has broken.

use super::Event;
use super::breaking::Breaking;
use super::problem::BreakingBody;
use super::unit::Outcome;

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ending {
    /// The loads as written are borne.
    FullLoad,
    /// The load fell below a part of its peak.
    LoadGone,
    /// What carried the loads has come off.
    CameOff,
    /// No equilibrium was found, and it is not known why.
    Lost,
    /// As many equilibria as were asked for.
    MostSolves,
    /// Somebody asked for it.
    Interrupted,
}

impl Ending {
    /// Whether the body bears what was asked for, so that its last state is the one that was meant.
    pub(super) fn is_goal(self) -> bool {
        self == Self::FullLoad
    }

    /// In words.
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::FullLoad => "the full load is reached",
            Self::LoadGone => "the load fell below its part of the peak",
            Self::CameOff => "nothing carries the load any more",
            Self::Lost => "no equilibrium was found: the solver did not converge",
            Self::MostSolves => "as many equilibria as allowed were found",
            Self::Interrupted => "the run was interrupted",
        }
    }
}

impl<const D: usize, P: BreakingBody<D>> Breaking<'_, D, P> {
    pub(super) fn ending(&self, event: &Event) -> Option<Ending> {
        let fracture = self.body.fracture();
        let peak = self.events.iter().map(|e| e.load.abs()).fold(0.0, f64::max);
        if self.outcome == Outcome::Lost {
            Some(Ending::Lost)
        } else if self.outcome == Outcome::Unborne || self.is_slack() {
            Some(Ending::CameOff)
        } else if event.broken > 0 && event.load.abs() < fracture.stop_below * peak {
            Some(Ending::LoadGone)
        } else if event.load_factor >= 1.0 && event.broken_now == 0 {
            Some(Ending::FullLoad)
        } else if self.events.len() >= fracture.max_solves {
            Some(Ending::MostSolves)
        } else {
            None
        }
    }
}
