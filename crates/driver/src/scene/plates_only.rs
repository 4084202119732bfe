//! Keys that have a meaning for plates in bending alone.

use crate::case::{Case, Load, Support};
use crate::diagnostic::{Faults, JsonPath, root};
use crate::model::hints;

/// Adds a fault for every key of a case of another body that is for plates in bending.
pub(super) fn refuse(case: &Case, faults: &mut Faults) {
    for (k, support) in case.supports.iter().enumerate() {
        let Support { phi_x, phi_y, phi_n, phi_t, .. } = support;
        let keys = [("phi_x", phi_x), ("phi_y", phi_y), ("phi_n", phi_n), ("phi_t", phi_t)];
        for (key, _) in keys.iter().filter(|key| key.1.is_some()) {
            tell(key, &root("supports").index(k), faults);
        }
        if support.phi_n_spring.is_some() {
            tell("phi_n_spring", &root("supports").index(k), faults);
        }
    }
    for (name, _) in case.materials.iter().filter(|(_, material)| material.thickness.is_some()) {
        tell("thickness", &root("materials").key(name), faults);
    }
    of_loads(&case.loads, &root("loads"), faults);
    for (k, load_case) in case.load_cases.iter().enumerate() {
        of_loads(&load_case.loads, &root("load_cases").index(k).key("loads"), faults);
    }
}

fn of_loads(loads: &[Load], path: &JsonPath, faults: &mut Faults) {
    for (k, load) in loads.iter().enumerate() {
        match load {
            Load::Line(_) => tell("line", &path.index(k), faults),
            Load::Pressure(load) => {
                let path = path.index(k).key("pressure");
                let keys = [("formula", load.formula.is_some()), ("region", load.region.is_some())];
                keys.iter().filter(|key| key.1).for_each(|(key, _)| tell(key, &path, faults));
            }
            _ => {}
        }
    }
}

fn tell(key: &str, path: &JsonPath, faults: &mut Faults) {
    faults
        .error(path.key(key), format!("`{key}` is for plates in bending"))
        .hint(format!("leave it out; plates that deflect and turn have the model `{}`", hints::PLATES));
}
