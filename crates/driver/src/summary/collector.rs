//! What the summary needs of states, collected as they come.

use super::doubts::Doubts;
use super::{Extremes, Forces, Located, ModelSummary, StateSummary, Status, Summary, beam, body, plate};
use crate::case::{Case, Check};
use crate::run::{CheckResult, FEW_DIGITS, ProbeResult, Range, RunReport, StateResult};
use crate::scene::{ASKED, Scene};
use serde::de::DeserializeOwned;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Collects the results of states as they come.
#[derive(Debug, Default)]
pub struct Collector {
    states: Vec<StateSummary>,
    probes: Vec<ProbeResult>,
    checks: Vec<CheckResult>,
    doubts: Doubts,
}

impl Collector {
    /// Takes what the summary needs of a state.
    pub fn take(&mut self, scene: &Scene, result: &StateResult) {
        let (state, probes, checks) = match (scene, result) {
            (Scene::Beam(scene), StateResult::Beam(result)) => beam::state(scene, result),
            (Scene::Body(scene), StateResult::Body(result)) => body::state(scene, result),
            (Scene::Plate(scene), StateResult::Plate(result)) => plate::state(scene, result),
            _ => unreachable!("a scene has results of its own kind"),
        };
        self.doubts.take(scene, result, &state);
        self.states.push(state);
        self.probes.extend(probes);
        if scene.case().is_traced() {
            // Those of the last equilibrium count.
            self.checks = checks;
        } else {
            self.checks.extend(checks);
        }
    }

    /// What the summary says of the states so far, as JSON, for a run that goes on later.
    pub fn save(&self) -> String {
        serde_json::json!([self.states, self.probes, self.doubts]).to_string()
    }

    /// Goes on from what was [saved](Self::save) of a scene. Checks are made on the last state, which is yet to come.
    ///
    /// # Errors
    /// The text is not what was saved.
    pub fn restore(scene: &Scene, saved: &str) -> serde_json::Result<Self> {
        match scene {
            Scene::Beam(_) => Self::read(saved, Forces::Beam),
            Scene::Body(_) => Self::read(saved, Forces::Body),
            Scene::Plate(_) => Self::read(saved, Forces::Plate),
        }
    }

    /// Load factor and probes of every state so far.
    pub fn history(&self) -> impl Iterator<Item = (f64, &[ProbeResult])> {
        let share = self.probes.len() / self.states.len().max(1);
        let of_state = move |(k, state): (usize, &StateSummary)| {
            (state.load_factor, &self.probes[k * share..(k + 1) * share])
        };
        self.states.iter().enumerate().map(of_state)
    }

    /// As [`restore`](Self::restore), with forces of one kind: without reactions, kinds look alike.
    fn read<F: DeserializeOwned>(saved: &str, forces: fn(F) -> Forces) -> serde_json::Result<Self> {
        let (states, probes, doubts): (Vec<StateSummary<F>>, _, _) = serde_json::from_str(saved)?;
        let state = |state: StateSummary<F>| StateSummary {
            name: state.name,
            load_factor: state.load_factor,
            extremes: state.extremes,
            forces: forces(state.forces),
            certificate: state.certificate,
        };
        Ok(Self { states: states.into_iter().map(state).collect(), probes, doubts, ..Self::default() })
    }

    /// The summary of the run.
    pub fn finish(mut self, scene: &Scene, report: RunReport, mut warnings: Vec<String>) -> Summary {
        if let Some(ending) = report.missed_goal() {
            refuse_limits(&mut self.checks, scene.case(), ending);
        }
        warnings.extend(few_digits(&self.states));
        warnings.extend(misapplied(&self.states));
        warnings.extend(self.doubts.warnings());
        // States before a restart are known from it alone.
        let converged = report.converged && self.states.iter().all(|s| s.certificate.converged);
        let status = match (converged, self.checks.iter().all(|c| c.passed)) {
            _ if report.is_interrupted => Status::Interrupted,
            (false, _) => Status::NotConverged,
            (true, false) => Status::CheckFailed,
            (true, true) => Status::Passed,
        };
        let model = match scene {
            Scene::Beam(scene) => ModelSummary::Beam(beam::model(scene)),
            Scene::Body(scene) => ModelSummary::Body(body::model(scene)),
            Scene::Plate(scene) => ModelSummary::Plate(plate::model(scene)),
        };
        let envelope = if scene.has_envelope() { envelope(&self.states) } else { BTreeMap::new() };
        Summary {
            status,
            interrupted: report.is_interrupted.then(|| how_far(&report, self.states.len(), scene.states())),
            title: scene.case().title.clone(),
            units: scene.case().units,
            model,
            sizes: report.sizes,
            estimate: None,
            no_estimate: None,
            checks: self.checks,
            probes: self.probes,
            states: self.states,
            envelope,
            fracture: report.fracture,
            path: report.path,
            exact: report.exact,
            skipped: report.skipped,
            counters: report.counters,
            warnings,
            solver: report.solver,
            timing_s: report.timing,
            peak_memory_bytes: None,
            version: env!("CARGO_PKG_VERSION"),
        }
    }
}

