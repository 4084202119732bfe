//! Loads of a beam: load cases, combinations and steps as right-hand sides.

use super::model_path::beam_path;
use super::place::Layout;
use super::resolved_loads::ResolvedLoads;
use super::section::Resolved;
use super::state::State;
use super::{distributed_load, heat, initial_strain, point_load, weight};
use crate::case::{Case, Load, LoadSharing};
use crate::diagnostic::Faults;
use crate::model::Beam;
use crate::scene::states::{self, Group, Sum};
use peristat_assembly::model::timoshenko_beam::BeamLoads;

/// All load cases; a case with plain `loads` has one. Fills in how the model shares distributed loads.
pub(super) fn load_cases(
    case: &Case,
    model: &mut Beam,
    layout: &Layout,
    sections: Option<&[Resolved]>,
    faults: &mut Faults,
) -> Vec<ResolvedLoads> {
    let on_springs = !case.foundation.is_empty();
    let default = match layout.treatment.covers() && !on_springs {
        true => LoadSharing::Consistent,
        false => LoadSharing::Lumped,
    };
    let sharing = *model.distributed_loads.get_or_insert(default);
    if sharing == LoadSharing::Consistent && !layout.treatment.covers() {
        faults
            .error(
                beam_path().key("distributed_loads"),
                "`consistent` loads need bonds whose weights sum to one across every cell",
            )
            .hint("use `lumped`, or the end treatment `cover`");
    }
    if sharing == LoadSharing::Consistent && on_springs {
        faults
            .error(
                beam_path().key("distributed_loads"),
                "`consistent` loads do not fit a foundation, which acts on the points",
            )
            .hint("leave `distributed_loads` out: errors of loads and foundation on the points cancel in part, with `consistent` loads they do not");
    }
    let lumped = sharing == LoadSharing::Lumped;
    let resolve = |group: &Group, faults: &mut Faults| {
        let mut resolved = ResolvedLoads::default();
        resolved.loads.lumped = lumped;
        let path = &group.path;
        for &(k, load) in &group.loads {
            match load {
                Load::Point(load) => {
                    point_load::add(load, layout, &path.index(k).key("point"), &mut resolved, faults)
                }
                Load::Gravity(load) => {
                    let path = path.index(k).key("gravity");
                    weight::add(load, (case, layout), sections, &path, &mut resolved, faults);
                }
                // Refused with the other keys of plates in bending.
                Load::Line(_) => {}
                Load::Traction(_) | Load::BodyForce(_) | Load::Pressure(_) | Load::Spin(_) => {
                    super::foreign::refuse(load, &path.index(k), faults)
                }
                Load::Temperature(load) => {
                    let path = path.index(k).key("temperature");
                    heat::add(load, (case, layout), sections, &path, &mut resolved, faults);
                }
                Load::InitialStrain(load) => {
                    let path = path.index(k).key("initial_strain");
                    initial_strain::add(load, (case, layout), sections, &path, &mut resolved, faults);
                }
                Load::Distributed(load) => {
                    let path = path.index(k).key("distributed");
                    distributed_load::add(load, (layout, group.factor), &path, &mut resolved, faults);
                }
            }
        }
        resolved
    };
    states::load_cases(case, resolve, faults)
}

/// The right-hand sides of the case.
pub(super) fn states(
    case: &Case,
    cases: &[ResolvedLoads],
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<Vec<State>> {
    let sums = states::sums(case, faults);
    let loads = |k: usize| (cases[k].loads.point.len() + cases[k].loads.distributed.len()) as f64;
    let all: f64 = sums.iter().flat_map(|sum| &sum.terms).map(|&(k, _)| loads(k)).sum();
    let key = if case.steps.is_some() { "steps" } else { "combinations" };
    if sums.len() > cases.len() && !super::size::check_loads(all, key, max_memory, faults) {
        return None;
    }
    let lumped = cases.first().is_some_and(|c| c.loads.lumped);
    let state = |sum: Sum| {
        let mut loads = BeamLoads { lumped, ..Default::default() };
        sum.terms.iter().for_each(|&(k, factor)| loads.extend(cases[k].loads.scaled(factor)));
        let of_case =
            |&(k, factor): &(usize, f64)| cases[k].eigenstrains.iter().map(move |given| given.times(factor));
        let eigenstrains = sum.terms.iter().flat_map(of_case).collect();
        State {
            name: sum.name,
            load_factor: sum.load_factor,
            motion_factor: sum.load_factor,
            loads,
            eigenstrains,
        }
    };
    Some(sums.into_iter().map(state).collect())
}
