//! The picture of a frame in its report: its deformed shape, and its section forces on its members.

use super::frame_plots::{HEIGHT, size, skeleton};
use crate::case::FieldName;
use crate::output::plot::{Look, thin};
use crate::output::report::{Part, Picture, Shape, View};
use crate::results::factor::magnification;
use crate::run::beam::{Along, BeamResult};
use crate::scene::beam::{BeamScene, FrameLayout};

/// Points of a view that are drawn, about: those of all states share a file.
const MOST_POINTS: usize = 2400;

/// The picture of a state, one of `share` in the report.
pub(super) fn picture(scene: &BeamScene, frame: &FrameLayout, result: &BeamResult, share: usize) -> Picture {
    let most = (MOST_POINTS / share / result.lines.len()).max(8);
    let moment = scene.units.moment();
    let along = Along::new(scene, result);
    let mut views = vec![deformed(scene, frame, result, most)];
    // A positive moment stretches the side of −w.
    views.extend(forces(frame, (result, &along), (FieldName::M, 1.0), most).map(|shapes| View {
        name: "bending moment M".into(),
        unit: moment.into(),
        note: "on the side in tension".into(),
        factor: -1.0,
        shapes,
        ..View::default()
    }));
    let signs = scene.case.drawing.signs;
    let shear_note = signs.shear_note().trim_start_matches(", ");
    let rest = [
        ("shear force V", (FieldName::V, signs.of_shear()), shear_note),
        ("axial force N", (FieldName::N, 1.0), "tension positive"),
    ];
    views.extend(rest.into_iter().filter_map(|(name, force, note)| {
        let shapes = forces(frame, (result, &along), force, most)?;
        let (name, unit, note) = (name.into(), scene.units.force().into(), note.into());
        Some(View { name, unit, note, factor: 1.0, shapes, ..View::default() })
    }));
    let members = frame.members.len();
    Picture {
        title: String::new(),
        description: format!(
            "Frame of {members} members: its deformed shape, and diagrams of its section forces"
        ),
        length: scene.units.length().into(),
        views,
    }
}

/// Members, joints and hinges as they were.
fn still(frame: &FrameLayout, look: Look) -> impl Iterator<Item = Shape> {
    skeleton(frame, look).into_iter().map(|shape| Shape {
        part: match shape.look {
            Look::Body => Part::Body,
            Look::Dots => Part::Dots,
            Look::Circles => Part::Circles,
            _ => Part::Ghost,
        },
        points: shape.points.into_iter().map(|(x, y)| [x, y]).collect(),
        ..Shape::default()
    })
}

fn deformed(scene: &BeamScene, frame: &FrameLayout, result: &BeamResult, most: usize) -> View {
    let mut displacements = result.displacements();
    let mut shapes: Vec<Shape> = still(frame, Look::Ghost).collect();
    let mut largest = 0.0_f64;
    for (line, member) in result.lines.iter().zip(&frame.members) {
        let count = line.x.len();
        let moves: Vec<[f64; 2]> = displacements.by_ref().take(count).collect();
        largest = moves.iter().map(|[x, y]| x.hypot(*y)).fold(largest, f64::max);
        let kept: Vec<usize> = (0..count - 1).step_by(count.div_ceil(most)).chain([count - 1]).collect();
        shapes.push(Shape {
            name: member.name.clone(),
            part: Part::Line,
            points: kept.iter().map(|&k| line.position(k)).collect(),
            moves: kept.iter().map(|&k| moves[k]).collect(),
            values: kept.iter().map(|&k| moves[k][0].hypot(moves[k][1])).collect(),
        });
    }
    View {
        name: "displacement".into(),
        unit: scene.units.length().into(),
        note: String::new(),
        factor: magnification(size(frame), largest),
        slides: true,
        shapes,
    }
}

/// A section force times a sign across the members, on their left where the value is positive; none if it was not recovered.
fn forces(
    frame: &FrameLayout,
    (result, along): (&BeamResult, &Along),
    (field, sign): (FieldName, f64),
    most: usize,
) -> Option<Vec<Shape>> {
    let largest = along.largest(field)?;
    let unit = if largest > 0.0 { HEIGHT * size(frame) / largest } else { 0.0 };
    let mut shapes = Vec::new();
    for (number, (line, member)) in result.lines.iter().zip(&frame.members).enumerate() {
        let ([c, s], [x0, y0]) = (line.direction, line.origin);
        let signed = |(x, value): (f64, f64)| (x, sign * value);
        let curve: Vec<_> = along.curve(field, number)?.into_iter().map(signed).collect();
        let points = thin(&curve, most);
        shapes.push(Shape {
            name: member.name.clone(),
            part: Part::Area,
            points: points.iter().map(|(x, _)| [x0 + c * x, y0 + s * x]).collect(),
            moves: points.iter().map(|(_, value)| [-s * unit * value, c * unit * value]).collect(),
            values: points.iter().map(|(_, value)| *value).collect(),
        });
    }
    shapes.extend(still(frame, Look::Body));
    Some(shapes)
}
