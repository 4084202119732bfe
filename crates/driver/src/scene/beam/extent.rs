//! The part of a line or member that a load or a foundation covers.

use super::frame_place;
use super::place::{Layout, Place};
use crate::diagnostic::{Faults, JsonPath, tidy};

/// A part of a line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    /// Line.
    pub(super) chain: usize,
    /// Start, in the line's own coordinate.
    pub(super) from: f64,
    /// End.
    pub(super) to: f64,
}

/// What a case says of an extent.
pub(super) struct GivenExtent<'a> {
    /// Member, on a frame.
    pub(super) member: Option<&'a str>,
    /// Start.
    pub(super) from: Option<f64>,
    /// End.
    pub(super) to: Option<f64>,
}

/// What messages call the thing that has an extent, and their hints.
pub(super) struct Words {
    /// Its name, such as `load`.
    pub(super) what: &'static str,
    /// Hint where a line has a member.
    pub(super) on_a_line: &'static str,
    /// Hint where the line is not clear.
    pub(super) of_a_line: &'static str,
    /// Hint where the member is missing.
    pub(super) of_a_member: &'static str,
}

/// Finds an extent: all of the member or of the only line if nothing else is said.
pub(super) fn find(
    given: &GivenExtent,
    layout: &Layout,
    path: &JsonPath,
    words: &Words,
    faults: &mut Faults,
) -> Option<Extent> {
    let extent = match &layout.frame {
        Some(_) => on_member(given, layout, path, words, faults),
        None => on_line(given, layout, path, words, faults),
    }?;
    let Extent { from, to, .. } = extent;
    if from >= to {
        faults.error(path.key("to"), format!("`to` must be greater than `from`, found {from} to {to}"));
        return None;
    }
    Some(extent)
}

fn on_member(
    given: &GivenExtent,
    layout: &Layout,
    path: &JsonPath,
    words: &Words,
    faults: &mut Faults,
) -> Option<Extent> {
    let frame = layout.frame.as_ref()?;
    let Some(name) = given.member else {
        faults.error(path.clone(), "`member` is missing").hint(words.of_a_member);
        return None;
    };
    let chain = frame_place::member(name, frame, &path.key("member"), faults)?;
    let line = &layout.lines[chain];
    let (from, to) = (given.from.unwrap_or(0.0), given.to.unwrap_or(line.length));
    for (key, x) in [("from", from), ("to", to)] {
        if !line.holds(x) {
            let what = words.what;
            faults
                .error(path.key(key), format!("the end of the {what} at x = {x} is off the member `{name}`"))
                .hint(format!("x runs from 0 to {} on this member", tidy(line.length)));
            return None;
        }
    }
    Some(Extent { chain, from, to })
}

fn on_line(
    given: &GivenExtent,
    layout: &Layout,
    path: &JsonPath,
    words: &Words,
    faults: &mut Faults,
) -> Option<Extent> {
    if given.member.is_some() {
        faults.error(path.key("member"), "`member` is for frames").hint(words.on_a_line);
        return None;
    }
    if layout.lines.len() > 1 && (given.from.is_none() || given.to.is_none()) {
        faults
            .error(path.clone(), "`from` and `to` are needed where the body has several lines")
            .hint(words.of_a_line);
        return None;
    }
    let (from, to) = (given.from.unwrap_or(layout.lines[0].from), given.to.unwrap_or(layout.lines[0].to()));
    let what = words.what;
    let [start, end] = [("from", from), ("to", to)]
        .map(|(key, x)| layout.place(x, &path.key(key), &format!("the end of the {what}"), faults));
    let (chain, other) = (start.as_ref().map(Place::chain)?, end.as_ref().map(Place::chain)?);
    if chain != other {
        faults
            .error(path.clone(), format!("a {what} from x = {from} to {to} spans a gap between lines"))
            .hint(format!("give one {what} per line"));
        return None;
    }
    Some(Extent { chain, from, to })
}
