//! From state to state, to every place where the path turns.

use super::super::certificate::{self, Certificate, Seen};
use super::super::measures::ratio;
use super::super::restart::{Restart, RestartFrom};
use super::super::scan;
use super::super::workspace::StateSolution;
use super::super::{Advance, RunError, RunReport, Sink, Sizes, SolvedState};
use super::auto::Chosen;
use super::body::{Body, State};
use super::control::{Goal, Step};
use super::course::Course;
use super::ending::Ending;
use super::facts::facts;
use super::kept::PathRestart;
use super::newton::TOLERANCE;
use super::point::PathPoint;
use super::problem::SofteningBody;
use super::report::report;
use crate::scene::path::PathScene;
use peristat_assembly::system::System;
use std::time::Instant;

/// A run along a path.
struct Run<'a, const D: usize, P> {
    body: &'a mut P,
    scene: PathScene,
    course: Course<D>,
    chosen: Chosen<D>,
    /// The place where the path turns next, by number.
    turn: usize,
    recorded: usize,
    /// Largest displacement of a recorded state so far: back at none, there is still a scale.
    farthest: f64,
    /// Wall time of records, s.
    seconds: f64,
}

/// Follows the path of a prepared problem from rest or from where another run was interrupted, and hands its states on.
///
/// # Errors
/// [`RunError`]: the stiffness has no factor, the restart does not fit, a result cannot be taken.
pub(in super::super) fn run<const D: usize, P: SofteningBody<D>>(
    body: &mut P,
    (system, sizes): (System<D>, Sizes),
    resume: Option<Restart>,
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError> {
    let mut loads = vec![0.0; system.size()];
    body.problem().add_load(0, &mut loads);
    let positions = body.problem().positions();
    let softening = Body::new(system, body.bonds(), loads, positions)?;
    let scene = body.path().clone();
    let course = Course::new(softening, scene.increment)?;
    let (unit, work) = &course.unit;
    let elastic = body.probes(&unit.u, &course.body.multipliers(unit))[scene.load];
    body.set_elastic(elastic, *work);
    let chosen = Chosen::new(&scene, &course);
    let mut run = Run { body, scene, course, chosen, turn: 0, recorded: 0, farthest: 0.0, seconds: 0.0 };
    match resume {
        Some(Restart { recorded, from: RestartFrom::Path(kept), .. }) => run.resume(recorded, *kept)?,
        Some(_) => return Err(RunError::Misfit),
        None => run.begin(sink)?,
    }
    let ending = loop {
        if let Some(ending) = run.step(sink)? {
            break ending;
        }
    };
    let Run { course, scene, chosen, seconds, .. } = run;
    Ok(report(course, &scene, &chosen, (sizes, ending), seconds))
}

impl<const D: usize, P: SofteningBody<D>> Run<'_, D, P> {
    /// Tells of the state of rest.
    fn begin(&mut self, sink: &mut dyn Sink) -> Result<(), RunError> {
        let rest = self.course.at_rest();
        self.push(rest, 1.0);
        self.tell(None, sink)
    }

    /// Goes to the next state, tells of it, and says whether the run ends there.
    fn step(&mut self, sink: &mut dyn Sink) -> Result<Option<Ending>, RunError> {
        let Some(&goal) = self.scene.turns.get(self.turn) else { return Ok(Some(Ending::Arrived)) };
        let from = self.course.state.load_factor;
        let towards = match goal {
            Goal::LoadFactor(to) => (to - from).signum(),
            Goal::Load(_) => -1.0,
        };
        let (body, load) = (&*self.body, self.scene.load);
        let load = |course: &Course<D>, state: &State<D>| {
            let multipliers = course.body.multipliers(state);
            body.probes(&state.u, &multipliers)[load]
        };
        let Step::To(state, cost, arrived) = self.chosen.step(&self.scene, &mut self.course, goal, &load)?
        else {
            self.record(sink)?;
            return Ok(Some(Ending::Stuck));
        };
        let point = self.course.accept(state, cost);
        self.turn += usize::from(arrived);
        let is_last = self.turn == self.scene.turns.len();
        self.chosen.committed(&mut self.course, arrived && !is_last);
        self.push(point, towards * (self.course.state.load_factor - from));
        let ending = self.ending();
        if ending.is_some() || arrived || self.course.accepted.is_multiple_of(self.scene.record_every) {
            self.record(sink)?;
        }
        self.tell(ending, sink)?;
        match ending {
            None if sink.is_interrupted() => Ok(Some(Ending::Interrupted)),
            ending => Ok(ending),
        }
    }

    /// Adds a committed state to the path, `along` being positive where it came on its way.
    fn push(&mut self, mut point: PathPoint, along: f64) {
        let state = &self.course.state;
        let multipliers = self.course.body.multipliers(state);
        point.probes = self.body.probes(&state.u, &multipliers);
        point.load = point.probes[self.scene.load];
        point.is_back = along < 0.0;
        self.body.measure(&self.course.body.bonds, &mut point);
        self.course.points.push(point);
    }

    /// Tells of the last state, and what it takes to go on from there.
    fn tell(&self, ending: Option<Ending>, sink: &mut dyn Sink) -> Result<(), RunError> {
        let Some(point) = self.course.points.last() else { return Ok(()) };
        let restart = || self.restart();
        sink.advance(Advance::Path(point), ending.is_none().then_some(&restart))?;
        Ok(())
    }

    /// Whether the run ends at the last state although the path goes on.
    fn ending(&self) -> Option<Ending> {
        let scene = &self.scene;
        let load = |p: &PathPoint| p.load.abs();
        let peak = self.course.points.iter().map(load).fold(0.0, f64::max);
        let last = self.course.points.last()?;
        if scene.stop_below.is_some_and(|part| last.softened + last.broken > 0 && load(last) < part * peak) {
            Some(Ending::LoadGone)
        } else if self.course.accepted >= scene.max_steps {
            Some(Ending::MostSteps)
        } else {
            (self.turn == scene.turns.len()).then_some(Ending::Arrived)
        }
    }

    /// Goes on from what another run kept.
    fn resume(&mut self, recorded: usize, kept: PathRestart) -> Result<(), RunError> {
        let body = &self.course.body;
        kept.fits::<D>(body.system.size(), body.bonds.list().len(), self.scene.turns.len())?;
        self.course.resume(&kept);
        let control = (kept.control, kept.reason);
        self.chosen = Chosen::resume(&self.scene, &mut self.course, control, kept.memory)?;
        self.course.body.counters = kept.counters;
        (self.turn, self.recorded, self.farthest) = (kept.turn, recorded, kept.farthest);
        Ok(())
    }

    /// What it takes to go on from the last state.
    fn restart(&self) -> Restart {
        let course = &self.course;
        let (work, largest_work) = course.works();
        let kept = PathRestart {
            points: course.points.clone(),
            turn: self.turn,
            farthest: self.farthest,
            state: course.state.keep(),
            history: course.body.bonds.history().to_vec(),
            work,
            largest_work,
            counters: course.body.counters.clone(),
            control: self.chosen.name,
            reason: self.chosen.reason.clone(),
            memory: self.chosen.memory(course),
        };
        Restart::new(self.recorded, RestartFrom::Path(Box::new(kept)))
    }

    /// Certifies the last state and hands it on.
    fn record(&mut self, sink: &mut dyn Sink) -> Result<(), RunError> {
        let begin = Instant::now();
        let (course, body) = (&mut self.course, &mut *self.body);
        let loads: Vec<f64> = course.body.loads.iter().map(|f| course.state.load_factor * f).collect();
        let correction = course.body.correction(&course.state)?;
        self.farthest = self.farthest.max(scan::largest(&course.state.u));
        let certificate = certify(body, course, &loads, (&correction, self.farthest));
        let solution = StateSolution {
            multipliers: course.body.multipliers(&course.state),
            ..StateSolution::of(course.state.u.clone())
        };
        let solved = SolvedState { state: self.recorded, load: &loads, solution, certificate };
        let name = format!("step {}", course.accepted);
        let bonds = (&course.body.bonds, &course.state.answers);
        let result = body.result(solved, name, course.state.load_factor, facts(&course.points), bonds);
        sink.take(result)?;
        self.recorded += 1;
        self.seconds += begin.elapsed().as_secs_f64();
        Ok(())
    }
}

