//! How far a beam with another bond law is from the same beam with the law that is exact.
//!
//! The law `exact` gives points the values of the local beam on any grid, so one more solve measures what the other laws
//! are off by: a formula would have to know supports, loads and grid.

use super::{BeamResult, run_linear};
use crate::case::Model;
use crate::diagnostic::{Faults, JsonPath};
use crate::run::RunOptions;
use crate::scene::beam::BeamScene;
use crate::scene::{Scene, tidy};
use std::path::Path;
use std::time::Instant;

/// The law that others are compared with.
const EXACT: &str = "exact";
/// Distance from the exact answer, relative, above which a law is warned of.
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
    energy: f64,
}

/// Where a law is furthest from the exact one.
struct Furthest {
    relative: f64,
    what: String,
}

/// Compares the states of a beam with those that exact bonds give it.
pub(super) struct Gauge {
    law: &'static str,
    stride: usize,
    exact: Result<Vec<Answer>, String>,
    furthest: Option<Furthest>,
    /// Time that solving with exact bonds took, s.
    pub(super) seconds: f64,
}

impl Gauge {
    /// Solves a scene with exact bonds; `None` if it has these.
    pub(super) fn new(scene: &BeamScene, options: &RunOptions) -> Option<Self> {
        let law = scene.beam.parameters().bond_law;
        if law.is_element {
            return None;
        }
        let begin = Instant::now();
        let stride = (scene.beam.points() * scene.states.len()).div_ceil(MOST_KEPT).max(1);
        let exact = answers(scene, stride, options);
        let seconds = begin.elapsed().as_secs_f64();
        Some(Self { law: law.name, stride, exact, furthest: None, seconds })
    }

    /// Takes the result of a state.
    pub(super) fn compare(&mut self, scene: &BeamScene, result: &BeamResult) {
        let index = result.record.index;
        let Some(exact) = self.exact.as_ref().ok().and_then(|all| all.get(index)) else { return };
        let least = self.furthest.as_ref().map_or(FAR, |f| f.relative);
        let (in_deflection, k) = deviation(result, exact, self.stride);
        let in_energy = if is_moved(scene, index, exact) {
            (result.record.certificate.energy - exact.energy).abs() / exact.energy
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

    /// Adds what there is to say of the law.
    pub(super) fn warn(self, warnings: &mut Faults) {
        match (self.exact, self.furthest) {
            (Err(reason), _) => warn(
                format!("how far the law `{}` is from the exact one is not known: {reason}", self.law),
                warnings,
            ),
            (Ok(_), Some(Furthest { relative, what })) => {
                let percent = 100.0 * relative;
                let digits = if percent < 99.95 { 1 } else { 0 };
                let law = self.law;
                warn(
                    format!("the law `{law}` is {percent:.digits$} % from the exact one in {what}"),
                    warnings,
                );
            }
            (Ok(_), None) => {}
        }
    }
}

/// Compares a beam that breaks with exact bonds before its first one breaks; returns the time that it took, s.
pub(super) fn warn_of_intact(scene: &BeamScene, options: &RunOptions, warnings: &mut Faults) -> f64 {
    let law = scene.beam.parameters().bond_law;
    if law.is_element {
        return 0.0;
    }
    let begin = Instant::now();
    let options = RunOptions { recover: false, ..*options };
    let compared = plain(scene, law.name, &options)
        .and_then(|intact| super::run(&intact, &options, &mut |_| Ok(())).map_err(|error| error.to_string()));
    match compared {
        Ok(report) => warnings.append(report.warnings),
        Err(reason) => warn(
            format!("how far the law `{}` is from the exact one is not known: {reason}", law.name),
            warnings,
        ),
    }
    begin.elapsed().as_secs_f64()
}

fn warn(message: String, warnings: &mut Faults) {
    let path = JsonPath::default().key("model").key("timoshenko_beam").key("bond_law");
    warnings.warning(path, message).hint(
        "leave `bond_law` out: the default is exact on any grid; other laws are for studies of the nonlocal beam",
    );
}

/// The answers of a scene with exact bonds, or why there are none.
fn answers(scene: &BeamScene, stride: usize, options: &RunOptions) -> Result<Vec<Answer>, String> {
    let options = RunOptions { recover: false, ..*options };
    let exact = plain(scene, EXACT, &options)?;
    let mut all = Vec::new();
    let report = run_linear(&exact, &options, &mut |result| {
        let displacements: Vec<[f64; 2]> = result.displacements().step_by(stride).collect();
        let largest = displacements.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
        all.push(Answer { displacements, largest, energy: result.record.certificate.energy });
        Ok(())
    });
    match report {
        Ok(report) if report.converged => Ok(all),
        Ok(_) => Err("with it a state did not converge".into()),
        Err(error) => Err(error.to_string()),
    }
}

/// A scene with a bond law, which does not break and tells nothing but its displacements.
fn plain(scene: &BeamScene, law: &str, options: &RunOptions) -> Result<BeamScene, String> {
    let mut case = scene.case.clone();
    (case.checks, case.probes, case.fracture) = (Vec::new(), Vec::new(), None);
    if let Model::TimoshenkoBeam(beam) = &mut case.model {
        beam.bond_law = Some(law.into());
    }
    // Only the checks of beams name files.
    let resolved = Scene::new(case, Path::new(""), "", "", options.max_memory).map_err(|e| e.to_string())?;
    resolved.into_beam().ok_or_else(|| "it is no beam".into())
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
    let is_flat = exact.energy > 0.0 && bent <= 1e-12 * exact.energy;
    is_flat || (loads.point.is_empty() && loads.distributed.is_empty() && exact.energy > STRAIN_FREE * bent)
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
