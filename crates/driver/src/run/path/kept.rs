//! What it takes to go on from a state on a path, to the last bit as if the run had not stopped.

use super::super::{Counters, RunError};
use super::body::State;
use super::classes::At;
use super::point::PathPoint;
use crate::case::PathControl;
use peristat_assembly::law::History;
use peristat_assembly::stiffness::{Answer, BondAnswers};
use peristat_assembly::sum::Sum;
use serde::{Deserialize, Serialize};

/// A state on a path, what led there, and how the control goes on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathRestart {
    /// The states so far, that of rest first.
    pub points: Vec<PathPoint>,
    /// The place where the path turns next, by number.
    pub turn: usize,
    /// Largest displacement of a recorded state.
    pub farthest: f64,
    /// The state.
    pub state: KeptState,
    /// What the bonds remember.
    pub history: Vec<History>,
    /// Work of loads and motions, and that of the forces of bonds.
    pub work: [Sum; 2],
    /// The largest work so far.
    pub largest_work: f64,
    /// How often expensive things were done.
    pub counters: Counters,
    /// What drives the body.
    pub control: PathControl,
    /// Why.
    pub reason: String,
    /// What the control remembers.
    pub memory: Memory,
}

/// A state in equilibrium, with what bonds answered before they remembered it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KeptState {
    /// Unknowns, one plane per component.
    pub unknowns: Vec<f64>,
    /// Load factor.
    pub load_factor: f64,
    /// What each bond answers, one number after the other.
    pub answers: Vec<f64>,
    /// Energy of the answers.
    pub energy: f64,
    /// Internal forces less loads.
    pub forces: Vec<f64>,
    /// The same on independent unknowns.
    pub residual: Vec<f64>,
    /// Incremental potential.
    pub potential: f64,
}

/// What a control remembers of the steps so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Memory {
    /// Of steps of the load factor.
    Displacement(Steps),
    /// Of tracing events.
    Event(Traced),
    /// Of steps of dissipated energy.
    Dissipation(Dissipated),
}

/// Steps of the load factor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Steps {
    /// The next one.
    pub step: f64,
    /// Unknowns per load factor along the last one.
    pub last: Option<Vec<f64>>,
    /// Unknowns and load factor of the last committed state.
    pub before: Option<(Vec<f64>, f64)>,
}

/// Tracing of events.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Traced {
    /// Where every bond is on its law.
    pub at: Vec<At>,
    /// Bonds at a limit.
    pub on: Vec<u32>,
    /// Whether the load factor grew.
    pub sign: f64,
    /// Energy that the last direction dissipated per load factor.
    pub dissipated: f64,
    /// Whether the path has just turned.
    pub turned: bool,
    /// Stiffness of every bond in the factor at hand, N/m; empty if there is none.
    pub factored: Vec<f64>,
    /// Bonds that have changed since, in the order of their columns.
    pub changed: Vec<u32>,
    /// Steps for where no direction is consistent.
    pub rescue: Steps,
}

/// Steps of dissipated energy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dissipated {
    /// Energy of the next one, J.
    pub energy: f64,
    /// How many bonds have to soften in a step to drive the next one.
    pub fewest: usize,
    /// Force that dissipates it, per bond.
    pub weights: Option<Vec<f64>>,
    /// Unknowns, load factor and damage of the bonds in the state before.
    pub before: Option<(Vec<f64>, f64, Vec<f64>)>,
    /// The last step: unknowns and load factor.
    pub last: Option<(Vec<f64>, f64)>,
    /// The steps of the load factor that it begins with.
    pub start: Steps,
}

impl<const D: usize> State<D> {
    /// What is kept of it.
    pub(super) fn keep(&self) -> KeptState {
        KeptState {
            unknowns: self.u.clone(),
            load_factor: self.load_factor,
            answers: self.answers.bonds.iter().flat_map(Answer::numbers).collect(),
            energy: self.answers.energy,
            forces: self.forces.clone(),
            residual: self.residual.clone(),
            potential: self.potential,
        }
    }

    /// The state that was kept.
    pub(super) fn kept(kept: KeptState) -> Self {
        let numbers = kept.answers.chunks_exact(D + Answer::<D>::SCALARS);
        let answers = BondAnswers { bonds: numbers.map(Answer::of_numbers).collect(), energy: kept.energy };
        Self {
            u: kept.unknowns,
            load_factor: kept.load_factor,
            answers,
            forces: kept.forces,
            residual: kept.residual,
            potential: kept.potential,
        }
    }
}

impl PathRestart {
    /// Whether this can be of a body with so many unknowns, components and bonds, whose path turns so often.
    ///
    /// # Errors
    /// [`RunError::Misfit`] if something in it is none of this body.
    pub(super) fn fits<const D: usize>(
        &self,
        unknowns: usize,
        bonds: usize,
        turns: usize,
    ) -> Result<(), RunError> {
        let state = &self.state;
        let fits = [&state.unknowns, &state.forces, &state.residual].iter().all(|v| v.len() == unknowns)
            && state.answers.len() == bonds * (D + Answer::<D>::SCALARS)
            && self.history.len() == bonds
            && self.turn < turns
            && !self.points.is_empty()
            && self.memory.fits(unknowns, bonds);
        if fits { Ok(()) } else { Err(RunError::Misfit) }
    }
}

impl Memory {
    fn fits(&self, unknowns: usize, bonds: usize) -> bool {
        match self {
            Self::Displacement(steps) => steps.fits(unknowns),
            Self::Event(traced) => {
                traced.at.len() == bonds
                    && (traced.factored.is_empty() || traced.factored.len() == bonds)
                    && traced.on.iter().chain(&traced.changed).all(|&bond| (bond as usize) < bonds)
                    && traced.rescue.fits(unknowns)
            }
            Self::Dissipation(steps) => {
                steps.weights.iter().all(|w| w.len() == bonds)
                    && steps.before.iter().all(|(u, _, damage)| u.len() == unknowns && damage.len() == bonds)
                    && steps.last.iter().all(|(u, _)| u.len() == unknowns)
                    && steps.start.fits(unknowns)
            }
        }
    }
}

impl Steps {
    fn fits(&self, unknowns: usize) -> bool {
        self.last.iter().chain(self.before.iter().map(|(u, _)| u)).all(|u| u.len() == unknowns)
    }
}
