//! The load cases of a case.

use super::context::LoadContext;
use super::sums::BodyLoads;
use super::traction::{add, on_wall, resolve};
use super::{asked, body_force, initial_strain, mass, point_load, pressure, temperature};
use crate::case::Load;
use crate::diagnostic::{Faults, root};
use crate::scene::body::site::ground::Ground;
use crate::scene::states::{self, Group};

/// All load cases, by numbers of the body.
pub(crate) fn load_cases(context: &LoadContext, faults: &mut Faults) -> Vec<BodyLoads> {
    let resolve = |group: &Group, faults: &mut Faults| {
        let context = &LoadContext { factor: group.factor, ..*context };
        let mut resolved = BodyLoads::default();
        let mut on_borders = Vec::new();
        refuse_pulled(group, context, faults);
        for &(k, load) in &group.loads {
            let path = group.path.index(k);
            match load {
                Load::Point(load) => {
                    point_load::resolve(load, context, &path.key("point"), &mut resolved, faults)
                }
                Load::BodyForce(load) => {
                    body_force::resolve(load, context, &path.key("body_force"), &mut resolved, faults)
                }
                Load::Gravity(load) => {
                    mass::gravity(load, context, &path.key("gravity"), &mut resolved, faults)
                }
                Load::Spin(load) => mass::spin(load, context, &path.key("spin"), &mut resolved, faults),
                Load::Traction(load) if context.ground.body.is_solid() => {
                    on_wall::resolve(load, context, &path.key("traction"), &mut resolved, faults)
                }
                Load::Traction(load) => {
                    let found = resolve::resolve(load, context, path.key("traction"), faults);
                    on_borders.extend(found.into_iter().flatten());
                }
                Load::Pressure(load) => {
                    pressure::resolve(load, context, &path.key("pressure"), &mut resolved, faults)
                }
                Load::Temperature(load) => {
                    temperature::resolve(load, context, &path.key("temperature"), &mut resolved, faults)
                }
                // Refused with the other keys of plates in bending.
                Load::Line(_) => {}
                Load::InitialStrain(load) => {
                    initial_strain::resolve(load, context, &path.key("initial_strain"), &mut resolved, faults)
                }
                Load::Distributed(_) => {
                    faults
                        .error(path.key("distributed"), "`distributed` loads are for beams")
                        .hint("in the plane a force per area on an edge is a `traction`, one per volume a `body_force`");
                }
            }
        }
        if !resolved.is_finite() {
            faults.error(group.path.clone(), "a formula of these loads has no value where it acts");
        }
        resolved.by_formula |= on_borders.iter().any(|t| t.profile.is_formula());
        on_borders.iter().for_each(|t| resolved.asked.add_multiple(1.0, &asked::of_traction(t, context)));
        add::add(&on_borders, context, &mut resolved, faults);
        resolved.on_border = on_borders;
        resolved
    };
    states::load_cases(context.ground.case, resolve, faults)
}

/// A fault where forces through joined sides, which grow with the load factor, would act with loads that do not.
fn refuse_pulled(group: &Group, context: &LoadContext, faults: &mut Faults) {
    let pulled = context.ground.case.periodic.iter().position(|p| p.force.is_some());
    if let Some(k) = pulled.filter(|_| group.factor.is_some()) {
        faults
            .error(
                root("periodic").index(k).key("force"),
                "a force through joined sides grows with the load factor, and loads by `load_factor` do not",
            )
            .hint("leave one of them out");
    }
}

/// Sums of load cases that are solved, with no load among them that is missing.
pub(crate) fn check_loaded(ground: &Ground, cases: &[BodyLoads], moves: bool, faults: &mut Faults) {
    let case = ground.case;
    let stretched = case.periodic.iter().any(|p| p.force.is_some());
    if cases.iter().all(BodyLoads::is_zero) && !moves && !stretched && !faults.has_errors() {
        let key = if case.load_cases.is_empty() { "loads" } else { "load_cases" };
        faults
            .warning(root(key), "nothing acts on the body: all results will be zero")
            .hint("give `loads`, or a support with a displacement that is not zero");
    }
}
