//! What the record of a run says of shell membranes.

use super::super::MaterialSummary;
use super::super::material_summary::{Words, fact, of_calibration};
use super::NAME;
use crate::units::Units;
use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::shell_membrane::{ShellEnds, ShellKinematics, ShellParameters};
use serde_json::json;

/// An isotropic material of a cylindrical shell.
pub(super) fn summary(of: &ShellParameters, units: Units) -> MaterialSummary {
    let words = Words { units, name: NAME };
    let entries = vec![
        ("youngs_modulus", json!(of.youngs_modulus)),
        ("poisson_ratio", json!(1.0 / 3.0)),
        ("radius", json!(of.radius)),
        ("kinematics", json!(of.kinematics)),
        ("ends", json!(of.ends)),
        ("bending", json!(of.bending)),
    ];
    let kinematics = match of.kinematics {
        ShellKinematics::Chord => "elongations of chords",
        ShellKinematics::Published => "elongations as published",
    };
    let bending = if of.bending { ", rows of bending" } else { "" };
    let calibration = of_calibration(of.calibration);
    let (e, thickness, r) =
        (words.stress(of.youngs_modulus), words.thickness(of.thickness), words.length(of.radius));
    let facts = vec![
        fact("model", format!("{}, {calibration}, {kinematics}{bending}", words.name)),
        fact("material", format!("E = {e}, ν = 1/3, {thickness}, radius {r}")),
    ];
    let edges = (of.calibration == Calibration::Matched).then(|| match of.ends {
        ShellEnds::Border => {
            "at its ends bonds end on the border, which moves with the points beside it".into()
        }
        ShellEnds::Weights => "every point has weights that make uniform strains exact".into(),
    });
    MaterialSummary { entries, facts, influence: "", edges }
}
