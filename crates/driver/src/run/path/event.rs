//! The exact path of a body whose bonds are piecewise linear: from kink to kink.
//!
//! Between two events, a bond that reaches its limit or fails, the equilibrium path is a straight line. Bonds at their
//! limit either flow on or unload; which ones do is found by trying, beginning with what went on before. The load factor
//! may fall: what a body does that snaps back, and no control of motions can follow, is part of the path.

mod reach;

use super::super::RunError;
use super::classes::{At, Guess, guesses};
use super::control::{Control, Goal, Load, Step};
use super::course::Course;
use super::displacement::Displacement;
use super::kept::{Memory, Traced};
use super::newton::Effort;
use super::point::Cost;
use super::tangent::Tangent;
use peristat_assembly::law::Law;
use reach::Pending;

/// Dissipated energy per load factor over that of the last direction, below which another direction is looked for.
const FALLEN: f64 = 0.02;
/// Rate of a bond over that of the unknowns, below which it is rounding.
const ROUNDING: f64 = 1e-13;
/// Rate of a bond over the largest rate, below which it neither flows nor unloads.
const STILL: f64 = 1e-10;

/// Tracing of events.
pub(super) struct Events<const D: usize> {
    tangent: Tangent<D>,
    /// Where every bond is on its law.
    at: Vec<At>,
    /// Bonds that are at a limit.
    on: Vec<u32>,
    /// Whether the load factor grew along the last step.
    sign: f64,
    /// Energy that the last direction dissipated per load factor.
    dissipated: f64,
    /// Whether the path has just turned.
    turned: bool,
    /// What is to be done when the step at hand is committed.
    pending: Option<Pending>,
    /// A step for where no direction is consistent.
    rescue: Displacement<D>,
}

/// A direction of the path: rates per way travelled.
struct Direction {
    sign: f64,
    unknowns: Vec<f64>,
    /// Rates of the elongations of all bonds.
    rates: Vec<f64>,
    flowing: Vec<u32>,
    /// Negative eigenvalues of the stiffness along it.
    negative: Option<usize>,
    /// Rates that are rounding.
    noise: f64,
}

impl<const D: usize> Events<D> {
    pub(super) fn new(course: &Course<D>, increment: f64) -> Self {
        Self {
            tangent: Tangent::new(course.body.system.size()),
            at: vec![At::Inside; course.body.bonds.list().len()],
            on: Vec::new(),
            sign: 1.0,
            dissipated: 0.0,
            turned: false,
            pending: None,
            rescue: Displacement::new(increment),
        }
    }

    /// Stiffness of a bond that does not flow, N/m.
    fn elastic(&self, course: &Course<D>, bond: usize) -> f64 {
        let bonds = &course.body.bonds;
        let stretch = self.at[bond].beside(course.stretch(bond));
        bonds.list()[bond].stiffness * bonds.law(bond).piece(stretch, &bonds.history()[bond]).slope
    }

    /// Stiffness of a bond that flows at its limit, N/m.
    fn flowing(&self, course: &Course<D>, bond: usize) -> f64 {
        match self.at[bond] {
            At::Upper => {
                course.body.bonds.list()[bond].stiffness * course.body.bonds.law(bond).softening_slope()
            }
            _ => 0.0,
        }
    }

    /// The direction in which the path goes on, and what it took to find it.
    fn direction(
        &mut self,
        course: &mut Course<D>,
        goal_sign: f64,
        effort: &mut Effort,
    ) -> Result<Option<Direction>, RunError> {
        let elastic: Vec<f64> = (0..self.at.len()).map(|k| self.elastic(course, k)).collect();
        let guesses = match self.turned {
            true => vec![Guess::unloading()],
            false => guesses(&self.on, goal_sign * self.sign > 0.0),
        };
        let mut best: Option<(f64, Direction)> = None;
        for guess in guesses {
            let Some(found) = self.settle(course, guess, (&elastic, goal_sign), effort)? else { continue };
            let dissipated = self.dissipation(course, &found);
            let goes_on = dissipated >= FALLEN * self.dissipated;
            if best.as_ref().is_none_or(|b| dissipated > b.0) {
                best = Some((dissipated, found));
            }
            if goes_on {
                break;
            }
        }
        Ok(best.map(|(dissipated, found)| {
            self.dissipated = dissipated;
            found
        }))
    }

    /// The direction that a guess comes to when bonds that contradict it change their class, if it is one.
    fn settle(
        &mut self,
        course: &mut Course<D>,
        guess: Guess,
        (elastic, goal_sign): (&[f64], f64),
        effort: &mut Effort,
    ) -> Result<Option<Direction>, RunError> {
        let Guess { along, mut flowing, flips, tries } = guess;
        let sign = along * goal_sign;
        for _ in 0..tries {
            let mut stiffness = elastic.to_vec();
            flowing.iter().for_each(|&k| stiffness[k as usize] = self.flowing(course, k as usize));
            effort.iterations += 1;
            let Some(unknowns) = self.tangent.direction(course, &stiffness, sign)? else { return Ok(None) };
            let rates = course.body.bonds.elongation_rates(&course.state.answers.bonds, &unknowns);
            let largest = |v: &[f64]| v.iter().fold(0.0, |most: f64, r| most.max(r.abs()));
            // Where a body has parted, rates are the rounding of how its parts move.
            let noise = ROUNDING * largest(&unknowns);
            let still = noise.max(STILL * largest(&rates));
            let wrong = |&k: &u32| {
                let outwards = self.at[k as usize].outwards() * rates[k as usize];
                (k, if flowing.binary_search(&k).is_ok() { -outwards } else { outwards })
            };
            let wrong: Vec<(u32, f64)> = self.on.iter().map(wrong).filter(|w| w.1 > still).collect();
            if wrong.is_empty() {
                // That all bonds unload away from the goal is no path.
                let flows = flowing.iter().any(|&k| rates[k as usize].abs() > noise);
                let goes_on = flows || self.on.is_empty() || along > 0.0;
                let negative = self.tangent.negative_eigenvalues();
                return Ok(goes_on.then_some(Direction { sign, unknowns, rates, flowing, negative, noise }));
            }
            let worst = wrong.iter().map(|w| w.1).fold(0.0, f64::max);
            for &(bond, _) in wrong.iter().filter(|w| w.1 >= flips * worst) {
                match flowing.binary_search(&bond) {
                    Ok(place) => _ = flowing.remove(place),
                    Err(place) => flowing.insert(place, bond),
                }
            }
        }
        Ok(None)
    }

