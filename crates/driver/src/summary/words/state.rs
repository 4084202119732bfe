//! A state in words: its extremes, and where they are.

use super::{Listing, number};
use crate::summary::{Located, StateSummary};

/// Smallest and largest values of the fields.
pub fn extremes(state: &StateSummary) -> Listing {
    let rows: Vec<Vec<String>> = state
        .extremes
        .iter()
        .map(|(field, e)| {
            // What is rounding beside the largest field of its kind, such as `stress`, reads as zero.
            let size = state.extremes.iter().filter(|other| kind(other.0) == kind(field));
            let size =
                size.map(|(_, e)| e.smallest.value.abs().max(e.largest.value.abs())).fold(0.0, f64::max);
            let clean = |value: f64| if value.abs() < 1e-11 * size { 0.0 } else { value };
            let cells = [&e.smallest, &e.largest].map(|l| [number(clean(l.value)), place(l)]);
            let name = if e.unit.is_empty() { (*field).to_string() } else { format!("{field} [{}]", e.unit) };
            std::iter::once(name).chain(cells.into_iter().flatten()).collect()
        })
        .collect();
    let on_lines = state.extremes.values().all(|e| e.smallest.member.is_none() && e.smallest.y.is_none());
    let at = if on_lines { "at x" } else { "at" };
    Listing::whole(&["field", "smallest", at, "largest", at], rows)
}

/// Stresses are of one kind, and so are strains.
pub(crate) fn kind(field: &str) -> &str {
    field.split('_').next().unwrap_or(field)
}

/// Where a value is: `beam 1.5` on a frame, `(1.5, 2)` in the plane.
pub(crate) fn place(located: &Located) -> String {
    let position = position(located.x, located.y, located.z);
    match &located.member {
        Some(member) => format!("{member} {position}"),
        None => position,
    }
}

/// A position on a line, in the plane, or in space.
pub(crate) fn position(x: f64, y: Option<f64>, z: Option<f64>) -> String {
    match (y, z) {
        (Some(y), Some(z)) => format!("({}, {}, {})", number(x), number(y), number(z)),
        (Some(y), None) => format!("({}, {})", number(x), number(y)),
        _ => number(x),
    }
}
