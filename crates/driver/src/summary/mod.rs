//! The record of a run: what `summary.json` holds and `--json` prints.

mod beam;
mod plane;

pub use beam::{BeamForces, BeamSummary};
pub use plane::{OrthotropicSummary, PlaneForces, PlaneMaterialSummary, PlaneSummary};

use crate::case::Units;
use crate::memory;
use crate::run::fracture::FractureReport;
use crate::run::{
    Certificate, CheckResult, Counters, ProbeResult, Range, RunReport, Sizes, SolverReport, StateResult,
    Timing,
};
use crate::scene::Scene;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// Everything converged and every check passed.
    Passed,
    /// Everything converged, a check failed.
    CheckFailed,
    /// A state did not converge.
    NotConverged,
}

/// A value and where it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Located {
    /// Value.
    pub value: f64,
    /// Position on its line, or in the plane.
    pub x: f64,
    /// The second coordinate of a point in the plane.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y: Option<f64>,
    /// Member of a frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
}

/// Smallest and largest value of a field.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Extremes {
    /// Smallest.
    pub smallest: Located,
    /// Largest.
    pub largest: Located,
}

/// One state without its fields.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StateSummary {
    /// Name.
    pub name: String,
    /// Load factor.
    pub load_factor: f64,
    /// Extreme values by field.
    pub extremes: BTreeMap<Cow<'static, str>, Extremes>,
    /// Forces, of the body and of what holds it.
    #[serde(flatten)]
    pub forces: Forces,
    /// Certificate.
    pub certificate: Certificate,
}

/// Forces of a state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Forces {
    /// Of a beam or frame; they do not break, so that these are never read again.
    #[serde(skip_deserializing)]
    Beam(BeamForces),
    /// Of a body in the plane.
    Plane(PlaneForces),
}

/// Model and its derived numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ModelSummary {
    /// A beam or frame.
    Beam(BeamSummary),
    /// A body in the plane.
    Plane(PlaneSummary),
}

/// Everything about a finished run but the fields.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// How it ended.
    pub status: Status,
    /// Title of the case.
    pub title: String,
    /// Units of all numbers.
    pub units: Units,
    /// Model and its derived numbers.
    pub model: ModelSummary,
    /// Sizes.
    #[serde(flatten)]
    pub sizes: Sizes,
    /// Checks.
    pub checks: Vec<CheckResult>,
    /// Probes.
    pub probes: Vec<ProbeResult>,
    /// States: load steps, or load cases and combinations.
    pub states: Vec<StateSummary>,
    /// Extreme values over all load cases and combinations, with the name of the state.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub envelope: BTreeMap<Cow<'static, str>, [(String, Located); 2]>,
    /// How the body broke.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fracture: Option<FractureReport>,
    /// What the scene was spared, and why.
    pub skipped: Vec<String>,
    /// Counters.
    pub counters: Counters,
    /// Warnings on the case.
    pub warnings: Vec<String>,
    /// Method and why it was chosen.
    pub solver: SolverReport,
    /// Wall time per stage, s.
    pub timing_s: Timing,
    /// Largest resident memory of the process, bytes, where the system tells.
    pub peak_memory_bytes: Option<u64>,
    /// Version of peristat.
    pub version: &'static str,
}

/// Collects the results of states as they come.
#[derive(Debug, Default)]
pub struct Collector {
    states: Vec<StateSummary>,
    probes: Vec<ProbeResult>,
    checks: Vec<CheckResult>,
}

impl Collector {
    /// Takes what the summary needs of a state.
    pub fn take(&mut self, scene: &Scene, result: &StateResult) {
        let (state, probes, checks) = match (scene, result) {
            (Scene::Beam(scene), StateResult::Beam(result)) => beam::state(scene, result),
            (Scene::Plane(scene), StateResult::Plane(result)) => plane::state(scene, result),
            _ => unreachable!("a scene has results of its own kind"),
        };
        self.states.push(state);
        self.probes.extend(probes);
        if scene.case().fracture.is_some() {
            // Those of the last equilibrium count.
            self.checks = checks;
        } else {
            self.checks.extend(checks);
        }
    }

