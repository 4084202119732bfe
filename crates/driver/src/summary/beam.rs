//! What the record of a run says of beams and frames.

use super::{Extremes, Forces, Located, StateSummary};
use crate::run::beam::{
    Along, BeamResult, JointReaction, MemberForces, OneWayState, Reaction, checks, probes,
};
use crate::run::{CheckResult, ProbeResult};
use crate::scene::beam::BeamScene;
use peristat_assembly::material::{Profile, SectionStiffness};
use serde::{Deserialize, Serialize};

/// Forces of a beam or frame and of its supports.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BeamForces {
    /// Smallest and largest section forces of every member of a frame.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub members: Vec<MemberForces>,
    /// Reactions of the supports of lines, in the order of the case.
    pub reactions: Vec<Reaction>,
    /// Reactions of the supports of a frame, in the order of the case.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joint_reactions: Vec<JointReaction>,
    /// Which of what acts one way does act, if there is any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub one_way: Option<OneWayState>,
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

/// A state without its fields, with its probes and checks.
pub(super) fn state(
    scene: &BeamScene,
    result: &BeamResult,
) -> (StateSummary, Vec<ProbeResult>, Vec<CheckResult>) {
    let name = |line: usize| scene.frame.as_ref().map(|f| f.members[line].name.clone());
    let located =
        |(value, line, x): (f64, usize, f64)| Located { value, x, y: None, z: None, member: name(line) };
    let along = Along::new(scene, result);
    let extremes = result.fields().iter().filter_map(|&field| {
        let [smallest, largest] = along.extremes(field)?;
        let unit = field.about().unit.label(scene.units).into();
        Some((field.name().into(), Extremes { smallest: located(smallest), largest: located(largest), unit }))
    });
    let state = StateSummary {
        name: result.record.name.clone(),
        load_factor: result.record.load_factor,
        extremes: extremes.collect(),
        forces: Forces::Beam(BeamForces {
            members: scene.frame.as_ref().map_or_else(Vec::new, |frame| along.member_forces(frame)),
            reactions: result.reactions.clone(),
            joint_reactions: result.joint_reactions.clone(),
            one_way: result.one_way.clone(),
        }),
        certificate: result.record.certificate.clone(),
    };
    let probes = probes(scene, result);
    let checks = checks(scene, result, &probes);
    (state, probes, checks)
}

/// The model of a beam and its derived numbers.
pub(super) fn model(scene: &BeamScene) -> BeamSummary {
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
