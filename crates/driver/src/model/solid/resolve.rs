//! Keys that both models of solids have, checked and filled in.

use super::super::Refused;
use super::super::bond_choice::BondChoice;
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::bond_plane::VolumeFactor;
use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::solid::SolidEdges;

/// Keys that have no meaning for solids, with the reason and what to do.
pub(in super::super) const REFUSED: [Refused; 2] = [
    Refused {
        key: "path",
        message: "the bonds of solids do not soften",
        hint: "model a slice of the body in the plane",
    },
    Refused {
        key: "rigid.bearing",
        message: "a `bearing` is that of a pin in the plane",
        hint: "leave `bearing` out: a rigid region bears all around",
    },
];

/// Horizon per spacing of solids, if nothing else is given.
pub(in super::super) const USUAL: f64 = 2.0;

/// Where the stiffness of bonds comes from, and what is done about faces.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Bonds {
    pub(in super::super) calibration: Calibration,
    pub(in super::super) volume_factor: Option<VolumeFactor>,
    pub(in super::super) edges: SolidEdges,
}

/// The keys with their defaults; `path` is that of the model.
pub(in super::super) fn bonds(
    (calibration, choice, edges): (Option<Calibration>, BondChoice, Option<SolidEdges>),
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Bonds> {
    let calibration = calibration.unwrap_or(Calibration::Matched);
    let is_published = calibration == Calibration::Published;
    let mut fine = choice.check(calibration, path, faults);
    if edges.is_some_and(SolidEdges::is_exact) && is_published {
        faults
            .error(
                path.key("edges"),
                "the edges `border` and `overlay` complete exact bonds, and those of the calibration `published` are not",
            )
            .hint("use `none`, or the calibration `matched`");
        fine = false;
    }
    let usual = if is_published { SolidEdges::None } else { SolidEdges::Border };
    let volume_factor = is_published.then(|| choice.volume_factor.unwrap_or_default());
    fine.then(|| Bonds { calibration, volume_factor, edges: edges.unwrap_or(usual) })
}
