//! The files of a beam or frame: its tables, grids and plots.

mod columns;
mod frame_plots;
mod frame_report;
mod plots;

pub(super) use columns::fields;

use super::envelope::Envelope;
use super::files::{self, Column, write_table};
use super::kept::FieldFiles;
use super::report::chart;
use crate::case::FieldName;
use crate::output::plot;
use crate::output::report::Block;
use crate::output::vtu::{self, CellType, Cells, DataArray, Grid};
use crate::run::beam::BeamResult;
use crate::scene::beam::BeamScene;
use crate::units::Units;
use std::io;
use std::path::Path;

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

/// Writes the fields of a state as a table and as a grid, where these are kept, and widens the envelope by them.
///
/// # Errors
/// The folder cannot be written.
pub(super) fn write(
    folder: &Path,
    name: &str,
    scene: &BeamScene,
    result: &BeamResult,
    (kept, envelope): (FieldFiles, Option<&mut Envelope>),
) -> io::Result<()> {
    let (places, left) = (columns::places(scene, result), columns::left(scene, result));
    let fields: Vec<Column> = fields(result).collect();
    let file = |extension: &str| folder.join("fields").join(format!("{name}.{extension}"));
    if kept.tables {
        let all = places.iter().chain(&fields).chain(&left);
        let columns: Vec<(&str, &[f64])> = all.map(|(name, values)| (*name, values.as_slice())).collect();
        write_table(&file("csv"), scene.units, &columns)?;
    }
    if kept.grids {
        write_grid(&file("vtu"), scene.units, &fields, result)?;
    }
    if let Some(envelope) = envelope {
        envelope.place(places);
        widen(envelope, result);
    }
    Ok(())
}

/// The figures of a state, one of `share` in the report: deflection, rotation, moment and shear; of a frame its deformed
/// shape and section forces. Those are also written as plots where a folder is given.
///
/// # Errors
/// The folder cannot be written.
pub(super) fn draw(
    folder: Option<&Path>,
    scene: &BeamScene,
    result: &BeamResult,
    share: usize,
) -> io::Result<Vec<Block>> {
    if let Some(frame) = &scene.frame {
        if let Some(folder) = folder {
            frame_plots::write(folder, scene, frame, result, &plots::title(scene, result))?;
        }
        return Ok(vec![Block::Picture(frame_report::picture(scene, frame, result, share))]);
    }
    let mut blocks = Vec::new();
    for (file, diagram) in plots::diagrams(scene, result) {
        if let Some(folder) = folder {
            plot::write(&folder.join(format!("{file}.svg")), &diagram)?;
        }
        blocks.push(Block::Chart(chart("", diagram)));
    }
    Ok(blocks)
}

/// Takes both sides of every point into account.
fn widen(envelope: &mut Envelope, result: &BeamResult) {
    for field in ENVELOPE.into_iter().filter(|f| result.fields().contains(f)) {
        let sides = [result.all_values(field), columns::all_left(result, field).map(Into::into)];
        sides.iter().flatten().for_each(|values| envelope.widen(field.name(), values));
    }
}

/// Writes the points, the lines between them and their fields as a grid.
fn write_grid(file: &Path, units: Units, fields: &[Column], result: &BeamResult) -> io::Result<()> {
    let points = columns::positions(result);
    let mut connectivity: Vec<u32> = Vec::new();
    let mut first = 0;
    for line in &result.lines {
        let count = line.x.len() as u32;
        connectivity.extend((first..first + count - 1).flat_map(|p| [p, p + 1]));
        first += count;
    }
    // The displacement as a vector, so that viewers can warp the body by it.
    let displacement: Vec<f64> = result.displacements().flat_map(|[x, y]| [x, y, 0.0]).collect();
    let mut data =
        vec![DataArray { name: "displacement", components: 3, values: &displacement, unit: units.length() }];
    data.extend(fields.iter().map(|(name, values)| DataArray {
        name,
        components: 1,
        values,
        unit: files::unit(name, units),
    }));
    let grid = Grid {
        points: &points,
        cells: &[Cells { cell_type: CellType::Line, connectivity: &connectivity }],
        point_data: &data,
        cell_data: &[],
    };
    vtu::write(file, &grid)
}
