//! Keys of supports of a body.

use crate::case::Support;
use crate::diagnostic::{Faults, JsonPath, positive};
use crate::model::Material;

/// Adds a fault for every key of a support that does not fit the body, or another key.
pub(crate) fn check(support: &Support, material: &dyn Material, path: &JsonPath, faults: &mut Faults) {
    for (key, _) in [("only", support.only.is_some()), ("gap", support.gap.is_some())].iter().filter(|k| k.1)
    {
        faults
            .error(path.key(*key), format!("`{key}` is for the supports of beams"))
            .hint("supports of a body push and pull: leave it out");
    }
    let (points_turn, deflects) = (material.has("phi"), material.has("w"));
    let is_solid = material.has("uz");
    if !material.has("ux") {
        return check_across(support, path, faults);
    }
    let foreign = [
        (
            "w",
            support.w.is_some() && !deflects,
            match is_solid {
                true => "a solid is held by `ux`, `uy` and `uz`",
                false => "a body in the plane is held by `ux` and `uy`",
            },
        ),
        (
            "phi",
            support.phi.is_some() && !points_turn,
            match deflects {
                true => "a shell membrane is held by `ux`, `uy` and `w`",
                false if is_solid => {
                    "points do not turn: hold a face by `ux`, `uy` and `uz`, or list it under `rigid`"
                }
                false => "points do not turn: list the region under `rigid` and give its `phi`",
            },
        ),
        ("w_spring", support.w_spring.is_some(), "use `ux_spring` and `uy_spring`"),
        (
            "phi_spring",
            support.phi_spring.is_some(),
            if points_turn {
                "use `ux_spring` and `uy_spring`"
            } else {
                "points do not turn: use `ux_spring` and `uy_spring`"
            },
        ),
    ];
    for (key, _, hint) in foreign.iter().filter(|f| f.1) {
        faults.error(path.key(*key), format!("`{key}` is for the supports of beams")).hint(*hint);
    }
    let pairs = [
        ("ux", support.ux.as_ref(), "ux_spring", support.ux_spring),
        ("uy", support.uy.as_ref(), "uy_spring", support.uy_spring),
        ("uz", support.uz.as_ref(), "uz_spring", support.uz_spring),
    ];
    let holds = pairs.iter().any(|p| p.1.is_some() || p.3.is_some())
        || support.inclined.is_some()
        || support.phi.is_some()
        || support.w.is_some();
    if !holds && !foreign.iter().any(|f| f.1) {
        faults.error(path.clone(), "this support holds nothing").hint(match (points_turn, deflects) {
            _ if is_solid => {
                "give `ux`, `uy`, `uz` or `inclined`; or `ux_spring`, `uy_spring`, `uz_spring` for an elastic support"
            }
            (true, _) => {
                "give `ux`, `uy`, `phi` or `inclined`; or `ux_spring`, `uy_spring` for an elastic support"
            }
            (_, true) => {
                "give `ux`, `uy`, `w` or `inclined`; or `ux_spring`, `uy_spring` for an elastic support"
            }
            _ => "give `ux`, `uy` or `inclined`; or `ux_spring`, `uy_spring` for an elastic support",
        });
    }
    if let Some(inclined) = support.inclined.filter(|i| i.degrees.abs() > 360.0) {
        faults
            .error(
                path.key("inclined").key("degrees"),
                format!("`degrees` must be between -360 and 360, found {}", inclined.degrees),
            )
            .hint("it is the direction that is held, counter-clockwise from x");
    }
    for (key, value, spring, stiffness) in pairs {
        let Some(stiffness) = stiffness else { continue };
        positive(stiffness, spring, path.key(spring), faults);
        if value.is_some() {
            faults
                .error(path.key(spring), format!("`{key}` is prescribed, so `{spring}` would do nothing"))
                .hint("remove one of them");
        }
    }
}

/// The same where points move across the plane alone.
fn check_across(support: &Support, path: &JsonPath, faults: &mut Faults) {
    let foreign = [
        ("ux", support.ux.is_some()),
        ("uy", support.uy.is_some()),
        ("phi", support.phi.is_some()),
        ("inclined", support.inclined.is_some()),
        ("ux_spring", support.ux_spring.is_some()),
        ("uy_spring", support.uy_spring.is_some()),
        ("w_spring", support.w_spring.is_some()),
        ("phi_spring", support.phi_spring.is_some()),
    ];
    for (key, _) in foreign.iter().filter(|key| key.1) {
        faults
            .error(
                path.key(*key),
                format!("points move across the plane alone, and `{key}` does not hold that"),
            )
            .hint("give `w`");
    }
    if support.w.is_none() && !foreign.iter().any(|key| key.1) {
        faults.error(path.clone(), "this support holds nothing").hint("give `w`");
    }
}
