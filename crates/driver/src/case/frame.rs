//! Plane frames: joints, and straight members between them.

use super::Grading;
use crate::model::Stiffness;
use peristat_assembly::material::Section;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A frame in the plane of x and y.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Frame {
    /// Points where members end.
    pub joints: Vec<Joint>,
    /// Straight members. They are rigidly joined where they meet, unless they have hinges there.
    pub members: Vec<Member>,
}

/// A point where members end.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Joint {
    /// Name, unique among joints.
    pub name: String,
    /// Position along x.
    pub x: f64,
    /// Position along y.
    pub y: f64,
}

/// A straight member with a grid of nodes. Its w grows to the left of the way from `from` to `to`, its u along that way.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Member {
    /// Name, unique among members.
    pub name: String,
    /// Joint where it begins.
    pub from: String,
    /// Joint where it ends.
    pub to: String,
    /// Number of cells, >= 1.
    pub cells: usize,
    /// Ends that turn freely in their joints.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub hinges: Vec<MemberEnd>,
    /// Where it begins and ends beside its joints: rigid arms join it to them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub offsets: Option<Offsets>,
    /// The only axial force that it bears: a cable bears tension, a strut that rests on its joints bears compression. It is then slack
    /// wherever it would bear the other, and has hinges at both ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub only: Option<AxialForce>,
    /// Cross-section, where it is not that of the model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub section: Option<Section>,
    /// Cross-section at the joint `to`; dimensions vary linearly from those at `from`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end_section: Option<Section>,
    /// Stiffness of the sections by numbers, where it is not that of the model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<Stiffness>,
    /// Cells of different lengths; all the same if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub grading: Option<Grading>,
}

/// Rigid arms from joints to the ends of a member.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Offsets {
    /// Along x and y from the joint `from` to the beginning of the member.
    #[serde(default, skip_serializing_if = "is_nowhere")]
    pub from: [f64; 2],
    /// Along x and y from the joint `to` to the end of the member.
    #[serde(default, skip_serializing_if = "is_nowhere")]
    pub to: [f64; 2],
}

fn is_nowhere(offset: &[f64; 2]) -> bool {
    *offset == [0.0; 2]
}

impl Frame {
    /// Where a member begins and ends, if its joints are there.
    pub fn ends(&self, member: &Member) -> Option<[[f64; 2]; 2]> {
        let offsets = member.offsets.unwrap_or_default();
        let end = |name: &str, [x, y]: [f64; 2]| {
            let joint = self.joints.iter().find(|joint| joint.name == name)?;
            Some([joint.x + x, joint.y + y])
        };
        Some([end(&member.from, offsets.from)?, end(&member.to, offsets.to)?])
    }
}

/// A kind of axial force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AxialForce {
    /// N > 0.
    Tension,
    /// N < 0.
    Compression,
}

impl AxialForce {
    /// Sign of N.
    pub fn sign(self) -> f64 {
        match self {
            Self::Tension => 1.0,
            Self::Compression => -1.0,
        }
    }
}

/// An end of a member.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MemberEnd {
    /// At the joint `from`.
    From,
    /// At the joint `to`.
    To,
}
