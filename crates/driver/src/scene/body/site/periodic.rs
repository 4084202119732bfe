//! Opposite sides of a body that are joined.

use super::symmetry::{Sides, Symmetry, line_on};
use crate::case::{Case, Periodic};
use crate::diagnostic::{Faults, JsonPath, root};
use peristat_assembly::body::{Face, SIDES, SquareLattice};

/// Adds the joined sides of the case to its mirrors.
pub(crate) fn join(
    case: &Case,
    sides: Option<Sides>,
    lattice: Option<&SquareLattice>,
    symmetry: &mut Symmetry,
    faults: &mut Faults,
) {
    if !case.periodic.is_empty() && !case.cracks.is_empty() {
        faults
            .error(root("periodic"), "`periodic` and `cracks` do not go together")
            .hint("model a body that is so large that its sides do not matter, or lines of `symmetry`");
    }
    for (k, given) in case.periodic.iter().enumerate() {
        let path = root("periodic").index(k);
        let axis = given.along.number();
        let name = ["x", "y", "z"][axis];
        let (Some(sides), Some(lattice)) = (sides, lattice) else {
            faults
                .error(path, "joined sides need a body that fills a lattice: `rectangle` or `outline`")
                .hint("take one of these");
            continue;
        };
        if lattice.is_turned() {
            let message =
                "joined sides need a lattice whose rows run along x, and those of this one are turned";
            faults.error(path, message).hint("model a body without `periodic`");
            continue;
        }
        if axis > 1 && !symmetry.is_solid {
            faults
                .error(path.key("along"), "a body in the plane has no sides along z")
                .hint("join the sides along x or y");
            continue;
        }
        if std::mem::replace(&mut symmetry.mirrors.joined[axis], true) {
            faults.error(path, format!("the sides along {name} are joined twice"));
            continue;
        }
        symmetry.mirrors.stretches[axis] = given.stretches;
        check_force(case, given, &path, faults);
        for side in [2 * axis, 2 * axis + 1] {
            let called = SIDES[side];
            if symmetry.at[side].is_some() {
                faults
                    .error(path.clone(), format!("the {called} side is a mirror by `symmetry`"))
                    .hint("remove one of both");
                continue;
            }
            let Some((edge, at)) = sides.whole(side) else {
                let message = match symmetry.is_solid {
                    true => format!("the body is not flat on its {called} side"),
                    false => format!("the body has no straight edge all along its {called} side"),
                };
                faults
                    .error(path.clone(), message)
                    .hint("joined sides are whole sides of the box around the body");
                continue;
            };
            if symmetry.is_solid {
                symmetry.goes_on.push(Face { axis, is_high: side % 2 == 1, at });
            }
            symmetry.joined.push(edge);
            symmetry.mirrors.set_line(side, line_on(lattice, sides, (side, at), &path, faults));
        }
    }
}

/// Faults of a force along joined sides.
fn check_force(case: &Case, given: &Periodic, path: &JsonPath, faults: &mut Faults) {
    if given.force.is_none() {
        return;
    }
    if !given.stretches {
        faults
            .error(path.key("force"), "a body that keeps its length takes any force along it")
            .hint("add \"stretches\": true");
    }
    if !case.load_cases.is_empty() {
        faults
            .error(path.key("force"), "`force` acts with `loads`, and there are `load_cases`")
            .hint("solve the load cases one by one");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use peristat_assembly::body::Outline;
    use serde_json::json;

    fn joined(periodic: &serde_json::Value, symmetry: &mut Symmetry) -> Faults {
        let case = json!({
            "title": "a", "model": { "bond_plane": { "youngs_modulus": 1.0, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [4.0, 2.0], "spacing": 1.0 } }, "periodic": periodic,
        });
        let case: Case = serde_json::from_value(case).unwrap();
        let outline = Outline::rectangle([0.0; 2], [4.0, 2.0]).unwrap();
        let lattice = outline.fill(1.0).unwrap();
        let mut faults = Faults::default();
        join(&case, Some(Sides::Edges(&outline)), Some(&lattice), symmetry, &mut faults);
        faults
    }

    #[test]
    fn both_sides_are_joined() {
        let mut symmetry = Symmetry::default();
        assert!(!joined(&json!([{ "along": "y" }]), &mut symmetry).has_errors());
        assert_eq!(symmetry.mirrors.joined, [false, true, false]);
        assert_eq!(symmetry.mirrors.lines, [[None; 2], [Some(0), Some(2)], [None; 2]]);
        assert!(symmetry.joins("bottom") && symmetry.joins("top") && !symmetry.joins("left"));
    }

    #[test]
    fn no_side_is_joined_twice_or_a_mirror() {
        assert!(joined(&json!([{ "along": "x" }, { "along": "x" }]), &mut Symmetry::default()).has_errors());
        let mut symmetry = Symmetry { at: [None, Some(4.0), None, None, None, None], ..Symmetry::default() };
        assert!(joined(&json!([{ "along": "x" }]), &mut symmetry).has_errors());
    }
}
