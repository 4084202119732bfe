//! Fields along lines through a plate: a table and three diagrams each.

use crate::case::FieldName;
use crate::output::plot::{Diagram, Series, Style};
use crate::results::files::write_table;
use crate::run::PlateResult;
use crate::scene::PlateScene;
use crate::scene::body::OutputLine;
use std::io;
use std::path::PathBuf;

/// Writes a table per line with the distance `s` from its start; places outside of the plate are left out.
///
/// # Errors
/// The file cannot be written.
pub(super) fn write(
    file: &dyn Fn(&str) -> PathBuf,
    scene: &PlateScene,
    result: &PlateResult,
) -> io::Result<()> {
    for line in &scene.lines {
        let inside = || line.points.iter().filter(|p| p.weights.is_some());
        let mut columns: Vec<(&str, Vec<f64>)> = vec![("s", inside().map(|p| p.s).collect())];
        let axes = ["x", "y"].into_iter().enumerate();
        columns.extend(axes.map(|(k, axis)| (axis, inside().map(|p| p.position[k]).collect())));
        columns.extend(result.fields().map(|field| (field.name(), along(line, result, field))));
        let columns: Vec<(&str, &[f64])> = columns.iter().map(|(n, v)| (*n, v.as_slice())).collect();
        write_table(&file(&line.name), scene.units, &columns)?;
    }
    Ok(())
}

/// Values of a field at the places of a line that are in the plate.
fn along(line: &OutputLine, result: &PlateResult, field: FieldName) -> Vec<f64> {
    let weights = line.points.iter().filter_map(|p| p.weights.as_ref());
    weights.filter_map(|w| result.value(field, w)).collect()
}

/// Deflections, moments and shear forces along every line: the name of the file of each, and its diagram.
pub(super) fn diagrams(scene: &PlateScene, result: &PlateResult, title: &str) -> Vec<(String, Diagram)> {
    use FieldName::{MomentXx, MomentXy, MomentYy, ShearX, ShearY, W};
    let units = scene.units;
    let kinds = [
        ("deflection", units.label("deflection", units.length()), &[W][..]),
        ("moment", units.label("moment per width", units.force()), &[MomentXx, MomentYy, MomentXy]),
        ("shear", units.label("shear force per width", units.force_per_length()), &[ShearX, ShearY]),
    ];
    let mut all = Vec::new();
    for line in &scene.lines {
        let s: Vec<f64> = line.points.iter().filter(|p| p.weights.is_some()).map(|p| p.s).collect();
        for (kind, label, fields) in &kinds {
            let series = |field: &FieldName| Series {
                label: field.name().into(),
                style: Style::Line,
                points: s.iter().copied().zip(along(line, result, *field)).collect(),
            };
            let diagram = Diagram {
                title: format!("{title} - {}", line.name),
                x_label: units.label("distance along the line", units.length()),
                y_label: label.clone(),
                series: fields.iter().map(series).collect(),
                ..Diagram::default()
            };
            all.push((format!("line_{}_{kind}", line.name), diagram));
        }
    }
    all
}
