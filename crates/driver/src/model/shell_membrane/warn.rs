//! Doubts about shells that can be solved.

use super::super::Resolved;
use super::NAME;
use crate::diagnostic::{Faults, root};
use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::shell_membrane::ShellParameters;

/// Adds the doubts about a shell that can be solved.
pub(super) fn warn(parameters: &ShellParameters, on: &Resolved, faults: &mut Faults) {
    let uncorrected = on.model.uncorrected();
    if uncorrected > 0 {
        let s = if uncorrected == 1 { "" } else { "s" };
        faults
            .warning(
                root("body"),
                format!(
                    "{uncorrected} point{s} at corners: no bonds without negative stiffness are exact there"
                ),
            )
            .hint("corners of panels are a few percent off; closed tubes have none");
    }
    if parameters.calibration == Calibration::Published {
        faults
            .warning(
                root("model").key(NAME).key("calibration"),
                "the published constant is wrong on a lattice and near ends: 5 to 10 % at the usual horizon, however small the spacing",
            )
            .hint("take the calibration `matched`, which is exact for every uniform strain");
    }
    warn_of_held_ends(on, faults);
}

/// Adds a doubt about ends whose axial motion is prescribed: their outermost points are held, half a spacing inside, which is not
/// how one stress reaches the points. Measured 3.4 to 10 % of the force between two such ends of 20 columns.
fn warn_of_held_ends(on: &Resolved, faults: &mut Faults) {
    let held = on.held.iter().find(|held| {
        let end = held.region.as_deref().is_some_and(|name| ["left", "right"].contains(&name));
        end && held.components.contains(&"ux")
    });
    let Some(held) = held else { return };
    faults
        .warning(
            held.path.key("ux"),
            "ends of shells are held at their outermost points: forces between held ends are up to 10 % too large on 20 columns, stresses beside them up to a third",
        )
        .hint("load the end by a traction, use `symmetry`, or read stresses a horizon and more away from it");
}
