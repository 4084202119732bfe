//! Beams and frames in words: the model, section forces of members, reactions.

use super::{Fact, Listing, MOST_ROWS, number};
use crate::case::Units;
use crate::run::beam::{JointReaction, MemberForces, OneWayCount, Reaction};
use crate::summary::{BeamForces, BeamSummary};

/// Model, horizon and section.
pub(super) fn model(m: &BeamSummary, units: Units) -> Vec<Fact> {
    let length = units.length();
    let ratios: Vec<String> = m
        .horizon_ratio
        .iter()
        .zip(m.spacing.iter().zip(&m.graded))
        .map(|(r, (h, graded))| match graded {
            true => format!("{} neighbours of a graded grid", number(*r)),
            false => format!("{} spacings = {}", number(*r), units.quantity(&number(r * h), length)),
        })
        .collect();
    // Members of a frame often share a grid; all of them would be a long list.
    let ratios = distinct(ratios);
    vec![
        ("model".into(), format!("{}, bond law {}, ends {}", m.name, m.bond_law, m.end_treatment)),
        ("horizon".into(), ratios.join("; ")),
        ("section".into(), section(m, units)),
    ]
}

/// Every text once, and of many only the first ones.
fn distinct(all: Vec<String>) -> Vec<String> {
    const MOST: usize = 4;
    let mut kept: Vec<String> = Vec::new();
    for text in all {
        if !kept.contains(&text) {
            kept.push(text);
        }
    }
    if kept.len() > MOST {
        let rest = kept.len() - MOST;
        kept.truncate(MOST);
        kept.push(format!("{rest} more"));
    }
    kept
}

/// What is known of the section, that at the start where it varies.
fn section(m: &BeamSummary, units: Units) -> String {
    let length = units.length();
    let with =
        |name: &str, value: f64, unit: String| format!("{name} = {}", units.quantity(&number(value), &unit));
    let known = [
        m.area.map(|a| with("A", a, format!("{length}²"))),
        m.second_moment.map(|i| with("I", i, format!("{length}⁴"))),
        m.kappa.map(|k| format!("κ = {}", number(k))),
        Some(with("EI", m.bending_stiffness, format!("N {length}²"))),
        Some(with("κGA", m.shear_stiffness, "N".into())),
        m.axial_stiffness.map(|a| with("EA", a, "N".into())),
    ];
    let known: Vec<String> = known.into_iter().flatten().collect();
    let member = m.member.as_ref().map_or(String::new(), |name| format!(" of member `{name}`"));
    known.join(", ") + &member + if m.varies { " at the start" } else { "" }
}

/// Smallest and largest section forces of members, forces of supports, and which of them act.
pub(super) fn forces(beam: &BeamForces, units: Units) -> Vec<Listing> {
    let all = [members(beam, units), reactions(beam, units), joint_reactions(beam, units), one_way(beam)];
    all.into_iter().flatten().collect()
}

/// Smallest and largest section forces of every member of a frame.
fn members(beam: &BeamForces, units: Units) -> Option<Listing> {
    // What is rounding beside the forces of the whole frame reads as zero.
    let largest = |of: fn(&MemberForces) -> [f64; 2]| {
        beam.members.iter().flat_map(of).fold(0.0, |a: f64, v| a.max(v.abs()))
    };
    let size = largest(|m| m.axial).max(largest(|m| m.shear));
    let scales = [size, size, largest(|m| m.moment)];
    let row = |m: &MemberForces| {
        let mut cells = vec![m.name.clone()];
        for (range, scale) in [m.axial, m.shear, m.moment].into_iter().zip(scales) {
            cells.extend(range.map(|v| number(if v.abs() < 1e-11 * scale { 0.0 } else { v })));
        }
        cells
    };
    let rows: Vec<Vec<String>> = beam.members.iter().take(MOST_ROWS).map(row).collect();
    let (force, moment) = (|name| units.label(name, units.force()), |name| units.label(name, units.moment()));
    let [n, v, m] = [force("N smallest"), force("V smallest"), moment("M smallest")];
    let header = ["member", &n, "largest", &v, "largest", &m, "largest"];
    Listing::new(&header, rows, beam.members.len(), "members")
}

/// Forces of the supports of lines.
fn reactions(beam: &BeamForces, units: Units) -> Option<Listing> {
    let has_axial = beam.reactions.iter().any(|r| r.axial.is_some());
    let row = |r: &Reaction| {
        let mut cells = vec![format!("x = {}", number(r.x)), number(r.force), number(r.moment)];
        cells.extend(has_axial.then(|| r.axial.map_or(String::new(), number)));
        cells
    };
    let rows: Vec<Vec<String>> = beam.reactions.iter().map(row).collect();
    let (force, along) = (units.label("force", units.force()), units.label("along x", units.force()));
    let header = ["support", &force, &units.label("moment", units.moment()), &along];
    Listing::new(&header[..if has_axial { 4 } else { 3 }], rows, beam.reactions.len(), "supports")
}

/// Forces of the supports of a frame.
fn joint_reactions(beam: &BeamForces, units: Units) -> Option<Listing> {
    let all = &beam.joint_reactions;
    let size = all.iter().flat_map(|r| [r.force_x, r.force_y]).fold(0.0, |a: f64, f| a.max(f.abs()));
    let force = |value: f64| number(if value.abs() < 1e-11 * size { 0.0 } else { value });
    let inclined = all.iter().any(|r| r.inclined.is_some());
    let row = |r: &JointReaction| {
        let mut cells = vec![r.place.clone(), force(r.force_x), force(r.force_y), number(r.moment)];
        cells.extend(inclined.then(|| r.inclined.map_or(String::new(), force)));
        cells
    };
    let rows: Vec<Vec<String>> = all.iter().take(MOST_ROWS).map(row).collect();
    let [x, y, inclined_force] =
        ["force x", "force y", "inclined"].map(|name| units.label(name, units.force()));
    let header = ["support", &x, &y, &units.label("moment", units.moment()), &inclined_force];
    Listing::new(&header[..if inclined { 5 } else { 4 }], rows, all.len(), "supports")
}

/// How much of what acts one way does, and how well it is known.
fn one_way(beam: &BeamForces) -> Option<Listing> {
    let parts = &beam.one_way.as_ref()?.parts;
    let row = |part: &OneWayCount| {
        let counts = [part.act, part.all - part.act].map(|count| count.to_string());
        let [act, rest] = counts;
        let errors = [part.wrong_force, part.penetration].map(|error| format!("{error:.1e}"));
        [vec![part.kind.words().into(), act, rest], errors.to_vec()].concat()
    };
    let rows: Vec<Vec<String>> = parts.iter().map(row).collect();
    Listing::new(&["one way", "act", "do not", "wrong force", "penetration"], rows, parts.len(), "kinds")
}
