//! Which keys of a support fit its body and each other.

use crate::case::{Amount, Support};
use crate::diagnostic::{Faults, JsonPath, positive, tidy};

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
    let held = pairs.iter().filter(|pair| pair.1.is_some()).count() + usize::from(support.inclined.is_some());
    let sprung = pairs.iter().filter(|pair| pair.3.is_some()).count();
    check_one_way(support, [held, sprung], path, faults);
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

/// What a support that acts one way must be, with the numbers of motions that it prescribes and that springs of it resist.
fn check_one_way(support: &Support, [held, sprung]: [usize; 2], path: &JsonPath, faults: &mut Faults) {
    if support.only.is_some() && held + sprung > 1 {
        faults
            .error(
                path.key("only"),
                format!("a support that acts one way holds one motion, and this one holds {}", held + sprung),
            )
            .hint("give each motion a support of its own at the same place");
    }
    let Some(gap) = support.gap else { return };
    if support.only.is_none() {
        faults
            .error(path.key("gap"), "`gap` is for a support that acts one way")
            .hint(r#"give `only`, the sign of its reaction: `"only": "positive"` pushes along w, x or y"#);
    }
    if !(gap >= 0.0 && gap.is_finite()) {
        faults
            .error(path.key("gap"), format!("`gap` must not be negative, found {}", tidy(gap)))
            .hint("a support that is set too high prescribes its motion: `\"w\": 0.001` with `only`");
    }
    if sprung > 0 {
        faults.error(path.key("gap"), "a spring has no `gap`").hint(
            "prescribe the motion in place of the spring, or put a short member of the same stiffness before the stop",
        );
    }
}
