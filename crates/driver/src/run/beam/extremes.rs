//! Smallest and largest values of the fields of a beam, over a state and over its lines.

use super::BeamResult;
use crate::case::FieldName;
use crate::run::{Range, scan};
use crate::scene::beam::{BeamScene, MemberLayout};
use serde::{Deserialize, Serialize};

/// Smallest and largest section forces of a member.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MemberForces {
    /// Name.
    pub name: String,
    /// Axial force, tension positive.
    #[serde(rename = "N")]
    pub axial: [f64; 2],
    /// Shear force.
    #[serde(rename = "V")]
    pub shear: [f64; 2],
    /// Bending moment.
    #[serde(rename = "M")]
    pub moment: [f64; 2],
}

/// Section forces per member of a frame, where they were recovered.
pub(crate) fn member_forces(scene: &BeamScene, result: &BeamResult) -> Vec<MemberForces> {
    let members = scene.frame.iter().flat_map(|f| f.members.iter().enumerate());
    let of = |(line, member): (usize, &MemberLayout)| {
        let range = |field| result.extremes_on(field, line).map(|e| e.map(|(value, _)| value));
        let (axial, shear) = (range(FieldName::N)?, range(FieldName::V)?);
        Some(MemberForces { name: member.name.clone(), axial, shear, moment: range(FieldName::M)? })
    };
    members.filter_map(of).collect()
}

impl BeamResult {
    /// Smallest and largest value of a field and their positions; both sides of a point where the field may jump.
    pub fn extremes(&self, field: FieldName) -> Option<[(f64, f64); 2]> {
        self.located_extremes(field).map(|extremes| extremes.map(|(value, _, x)| (value, x)))
    }

    /// The same with the line between value and position.
    pub fn located_extremes(&self, field: FieldName) -> Option<[(f64, usize, f64); 2]> {
        let mut range = Range::default();
        for line in 0..self.lines.len() {
            range.take(self.extremes_on(field, line)?.map(|(value, x)| (value, (line, x))));
        }
        range.ends().map(|ends| ends.map(|(value, (line, x))| (value, line, x)))
    }

    /// Smallest and largest value of a field on one line and their positions.
    pub fn extremes_on(&self, field: FieldName, line: usize) -> Option<[(f64, f64); 2]> {
        let x = &self.lines[line].x;
        let located = |values: &[f64], ends: usize| {
            Some(scan::extremes(values)?.map(|k| (values[k], x.at(k / ends + k % ends))))
        };
        // Both ends of every cell, where a field may jump.
        match self.cells(field, line) {
            Some(cells) => located(cells.as_flattened(), 2),
            None => located(&self.values(field, line)?, 1),
        }
    }
}