    /// What the summary says of the states so far, as JSON, for a run that goes on later.
    pub fn save(&self) -> String {
        serde_json::json!([self.states, self.probes]).to_string()
    }

    /// Goes on from what was [saved](Self::save). Checks are made on the last state, which is yet to come.
    ///
    /// # Errors
    /// The text is not what was saved.
    pub fn restore(saved: &str) -> serde_json::Result<Self> {
        let (states, probes) = serde_json::from_str(saved)?;
        Ok(Self { states, probes, checks: Vec::new() })
    }

    /// The summary of the run.
    pub fn finish(self, scene: &Scene, report: RunReport, warnings: Vec<String>) -> Summary {
        // States before a restart are known from it alone.
        let converged = report.converged && self.states.iter().all(|s| s.certificate.converged);
        let status = match (converged, self.checks.iter().all(|c| c.passed)) {
            (false, _) => Status::NotConverged,
            (true, false) => Status::CheckFailed,
            (true, true) => Status::Passed,
        };
        let model = match scene {
            Scene::Beam(scene) => ModelSummary::Beam(beam::model(scene)),
            Scene::Plane(scene) => ModelSummary::Plane(plane::model(scene)),
        };
        let envelope = if scene.has_envelope() { envelope(&self.states) } else { BTreeMap::new() };
        Summary {
            status,
            title: scene.case().title.clone(),
            units: scene.case().units,
            model,
            sizes: report.sizes,
            checks: self.checks,
            probes: self.probes,
            states: self.states,
            envelope,
            fracture: report.fracture,
            skipped: report.skipped,
            counters: report.counters,
            warnings,
            solver: report.solver,
            timing_s: report.timing,
            peak_memory_bytes: memory::peak(),
            version: env!("CARGO_PKG_VERSION"),
        }
    }
}

/// Extreme values over all states.
fn envelope(states: &[StateSummary]) -> BTreeMap<Cow<'static, str>, [(String, Located); 2]> {
    let mut ranges: BTreeMap<Cow<'static, str>, Range<(String, Located)>> = BTreeMap::new();
    for state in states {
        for (field, Extremes { smallest, largest }) in &state.extremes {
            let end = |at: &Located| (at.value, (state.name.clone(), at.clone()));
            ranges.entry(field.clone()).or_default().take([end(smallest), end(largest)]);
        }
    }
    ranges.into_iter().filter_map(|(field, range)| Some((field, range.ends()?.map(|(_, at)| at)))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn a_saved_collector_goes_on_with_the_same_states_and_probes() {
        let text = include_str!("../cli/new_bond_plane.json").to_string();
        let coarse = ["body.rectangle.spacing=5.0".to_string(), "checks=[]".to_string()];
        let source = crate::case::from_text("case", text, &coarse).unwrap();
        let scene = Scene::new(source.case, Path::new("."), "case", "", None).unwrap();
        let (mut all, mut first) = (Collector::default(), Collector::default());
        let mut take = crate::run::taking(|result| {
            all.take(&scene, &result);
            all.take(&scene, &result);
            first.take(&scene, &result);
            let mut second = Collector::restore(&first.save())?;
            second.take(&scene, &result);
            assert_eq!(second.states, all.states);
            assert_eq!(second.probes, all.probes);
            Ok(())
        });
        let options = crate::run::RunOptions { recover: true, max_memory: None };
        crate::run::run(&scene, &options, None, &mut take).unwrap();
        drop(take);
        assert_eq!((all.states.len(), all.probes.len()), (2, 6));
        let Forces::Plane(forces) = &all.states[0].forces else { panic!("a plate is in the plane") };
        assert_eq!(forces.mirrors.len(), 2);
        assert!(Collector::restore("{}").is_err());
    }
}
