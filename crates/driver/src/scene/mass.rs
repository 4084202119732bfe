//! Mass: what weight and inertia of turning are per volume.

use crate::case::{Case, Gravity, Spin};
use crate::diagnostic::{Faults, JsonPath, positive, root, tidy};
use crate::units::Units;
use std::f64::consts::PI;

/// Adds a warning where no material has the density of a case in its units.
pub(super) fn check(case: &Case, faults: &mut Faults) {
    let Some(density) = case.density else { return };
    if !positive(density, "density", root("density"), faults) {
        return;
    }
    if case.units.usual_densities().is_some_and(|usual| !usual.contains(&density)) {
        faults
            .warning(root("density"), format!("{} {} is an unusual density", tidy(density), case.units.density()))
            .hint("steel has 7850 kg/m³ or, in mm-N-MPa, 7.85e-9 t/mm³; `units` only labels, it converts nothing");
    }
}

/// Mass per volume, with a fault at the load `key` that needs it where there is none.
fn density(case: &Case, key: &str, path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    if case.density.is_none() {
        let steel = match case.units {
            Units::MetreNewtonPascal => "steel has `\"density\": 7850` kg/m³",
            Units::MillimetreNewtonMegapascal => "steel has `\"density\": 7.85e-9` t/mm³",
            Units::Dimensionless => "mass per volume of the material",
        };
        faults
            .error(path.clone(), format!("`{key}` needs the `density` of the material, beside `model`"))
            .hint(steel);
    }
    case.density
}

/// Force per volume of a weight that falls along a direction.
pub(super) fn weight(
    case: &Case,
    load: &Gravity,
    along: [f64; 3],
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<[f64; 3]> {
    let density = density(case, "gravity", path, faults);
    let length = along.iter().fold(0.0_f64, |a, x| a.hypot(*x));
    if length == 0.0 {
        faults
            .error(path.key("along"), "`along` has no direction")
            .hint("[0, -1] is downwards in the plane, [0, 0, -1] in a solid with z upwards");
        return None;
    }
    let acceleration = match (load.acceleration, case.units.gravity()) {
        (Some(given), _) => {
            positive(given, "acceleration", path.key("acceleration"), faults).then_some(given)
        }
        (None, Some(usual)) => Some(usual),
        (None, None) => {
            faults
                .error(
                    path.clone(),
                    "`acceleration` is missing: numbers without units have none of their own",
                )
                .hint("give `acceleration`, or `units`");
            None
        }
    };
    let force = density? * acceleration?;
    Some(along.map(|x| force * (x / length)))
}

/// Force per volume and distance from the axis of a body that turns, ρ ω².
pub(super) fn spin(case: &Case, load: &Spin, path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    let density = density(case, "spin", path, faults);
    let omega = match (load.omega, load.rpm) {
        (Some(omega), None) => omega,
        (None, Some(rpm)) => rpm * PI / 30.0,
        (given, _) => {
            let what = if given.is_some() {
                "`omega` and `rpm` are both given"
            } else {
                "neither `omega` nor `rpm` is given"
            };
            faults
                .error(path.clone(), what)
                .hint("`omega` is in radians per second, `rpm` in revolutions per minute");
            return None;
        }
    };
    if omega == 0.0 {
        faults.error(path.clone(), "this load is zero");
    }
    Some(density? * omega * omega)
}
