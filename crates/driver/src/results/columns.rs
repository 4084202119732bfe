//! The columns of tables: where points are, and what is known on them.

use crate::case::FieldName;
use crate::run::StateResult;
use crate::scene::Scene;

/// Section forces to the left of the points, where they may jump, and their columns.
const LEFT: [(FieldName, &str); 3] =
    [(FieldName::N, "N_left"), (FieldName::V, "V_left"), (FieldName::M, "M_left")];

/// Fields whose smallest and largest values over all states are written.
const ENVELOPE: [FieldName; 8] = [
    FieldName::Ux,
    FieldName::Uy,
    FieldName::W,
    FieldName::U,
    FieldName::Phi,
    FieldName::M,
    FieldName::V,
    FieldName::N,
];

/// A column of a table.
pub(super) type Column = (&'static str, Vec<f64>);

/// Values of a field at all real points, line by line.
pub(super) fn all(result: &StateResult, field: FieldName) -> Option<Vec<f64>> {
    let lines: Option<Vec<_>> = (0..result.lines.len()).map(|l| result.values(field, l)).collect();
    Some(lines?.concat())
}

/// Values of a field to the left of all real points, where it may jump.
pub(super) fn all_left(result: &StateResult, field: FieldName) -> Option<Vec<f64>> {
    let lines: Option<Vec<_>> = (0..result.lines.len()).map(|l| result.left_values(field, l)).collect();
    Some(lines?.concat())
}

/// Positions of all real points in space.
pub(super) fn positions(result: &StateResult) -> Vec<[f64; 3]> {
    let of = |line: &crate::run::LineFields| -> Vec<[f64; 3]> {
        (0..line.x.len()).map(|k| line.position(k)).map(|[x, y]| [x, y, 0.0]).collect()
    };
    result.lines.iter().flat_map(of).collect()
}

/// Where the points are: `x` on lines; on a frame the number of the member, from 1, the distance `s` from its joint
/// `from`, and the position in the plane.
pub(super) fn places(scene: &Scene, result: &StateResult) -> Vec<Column> {
    let along = result.lines.iter().flat_map(|l| l.x.iter().copied()).collect();
    if scene.frame.is_none() {
        return vec![("x", along)];
    }
    let numbers = result.lines.iter().zip(1_u32..).flat_map(|(l, k)| vec![f64::from(k); l.x.len()]);
    let positions = positions(result);
    let coordinate = |k: usize| positions.iter().map(|p| p[k]).collect();
    vec![("member", numbers.collect()), ("s", along), ("x", coordinate(0)), ("y", coordinate(1))]
}

/// The fields that a state has.
pub(super) fn fields(result: &StateResult) -> Vec<Column> {
    result.fields().iter().filter_map(|&f| Some((f.name(), all(result, f)?))).collect()
}

/// Section forces to the left of the points; those of lines in the order in which readers know them.
pub(super) fn left(scene: &Scene, result: &StateResult) -> Vec<Column> {
    let mut columns: Vec<Column> =
        LEFT.iter().filter_map(|&(f, name)| Some((name, all_left(result, f)?))).collect();
    if scene.frame.is_none() {
        columns.reverse();
    }
    columns
}

/// Smallest and largest values of some fields over all states.
#[derive(Debug, Default)]
pub(super) struct Envelope(Vec<(FieldName, Vec<[f64; 2]>)>);

impl Envelope {
    /// Takes a state into account.
    pub(super) fn widen(&mut self, result: &StateResult) {
        for field in ENVELOPE.into_iter().filter(|f| result.fields().contains(f)) {
            let sides = [all(result, field), all_left(result, field)];
            for values in sides.into_iter().flatten() {
                let known = self.0.iter().position(|b| b.0 == field).unwrap_or_else(|| {
                    self.0.push((field, vec![[f64::INFINITY, f64::NEG_INFINITY]; values.len()]));
                    self.0.len() - 1
                });
                for (bound, value) in self.0[known].1.iter_mut().zip(values) {
                    *bound = [bound[0].min(value), bound[1].max(value)];
                }
            }
        }
    }

    /// Its columns, such as `w_smallest`.
    pub(super) fn columns(&self) -> Vec<(String, Vec<f64>)> {
        let of = |(field, bounds): &(FieldName, Vec<[f64; 2]>)| {
            let side = |k: usize, name: &str| {
                (format!("{}_{name}", field.name()), bounds.iter().map(|b| b[k]).collect())
            };
            [side(0, "smallest"), side(1, "largest")]
        };
        self.0.iter().flat_map(of).collect()
    }
}
