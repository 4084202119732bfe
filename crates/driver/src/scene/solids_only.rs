//! Keys that have a meaning for solids alone.

use crate::case::{At, Case, Load, Probe, Support};
use crate::diagnostic::{Faults, JsonPath, root};
use crate::model::hints;

/// Adds a fault for every key of a case of another body that is for solids.
pub(crate) fn refuse(case: &Case, faults: &mut Faults) {
    for (k, support) in case.supports.iter().enumerate() {
        of_support(support, &root("supports").index(k), faults);
    }
    of_loads(&case.loads, &root("loads"), faults);
    for (k, load_case) in case.load_cases.iter().enumerate() {
        of_loads(&load_case.loads, &root("load_cases").index(k).key("loads"), faults);
    }
    for (k, rigid) in case.rigid.iter().enumerate() {
        let path = root("rigid").index(k);
        let turns = [("phi_x", &rigid.phi_x), ("phi_y", &rigid.phi_y), ("phi_z", &rigid.phi_z)];
        for (key, value) in [("uz", &rigid.uz)].into_iter().chain(turns) {
            tell(key, value.is_some(), &path, faults);
        }
    }
    for (k, Probe { at, .. }) in case.probes.iter().enumerate() {
        of_place(at, &root("probes").index(k).key("at"), faults);
    }
}

fn of_support(support: &Support, path: &JsonPath, faults: &mut Faults) {
    of_place(&support.at, &path.key("at"), faults);
    tell("uz", support.uz.is_some(), path, faults);
    tell("uz_spring", support.uz_spring.is_some(), path, faults);
}

fn of_loads(loads: &[Load], path: &JsonPath, faults: &mut Faults) {
    for (k, load) in loads.iter().enumerate() {
        match load {
            Load::Point(load) => {
                let path = path.index(k).key("point");
                of_place(&load.at, &path.key("at"), faults);
                let moments =
                    [("moment_x", load.moment_x), ("moment_y", load.moment_y), ("moment_z", load.moment_z)];
                for (key, value) in [("force_z", load.force_z)].into_iter().chain(moments) {
                    tell(key, value != 0.0, &path, faults);
                }
            }
            Load::Traction(load) => {
                let path = path.index(k).key("traction");
                tell("face", load.face.is_some(), &path, faults);
                tell("along", load.along.is_some(), &path, faults);
            }
            Load::Distributed(_)
            | Load::BodyForce(_)
            | Load::Gravity(_)
            | Load::Line(_)
            | Load::Spin(_)
            | Load::Pressure(_)
            | Load::Temperature(_)
            | Load::InitialStrain(_) => {}
        }
    }
}

fn of_place(at: &At, path: &JsonPath, faults: &mut Faults) {
    tell("z", at.z.is_some(), path, faults);
}

fn tell(key: &str, is_given: bool, path: &JsonPath, faults: &mut Faults) {
    if is_given {
        faults.error(path.key(key), format!("`{key}` is for solids")).hint(format!(
            "leave it out; solids have the model `{}` or `{}`",
            hints::SOLIDS[0],
            hints::SOLIDS[1]
        ));
    }
}
