//! The files of a plate in bending: its tables, grids, lines and maps.

mod blocks;
mod held_lines;
mod lines;
mod map;

use super::envelope::Envelope;
use super::files::{self, write_table};
use super::kept::FieldFiles;
use super::report::chart;
use crate::case::FieldName;
use crate::output::plot::{self, Map, Patch, write_map};
use crate::output::report::Block;
use crate::output::vtu::{self, CellType, Cells, DataArray, Grid};
use crate::run::PlateResult;
use crate::run::scan;
use crate::scene::PlateScene;
use blocks::Blocks;
pub(super) use held_lines::TABLE;
use std::borrow::Cow;
use std::io;
use std::path::Path;

/// A column of a table.
type Column<'a> = (&'static str, Cow<'a, [f64]>);

/// Writes the fields of a state as a table and as a grid, where these are kept, and along lines, and widens the envelope by them.
///
/// # Errors
/// The folder cannot be written.
pub(super) fn write(
    folder: &Path,
    name: &str,
    scene: &PlateScene,
    result: &PlateResult,
    (kept, envelope): (FieldFiles, Option<&mut Envelope>),
) -> io::Result<()> {
    let file = |name: &str, extension: &str| folder.join("fields").join(format!("{name}.{extension}"));
    let fields: Vec<Column> = result.fields().filter_map(|f| Some((f.name(), result.values(f)?))).collect();
    let places = places(scene);
    let columns: Vec<(&str, &[f64])> = places
        .iter()
        .map(|(name, values)| (*name, values.as_slice()))
        .chain(fields.iter().map(|(name, values)| (*name, &values[..])))
        .collect();
    if kept.tables {
        write_table(&file(name, "csv"), scene.units, &columns)?;
    }
    if kept.grids {
        write_grid(&file(name, "vtu"), scene, &fields)?;
    }
    if let Some(envelope) = envelope {
        // The direction of a moment has no largest value.
        let kept = fields.iter().filter(|field| field.0 != FieldName::MomentDirection.name());
        kept.for_each(|(name, values)| envelope.widen(name, values));
        envelope.place(places);
    }
    if !scene.held_lines.is_empty() {
        held_lines::write(&folder.join("fields").join(format!("{name}{TABLE}")), scene, result)?;
    }
    lines::write(&|line: &str| file(&format!("{name}_{line}"), "csv"), scene, result)
}

/// The figures of a state for the report; those are also written as plots where a folder is given.
///
/// # Errors
/// The folder cannot be written.
pub(super) fn draw(
    folder: Option<&Path>,
    scene: &PlateScene,
    result: &PlateResult,
) -> io::Result<Vec<Block>> {
    let title = title(scene, result);
    if let Some(folder) = folder {
        write_maps(folder, scene, result, &title)?;
    }
    let mut blocks = vec![Block::Map(map::map(scene, result))];
    let along = lines::diagrams(scene, result, &title).into_iter();
    for (file, diagram) in along.chain(held_lines::diagrams(scene, result, &title)) {
        if let Some(folder) = folder {
            plot::write(&folder.join(format!("{file}.svg")), &diagram)?;
        }
        blocks.push(Block::Chart(chart(&diagram.title.clone(), diagram)));
    }
    Ok(blocks)
}

/// Whether every value of a state is a number.
pub(super) fn finite(result: &PlateResult) -> bool {
    let is_finite = |f: &f64| f.is_finite();
    result.recovered.as_ref().is_none_or(|fields| {
        fields.moment.iter().flatten().all(is_finite) && fields.shear.iter().flatten().all(is_finite)
    })
}

/// The title of a state: that of the case, and its name where there are several.
fn title(scene: &PlateScene, result: &PlateResult) -> String {
    match scene.states.len() > 1 || scene.case.is_traced() {
        false => scene.case.title.clone(),
        true => format!("{} - {}", scene.case.title, result.record.name),
    }
}

/// Where the points are.
fn places(scene: &PlateScene) -> Vec<files::Column> {
    let nodes = scene.plate.nodes();
    let coordinate = |k: usize| (0..nodes.points()).map(|p| nodes.place(p)[k]).collect();
    vec![("x", coordinate(0)), ("y", coordinate(1))]
}

/// Writes the points, the cells between them and their fields as a grid.
fn write_grid(file: &Path, scene: &PlateScene, fields: &[Column]) -> io::Result<()> {
    let nodes = scene.plate.nodes();
    let points: Vec<[f64; 3]> =
        (0..nodes.points()).map(|p| nodes.place(p)).map(|[x, y]| [x, y, 0.0]).collect();
    let around = |[a, b, c, d]: [usize; 4]| [a, b, d, c].map(|p| p as u32);
    let quads: Vec<u32> = nodes.all_cells().filter_map(|cell| nodes.corners(cell)).flat_map(around).collect();
    // The deflection as a vector, so that viewers can warp the plate by it.
    let mut displacement = vec![0.0; 3 * points.len()];
    if let Some((_, w)) = fields.iter().find(|field| field.0 == FieldName::W.name()) {
        w.iter().enumerate().for_each(|(p, w)| displacement[3 * p + 2] = *w);
    }
    let unit = |name: &str| files::unit(name, scene.units);
    let mut data = vec![DataArray {
        name: "displacement",
        components: 3,
        values: &displacement,
        unit: scene.units.length(),
    }];
    data.extend(fields.iter().map(|(name, values)| DataArray {
        name,
        components: 1,
        values,
        unit: unit(name),
    }));
    let cells = [Cells { cell_type: CellType::Quad, connectivity: &quads }];
    vtu::write(file, &Grid { points: &points, cells: &cells, point_data: &data, cell_data: &[] })
}

/// Writes maps of the deflection and of the moments into a folder.
fn write_maps(folder: &Path, scene: &PlateScene, result: &PlateResult, title: &str) -> io::Result<()> {
    let blocks = Blocks::drawn(scene);
    let corners: Vec<[[f64; 2]; 4]> = blocks.corners().collect();
    use FieldName::{Damage, MomentXx, MomentXy, MomentYy, W};
    let drawn = [W, MomentXx, MomentYy, MomentXy, Damage];
    for field in drawn.into_iter().filter(|field| result.fields().any(|own| own == *field)) {
        let Some(values) = result.values(field) else { continue };
        let Some([low, high]) = scan::extremes(&values) else { continue };
        let place = |point: usize| {
            let [x, y] = scene.plate.nodes().place(point).map(plot::short);
            format!("({x}, {y})")
        };
        let map = Map {
            title: title.into(),
            note: format!("smallest at {}, largest at {}", place(low), place(high)),
            label: match field {
                Damage => "damage: cut part of the bonds".into(),
                _ => scene.units.label(field.name(), field.about().unit.label(scene.units)),
            },
            range: [values[low], values[high]],
            patches: corners
                .iter()
                .zip(blocks.means(&values))
                .map(|(corners, value)| Patch::flat(*corners, value))
                .collect(),
            ..Map::default()
        };
        write_map(&folder.join(format!("{}.svg", field.name())), &map)?;
    }
    Ok(())
}
