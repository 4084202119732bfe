//! From state to state, to every place where the path turns.

use super::super::certificate::{self, Certificate, Seen};
use super::super::measures::ratio;
use super::super::scan;
use super::super::workspace::StateSolution;
use super::super::{Advance, RunError, RunReport, Sink, Sizes, SolvedState};
use super::auto::Chosen;
use super::body::{Body, State};
use super::control::{Goal, Step};
use super::course::Course;
use super::ending::Ending;
use super::facts::facts;
use super::newton::TOLERANCE;
use super::point::PathPoint;
use super::problem::SofteningBody;
use super::report::report;
use peristat_assembly::system::System;
use std::time::Instant;

/// A run along a path.
struct Run<'a, const D: usize, P> {
    body: &'a mut P,
    course: Course<D>,
    recorded: usize,
    /// Largest displacement of a recorded state so far: back at none, there is still a scale.
    farthest: f64,
    /// Wall time of records, s.
    seconds: f64,
}

/// Follows the path of a prepared problem, and hands its states on.
///
/// # Errors
/// [`RunError`]: the stiffness has no factor, a result cannot be taken.
pub(in super::super) fn run<const D: usize, P: SofteningBody<D>>(
    body: &mut P,
    (system, sizes): (System<D>, Sizes),
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError> {
    let mut loads = vec![0.0; system.size()];
    body.problem().add_load(0, &mut loads);
    let positions = body.problem().positions();
    let softening = Body::new(system, body.bonds(), loads, positions)?;
    let scene = body.path().clone();
    let course = Course::new(softening, scene.increment)?;
    let mut chosen = Chosen::new(&scene, &course);
    let (unit, work) = &course.unit;
    let elastic = body.probes(&unit.u, &course.body.multipliers(unit))[scene.load];
    body.set_elastic(elastic, *work);
    let mut run = Run { body, course, recorded: 0, farthest: 0.0, seconds: 0.0 };
    let rest = run.course.at_rest();
    run.tell(rest, 1.0, sink)?;
    let mut ending = Ending::Arrived;
    'turns: for (number, &goal) in scene.turns.iter().enumerate() {
        loop {
            let from = run.course.state.load_factor;
            let towards = match goal {
                Goal::LoadFactor(to) => (to - from).signum(),
                Goal::Load(_) => -1.0,
            };
            let load = |course: &Course<D>, state: &State<D>| {
                let multipliers = course.body.multipliers(state);
                run.body.probes(&state.u, &multipliers)[run.body.path().load]
            };
            let Step::To(state, cost, arrived) = chosen.step(&scene, &mut run.course, goal, &load)? else {
                ending = Ending::Stuck;
                break 'turns;
            };
            let point = run.course.accept(state, cost);
            let is_last = number + 1 == scene.turns.len();
            chosen.committed(&mut run.course, arrived && !is_last);
            run.tell(point, towards * (run.course.state.load_factor - from), sink)?;
            if let Some(end) = run.ending() {
                ending = end;
                break 'turns;
            }
            if arrived {
                if !is_last {
                    run.record(sink)?;
                }
                break;
            }
            if run.course.accepted.is_multiple_of(scene.record_every) {
                run.record(sink)?;
            }
            if sink.is_interrupted() {
                ending = Ending::Interrupted;
                break 'turns;
            }
        }
    }
    // One that was interrupted may have recorded it.
    if ending != Ending::Interrupted || !run.course.accepted.is_multiple_of(scene.record_every) {
        run.record(sink)?;
    }
    let Run { course, seconds, .. } = run;
    Ok(report(course, &scene, &chosen, (sizes, ending), seconds))
}

impl<const D: usize, P: SofteningBody<D>> Run<'_, D, P> {
    /// Tells of a committed state, `along` being positive where it came on its way.
    fn tell(&mut self, mut point: PathPoint, along: f64, sink: &mut dyn Sink) -> Result<(), RunError> {
        let state = &self.course.state;
        let multipliers = self.course.body.multipliers(state);
        point.probes = self.body.probes(&state.u, &multipliers);
        point.load = point.probes[self.body.path().load];
        point.is_back = along < 0.0;
        self.body.measure(&self.course.body.bonds, &mut point);
        sink.advance(Advance::Path(&point), None)?;
        self.course.points.push(point);
        Ok(())
    }

    /// Whether the run ends at the last state although the path goes on.
    fn ending(&self) -> Option<Ending> {
        let scene = self.body.path();
        let load = |p: &PathPoint| p.load.abs();
        let peak = self.course.points.iter().map(load).fold(0.0, f64::max);
        let last = self.course.points.last()?;
        if scene.stop_below.is_some_and(|part| last.softened + last.broken > 0 && load(last) < part * peak) {
            Some(Ending::LoadGone)
        } else if self.course.accepted >= scene.max_steps {
            Some(Ending::MostSteps)
        } else {
            None
        }
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
