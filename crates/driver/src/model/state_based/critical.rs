//! At which stretches bonds of families break.

use super::super::{Critical, foreign, needed};
use crate::diagnostic::{Faults, JsonPath};

/// The stretch at which every bond breaks.
pub(super) fn stretch(given: &Critical, path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    let others = [
        ("energy_release_rate", given.energy_release_rate),
        ("fibre_stretch", given.fibre_stretch),
        ("matrix_stretch", given.matrix_stretch),
        ("fibre_energy_release_rate", given.fibre_energy_release_rate),
        ("matrix_energy_release_rate", given.matrix_energy_release_rate),
        ("curvature", given.curvature),
        ("shear_strain", given.shear_strain),
    ];
    foreign(
        &others,
        "bonds of families break by `stretch`: they share the energy of their points",
        path,
        faults,
    );
    needed(given.stretch, "stretch", path, faults)
}
