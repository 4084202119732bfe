//! What the `at` of a case names: a place on a line or member, or a joint.

use super::frame_layout::FrameLayout;
use super::place::{Layout, Place};
use crate::case::At;
use crate::diagnostic::{Faults, JsonPath, suggest, tidy};

/// A place that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FramePlace {
    /// On a line or member.
    On(Place),
    /// A joint of the frame.
    Joint(usize),
}

/// How a place on a frame is written, for hints.
const ON_A_FRAME: &str =
    r#"write { "joint": "A" }, or { "member": "beam", "x": 1.2 } with x from the joint `from`"#;

/// Finds the place that `at` names; `path` leads to it.
pub(super) fn find(
    at: &At,
    layout: &Layout,
    path: &JsonPath,
    what: &str,
    faults: &mut Faults,
) -> Option<FramePlace> {
    match &layout.frame {
        Some(frame) => on_frame(at, frame, layout, path, what, faults),
        None => on_line(at, layout, path, what, faults),
    }
}

fn on_line(at: &At, layout: &Layout, path: &JsonPath, what: &str, faults: &mut Faults) -> Option<FramePlace> {
    if !super::foreign::check_place(at, path, r#"a place on a line is written { "x": 1.0 }"#, faults) {
        return None;
    }
    for (key, given) in [("joint", &at.joint), ("member", &at.member)] {
        if given.is_some() {
            faults
                .error(path.key(key), format!("`{key}` is for frames"))
                .hint(r#"a place on a line is written { "x": 1.0 }"#);
            return None;
        }
    }
    let Some(x) = at.x else {
        faults.error(path.clone(), "`x` is missing").hint(r#"a place on a line is written { "x": 1.0 }"#);
        return None;
    };
    layout.place(x, &path.key("x"), what, faults).map(FramePlace::On)
}

fn on_frame(
    at: &At,
    frame: &FrameLayout,
    layout: &Layout,
    path: &JsonPath,
    what: &str,
    faults: &mut Faults,
) -> Option<FramePlace> {
    if !super::foreign::check_place(at, path, ON_A_FRAME, faults) {
        return None;
    }
    match (&at.joint, &at.member, at.x) {
        (Some(name), None, None) => {
            let found = frame.joints.iter().position(|j| j.name == *name);
            if found.is_none() {
                faults
                    .error(path.key("joint"), format!("there is no joint `{name}`"))
                    .hint(suggest(name, frame.joints.iter().map(|j| j.name.as_str())));
            }
            found.map(FramePlace::Joint)
        }
        (None, Some(name), x) => {
            let chain = member(name, frame, &path.key("member"), faults)?;
            let (from, to) = (frame.members[chain].joints, layout.lines[chain].length);
            let [from_name, to_name] = from.map(|j| frame.joints[j].name.as_str());
            let extent = format!("x runs from 0 at `{from_name}` to {} at `{to_name}`", tidy(to));
            let Some(x) = x else {
                faults.error(path.clone(), "`x` is missing").hint(extent);
                return None;
            };
            if !layout.lines[chain].holds(x) {
                faults
                    .error(path.key("x"), format!("{what} at x = {} is off the member `{name}`", tidy(x)))
                    .hint(extent);
                return None;
            }
            Some(FramePlace::On(layout.place_on(chain, x)))
        }
        (Some(_), Some(_), _) => {
            faults.error(path.clone(), "`joint` and `member` are both given").hint(ON_A_FRAME);
            None
        }
        (Some(_), None, Some(_)) => {
            faults.error(path.key("x"), "a joint is a point: `x` has no meaning here").hint(ON_A_FRAME);
            None
        }
        (None, None, Some(_)) => {
            faults.error(path.key("x"), "`x` alone names no place on a frame").hint(ON_A_FRAME);
            None
        }
        (None, None, None) => {
            faults.error(path.clone(), "no place is given").hint(ON_A_FRAME);
            None
        }
    }
}

/// The member of a name.
pub(super) fn member(name: &str, frame: &FrameLayout, path: &JsonPath, faults: &mut Faults) -> Option<usize> {
    let found = frame.members.iter().position(|m| m.name == name);
    if found.is_none() {
        faults
            .error(path.clone(), format!("there is no member `{name}`"))
            .hint(suggest(name, frame.members.iter().map(|m| m.name.as_str())));
    }
    found
}

impl Layout {
    /// What the user calls a place on a line: `x = 1.2`, or `the member `beam` at x = 1.2`.
    pub(super) fn words(&self, spot: FramePlace, x: f64) -> String {
        match (&self.frame, spot) {
            (Some(frame), FramePlace::Joint(joint)) => format!("joint `{}`", frame.joints[joint].name),
            (Some(frame), FramePlace::On(place)) => {
                format!("member `{}` at x = {}", frame.members[place.chain()].name, tidy(x))
            }
            (None, _) => format!("x = {}", tidy(x)),
        }
    }
}
