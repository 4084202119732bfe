//! Where bonds are on their laws while the path is traced, and which of those at a limit may flow on.

use super::course::Course;
use peristat_assembly::law::Law;
use serde::{Deserialize, Serialize};

/// How near to its limit a bond is at it, over its yield stretch.
const AT_LIMIT: f64 = 1e-9;

/// Changes of the classes of bonds while a direction is looked for, at most.
const MOST_TRIES: usize = 30;

/// Where a bond is on its law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum At {
    /// On an elastic piece.
    Inside,
    /// Where it flows in tension.
    Upper,
    /// Where it flows in compression.
    Lower,
    /// On the piece below a bend that it has just reached.
    Below,
    /// On that above it.
    Above,
}

impl At {
    /// Whether the bond may flow.
    pub(super) fn is_limit(self) -> bool {
        matches!(self, Self::Upper | Self::Lower)
    }

    /// Sign of the rate of stretch with which it flows.
    pub(super) fn outwards(self) -> f64 {
        if self == Self::Lower { -1.0 } else { 1.0 }
    }

    /// A stretch that is on the right side of a bend at no stretch, whatever rounding made of it.
    pub(super) fn beside(self, stretch: f64) -> f64 {
        match self {
            Self::Below => stretch.min(-f64::MIN_POSITIVE),
            Self::Above => stretch.max(f64::MIN_POSITIVE),
            _ => stretch,
        }
    }

    /// Where a bond is after a step that was not traced.
    pub(super) fn of<const D: usize>(course: &Course<D>, bond: usize) -> Self {
        let (bonds, stretch) = (&course.body.bonds, course.stretch(bond));
        let (law, history) = (bonds.law(bond), &bonds.history()[bond]);
        let near = AT_LIMIT * law.yield_stretch();
        let piece = law.piece(stretch, history);
        if history.broken || !near.is_finite() {
            Self::Inside
        } else if (stretch - piece.upper).abs() <= near {
            Self::Upper
        } else if piece.flows_below && (stretch - piece.lower).abs() <= near {
            Self::Lower
        } else {
            Self::Inside
        }
    }
}

/// A guess at how the path goes on.
pub(super) struct Guess {
    /// Whether towards the goal, 1, or away from it, −1.
    pub(super) along: f64,
    /// Bonds that flow, in order.
    pub(super) flowing: Vec<u32>,
    /// Part of the worst contradiction from which bonds change their class; 0 for all that contradict, 1 for the worst.
    pub(super) flips: f64,
    /// Changes of classes, at most.
    pub(super) tries: usize,
}

impl Guess {
    /// Where the path turns: all bonds unload.
    pub(super) fn unloading() -> Self {
        Self { along: 1.0, flowing: Vec::new(), flips: 0.0, tries: MOST_TRIES }
    }
}

/// Guesses, the likeliest first, with the bonds at their limits, all of which flowed or have just got there; `towards` is
/// whether the path went towards the goal.
///
/// That the path turns back while nearly all bonds unload is consistent, too, and must not be found: the order matters, and
/// a direction that dissipates next to nothing is taken only where there is no other.
pub(super) fn guesses(on: &[u32], towards: bool) -> Vec<Guess> {
    let guess = |along: f64, flips: f64, tries: usize| Guess { along, flowing: on.to_vec(), flips, tries };
    let boldly = guess(1.0, 0.0, MOST_TRIES);
    if on.is_empty() {
        return vec![boldly];
    }
    let carefully = |along: f64| guess(along, 0.3, MOST_TRIES);
    // One bond at a time takes many tries, but does not run in circles.
    let patiently = |along: f64| guess(along, 1.0, 10 * MOST_TRIES);
    match towards {
        true => vec![boldly, carefully(1.0), carefully(-1.0), patiently(-1.0), patiently(1.0)],
        false => vec![carefully(-1.0), boldly, carefully(1.0), patiently(1.0), patiently(-1.0)],
    }
}
