//! Pictures of a frame: its section forces drawn on its members, and its deformed shape.

use crate::case::FieldName;
use crate::output::plot::{Label, Look, Picture, Shape, thin, write_picture};
use crate::results::factor::magnification;
use crate::run::beam::{Along, BeamResult};
use crate::scene::beam::{BeamScene, EndOfMember, FrameLayout};
use std::io;
use std::path::Path;

/// Part of the size of the frame that the largest value of a diagram takes.
pub(super) const HEIGHT: f64 = 0.14;
/// Points per frame that are drawn, about: more are not seen.
const MOST_POINTS: usize = 12_000;

/// Writes axial force, shear, moment and the deformed shape into a folder.
///
/// # Errors
/// The folder cannot be written.
pub(super) fn write(
    folder: &Path,
    scene: &BeamScene,
    frame: &FrameLayout,
    result: &BeamResult,
    title: &str,
) -> io::Result<()> {
    let (units, signs) = (scene.units, scene.case.drawing.signs);
    let along = Along::new(scene, result);
    // A positive moment stretches the side of −w.
    let diagrams = [
        ("axial_force", FieldName::N, 1.0, units.label("axial force N", "N") + ", tension positive"),
        ("shear", FieldName::V, 1.0, units.label("shear force V", "N") + signs.shear_note()),
        (
            "moment",
            FieldName::M,
            -1.0,
            units.label("bending moment M", units.moment()) + ", on the side in tension",
        ),
    ];
    for (file, field, side, note) in diagrams {
        let sign = if field == FieldName::V { signs.of_shear() } else { 1.0 };
        let Some(picture) = diagram(frame, (result, &along), field, (side, sign)) else { continue };
        let picture = Picture { title: title.into(), note, ..picture };
        write_picture(&folder.join(format!("{file}.svg")), &picture)?;
    }
    let (picture, factor) = deformed(frame, result);
    let note = format!("deformed shape, displacements times {factor}");
    write_picture(&folder.join("deformed.svg"), &Picture { title: title.into(), note, ..picture })
}

/// Length of the diagonal around the frame.
pub(super) fn size(frame: &FrameLayout) -> f64 {
    let extent = |k: usize| {
        let of = || frame.joints.iter().map(|j| j.position[k]);
        of().fold(f64::NEG_INFINITY, f64::max) - of().fold(f64::INFINITY, f64::min)
    };
    extent(0).hypot(extent(1))
}

/// The members as lines, and their joints and hinges.
pub(super) fn skeleton(frame: &FrameLayout, look: Look) -> Vec<Shape> {
    let place = |joint: usize| (frame.joints[joint].position[0], frame.joints[joint].position[1]);
    let mut shapes: Vec<Shape> = frame
        .members
        .iter()
        .map(|m| Shape { look, points: [0, 1].map(|side| frame.end(m, side).into()).to_vec() })
        .collect();
    let dots = (0..frame.joints.len()).map(place).collect();
    shapes.push(Shape { look: Look::Dots, points: dots });
    // A hinge stands beside its joint, on the member that turns.
    let shift = 0.015 * size(frame);
    let hinges = frame.joints.iter().flat_map(|j| j.ends.iter().filter(|e| e.hinged));
    let circle = |end: &EndOfMember| {
        let sign = if end.side == 0 { shift } else { -shift };
        let member = &frame.members[end.member];
        let ([x, y], [c, s]) = (frame.end(member, end.side), member.direction);
        (x + sign * c, y + sign * s)
    };
    shapes.push(Shape { look: Look::Circles, points: hinges.map(circle).collect() });
    shapes
}

/// A section force times a sign across the members, on their left where `side` is 1 and the value positive.
fn diagram(
    frame: &FrameLayout,
    (result, along): (&BeamResult, &Along),
    field: FieldName,
    (side, sign): (f64, f64),
) -> Option<Picture> {
    let largest = along.largest(field)?;
    let unit = if largest > 0.0 { side * HEIGHT * size(frame) / largest } else { 0.0 };
    let most = (MOST_POINTS / result.lines.len()).max(8);
    let (mut shapes, mut labels) = (Vec::new(), Vec::new());
    for (number, line) in result.lines.iter().enumerate() {
        let signed = |(x, value): (f64, f64)| (x, sign * value);
        let curve: Vec<_> = along.curve(field, number)?.into_iter().map(signed).collect();
        let ([c, s], [x0, y0]) = (line.direction, line.origin);
        let on = |x: f64, across: f64| (x0 + c * x - s * across, y0 + s * x + c * across);
        let (first, last) = (curve[0].0, curve[curve.len() - 1].0);
        let mut points = vec![on(first, 0.0)];
        points.extend(thin(&curve, most).into_iter().map(|(x, value)| on(x, unit * value)));
        points.extend([on(last, 0.0), on(first, 0.0)]);
        shapes.push(Shape { look: Look::Area, points });
        let extreme = extreme(&curve);
        if let Some((x, value)) = extreme.filter(|(_, value)| value.abs() > 0.01 * largest) {
            let away = (unit * value).signum();
            labels.push(Label { value, at: on(x, unit * value), away: (-s * away, c * away) });
        }
    }
    labels.sort_by(|a, b| b.value.abs().total_cmp(&a.value.abs()));
    shapes.extend(skeleton(frame, Look::Body));
    Some(Picture { shapes, labels, ..Picture::default() })
}

/// The largest magnitude of a curve; where it lasts, the place nearest to the middle.
fn extreme(curve: &[(f64, f64)]) -> Option<(f64, f64)> {
    let largest = curve.iter().map(|p| p.1.abs()).fold(0.0, f64::max);
    let middle = 0.5 * (curve.first()?.0 + curve.last()?.0);
    let as_large = curve.iter().copied().filter(|p| p.1.abs() >= largest * (1.0 - 1e-9));
    as_large.min_by(|a, b| (a.0 - middle).abs().total_cmp(&(b.0 - middle).abs()))
}

/// The deformed shape over the frame as it was, and the round factor on its displacements.
fn deformed(frame: &FrameLayout, result: &BeamResult) -> (Picture, f64) {
    let largest = result.displacements().map(|[x, y]| x.hypot(y)).fold(0.0, f64::max);
    let factor = magnification(size(frame), largest);
    let mut shapes = skeleton(frame, Look::Ghost);
    let mut displacements = result.displacements();
    let most = (MOST_POINTS / result.lines.len()).max(8);
    for line in &result.lines {
        let moved: Vec<(f64, f64)> = (0..line.x.len())
            .zip(&mut displacements)
            .map(|(k, [ux, uy])| {
                let [x, y] = line.position(k);
                (x + factor * ux, y + factor * uy)
            })
            .collect();
        let step = moved.len().div_ceil(most);
        let last = moved.last().copied();
        shapes
            .push(Shape { look: Look::Line, points: moved.into_iter().step_by(step).chain(last).collect() });
    }
    (Picture { shapes, ..Picture::default() }, factor)
}
