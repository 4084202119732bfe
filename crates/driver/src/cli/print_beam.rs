//! Beams and frames as text: the model, section forces of members, reactions.

use super::print::{number, table};
use crate::case::Units;
use crate::run::beam::{JointReaction, MemberForces, Reaction};
use crate::summary::{BeamForces, BeamSummary};
use std::fmt::Write;

/// Tells model, horizon and section, each as a key and a text.
pub(super) fn model(m: &BeamSummary, units: Units, line: &mut impl FnMut(&str, String)) {
    let length = units.length();
    let ratios: Vec<String> = m
        .horizon_ratio
        .iter()
        .zip(m.spacing.iter().zip(&m.graded))
        .map(|(r, (h, graded))| match graded {
            true => format!("{} neighbours of a graded grid", number(*r)),
            false => format!("{} spacings = {} {length}", number(*r), number(r * h)),
        })
        .collect();
    // Members of a frame often share a grid; all of them would be a long list.
    let ratios = distinct(ratios);
    line("model", format!("{}, bond law {}, ends {}", m.name, m.bond_law, m.end_treatment));
    line("horizon", ratios.join("; "));
    line("section", section(m, length));
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
fn section(m: &BeamSummary, length: &str) -> String {
    let known = [
        m.area.map(|a| format!("A = {} {length}²", number(a))),
        m.second_moment.map(|i| format!("I = {} {length}⁴", number(i))),
        m.kappa.map(|k| format!("κ = {}", number(k))),
        Some(format!("EI = {} N {length}²", number(m.bending_stiffness))),
        Some(format!("κGA = {} N", number(m.shear_stiffness))),
        m.axial_stiffness.map(|a| format!("EA = {} N", number(a))),
    ];
    let known: Vec<String> = known.into_iter().flatten().collect();
    let member = m.member.as_ref().map_or(String::new(), |name| format!(" of member `{name}`"));
    known.join(", ") + &member + if m.varies { " at the start" } else { "" }
}

/// Smallest and largest section forces of members, and forces of supports.
pub(super) fn forces(out: &mut String, beam: &BeamForces) {
    members(out, beam);
    reactions(out, beam);
}

/// Smallest and largest section forces of every member of a frame.
fn members(out: &mut String, beam: &BeamForces) {
    // What is rounding beside the forces of the whole frame reads as zero.
    let largest = |of: fn(&MemberForces) -> [f64; 2]| {
        beam.members.iter().flat_map(of).fold(0.0, |a: f64, v| a.max(v.abs()))
    };
    let force = largest(|m| m.axial).max(largest(|m| m.shear));
    let scales = [force, force, largest(|m| m.moment)];
    let row = |m: &MemberForces| {
        let mut cells = vec![m.name.clone()];
        for (range, scale) in [m.axial, m.shear, m.moment].into_iter().zip(scales) {
            cells.extend(range.map(|v| number(if v.abs() < 1e-11 * scale { 0.0 } else { v })));
        }
        cells
    };
    let rows: Vec<Vec<String>> = beam.members.iter().take(MOST_ROWS).map(row).collect();
    if !rows.is_empty() {
        let header = ["member", "N smallest", "largest", "V smallest", "largest", "M smallest", "largest"];
        let _ = write!(out, "\n{}", table(&header, &rows));
        more(out, beam.members.len(), "members");
    }
}

/// Rows that a table of a frame has, at most.
const MOST_ROWS: usize = 40;

/// Says where the rest of a long table is.
fn more(out: &mut String, count: usize, what: &str) {
    if count > MOST_ROWS {
        let _ = writeln!(out, "\n  {} {what} more are in summary.json", count - MOST_ROWS);
    }
}

/// Forces of the supports.
fn reactions(out: &mut String, beam: &BeamForces) {
    let has_axial = beam.reactions.iter().any(|r| r.axial.is_some());
    let row = |r: &Reaction| {
        let mut cells = vec![format!("x = {}", number(r.x)), number(r.force), number(r.moment)];
        cells.extend(has_axial.then(|| r.axial.map_or(String::new(), number)));
        cells
    };
    let rows: Vec<Vec<String>> = beam.reactions.iter().map(row).collect();
    if !rows.is_empty() {
        let header = ["support", "force", "moment", "along x"];
        let _ = write!(out, "\n{}", table(&header[..if has_axial { 4 } else { 3 }], &rows));
    }
    joint_reactions(out, beam);
}

fn joint_reactions(out: &mut String, beam: &BeamForces) {
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
    if !rows.is_empty() {
        let header = ["support", "force x", "force y", "moment", "inclined"];
        let _ = write!(out, "\n{}", table(&header[..if inclined { 5 } else { 4 }], &rows));
        more(out, all.len(), "supports");
    }
}
