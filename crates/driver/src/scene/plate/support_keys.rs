//! Keys of supports of a plate.

use crate::case::Support;
use crate::diagnostic::{Faults, JsonPath, positive};

/// Adds a fault for every key of a support that does not fit a plate, or another key.
pub(super) fn check(support: &Support, path: &JsonPath, faults: &mut Faults) {
    let foreign = [
        ("ux", support.ux.is_some()),
        ("uy", support.uy.is_some()),
        ("uz", support.uz.is_some()),
        ("phi", support.phi.is_some()),
        ("inclined", support.inclined.is_some()),
        ("ux_spring", support.ux_spring.is_some()),
        ("uy_spring", support.uy_spring.is_some()),
        ("uz_spring", support.uz_spring.is_some()),
        ("phi_spring", support.phi_spring.is_some()),
        ("only", support.only.is_some()),
        ("gap", support.gap.is_some()),
    ];
    for (key, _) in foreign.iter().filter(|key| key.1) {
        faults
            .error(path.key(*key), format!("`{key}` does not hold a plate in bending"))
            .hint("give `w`, `phi_n`, `phi_t`, `phi_x` or `phi_y`; or `w_spring` or `phi_n_spring` for an elastic support");
    }
    let Support { w, phi_x, phi_y, phi_n, phi_t, w_spring, phi_n_spring, .. } = support;
    let holds = [w, phi_x, phi_y, phi_n, phi_t].iter().any(|given| given.is_some())
        || w_spring.is_some()
        || phi_n_spring.is_some();
    if !holds && !foreign.iter().any(|key| key.1) {
        faults.error(path.clone(), "this support holds nothing").hint(
            "a clamped edge gives `w`, `phi_n` and `phi_t`, a simple support `w` and `phi_t`, a guided edge `phi_n`",
        );
    }
    let springs = [("w_spring", w_spring, ("w", w)), ("phi_n_spring", phi_n_spring, ("phi_n", phi_n))];
    for (key, stiffness, (held, value)) in springs {
        let Some(stiffness) = *stiffness else { continue };
        positive(stiffness, key, path.key(key), faults);
        if value.is_some() {
            faults
                .error(path.key(key), format!("`{held}` is prescribed, so `{key}` would do nothing"))
                .hint("remove one of them");
        }
    }
    let turns = [("phi_x", phi_x), ("phi_y", phi_y)].into_iter().filter(|key| key.1.is_some());
    if let (Some((key, _)), true) = (turns.into_iter().next(), phi_n.is_some() || phi_t.is_some()) {
        faults
            .error(path.key(key), format!("`{key}` and `phi_n` or `phi_t` are both given"))
            .hint("hold rotations along x and y, or along and across an edge");
    }
}