/// What shows that the last state is in equilibrium: balance of forces and moments, the residual, and the work of the path
/// by forces of bonds.
fn certify<const D: usize, P: SofteningBody<D>>(
    body: &P,
    course: &Course<D>,
    loads: &[f64],
    (correction, farthest): (&[f64], f64),
) -> Certificate {
    let (state, constraints) = (&course.state, course.body.system.constraints());
    let mut held = vec![0.0; state.u.len()];
    for row in constraints.rows() {
        let force = state.forces[row.unknown];
        held[row.unknown] += force;
        row.masters.iter().for_each(|&(m, c)| held[m] -= c * force);
    }
    let held = held.into_iter().enumerate().filter(|h| h.1 != 0.0);
    let last = course.points.last().cloned().unwrap_or_default();
    let balance = certificate::balance(body.problem().model(), loads, held);
    let largest = state.answers.bonds.iter().map(|a| a.force.abs()).fold(0.0, f64::max);
    let residual = state.residual.iter().map(|r| r.abs()).fold(0.0, f64::max);
    let identity = last.identity.abs();
    // The loads of parts that came off, and rigid motions of finite size, have no balance.
    let model = body.problem().model();
    let stored = course.points.iter().map(|p| p.stored).fold(0.0, f64::max);
    let energy = correction.iter().zip(&state.residual).map(|(d, r)| d * r).sum::<f64>().abs();
    let stiffening = ratio(energy, 2.0 * stored);
    let seen = Seen {
        correction: ratio(scan::largest(correction), farthest),
        stiffening,
        strain_correction: model.contrast() * stiffening.sqrt(),
        imbalance: identity,
        calibration: model.calibration_error(),
        contrast: model.contrast(),
    };
    Certificate {
        residual: ratio(residual, largest),
        next_correction: last.residual,
        first_correction: 0.0,
        balance,
        energy_balance: identity,
        energy: last.stored,
        ..seen.certificate(last.residual <= 10.0 * TOLERANCE, true)
    }
}
