//! Strengths that judge stresses.

use crate::case::{Case, Strengths};
use crate::diagnostic::{Faults, JsonPath, positive, root};
use crate::model::Material;

/// Adds a fault for every strength that a material needs and has not, or that has no meaning for it.
pub(crate) fn check(case: &Case, material: &dyn Material, faults: &mut Faults) {
    case.strengths.iter().for_each(|strengths| check_one(strengths, material, &root("strengths"), faults));
    for (name, given) in &case.materials {
        let Some(own) = &given.strengths else { continue };
        let path = root("materials").key(name).key("strengths");
        check_one(own, material, &path, faults);
        if case.strengths.is_none() {
            faults
                .error(path, "the material of `model` has no `strengths`")
                .hint("give them beside `model`, for all points that are of no other material");
        }
    }
}

fn check_one(strengths: &Strengths, material: &dyn Material, path: &JsonPath, faults: &mut Faults) {
    let of_fibres = strengths.of_fibres();
    let plain = [("yield_stress", strengths.yield_stress)];
    let (needed, foreign, of): (&[_], &[_], _) = match material.fibres() {
        Some(_) => (&of_fibres, &plain, "a material without fibres"),
        None => (&plain, &of_fibres, "a material with fibres"),
    };
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
