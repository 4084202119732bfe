//! Fields along lines through a body: a table and two diagrams each.

use crate::case::FieldName;
use crate::output::plot::{Diagram, Series, Style};
use crate::results::files::write_table;
use crate::run::body::BodyResult;
use crate::scene::body::{BodyScene, OutputLine};
use std::io;
use std::path::PathBuf;

/// Writes a table per line with the distance `s` from its start; places outside of the body are left out.
///
/// # Errors
/// The file cannot be written.
pub(super) fn write(
    file: &dyn Fn(&str) -> PathBuf,
    scene: &BodyScene,
    result: &BodyResult,
) -> io::Result<()> {
    for line in &scene.lines {
        let inside = || line.points.iter().filter(|p| p.weights.is_some());
        let mut columns: Vec<(&str, Vec<f64>)> = vec![("s", inside().map(|p| p.s).collect())];
        let axes = ["x", "y", "z"].into_iter().take(scene.body().axes()).enumerate();
        columns.extend(axes.map(|(k, axis)| (axis, inside().map(|p| p.position[k]).collect())));
        columns.extend(result.fields().map(|f| (f.name(), along(line, scene, result, f))));
        let columns: Vec<(&str, &[f64])> = columns.iter().map(|(n, v)| (*n, v.as_slice())).collect();
        write_table(&file(&line.name), scene.units, &columns)?;
    }
    Ok(())
}

/// Values of a field at the places of a line that are in the body.
fn along(line: &OutputLine, scene: &BodyScene, result: &BodyResult, field: FieldName) -> Vec<f64> {
    let weights = line.points.iter().filter_map(|p| p.weights.as_ref());
    weights.filter_map(|w| result.value(scene, field, w)).collect()
}

/// Displacements and stresses along every line: the name of the file of each, and its diagram.
pub(super) fn diagrams(scene: &BodyScene, result: &BodyResult, title: &str) -> Vec<(String, Diagram)> {
    let units = scene.units;
    let (length, stress) = (units.length(), units.stress());
    let kinds = [
        (
            "displacement",
            units.label("displacement", length),
            &[FieldName::Ux, FieldName::Uy, FieldName::Uz][..],
        ),
        (
            "stress",
            units.label("stress", stress),
            &[FieldName::StressXx, FieldName::StressYy, FieldName::StressXy, FieldName::VonMises],
        ),
    ];
    let mut all = Vec::new();
    for line in &scene.lines {
        let s: Vec<f64> = line.points.iter().filter(|p| p.weights.is_some()).map(|p| p.s).collect();
        for (kind, label, fields) in &kinds {
            let there_are = |field: &&FieldName| result.fields().any(|own| own == **field);
            let series = |field: &FieldName| Series {
                label: field.name().into(),
                style: Style::Line,
                points: s.iter().copied().zip(along(line, scene, result, *field)).collect(),
            };
            let diagram = Diagram {
                title: format!("{title} - {}", line.name),
                x_label: units.label("distance along the line", length),
                y_label: label.clone(),
                series: fields.iter().filter(there_are).map(series).collect(),
                ..Diagram::default()
            };
            all.push((format!("line_{}_{kind}", line.name), diagram));
        }
    }
    all
}
