//! The files of a body: its tables, grids, lines, maps and pictures.

mod apart;
mod blocks;
mod cells;
mod crack_surface;
mod lines;
mod marks;
mod plots;
mod raster;
mod report;
mod slices;
mod solid;
mod surface;

use super::envelope::Envelope;
use super::files::{self, write_table};
use super::kept::FieldFiles;
use super::report::chart;
use crate::case::{FieldName, Unit};
use crate::output::plot;
use crate::output::report::Block;
use crate::output::vtu::{self, CellType, Cells, DataArray, Grid};
use crate::run::body::BodyResult;
use crate::scene::body::BodyScene;
use peristat_assembly::body::PointBody;
use std::borrow::Cow;
use std::io;
use std::path::Path;

/// A column of a table.
type Column<'a> = (&'static str, Cow<'a, [f64]>);

/// Fields whose smallest and largest values over all states are written.
const ENVELOPE: [FieldName; 12] = [
    FieldName::Ux,
    FieldName::Uy,
    FieldName::Uz,
    FieldName::W,
    FieldName::Phi,
    FieldName::StressXx,
    FieldName::StressYy,
    FieldName::StressXy,
    FieldName::StressZz,
    FieldName::StressYz,
    FieldName::StressXz,
    FieldName::VonMises,
];

/// Writes the fields of a state as a table and as a grid, where these are kept, and along lines, and widens the envelope by them.
///
/// # Errors
/// The folder cannot be written.
pub(super) fn write(
    folder: &Path,
    name: &str,
    scene: &BodyScene,
    result: &BodyResult,
    (kept, envelope): (FieldFiles, Option<&mut Envelope>),
) -> io::Result<()> {
    let file = |name: &str, extension: &str| folder.join("fields").join(format!("{name}.{extension}"));
    let fields: Vec<Column> =
        result.fields().filter_map(|f| Some((f.name(), result.values(scene, f)?))).collect();
    let places = places(scene);
    let columns: Vec<(&str, &[f64])> = places
        .iter()
        .map(|(name, values)| (*name, values.as_slice()))
        .chain(fields.iter().map(|(name, values)| (*name, &values[..])))
        .collect();
    if kept.tables {
        write_table(&file(name, "csv"), scene.units, &columns)?;
    }
    if let Some(envelope) = envelope {
        for field in ENVELOPE {
            if let Some((_, values)) = fields.iter().find(|f| f.0 == field.name()) {
                envelope.widen(field.name(), values);
            }
        }
        envelope.place(places);
    } else {
        drop(places);
    }
    if kept.grids {
        write_grid(&file(name, "vtu"), scene, &fields)?;
        if let (PointBody::Solid(lattice), true) = (scene.body(), scene.fracture.is_some()) {
            crack_surface::write(&file(&format!("{name}_crack"), "vtu"), (scene, lattice), result)?;
        }
    }
    lines::write(&|line: &str| file(&format!("{name}_{line}"), "csv"), scene, result)
}

/// The figures of a state for the report; those are also written as plots where a folder is given.
///
/// # Errors
/// The folder cannot be written.
pub(super) fn draw(folder: Option<&Path>, scene: &BodyScene, result: &BodyResult) -> io::Result<Vec<Block>> {
    if let Some(folder) = folder {
        plots::write(folder, scene, result)?;
    }
    let mut blocks = vec![match scene.body().is_solid() {
        true => Block::Solid(solid::solid(scene, result)),
        false => Block::Map(report::map(scene, result)),
    }];
    if result.recovered.is_some() {
        for (file, diagram) in lines::diagrams(scene, result, &plots::title(scene, result)) {
            if let Some(folder) = folder {
                plot::write(&folder.join(format!("{file}.svg")), &diagram)?;
            }
            blocks.push(Block::Chart(chart(&diagram.title.clone(), diagram)));
        }
    }
    Ok(blocks)
}

/// Where the points are.
fn places(scene: &BodyScene) -> Vec<files::Column> {
    let body = scene.body();
    let mut columns = [(); 3].map(|()| Vec::with_capacity(body.points()));
    body.visit(|at| columns.iter_mut().zip(at).for_each(|(column, x)| column.push(x)));
    let named = ["x", "y", "z"].into_iter().zip(columns);
    named.take(body.axes()).collect()
}

/// Writes the points, the cells between them and their fields as a grid; a shell as the cylinder that it is.
fn write_grid(file: &Path, scene: &BodyScene, fields: &[Column]) -> io::Result<()> {
    let radius = scene.material().cylinder_radius();
    let (mut points, mut angles) = (Vec::with_capacity(scene.body().points()), Vec::new());
    scene.body().visit(|[x, y, z]| match radius {
        Some(r) => {
            let (sin, cos) = (y / r).sin_cos();
            points.push([x, r * sin, r * cos]);
            angles.push([sin, cos]);
        }
        None => points.push([x, y, z]),
    });
    let cells = cells::cells(scene);
    // The displacement as a vector, so that viewers can warp the body by it.
    const DISPLACEMENTS: [(usize, FieldName); 4] =
        [(0, FieldName::Ux), (1, FieldName::Uy), (2, FieldName::Uz), (2, FieldName::W)];
    let mut displacement = vec![0.0; 3 * points.len()];
    for (c, field) in DISPLACEMENTS {
        if let Some((_, values)) = fields.iter().find(|f| f.0 == field.name()) {
            values.iter().enumerate().for_each(|(p, value)| displacement[3 * p + c] = *value);
        }
    }
    for (vector, [sin, cos]) in displacement.chunks_exact_mut(3).zip(&angles) {
        let (v, w) = (vector[1], vector[2]);
        (vector[1], vector[2]) = (v * cos + w * sin, w * cos - v * sin);
    }
    let mut data = vec![DataArray {
        name: "displacement",
        components: 3,
        values: &displacement,
        unit: scene.units.length(),
    }];
    let in_vector = [FieldName::Ux, FieldName::Uy, FieldName::Uz].map(FieldName::name);
    let is_plain = |c: &&Column| !in_vector.contains(&c.0);
    data.extend(fields.iter().filter(is_plain).map(|(name, values)| DataArray {
        name,
        components: 1,
        values,
        unit: files::unit(name, scene.units),
    }));
    // Means and integrals over a solid weigh its points by it.
    let body = scene.body();
    let volumes: Option<Vec<f64>> =
        body.is_solid().then(|| (0..body.points()).map(|p| body.measure(p)).collect());
    let volume = Unit::One.times_length(3, scene.units);
    data.extend(volumes.iter().map(|values| DataArray {
        name: "volume",
        components: 1,
        values,
        unit: &volume,
    }));
    let all = [
        Cells { cell_type: CellType::Quad, connectivity: &cells.quads },
        Cells { cell_type: CellType::Hexahedron, connectivity: &cells.hexahedra },
        Cells { cell_type: CellType::Vertex, connectivity: &cells.vertices },
    ];
    vtu::write(file, &Grid { points: &points, cells: &all, point_data: &data, cell_data: &[] })
}

/// Whether every value of a state is a number.
pub(super) fn finite(result: &BodyResult) -> bool {
    let finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
    let recovered = result.recovered.as_ref();
    recovered.is_none_or(|r| r.stress.iter().all(|s| finite(s)) && finite(&r.energy_density))
        && finite(&result.intensities)
}
