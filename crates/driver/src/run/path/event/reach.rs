//! How far a direction leads: to the next bond that reaches a limit or a bend, or fails.

use super::super::classes::At;
use super::super::course::Course;
use super::{Direction, Events};
use peristat_assembly::law::Law;

/// Events that are nearer to each other than this part of the way to the first count as one: symmetric bodies stay so.
const MERGED: f64 = 1e-9;

/// Outcome of an advance to the next event.
pub(super) struct Pending {
    /// Bonds that reach a limit or a bend, and how.
    pub(super) reached: Vec<(u32, At)>,
    /// Bonds that flowed.
    pub(super) flowing: Vec<u32>,
    pub(super) failed: Vec<u32>,
    pub(super) sign: f64,
}

impl<const D: usize> Events<D> {
    /// How far bonds let the path go in a direction, and what happens there.
    pub(super) fn reach(&self, course: &Course<D>, direction: &Direction, most: f64) -> (f64, Pending) {
        let bonds = &course.body.bonds;
        let mut events: Vec<(f64, u32, Option<At>)> = Vec::new();
        for (k, bond) in bonds.list().iter().enumerate() {
            let (rate, history) = (direction.rates[k] / bond.length, &bonds.history()[k]);
            if direction.rates[k].abs() <= direction.noise || history.broken {
                continue;
            }
            let (stretch, law) = (course.stretch(k), bonds.law(k));
            let mut event = |to: f64, at: Option<At>| {
                let way = ((to - stretch) / rate).max(0.0);
                if way.is_finite() {
                    events.push((way, k as u32, at));
                }
            };
            if self.at[k].is_limit() {
                let flows = direction.flowing.binary_search(&(k as u32)).is_ok();
                if flows && self.at[k] == At::Upper {
                    event(law.failure(history), None);
                }
                // A bond that unloads leaves its limit; its next one is behind it.
                let piece = law.piece(stretch, history);
                if !flows && rate < 0.0 && piece.lower > f64::NEG_INFINITY {
                    event(piece.lower, Some(if piece.flows_below { At::Lower } else { At::Below }));
                }
                continue;
            }
            let piece = law.piece(self.at[k].beside(stretch), history);
            if rate > 0.0 {
                match piece.bend < piece.upper {
                    true => event(piece.bend, Some(At::Above)),
                    false => event(piece.upper, Some(At::Upper)),
                }
            } else if piece.lower > f64::NEG_INFINITY {
                event(piece.lower, Some(if piece.flows_below { At::Lower } else { At::Below }));
            }
        }
        let way = events.iter().map(|e| e.0).fold(most, f64::min);
        let here = way * (1.0 + MERGED) + f64::MIN_POSITIVE;
        let mut pending = Pending {
            reached: Vec::new(),
            failed: Vec::new(),
            flowing: direction.flowing.clone(),
            sign: direction.sign,
        };
        for (_, bond, at) in events.into_iter().filter(|e| e.0 <= here) {
            match at {
                Some(at) => pending.reached.push((bond, at)),
                None => pending.failed.push(bond),
            }
        }
        (way, pending)
    }
}
