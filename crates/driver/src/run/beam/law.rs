//! How far a beam with another bond law, other ends or another grid is from the same beam by default.
//!
//! By default points have the values of the local beam on any grid, so one more solve measures what the others are off by:
//! a formula would have to know supports, loads and grid.

use super::exact_state::ExactState;
use super::twin::{self, Departure, Twin};
use super::{Along, BeamResult, probes, run_linear};
use crate::case::FieldName;
use crate::diagnostic::Faults;
use crate::diagnostic::tidy;
use crate::run::RunOptions;
use crate::scene::beam::BeamScene;
use std::time::Instant;

/// Distance from the exact answer, relative, above which a beam is warned of.
const FAR: f64 = 0.01;
/// Displacements that are kept of all states together, at most. Beams are smooth: some of many points tell the largest.
const MOST_KEPT: usize = 1 << 20;
/// Energy over that of a beam bent by as much, below which motions strain nothing.
const STRAIN_FREE: f64 = 1e-3;

/// What is compared of a state.
struct Answer {
    displacements: Vec<[f64; 2]>,
    /// The largest of them.
    largest: f64,
    state: ExactState,
}

/// Where a beam is furthest from the exact one.
struct Furthest {
    relative: f64,
    what: String,
}

/// Compares the states of a beam with those of the exact one.
pub(super) struct Gauge {
    departures: Vec<Departure>,
    stride: usize,
    exact: Result<Vec<Answer>, String>,
    furthest: Option<Furthest>,
    /// Time that solving the exact beam took, s.
    pub(super) seconds: f64,
}

impl Gauge {
    /// Solves the exact beam; `None` if a scene is that, or nobody asks.
    pub(super) fn new(scene: &BeamScene, options: &RunOptions) -> Option<Self> {
        let departures = if options.compare { twin::departures(scene) } else { Vec::new() };
        if departures.is_empty() {
            return None;
        }
        let begin = Instant::now();
        let stride = (scene.beam.points() * scene.states.len()).div_ceil(MOST_KEPT).max(1);
        let exact = answers(scene, stride, options);
        let seconds = begin.elapsed().as_secs_f64();
        Some(Self { departures, stride, exact, furthest: None, seconds })
    }

    /// Takes the result of a state.
    pub(super) fn compare(&mut self, scene: &BeamScene, result: &BeamResult) {
        let index = result.record.index;
        let Some(exact) = self.exact.as_ref().ok().and_then(|all| all.get(index)) else { return };
        let least = self.furthest.as_ref().map_or(FAR, |f| f.relative);
        let (in_deflection, k) = deviation(result, exact, self.stride);
        let in_energy = if is_moved(scene, index, exact) {
            (result.record.certificate.energy - exact.state.energy).abs() / exact.state.energy
        } else {
            0.0
        };
        let relative = in_deflection.max(in_energy);
        if relative > least {
            let mut what = match in_deflection < in_energy {
                true => "energy".into(),
                false => format!("deflection {}", place(scene, result, k * self.stride)),
            };
            if scene.states.len() > 1 {
                what += &format!(" in `{}`", result.record.name);
            }
            self.furthest = Some(Furthest { relative, what });
        }
    }

    /// Adds what there is to say of the beam, and hands on the states of the exact one.
    pub(super) fn finish(self, warnings: &mut Faults) -> Option<Vec<ExactState>> {
        if let Some(Furthest { relative, what }) = self.furthest {
            let percent = 100.0 * relative;
            let digits = if percent < 99.95 { 1 } else { 0 };
            let beam = twin::words(&self.departures);
            let message = format!("{beam} is {percent:.digits$} % from the exact one in {what}");
            twin::warn(&self.departures, message, warnings);
        }
        match self.exact {
            Ok(answers) => Some(answers.into_iter().map(|answer| answer.state).collect()),
            Err(reason) => {
                warn_of_unknown(&self.departures, &reason, warnings);
                None
            }
        }
    }
}

