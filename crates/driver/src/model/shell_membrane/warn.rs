//! Doubts about shells that can be solved.

use super::super::{HeldRegion, Resolved};
use super::NAME;
use crate::diagnostic::{Faults, root};
use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::shell_membrane::{ShellMembrane, ShellParameters};

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
    warn_of_held_ends(parameters, on, faults);
}

/// Adds a doubt about ends whose axial motion is prescribed.
fn warn_of_held_ends(parameters: &ShellParameters, on: &Resolved, faults: &mut Faults) {
    let Some((lattice, mirrors)) = on.model.lattice() else { return };
    let is_end = |held: &&HeldRegion| {
        let end = held.region.as_deref().is_some_and(|name| ["left", "right"].contains(&name));
        end && held.components.contains(&"ux")
    };
    let held: Vec<&HeldRegion> = on.held.iter().filter(is_end).collect();
    let Some(last) = held.last() else { return };
    let path = last.path.key("ux");
    if !ShellMembrane::has_border(parameters, &mirrors.real(lattice)) {
        // Points half a spacing inside are not how one stress reaches the lattice. Measured 3.4 to 10 % of the force.
        faults
            .warning(
                path,
                "these ends are held at their outermost points: forces between held ends are up to 10 % too large on 20 columns, stresses beside them up to a third",
            )
            .hint("take the ends `border`, the default, or read stresses a horizon and more away from it");
        return;
    }
    if held.len() > 1 && !mirrors.joined[1] && mirrors.lines[1].contains(&None) && !parameters.bending {
        // Chords below the surface have a moment about it, which a free side does not carry: the panel bends until it is gone.
        faults
            .warning(
                path,
                "a panel with free sides bends without any strain between held ends: its axial force is 6 to 10 % too small at any spacing",
            )
            .hint("take \"bending\": true, with which it is 0.2 to 0.5 % off on 20 rows");
    }
}
