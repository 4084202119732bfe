//! The map of a plate in its report: all fields of a state.

use super::blocks::Blocks;
use crate::case::FieldName;
use crate::output::plot::short;
use crate::output::report::{Cells, Field, Map};
use crate::run::PlateResult;
use crate::run::scan;
use crate::scene::PlateScene;

/// The map of a state.
pub(super) fn map(scene: &PlateScene, result: &PlateResult) -> Map {
    let blocks = Blocks::mapped(scene);
    let field = |f: FieldName| {
        let values = result.values(f)?;
        let range = scan::extremes(&values).map_or([0.0; 2], |ends| ends.map(|point| values[point]));
        let unit = f.about().unit.label(scene.units).into();
        Some(Field { name: f.name().into(), unit, values: blocks.means(&values), range })
    };
    let note = match blocks.step {
        1 => {
            "Every cell is the mean of its corners; the colour bar ends at the extremes of all points.".into()
        }
        step => format!(
            "Every cell is the mean of {step} × {step}; the colour bar ends at the extremes of all points."
        ),
    };
    // Where bonds break damage tells most.
    let (first, others): (Vec<_>, Vec<_>) = result.fields().partition(|f| *f == FieldName::Damage);
    Map {
        note,
        length: scene.units.length().into(),
        cells: cells(&blocks),
        fields: first.into_iter().chain(others).filter_map(field).collect(),
        state: (result.record.index, state_name(scene, result)),
        ..Map::default()
    }
}

/// What a state is called, with its load factor where it has one of its own.
fn state_name(scene: &PlateScene, result: &PlateResult) -> String {
    let record = &result.record;
    match scene.case.steps.is_some() || scene.case.is_traced() {
        true => format!("{}, load factor {}", record.name, short(record.load_factor)),
        false => record.name.clone(),
    }
}

fn cells(blocks: &Blocks) -> Cells {
    let (origin, side) = blocks.layout();
    let mut runs: Vec<[usize; 3]> = Vec::new();
    for [column, row] in blocks.places.iter().map(|place| place.map(|k| k as usize)) {
        match runs.last_mut() {
            Some(run) if run[0] == row && run[1] + run[2] == column => run[2] += 1,
            _ => runs.push([row, column, 1]),
        }
    }
    let (size, last) = blocks.size();
    Cells::Grid { origin, sides: [[side, 0.0], [0.0, side]], size, last, runs, torn: Vec::new() }
}