/// Compares a beam that breaks with the exact one before its first bond breaks; returns the time that it took, s.
pub(super) fn warn_of_intact(scene: &BeamScene, options: &RunOptions, warnings: &mut Faults) -> f64 {
    let departures = if options.compare { twin::departures(scene) } else { Vec::new() };
    if departures.is_empty() {
        return 0.0;
    }
    let begin = Instant::now();
    let options = RunOptions { recover: false, ..*options };
    let compared = twin::intact(scene, options.max_memory)
        .and_then(|intact| super::run(&intact, &options, &mut |_| Ok(())).map_err(|error| error.to_string()));
    match compared {
        Ok(report) => warnings.append(report.warnings),
        Err(reason) => warn_of_unknown(&departures, &reason, warnings),
    }
    begin.elapsed().as_secs_f64()
}

fn warn_of_unknown(departures: &[Departure], reason: &str, warnings: &mut Faults) {
    let beam = twin::words(departures);
    twin::warn(departures, format!("how far {beam} is from the exact one is not known: {reason}"), warnings);
}

/// The answers of the exact beam at the points of a scene, or why there are none.
fn answers(scene: &BeamScene, stride: usize, options: &RunOptions) -> Result<Vec<Answer>, String> {
    let options = RunOptions { recover: false, ..*options };
    let twin = Twin::new(scene, options.max_memory)?;
    let mut all = Vec::new();
    let report = run_linear(&twin.scene, &options, &mut |result| {
        let lines = result.lines.iter().zip(&twin.shared);
        let shared =
            lines.flat_map(|(line, [first, step])| result.displacements_on(line).skip(*first).step_by(*step));
        let displacements: Vec<[f64; 2]> = shared.step_by(stride).collect();
        let largest = displacements.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
        all.push(Answer { displacements, largest, state: state(&twin.scene, &result) });
        Ok(())
    });
    match report {
        Ok(report) if report.converged => Ok(all),
        Ok(_) => Err("with it a state did not converge".into()),
        Err(error) => Err(error.to_string()),
    }
}

/// What estimates of errors need of a state of the exact beam.
fn state(scene: &BeamScene, result: &BeamResult) -> ExactState {
    let along = Along::new(scene, result);
    let largest = |field: &FieldName| {
        let [smallest, largest] = along.extremes(*field)?;
        Some((*field, smallest.0.abs().max(largest.0.abs())))
    };
    // Those that were not recovered have none.
    let fields: &[FieldName] = if scene.probes.is_empty() { result.fields() } else { &[] };
    ExactState {
        probes: probes(scene, result),
        largest: fields.iter().filter_map(largest).collect(),
        energy: result.record.certificate.energy,
    }
}

/// The largest distance from the exact displacements, over the largest of these, and at which of the points.
fn deviation(result: &BeamResult, exact: &Answer, stride: usize) -> (f64, usize) {
    let pairs = result.displacements().step_by(stride).zip(&exact.displacements);
    let distances = pairs.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
    let furthest = (0..).zip(distances).max_by(|a: &(usize, f64), b| a.1.total_cmp(&b.1));
    let (k, distance) = furthest.unwrap_or_default();
    (if distance == 0.0 { 0.0 } else { distance / exact.largest }, k)
}

/// Whether deflections tell nothing of a law, and the energy does: where nothing but motions of supports strains a beam, they
/// are all but prescribed, and where all points are held there are none.
fn is_moved(scene: &BeamScene, state: usize, exact: &Answer) -> bool {
    let loads = &scene.states[state].loads;
    let lines = scene.beam.chains().iter().map(|chain| chain.line());
    let softest = lines.map(|line| line.stiffness.bending.value(0.0) / line.length.powi(3));
    let bent = softest.fold(f64::INFINITY, f64::min) * exact.largest.powi(2);
    // Points that supports hold, all of them, do not deflect whatever the law.
    let is_flat = exact.state.energy > 0.0 && bent <= 1e-12 * exact.state.energy;
    is_flat
        || (loads.point.is_empty() && loads.distributed.is_empty() && exact.state.energy > STRAIN_FREE * bent)
}

/// Where a point is, counted over all lines.
fn place(scene: &BeamScene, result: &BeamResult, point: usize) -> String {
    let mut point = point;
    for (k, line) in result.lines.iter().enumerate() {
        if point < line.x.len() {
            let x = line.x.at(point);
            let x = tidy(format!("{x:.5e}").parse().unwrap_or(x));
            return match &scene.frame {
                Some(frame) => format!("at x = {x} of member `{}`", frame.members[k].name),
                None => format!("at x = {x}"),
            };
        }
        point -= line.x.len();
    }
    "at the end".into()
}
