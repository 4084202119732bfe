//! Bodies between mirrors and joined sides: what goes through those is reported, or balances itself.

use super::asked::Asked;
use super::bodies;
use super::hold::Hold;
use super::medium::Medium;
use super::{Course, Loaded, Sharing, TRACTIONS, is_axis, origin, traction};
use crate::stress::row::Row;
use serde_json::{Value, json};

/// Sides that are mirrors or joined, and what is held beside them.
struct Repetition {
    name: &'static str,
    symmetry: &'static [&'static str],
    /// Directions in which sides are joined, and whether the body becomes longer.
    periodic: &'static [(&'static str, bool)],
    /// Motions that are left, to be held at a point.
    held: &'static [&'static str],
}

/// Error of the force through a mirror across the axis of a solid body under one stress, whose points beside the axis have other
/// volumes in the energy; measured 0.0024.
const SOLID: f64 = 0.0025;

const REPETITIONS: [Repetition; 8] = [
    Repetition { name: "a mirror on the left", symmetry: &["left"], periodic: &[], held: &["uy"] },
    Repetition { name: "a mirror below", symmetry: &["bottom"], periodic: &[], held: &["ux"] },
    Repetition {
        name: "mirrors on the left and below",
        symmetry: &["left", "bottom"],
        periodic: &[],
        held: &[],
    },
    Repetition {
        name: "mirrors below and above",
        symmetry: &["bottom", "top"],
        periodic: &[],
        held: &["ux"],
    },
    Repetition { name: "joined along x", symmetry: &[], periodic: &[("x", false)], held: &["ux", "uy"] },
    Repetition { name: "joined along y", symmetry: &[], periodic: &[("y", false)], held: &["ux", "uy"] },
    Repetition {
        name: "joined along y, stretching",
        symmetry: &[],
        periodic: &[("y", true)],
        held: &["ux", "uy"],
    },
    Repetition {
        name: "a mirror below, joined along x",
        symmetry: &["bottom"],
        periodic: &[("x", false)],
        held: &["ux"],
    },
];

impl Repetition {
    /// Whether an edge is loaded: it is neither a mirror nor joined.
    fn leaves(&self, edge: &str) -> bool {
        let across = if edge == "left" || edge == "right" { "x" } else { "y" };
        !self.symmetry.contains(&edge) && self.periodic.iter().all(|p| p.0 != across)
    }

    /// Whether a body of revolution can have it: its mirrors and joints are along the axis.
    fn suits(&self, medium: &Medium) -> bool {
        let is_axial = !self.symmetry.contains(&"left") && self.periodic.iter().all(|p| p.0 == "y");
        (!medium.is_revolved() || is_axial) && medium.is_symmetric && !medium.is_turned
    }

    fn hold(&self, medium: &Medium, at: [f64; 2]) -> Hold {
        let held = self.held.iter().filter(|h| !(medium.is_revolved() && **h == "ux"));
        let mut support: Value =
            held.map(|h| (h.to_string(), json!(0.0))).collect::<serde_json::Map<_, _>>().into();
        let is_held = support.as_object().is_some_and(|keys| !keys.is_empty());
        support["at"] = json!({ "x": at[0], "y": at[1] });
        let supports = if is_held { vec![support] } else { Vec::new() };
        Hold { supports, places: vec![at], tells_moment: false, ..Hold::points(self.name, []) }
    }
}

pub(super) fn rows(medium: &Medium) -> Vec<Row> {
    let body = bodies::rectangle(origin(medium));
    let mut rows = Vec::new();
    for repetition in REPETITIONS.iter().filter(|r| r.suits(medium)) {
        let hold = repetition.hold(medium, [body.from[0] + 3.5, body.from[1] + 2.5]);
        for edge in body.edges.iter().filter(|e| repetition.leaves(e.name) && !is_axis(medium, e)) {
            for t in TRACTIONS {
                // Each of them in two of the sharings, by turns.
                let turn = rows.len();
                for sharing in [Sharing::Usual, [Sharing::Lumped, Sharing::Depth(5.0)][turn / 2 % 2]] {
                    let (load, asked) = traction(edge, t, sharing, medium.across);
                    let what = format!("{}, {t:?}, {sharing:?}", edge.name);
                    let loaded = Loaded { medium, body: &body, hold: &hold };
                    let sweep = "asked and applied: between mirrors and joined sides";
                    let mut row = loaded.row(sweep, &what, json!([load]), &asked);
                    row.case["symmetry"] = json!(repetition.symmetry);
                    let joined = |p: &(&str, bool)| json!({ "along": p.0, "stretches": p.1 });
                    row.case["periodic"] = repetition.periodic.iter().map(joined).collect();
                    leave_inside(&mut row, repetition, &asked);
                    let is_one_stress = matches!(t.0, Course::Uniform | Course::Total | Course::Pressure);
                    let is_solid = is_one_stress && body.edges.iter().any(|e| is_axis(medium, e));
                    row.resultant.iter_mut().filter(|_| is_solid).for_each(|r| r.bound = SOLID);
                    rows.push(row);
                }
            }
        }
    }
    rows
}

/// What a consistent traction does through a mirror across which it asks for nothing is inside the body: a mirrored half has as
/// much of it as the whole.
fn leave_inside(row: &mut Row, repetition: &Repetition, asked: &Asked) {
    let across = [["left", "right"], ["bottom", "top"]];
    let is_mirrored = |axis: usize| repetition.symmetry.iter().any(|side| across[axis].contains(side));
    let Some(resultant) = &mut row.resultant else { return };
    for axis in (0..2).filter(|&axis| is_mirrored(axis)) {
        if asked.force[axis].abs() <= 1e-10 * asked.size {
            resultant.force[axis] = None;
        }
    }
}
