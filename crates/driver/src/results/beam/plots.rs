//! Diagrams of a state of a beam, with its closed form where a check names one.

use crate::case::FieldName;
use crate::output::plot::{self, Diagram, Series, Style};
use crate::reference::{Field, Solution};
use crate::run::beam::BeamResult;
use crate::scene::ExpectationKind;
use crate::scene::beam::{BeamComparison, BeamScene};
use std::io;
use std::path::Path;

/// Writes deflection, rotation, moment and shear into a folder; of a frame its section forces and deformed shape.
///
/// # Errors
/// The folder cannot be written.
pub(in crate::results) fn write(folder: &Path, scene: &BeamScene, result: &BeamResult) -> io::Result<()> {
    let title = match scene.states.len() {
        1 => scene.case.title.clone(),
        _ => format!("{} - {}", scene.case.title, result.record.name),
    };
    if let Some(frame) = &scene.frame {
        return super::frame_plots::write(folder, scene, frame, result, &title);
    }
    let (length, moment) = (scene.units.length(), scene.units.moment());
    let diagrams = [
        ("deflection", Field::W, format!("deflection w [{length}]")),
        ("rotation", Field::Phi, "rotation φ [rad]".into()),
        ("moment", Field::M, format!("bending moment M [{moment}]")),
        ("shear", Field::V, "shear force V [N]".into()),
    ];
    for (file, field, y_label) in diagrams {
        let mut series = Vec::new();
        if let Some(points) = closed_form(scene, result, field) {
            series.push(Series { label: "closed form".into(), style: Style::Line, points });
        }
        let style = if series.is_empty() { Style::Line } else { Style::Dots };
        let Some(points) = curve(result, field) else {
            continue;
        };
        series.push(Series { label: "peristat".into(), style, points });
        let title = title.clone();
        let diagram = Diagram { title, x_label: format!("x [{length}]"), y_label, series };
        plot::write(&folder.join(format!("{file}.svg")), &diagram)?;
    }
    Ok(())
}

/// A field along the beam; section forces take both values of a point where they jump.
fn curve(result: &BeamResult, field: Field) -> Option<Vec<(f64, f64)>> {
    let mut points = Vec::new();
    for (line, fields) in result.lines.iter().enumerate() {
        match field {
            Field::W | Field::Phi => {
                let name = if field == Field::W { FieldName::W } else { FieldName::Phi };
                points.extend(fields.x.iter().copied().zip(result.values(name, line)?.iter().copied()));
            }
            Field::M | Field::V | Field::Energy => {
                let forces = &fields.recovered.as_ref()?.forces;
                let cells = if field == Field::M { &forces.moment } else { &forces.shear };
                for (cell, x) in cells.iter().zip(fields.x.windows(2)) {
                    points.extend([(x[0], cell[0]), (x[1], cell[1])]);
                }
            }
        }
    }
    Some(points)
}

/// The closed form of a check on this state, for the same field.
fn closed_form(scene: &BeamScene, result: &BeamResult, field: Field) -> Option<Vec<(f64, f64)>> {
    let solution =
        scene.expectations.iter().filter(|e| e.state == result.record.index).find_map(|e| match &e.kind {
            ExpectationKind::Points(BeamComparison::ClosedForm { solution, .. }) => Some(solution),
            _ => None,
        })?;
    sampled(solution, field, &result.lines[0].x, scene.beam.chains()[0].line().from)
}

/// A solution at no more than a few hundred positions, with both sides of every point so that jumps show.
fn sampled(solution: &Solution, field: Field, x: &[f64], from: f64) -> Option<Vec<(f64, f64)>> {
    let (first, last) = (x.first()?, x.last()?);
    let nudge = 1e-9 * (last - first);
    let mut points = Vec::new();
    for k in 0..=200 {
        let middle = first + (last - first) * f64::from(k) / 200.0;
        for x in [middle - nudge, middle + nudge] {
            let x = x.clamp(*first, *last);
            points.push((x, solution.value(field, x - from)?));
        }
    }
    Some(points)
}
