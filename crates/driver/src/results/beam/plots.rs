//! Diagrams of a state of a beam, with its closed form where a check names one.

use crate::case::{FieldName, Signs};
use crate::output::plot::{Diagram, Series, Style};
use crate::reference::{Field, Solution};
use crate::run::beam::{Along, BeamResult};
use crate::scene::ExpectationKind;
use crate::scene::beam::{BeamComparison, BeamScene};

/// The title of a state: that of the case, and its name where there are several.
pub(super) fn title(scene: &BeamScene, result: &BeamResult) -> String {
    match scene.states.len() {
        1 => scene.case.title.clone(),
        _ => format!("{} - {}", scene.case.title, result.record.name),
    }
}

/// Deflection, rotation, moment and shear along lines: the name of the file of each, and its diagram.
pub(super) fn diagrams(scene: &BeamScene, result: &BeamResult) -> Vec<(&'static str, Diagram)> {
    let units = scene.units;
    let (length, moment) = (units.length(), units.moment());
    let signs = scene.case.drawing.signs;
    let fields = [
        ("deflection", (FieldName::W, Field::W), units.label("deflection w", length)),
        ("rotation", (FieldName::Phi, Field::Phi), "rotation φ [rad]".into()),
        ("moment", (FieldName::M, Field::M), units.label("bending moment M", moment) + moment_note(signs)),
        ("shear", (FieldName::V, Field::V), units.label("shear force V", "N") + signs.shear_note()),
    ];
    let along = Along::new(scene, result);
    let diagram = |(file, (name, field), y_label): (&'static str, (FieldName, Field), String)| {
        let sign = if field == Field::V { signs.of_shear() } else { 1.0 };
        let signed = |points: Vec<(f64, f64)>| points.into_iter().map(|(x, y)| (x, sign * y)).collect();
        let curves: Option<Vec<_>> = (0..result.lines.len()).map(|line| along.curve(name, line)).collect();
        let points = signed(curves?.concat());
        let mut series = Vec::new();
        if let Some(points) = closed_form(scene, result, field).map(signed) {
            series.push(Series { label: "closed form".into(), style: Style::Line, points });
        }
        let style = if series.is_empty() { Style::Line } else { Style::Dots };
        series.push(Series { label: "peristat".into(), style, points });
        let (title, x_label) = (title(scene, result), units.label("x", length));
        let downwards = field == Field::M && signs == Signs::TensionSide;
        Some((file, Diagram { title, x_label, y_label, downwards, series }))
    };
    fields.into_iter().filter_map(diagram).collect()
}

/// What the diagram of moments says of their side.
fn moment_note(signs: Signs) -> &'static str {
    match signs {
        Signs::Fields => "",
        Signs::Structural => ", sagging positive",
        Signs::TensionSide => ", on the side in tension",
    }
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
