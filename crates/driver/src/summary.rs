//! The record of a run: what `summary.json` holds and `--json` prints.

use crate::case::{Model, Units};
use crate::memory;
use crate::run::{
    self, Certificate, CheckResult, Counters, JointReaction, MemberForces, ProbeResult, Range, Reaction,
    RunReport, Sizes, SolverReport, StateResult, Timing,
};
use crate::scene::Scene;
use peristat_assembly::material::{Profile, SectionStiffness};
use serde::Serialize;
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
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Located {
    /// Value.
    pub value: f64,
    /// Position on its line.
    pub x: f64,
    /// Member of a frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
}

/// Smallest and largest value of a field.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Extremes {
    /// Smallest.
    pub smallest: Located,
    /// Largest.
    pub largest: Located,
}

/// One state without its fields.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StateSummary {
    /// Name.
    pub name: String,
    /// Load factor.
    pub load_factor: f64,
    /// Extreme values by field.
    pub extremes: BTreeMap<&'static str, Extremes>,
    /// Smallest and largest section forces of every member of a frame.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub members: Vec<MemberForces>,
    /// Reactions of the supports of lines, in the order of the case.
    pub reactions: Vec<Reaction>,
    /// Reactions of the supports of a frame, in the order of the case.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub joint_reactions: Vec<JointReaction>,
    /// Certificate.
    pub certificate: Certificate,
}

/// The beam that was solved.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BeamSummary {
    /// Name of the model.
    pub name: &'static str,
    /// Bond law.
    pub bond_law: &'static str,
    /// End treatment.
    pub end_treatment: &'static str,
    /// Horizon over spacing, per line.
    pub horizon_ratio: Vec<f64>,
    /// Spacing, per line; the mean spacing of a graded grid.
    pub spacing: Vec<f64>,
    /// Whether the grid is graded, per line.
    pub graded: Vec<bool>,
    /// Member whose section the numbers below are, on a frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
    /// Whether sections vary along their lines; the numbers below are then those at the start of the first one.
    pub varies: bool,
    /// Area A.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub area: Option<f64>,
    /// Second moment of area I.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub second_moment: Option<f64>,
    /// Shear correction factor κ.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kappa: Option<f64>,
    /// Bending stiffness EI.
    pub bending_stiffness: f64,
    /// Shear stiffness κGA.
    pub shear_stiffness: f64,
    /// Axial stiffness EA, where points move along their lines.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial_stiffness: Option<f64>,
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
    pub model: BeamSummary,
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
    pub envelope: BTreeMap<&'static str, [(String, Located); 2]>,
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
        let name = |line: usize| scene.frame.as_ref().map(|f| f.members[line].name.clone());
        let located = |(value, line, x): (f64, usize, f64)| Located { value, x, member: name(line) };
        let extremes = result.fields().iter().filter_map(|&field| {
            let [smallest, largest] = result.located_extremes(field)?;
            Some((field.name(), Extremes { smallest: located(smallest), largest: located(largest) }))
        });
        self.states.push(StateSummary {
            name: result.name.clone(),
            load_factor: result.load_factor,
            extremes: extremes.collect(),
            members: run::member_forces(scene, result),
            reactions: result.reactions.clone(),
            joint_reactions: result.joint_reactions.clone(),
            certificate: result.certificate.clone(),
        });
        self.probes.extend(crate::run::probes(scene, result));
        self.checks.extend(crate::run::checks(scene, result));
    }

    /// The summary of the run.
    pub fn finish(self, scene: &Scene, report: RunReport, warnings: Vec<String>) -> Summary {
        let status = match (report.converged, self.checks.iter().all(|c| c.passed)) {
            (false, _) => Status::NotConverged,
            (true, false) => Status::CheckFailed,
            (true, true) => Status::Passed,
        };
        let envelope = if scene.has_envelope { envelope(&self.states) } else { BTreeMap::new() };
        Summary {
            status,
            title: scene.case.title.clone(),
            units: scene.units,
            model: beam(scene),
            sizes: report.sizes,
            checks: self.checks,
            probes: self.probes,
            states: self.states,
            envelope,
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

fn beam(scene: &Scene) -> BeamSummary {
    let Model::TimoshenkoBeam(_) = &scene.case.model;
    let start = |profile: &Option<Profile>| profile.as_ref().map(|p| p.value(0.0));
    let (p, stiffness) = (scene.beam.parameters(), &scene.beam.chains()[0].line().stiffness);
    BeamSummary {
        name: "timoshenko_beam",
        bond_law: p.bond_law.name,
        end_treatment: p.end_treatment.name,
        horizon_ratio: scene.beam.chains().iter().map(|c| c.line().horizon_ratio).collect(),
        spacing: scene.beam.chains().iter().map(|c| c.spacing).collect(),
        graded: scene.beam.chains().iter().map(|c| c.line().stations.is_some()).collect(),
        member: scene.frame.as_ref().map(|f| f.members[0].name.clone()),
        varies: scene.beam.chains().iter().any(|c| varies(&c.line().stiffness)),
        area: start(&scene.sections[0].area),
        second_moment: start(&scene.sections[0].second_moment),
        kappa: scene.sections[0].kappa,
        bending_stiffness: stiffness.bending.value(0.0),
        shear_stiffness: stiffness.shear.value(0.0),
        axial_stiffness: scene.has_axial.then(|| stiffness.axial.value(0.0)),
    }
}

fn varies(stiffness: &SectionStiffness) -> bool {
    stiffness.bending.uniform().is_none() || stiffness.shear.uniform().is_none()
}

/// Extreme values over all states.
fn envelope(states: &[StateSummary]) -> BTreeMap<&'static str, [(String, Located); 2]> {
    let mut ranges: BTreeMap<&'static str, Range<(String, Located)>> = BTreeMap::new();
    for state in states {
        for (&field, Extremes { smallest, largest }) in &state.extremes {
            let end = |at: &Located| (at.value, (state.name.clone(), at.clone()));
            ranges.entry(field).or_default().take([end(smallest), end(largest)]);
        }
    }
    ranges.into_iter().filter_map(|(field, range)| Some((field, range.ends()?.map(|(_, at)| at)))).collect()
}
