//! What bonds that bend and shear break by, as cases say it.

use crate::diagnostic::{Faults, JsonPath};
use crate::model::{Critical, foreign, needed};

/// What a case gives.
pub(super) enum Criterion {
    /// Energy per area of a crack.
    Energy(f64),
    /// Critical curvature and shear strain, infinite where it is not given: such a strain never breaks a bond.
    Strains([f64; 2]),
}

/// How bonds that bend and shear can break; `what` is what breaks, such as `a beam`.
pub(super) fn hint(what: &str) -> String {
    format!("{what} breaks by `curvature` and `shear_strain`, or by `energy_release_rate`")
}

/// What the case gives, with faults of what it cannot.
pub(super) fn given(given: &Critical, what: &str, path: &JsonPath, faults: &mut Faults) -> Option<Criterion> {
    let others = [
        ("stretch", given.stretch),
        ("fibre_stretch", given.fibre_stretch),
        ("matrix_stretch", given.matrix_stretch),
        ("fibre_energy_release_rate", given.fibre_energy_release_rate),
        ("matrix_energy_release_rate", given.matrix_energy_release_rate),
    ];
    foreign(&others, &hint(what), path, faults);
    let strains = [("curvature", given.curvature), ("shear_strain", given.shear_strain)];
    let named = strains.iter().find(|strain| strain.1.is_some());
    match (given.energy_release_rate, named) {
        (Some(rate), None) => needed(Some(rate), "energy_release_rate", path, faults).map(Criterion::Energy),
        (Some(_), Some((key, _))) => {
            faults
                .error(
                    path.key("energy_release_rate"),
                    format!("`{key}` and `energy_release_rate` are both given"),
                )
                .hint("the one follows from the other: remove one of them");
            None
        }
        (None, None) => {
            faults.error(path.clone(), "`curvature` or `shear_strain` is missing").hint(hint(what));
            None
        }
        (None, Some(_)) => {
            let [curvature, shear_strain] = strains.map(|(key, value)| match value {
                Some(_) => needed(value, key, path, faults),
                None => Some(f64::INFINITY),
            });
            Some(Criterion::Strains([curvature?, shear_strain?]))
        }
    }
}
