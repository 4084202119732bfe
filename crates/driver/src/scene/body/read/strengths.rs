//! Strengths that judge stresses.

use crate::case::Case;
use crate::diagnostic::{Faults, positive, root};
use crate::model::Material;

/// Adds a fault for every strength that the material needs and has not, or that has no meaning for it.
pub(crate) fn check(case: &Case, material: &dyn Material, faults: &mut Faults) {
    let Some(strengths) = &case.strengths else { return };
    let of_fibres = strengths.of_fibres();
    let plain = [("yield_stress", strengths.yield_stress)];
    let (needed, foreign, of): (&[_], &[_], _) = match material.fibres() {
        Some(_) => (&of_fibres, &plain, "a material without fibres"),
        None => (&plain, &of_fibres, "a material with fibres"),
    };
    let path = root("strengths");
    for (key, value) in needed {
        match value {
            Some(value) => {
                positive(*value, key, path.key(*key), faults);
            }
            None => {
                faults.error(path.clone(), format!("`{key}` is missing"));
            }
        }
    }
    for (key, _) in foreign.iter().filter(|(_, value)| value.is_some()) {
        faults.error(path.key(*key), format!("`{key}` is for {of}"));
    }
}