    /// Energy that softening bonds dissipate along a direction.
    fn dissipation(&self, course: &Course<D>, direction: &Direction) -> f64 {
        let bonds = &course.body.bonds;
        let of = |&k: &u32| {
            let (k, bond) = (k as usize, &bonds.list()[k as usize]);
            bond.stiffness * bond.length * bonds.law(k).dissipation_rate() * direction.rates[k]
        };
        direction.flowing.iter().filter(|&&k| self.at[k as usize] == At::Upper).map(of).sum()
    }

    /// A step of the load factor where no direction is consistent; limits are found anew from what it changed.
    fn rescue(&mut self, course: &mut Course<D>, goal: Goal, load: Load<D>) -> Result<Step<D>, RunError> {
        self.pending = None;
        self.rescue.step(course, goal, load)
    }
}

impl<const D: usize> Control<D> for Events<D> {
    fn step(&mut self, course: &mut Course<D>, goal: Goal, load: Load<D>) -> Result<Step<D>, RunError> {
        let from = course.state.load_factor;
        let goal_sign = match goal {
            Goal::LoadFactor(end) => (end - from).signum(),
            Goal::Load(_) => -1.0,
        };
        let mut cost = Cost::default();
        let Some(direction) = self.direction(course, goal_sign, &mut cost.effort)? else {
            return self.rescue(course, goal, load);
        };
        cost.negative = direction.negative;
        let most = match goal {
            _ if direction.sign != goal_sign => f64::INFINITY,
            Goal::LoadFactor(end) => (end - from).abs(),
            Goal::Load(_) => (from - course.farthest_back()).max(0.0),
        };
        let (mut way, mut pending) = self.reach(course, &direction, most);
        if !way.is_finite() {
            return self.rescue(course, goal, load);
        }
        let go = |way: f64, course: &mut Course<D>| {
            let mut state = course.state.clone();
            state.u.iter_mut().zip(&direction.unknowns).for_each(|(u, d)| *u += way * d);
            state.load_factor += way * direction.sign;
            course.body.evaluate(&mut state);
            state
        };
        let mut state = go(way, course);
        let mut is_at_goal = way >= most;
        if is_at_goal && let Goal::LoadFactor(end) = goal {
            state.load_factor = end;
        }
        if let Goal::Load(target) = goal {
            let [here, there] = [load(course, &course.state), load(course, &state)].map(|p| p - target);
            if (here > 0.0) != (there > 0.0) {
                way *= here / (here - there);
                state = go(way, course);
                (pending.reached, pending.failed, is_at_goal) = (Vec::new(), Vec::new(), true);
            } else if is_at_goal {
                return Ok(Step::Stuck);
            }
        }
        self.pending = Some(pending);
        Ok(Step::To(state, cost, is_at_goal))
    }

    fn committed(&mut self, course: &mut Course<D>, turns: bool) {
        self.turned = turns;
        let Some(pending) = self.pending.take() else {
            self.rescue.committed(course, false);
            self.at = (0..self.at.len()).map(|bond| At::of(course, bond)).collect();
            self.on = (0..self.at.len() as u32).filter(|&k| self.at[k as usize].is_limit()).collect();
            return;
        };
        self.sign = pending.sign;
        let left = self.on.iter().filter(|k| pending.flowing.binary_search(k).is_err());
        left.for_each(|&k| self.at[k as usize] = At::Inside);
        pending.reached.iter().for_each(|&(bond, at)| self.at[bond as usize] = at);
        pending.failed.iter().for_each(|&bond| course.fail(bond as usize));
        // Rounding may have failed others, too.
        for &bond in &pending.flowing {
            if course.body.bonds.history()[bond as usize].broken {
                self.at[bond as usize] = At::Inside;
            }
        }
        let fresh = pending.reached.iter().map(|r| r.0);
        self.on = pending
            .flowing
            .iter()
            .copied()
            .chain(fresh)
            .filter(|&k| self.at[k as usize].is_limit())
            .collect();
        self.on.sort_unstable();
        self.on.dedup();
    }

    fn memory(&self, course: &Course<D>) -> Memory {
        let (factored, changed) = self.tangent.factored(&course.body);
        Memory::Event(Traced {
            at: self.at.clone(),
            on: self.on.clone(),
            sign: self.sign,
            dissipated: self.dissipated,
            turned: self.turned,
            factored,
            changed,
            rescue: self.rescue.steps(),
        })
    }

    fn recall(&mut self, course: &mut Course<D>, memory: Memory) -> Result<(), RunError> {
        let Memory::Event(kept) = memory else { return Err(RunError::Misfit) };
        self.tangent.factor_again(course, (kept.factored, &kept.changed))?;
        (self.at, self.on) = (kept.at, kept.on);
        (self.sign, self.dissipated, self.turned) = (kept.sign, kept.dissipated, kept.turned);
        self.rescue.recall_steps(kept.rescue);
        Ok(())
    }
}