/// How far a run came that was interrupted.
fn how_far(report: &RunReport, states: usize, all: usize) -> String {
    match (&report.fracture, &report.path) {
        (Some(fracture), _) => format!("after {} equilibria", fracture.solves),
        (_, Some(path)) => format!("after {} steps", path.steps),
        _ => format!("after {states} of {all} states"),
    }
}

/// Lets the limits of probes fail whose state was never reached: what has come off, or bears less than it was to bear, keeps
/// every limit. What is known by name is of the whole run.
fn refuse_limits(results: &mut [CheckResult], case: &Case, ending: &str) {
    for (result, check) in results.iter_mut().zip(&case.checks) {
        if let Check::Limit(limit) = check
            && case.probes.iter().any(|probe| probe.name == limit.probe)
        {
            result.passed = false;
            result.remark = Some(format!("not at the full load: {ending}"));
        }
    }
}

/// What there is to say of the state of which the fewest digits can be trusted, if these are few.
fn few_digits(states: &[StateSummary]) -> Option<String> {
    let fewest = |s: &&StateSummary| s.certificate.digits.min(s.certificate.strain_digits);
    let others = states.iter().filter(|s| !is_misapplied(s));
    let worst = others.min_by_key(fewest).filter(|s| fewest(s) < FEW_DIGITS)?;
    let certificate = &worst.certificate;
    Some(format!(
        "{}: only {} digits of displacements and {} of strains and forces can be trusted, by rounding and iteration",
        worst.name, certificate.digits, certificate.strain_digits
    ))
}

/// Difference of the loads of a state as asked and as applied.
fn difference(state: &StateSummary) -> f64 {
    state.certificate.resultants.as_ref().map_or(0.0, |r| r.difference)
}

/// Whether a state was refused for its loads.
fn is_misapplied(state: &StateSummary) -> bool {
    !state.certificate.converged && difference(state) > ASKED
}

/// What there is to say of the state whose loads differ most from what was asked for, if it was refused for that.
fn misapplied(states: &[StateSummary]) -> Option<String> {
    let refused = states.iter().filter(|s| is_misapplied(s));
    let worst = refused.max_by(|a, b| difference(a).total_cmp(&difference(b)))?;
    Some(format!(
        "{}: the loads that act are not those that were asked for, by {:.1e} of them: see their resultants; this is a fault of the program, or of a formula that jumps within a cell",
        worst.name,
        difference(worst)
    ))
}

/// Extreme values over all states.
fn envelope(states: &[StateSummary]) -> BTreeMap<Cow<'static, str>, [(String, Located); 2]> {
    let mut ranges: BTreeMap<Cow<'static, str>, Range<(String, Located)>> = BTreeMap::new();
    for state in states {
        for (field, Extremes { smallest, largest, .. }) in &state.extremes {
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

    fn scene(text: &str, overrides: &[&str]) -> Scene {
        let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
        let source =
            crate::case::from_text("case", text.into(), &overrides, &crate::input::Folder::default())
                .unwrap();
        Scene::new(source.case, Path::new("."), "case", "", None).unwrap()
    }

    /// Takes every state of a scene twice, going on each time from what was saved before.
    fn assert_goes_on(scene: &Scene) -> Collector {
        let mut all = Collector::default();
        let mut take = crate::run::taking(|result| {
            for _ in 0..2 {
                let mut second = Collector::restore(scene, &all.save())?;
                second.take(scene, &result);
                all.take(scene, &result);
                assert_eq!(second.states, all.states);
                assert_eq!(second.probes, all.probes);
                assert_eq!(second.doubts, all.doubts);
            }
            Ok(())
        });
        let options = crate::run::RunOptions { recover: true, max_memory: None, compare: true };
        crate::run::run(scene, &options, None, &mut take).unwrap();
        drop(take);
        all
    }

    #[test]
    fn a_saved_collector_goes_on_with_the_same_states_and_probes() {
        let coarse = ["body.rectangle.spacing=5.0", "checks=[]"];
        let plate = scene(crate::model::start("bond_plane").unwrap(), &coarse);
        let all = assert_goes_on(&plate);
        assert_eq!((all.states.len(), all.probes.len()), (2, 6));
        let Forces::Body(forces) = &all.states[0].forces else { panic!("a plate is in the plane") };
        assert_eq!(forces.mirrors.len(), 2);
        assert!(Collector::restore(&plate, "{}").is_err());
    }

    #[test]
    fn forces_of_beams_are_read_as_such_with_and_without_supports() {
        let beam = crate::model::start("timoshenko_beam").unwrap();
        let bedded = ["supports=[]", r#"foundation=[{"stiffness": {"uniform": 1e6}}]"#, "checks=[]"];
        let frame = crate::model::start("plane_frame").unwrap();
        let cases = [scene(beam, &["checks=[]"]), scene(beam, &bedded), scene(frame, &["checks=[]"])];
        let counts = cases.map(|scene| {
            let all = assert_goes_on(&scene);
            let Forces::Beam(forces) = &all.states[0].forces else { panic!("a beam") };
            [forces.reactions.len(), forces.joint_reactions.len(), forces.members.len()]
        });
        assert_eq!(counts, [[1, 0, 0], [0, 0, 0], [0, 2, 3]]);
    }
}
