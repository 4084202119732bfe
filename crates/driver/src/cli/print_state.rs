//! A state as text: extremes, members, reactions, certificate.

use super::print::{number, table};
use crate::run::{JointReaction, MemberForces, Reaction};
use crate::summary::{Located, StateSummary};
use std::fmt::Write;

/// A residual above this leaves section forces fewer digits than engineers expect.
const FEW_DIGITS: f64 = 1e-6;

/// Smallest and largest values of the fields, and of the members of a frame.
pub(super) fn extremes(out: &mut String, state: &StateSummary) {
    let rows: Vec<Vec<String>> = state
        .extremes
        .iter()
        .map(|(field, e)| {
            // What is rounding beside the other extreme reads as zero.
            let size = e.smallest.value.abs().max(e.largest.value.abs());
            let clean = |value: f64| if value.abs() < 1e-11 * size { 0.0 } else { value };
            let cells = [&e.smallest, &e.largest].map(|l| [number(clean(l.value)), place(l)]);
            std::iter::once((*field).to_string()).chain(cells.into_iter().flatten()).collect()
        })
        .collect();
    let at = if state.members.is_empty() { "at x" } else { "at" };
    out.push_str(&table(&["field", "smallest", at, "largest", at], &rows));
    members(out, state);
}

/// Where a value is: `beam 1.5` on a frame.
pub(super) fn place(located: &Located) -> String {
    match &located.member {
        Some(member) => format!("{member} {}", number(located.x)),
        None => number(located.x),
    }
}

/// Smallest and largest section forces of every member of a frame.
fn members(out: &mut String, state: &StateSummary) {
    // What is rounding beside the forces of the whole frame reads as zero.
    let largest = |of: fn(&MemberForces) -> [f64; 2]| {
        state.members.iter().flat_map(of).fold(0.0, |a: f64, v| a.max(v.abs()))
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
    let rows: Vec<Vec<String>> = state.members.iter().take(MOST_ROWS).map(row).collect();
    if !rows.is_empty() {
        let header = ["member", "N smallest", "largest", "V smallest", "largest", "M smallest", "largest"];
        let _ = write!(out, "\n{}", table(&header, &rows));
        more(out, state.members.len(), "members");
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
pub(super) fn reactions(out: &mut String, state: &StateSummary) {
    let has_axial = state.reactions.iter().any(|r| r.axial.is_some());
    let row = |r: &Reaction| {
        let mut cells = vec![format!("x = {}", number(r.x)), number(r.force), number(r.moment)];
        cells.extend(has_axial.then(|| r.axial.map_or(String::new(), number)));
        cells
    };
    let rows: Vec<Vec<String>> = state.reactions.iter().map(row).collect();
    if !rows.is_empty() {
        let header = ["support", "force", "moment", "along x"];
        let _ = write!(out, "\n{}", table(&header[..if has_axial { 4 } else { 3 }], &rows));
    }
    joint_reactions(out, state);
}

fn joint_reactions(out: &mut String, state: &StateSummary) {
    let all = &state.joint_reactions;
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

/// What the result is certified with.
pub(super) fn certificate(out: &mut String, state: &StateSummary) {
    let c = &state.certificate;
    let balance: Vec<String> = c.balance.iter().map(|b| format!("{} {:.1e}", b.motion, b.relative)).collect();
    let _ = writeln!(
        out,
        "\n  certificate: {}, next correction {:.1e}, residual {:.1e}, balance of {}, energy {:.1e}",
        if c.converged { "converged" } else { "NOT CONVERGED" },
        c.next_correction,
        c.residual,
        balance.join(" and "),
        c.energy_balance
    );
    if c.converged && c.residual > FEW_DIGITS {
        let _ = writeln!(
            out,
            "  note: displacements are rounded, and end forces are their differences: section forces and reactions may be off by {:.0e} of the largest",
            c.residual
        );
    }
}
