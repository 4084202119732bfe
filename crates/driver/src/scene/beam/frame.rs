//! The frame of a scene: joints and members before any bond exists.

use super::ends;
use super::frame_checks;
use super::frame_layout::{EndOfMember, FrameLayout, JointLayout, MemberLayout, ROUNDING, path};
use super::line::{MOST_POINTS, layout_line};
use super::model_path::beam_path;
use super::place::{Layout, LayoutLine};
use crate::case::{AxialForce, Case, Frame, Line, Member, MemberEnd};
use crate::diagnostic::{Faults, JsonPath, suggest, tidy};
use peristat_assembly::model::timoshenko_beam::Grid;
use peristat_assembly::model::timoshenko_beam::end_treatment::EndTreatment;
use std::collections::HashMap;

/// Members as lines, and the joints between them.
pub(super) fn layout(
    case: &Case,
    frame: &Frame,
    treatment: &'static EndTreatment,
    faults: &mut Faults,
) -> Option<Layout> {
    let before = faults.errors();
    if !treatment.covers() {
        faults
            .error(
                beam_path().key("end_treatment"),
                format!("members of a frame cannot have the end treatment `{}`", treatment.name),
            )
            .hint("leave `end_treatment` out: a frame needs `cover`");
    }
    if frame.members.is_empty() {
        faults.error(path().key("members"), "the frame has no members");
    }
    let mut joints = joints(frame, faults);
    let (mut lines, mut members) = (Vec::new(), Vec::new());
    let names: Vec<(&str, JsonPath)> = frame
        .members
        .iter()
        .enumerate()
        .map(|(k, m)| (m.name.as_str(), path().key("members").index(k).key("name")))
        .collect();
    frame_checks::unique(&names, "members", faults);
    let known: HashMap<String, usize> =
        joints.iter().enumerate().rev().map(|(k, j)| (j.name.clone(), k)).collect();
    for (k, member) in frame.members.iter().enumerate() {
        let at = path().key("members").index(k);
        let Some((line, laid)) = place_member(case, member, &joints, &known, &at, faults) else { continue };
        for side in 0..2 {
            let hinged = member.hinges.contains(&[MemberEnd::From, MemberEnd::To][side]);
            joints[laid.joints[side]].ends.push(EndOfMember { member: k, side, hinged });
        }
        lines.push(line);
        members.push(laid);
    }
    frame_checks::check_joints(frame, &known, faults);
    frame_checks::check_hinges(frame, faults);
    frame_checks::check_one_way(frame, faults);
    if faults.errors() == before {
        ends::arrange(&mut joints, &mut members, faults);
        frame_checks::warn_of_places(frame, faults);
    }
    if lines.iter().map(|l| l.cells + 1).sum::<usize>() > MOST_POINTS {
        faults.error(
            path().key("members"),
            format!("the members have more than {MOST_POINTS} points together"),
        );
    }
    let fine = faults.errors() == before;
    fine.then_some(Layout { lines, treatment, frame: Some(FrameLayout { joints, members }) })
}

fn joints(frame: &Frame, faults: &mut Faults) -> Vec<JointLayout> {
    let at = |k: usize| path().key("joints").index(k);
    let names: Vec<(&str, JsonPath)> =
        frame.joints.iter().enumerate().map(|(k, j)| (j.name.as_str(), at(k).key("name"))).collect();
    frame_checks::unique(&names, "joints", faults);
    let lay =
        |j: &crate::case::Joint| JointLayout { name: j.name.clone(), position: [j.x, j.y], ends: Vec::new() };
    frame.joints.iter().map(lay).collect()
}

/// A member as a line of its own coordinate from 0.
fn place_member(
    case: &Case,
    member: &Member,
    joints: &[JointLayout],
    known: &HashMap<String, usize>,
    at: &JsonPath,
    faults: &mut Faults,
) -> Option<(LayoutLine, MemberLayout)> {
    let mut find = |name: &str, key: &str| {
        let found = known.get(name).copied();
        if found.is_none() {
            faults
                .error(at.key(key), format!("there is no joint `{name}`"))
                .hint(suggest(name, joints.iter().map(|j| j.name.as_str())));
        }
        found
    };
    let ends = [find(&member.from, "from"), find(&member.to, "to")];
    let mut fine = true;
    if member.cells == 0 || member.cells > MOST_POINTS {
        let limit = if member.cells == 0 { "at least 1".into() } else { format!("at most {MOST_POINTS}") };
        faults.error(at.key("cells"), format!("`cells` must be {limit}, found {}", member.cells));
        fine = false;
    }
    let [Some(from), Some(to)] = ends else { return None };
    if from == to {
        faults.error(at.key("to"), format!("the member begins and ends at the joint `{}`", member.to));
        return None;
    }
    let given = member.offsets.unwrap_or_default();
    let offsets = [given.from, given.to];
    let end = |joint: usize, offset: [f64; 2]| [0, 1].map(|k| joints[joint].position[k] + offset[k]);
    let (a, b) = (end(from, offsets[0]), end(to, offsets[1]));
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let length = dx.hypot(dy);
    // Positions of points must differ, so cells must be seen beside the coordinates.
    let far = [a, b].as_flattened().iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let spacing = length / member.cells.max(1) as f64;
    if length == 0.0 {
        faults.error(at.clone(), format!("the member `{}` has no length", member.name)).hint(format!(
            "its ends are both at ({}, {})",
            tidy(a[0]),
            tidy(a[1])
        ));
        return None;
    }
    if spacing <= 1e-14 * far {
        faults.error(at.clone(), "the joints are so far from the origin that neighbouring points coincide");
        return None;
    }
    if !fine {
        return None;
    }
    let (cells, grading) = (member.cells, member.grading.clone());
    let line = Line { from: 0.0, length, cells, grid: Grid::Nodes, grading };
    let line = layout_line(case, &line, at, faults)?;
    let direction = [dx, dy].map(|d| if d.abs() <= ROUNDING * length { 0.0 } else { d / length });
    let only = member.only.map(AxialForce::sign);
    let laid = MemberLayout {
        name: member.name.clone(),
        joints: [from, to],
        direction,
        offsets,
        only,
        released: None,
    };
    Some((line, laid))
}
