//! The columns of tables: where the points of a beam are, and what is known on them.

use crate::case::FieldName;
use crate::results::files::Column;
use crate::run::beam::{BeamResult, LineFields};
use crate::scene::beam::BeamScene;

/// Section forces to the left of the points, where they may jump, and their columns.
const LEFT: [(FieldName, &str); 3] =
    [(FieldName::N, "N_left"), (FieldName::V, "V_left"), (FieldName::M, "M_left")];

/// Values of a field to the left of all real points, where it may jump.
pub(super) fn all_left(result: &BeamResult, field: FieldName) -> Option<Vec<f64>> {
    let lines: Option<Vec<_>> = (0..result.lines.len()).map(|l| result.left_values(field, l)).collect();
    Some(lines?.concat())
}

/// Positions of all real points in space.
pub(super) fn positions(result: &BeamResult) -> Vec<[f64; 3]> {
    let of = |line: &LineFields| -> Vec<[f64; 3]> {
        (0..line.x.len()).map(|k| line.position(k)).map(|[x, y]| [x, y, 0.0]).collect()
    };
    result.lines.iter().flat_map(of).collect()
}

/// Where the points are: `x` on lines; on a frame the number of the member, from 1, the distance `s` from its joint
/// `from`, and the position in the plane.
pub(super) fn places(scene: &BeamScene, result: &BeamResult) -> Vec<Column> {
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
pub(crate) fn fields(result: &BeamResult) -> impl Iterator<Item = Column> {
    result.fields().iter().filter_map(|&f| Some((f.name(), result.all_values(f)?.into_owned())))
}

/// Section forces to the left of the points; those of lines in the order in which readers know them.
pub(super) fn left(scene: &BeamScene, result: &BeamResult) -> Vec<Column> {
    let mut columns: Vec<Column> =
        LEFT.iter().filter_map(|&(f, name)| Some((name, all_left(result, f)?))).collect();
    if scene.frame.is_none() {
        columns.reverse();
    }
    columns
}
