//! Keys that only one of the two calibrations of bonds has a meaning for.

use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::bond_plane::{VolumeFactor, Weights};
use peristat_assembly::model::plane::Calibration;

/// What a case chooses of its bonds.
pub(super) struct BondChoice {
    pub(super) weights: Option<Weights>,
    pub(super) volume_factor: Option<VolumeFactor>,
}

impl BondChoice {
    /// Whether all of it has a meaning; `path` is that of the model.
    pub(super) fn check(&self, calibration: Calibration, path: &JsonPath, faults: &mut Faults) -> bool {
        let published = calibration == Calibration::Published;
        if self.volume_factor.is_some() && !published {
            faults
                .error(
                    path.key("volume_factor"),
                    "the calibration `matched` has no volume factors: its bonds are exact without them",
                )
                .hint(r#"remove `volume_factor`, or take "calibration": "published""#);
        }
        if self.weights.is_some() && published {
            faults
                .error(
                    path.key("weights"),
                    "`weights` chooses among exact bonds, and those of the calibration `published` are not",
                )
                .hint(r#"remove `weights`, or take "calibration": "matched""#);
        }
        if published { self.weights.is_none() } else { self.volume_factor.is_none() }
    }

    /// Whether listed points can have them.
    pub(super) fn check_listed(&self, path: &JsonPath, faults: &mut Faults) -> bool {
        let needs_cells = self.volume_factor == Some(VolumeFactor::Area);
        if needs_cells {
            faults
                .error(path.key("volume_factor"), "the volume factor `area` needs the cells of a lattice")
                .hint("use `ramp`");
        }
        let needs_offsets = self.weights == Some(Weights::Isotropic);
        if needs_offsets {
            faults
                .error(path.key("weights"), "weights that are `isotropic` need the offsets of a lattice")
                .hint("leave `weights` out, or fill the body with cells");
        }
        !needs_cells && !needs_offsets
    }
}
