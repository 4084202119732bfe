//! Smallest and largest values of fields, over a state and over its lines.

use super::{StateResult, scan};
use crate::case::FieldName;
use crate::scene::{MemberLayout, Scene};
use serde::Serialize;

/// Smallest and largest section forces of a member.
#[derive(Clone, Debug, PartialEq, Serialize)]
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
pub(crate) fn member_forces(scene: &Scene, result: &StateResult) -> Vec<MemberForces> {
    let members = scene.frame.iter().flat_map(|f| f.members.iter().enumerate());
    let of = |(line, member): (usize, &MemberLayout)| {
        let range = |field| result.extremes_on(field, line).map(|e| e.map(|(value, _)| value));
        let (axial, shear) = (range(FieldName::N)?, range(FieldName::V)?);
        Some(MemberForces { name: member.name.clone(), axial, shear, moment: range(FieldName::M)? })
    };
    members.filter_map(of).collect()
}

impl StateResult {
    /// Smallest and largest value of a field and their positions; both sides of a point where the field may jump.
    pub fn extremes(&self, field: FieldName) -> Option<[(f64, f64); 2]> {
        self.located_extremes(field).map(|extremes| extremes.map(|(value, _, x)| (value, x)))
    }

    /// The same with the line between value and position.
    pub fn located_extremes(&self, field: FieldName) -> Option<[(f64, usize, f64); 2]> {
        let mut extremes: Option<[(f64, usize, f64); 2]> = None;
        for line in 0..self.lines.len() {
            let [a, b] = self.extremes_on(field, line)?.map(|(value, x)| (value, line, x));
            let [low, high] = extremes.get_or_insert([a, b]);
            if a.0 < low.0 {
                *low = a;
            }
            if b.0 > high.0 {
                *high = b;
            }
        }
        extremes
    }

    /// Smallest and largest value of a field on one line and their positions.
    pub fn extremes_on(&self, field: FieldName, line: usize) -> Option<[(f64, f64); 2]> {
        let mut extremes: Option<[(f64, f64); 2]> = None;
        let x = &self.lines[line].x;
        let mut take = |values: &[f64]| {
            if let Some([a, b]) = scan::extremes(values).map(|ends| ends.map(|k| (values[k], x.at(k)))) {
                let [low, high] = extremes.get_or_insert([a, b]);
                if a.0 < low.0 {
                    *low = a;
                }
                if b.0 > high.0 {
                    *high = b;
                }
            }
        };
        take(&self.values(field, line)?);
        if let Some(left) = self.left_values(field, line) {
            take(&left);
        }
        extremes
    }
}
