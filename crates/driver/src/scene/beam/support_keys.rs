//! Which keys of a support fit its body and each other.

use crate::case::{Amount, Support};
use crate::diagnostic::{Faults, JsonPath, positive};

/// A key of a support with the key that does its work on the other kind of body.
struct Misplaced {
    key: &'static str,
    given: bool,
    hint: &'static str,
}

/// Adds a fault for every key that does not fit.
pub(super) fn check(support: &Support, on_frame: bool, path: &JsonPath, faults: &mut Faults) {
    let misplaced = |key, given, hint| Misplaced { key, given, hint };
    let foreign = if on_frame {
        [
            misplaced("w", support.w.is_some(), "a frame is held by `ux`, `uy` or `inclined`, and `phi`"),
            misplaced("w_spring", support.w_spring.is_some(), "use `ux_spring` or `uy_spring`"),
            misplaced("", false, ""),
        ]
    } else {
        [
            misplaced("uy", support.uy.is_some(), "on a line use `w`, the deflection"),
            misplaced("uy_spring", support.uy_spring.is_some(), "on a line use `w_spring`"),
            misplaced(
                "inclined",
                support.inclined.is_some(),
                "on a line use `w` or `ux`; an inclined roller needs the body `frame`",
            ),
        ]
    };
    let kind = if on_frame { "line" } else { "frame" };
    for Misplaced { key, hint, .. } in foreign.iter().filter(|m| m.given) {
        faults.error(path.key(*key), format!("`{key}` is for the supports of a {kind}")).hint(*hint);
    }
    let pairs = [
        ("w", support.w.as_ref(), "w_spring", support.w_spring),
        ("ux", support.ux.as_ref(), "ux_spring", support.ux_spring),
        ("uy", support.uy.as_ref(), "uy_spring", support.uy_spring),
        ("phi", support.phi.as_ref(), "phi_spring", support.phi_spring),
    ];
    for (key, held, ..) in &pairs {
        if matches!(held, Some(Amount::Formula(_))) {
            faults
                .error(path.key(*key), "formulas are for bodies: a support of a beam is at one place")
                .hint("give its number");
        }
    }
    let nothing = pairs.iter().all(|(_, held, _, spring)| held.is_none() && spring.is_none());
    if nothing && support.inclined.is_none() {
        let hint = match on_frame {
            true => {
                "give `ux`, `uy`, `inclined` or `phi`; or `ux_spring`, `uy_spring`, `phi_spring` for an elastic support"
            }
            false => "give `w`, `phi`, or both; or `w_spring`, `phi_spring` for an elastic support",
        };
        faults.error(path.clone(), "this support holds nothing").hint(hint);
    }
    if let Some(inclined) = support.inclined.filter(|i| i.degrees.abs() > 360.0) {
        faults
            .error(
                path.key("inclined").key("degrees"),
                format!("`degrees` must be between -360 and 360, found {}", inclined.degrees),
            )
            .hint("it is the direction that is held, counter-clockwise from x");
    }
    for (held, value, spring, stiffness) in pairs {
        let Some(stiffness) = stiffness else { continue };
        positive(stiffness, spring, path.key(spring), faults);
        // A key that is not for this body has its fault already.
        if value.is_some() && held != if on_frame { "w" } else { "uy" } {
            faults
                .error(path.key(spring), format!("`{held}` is prescribed, so `{spring}` would do nothing"))
                .hint("remove one of them");
        }
    }
}
