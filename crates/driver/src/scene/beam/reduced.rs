//! Probes of what is made of a field along lines.

use super::probes::{self, ProbeSite, ProbedBeam};
use super::{foreign, frame_place};
use crate::case::{FieldName, Probe, Reduction};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::words;
use std::ops::Range;

/// The lines that a probe looks at which makes `of` of their values.
pub(super) fn resolve(
    probe: &Probe,
    of: Reduction,
    context: &ProbedBeam,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<ProbeSite> {
    let field = probe.field;
    let (lines, place) = lines(probe, context, path, faults)?;
    if !probes::fits_body(field, context, &path.key("field"), faults) {
        return None;
    }
    if field.is_reaction() {
        let there_are = FieldName::of_beam(context.layout.frame.is_some(), context.has_axial);
        faults
            .error(
                path.key("of"),
                format!("`{}` is no field of all points, so there is nothing to make of it", field.name()),
            )
            .hint(format!("leave `of` out, or take another field: {}", words::there_are(there_are)));
        return None;
    }
    let mut sections = context.sections[lines.clone()].iter();
    let knows = sections.all(|section| probes::needs_section(field, section, context.model, path, faults));
    knows.then_some(ProbeSite::Lines { of, lines, place })
}

/// All lines, or those of a member, and what the user calls them.
fn lines(
    probe: &Probe,
    context: &ProbedBeam,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(Range<usize>, String)> {
    let (at, layout) = (&probe.at, context.layout);
    let place = path.key("at");
    if at.is_nowhere() {
        let body = if layout.frame.is_some() { "the frame" } else { "the beam" };
        return Some((0..layout.lines.len(), body.into()));
    }
    let hint = match &layout.frame {
        Some(_) => r#"write { "member": "beam" } for a member, or leave `at` out for the whole frame"#,
        None => "leave `at` out for the whole beam, or `of` for one point",
    };
    if !foreign::check_place(at, &place, hint, faults) {
        return None;
    }
    match (&layout.frame, &at.member) {
        (Some(frame), Some(name)) if at.x.is_none() && at.joint.is_none() => {
            let k = frame_place::member(name, frame, &place.key("member"), faults)?;
            Some((k..k + 1, format!("member `{name}`")))
        }
        (None, Some(_)) => {
            faults.error(place.key("member"), "`member` is for frames").hint(hint);
            None
        }
        _ => {
            let whole = if layout.frame.is_some() { "a member or the whole frame" } else { "the whole beam" };
            faults.error(path.key("of"), format!("`of` is for {whole}, and this is a point")).hint(hint);
            None
        }
    }
}
