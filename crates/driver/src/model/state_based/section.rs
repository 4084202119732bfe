//! The section of a body of revolution and its axis.

use super::super::Asked;
use crate::diagnostic::{Faults, root, tidy};
use peristat_assembly::body::{Outline, SquareLattice};

/// Whether the section of a body of revolution touches its axis; `None` if there is no such body.
pub(super) fn touches_axis(
    asked: &Asked,
    (outline, lattice): (Option<&Outline>, Option<&SquareLattice>),
    faults: &mut Faults,
) -> Option<bool> {
    for (at, side) in asked.symmetry.iter().enumerate().filter(|s| matches!(s.1.as_str(), "left" | "right")) {
        let hint = match side.as_str() {
            "left" => "a body that begins at x = 0 has its axis there by itself",
            _ => "hold `ux` of the edge: a smooth rigid wall",
        };
        faults
            .error(
                root("symmetry").index(at),
                format!(
                    "the {side} side of a body of revolution is no mirror: what is behind it has other radii"
                ),
            )
            .hint(hint);
    }
    let joined = asked.joined.iter().position(|sides| sides.axis == 0);
    if let Some(at) = joined {
        faults
            .error(
                root("periodic").index(at).key("along"),
                "the sides along x of a body of revolution are its inside and its outside",
            )
            .hint("join its bottom and its top: \"along\": \"y\"");
        return None;
    }
    let (Some(outline), Some(lattice)) = (outline, lattice) else { return Some(false) };
    let left = outline.bounds()[0][0];
    let slack = 1e-6 * lattice.spacing();
    if left < -slack {
        faults
            .error(
                root("body"),
                format!("x is the radius of a body of revolution, and this one reaches to {}", tidy(left)),
            )
            .hint("draw the half of the section with x >= 0");
        return None;
    }
    let first = lattice.corner()[0] + f64::from(lattice.columns().start) * lattice.spacing();
    if left <= slack && first > slack {
        faults
            .error(root("body"), "holes take away all of the body that touches its axis")
            .hint(format!("draw the body from x = {} on", tidy(first)));
        return None;
    }
    Some(left <= slack)
}
