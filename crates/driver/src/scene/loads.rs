//! Loads of a scene: load cases, combinations and steps as right-hand sides.

use super::place::Layout;
use super::{State, distributed_load, point_load, root};
use crate::case::{Case, Load, LoadSharing, Model};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::timoshenko_beam::BeamLoads;
use std::collections::HashSet;

/// Loads of one load case, and the points they split.
#[derive(Clone, Debug, Default)]
pub(super) struct ResolvedLoads {
    /// Name of the load case.
    pub(super) name: String,
    /// The loads.
    pub(super) loads: BeamLoads,
    /// Line and real point of concentrated loads that act on a point.
    pub(super) splits: Vec<(usize, usize)>,
}

/// All load cases; a case with plain `loads` has one.
pub(super) fn load_cases(case: &mut Case, layout: &Layout, faults: &mut Faults) -> Vec<ResolvedLoads> {
    if !case.loads.is_empty() && !case.load_cases.is_empty() {
        faults
            .error(root("loads"), "`loads` and `load_cases` are both given")
            .hint("move the loads into a load case");
    }
    let Model::TimoshenkoBeam(beam) = &mut case.model;
    let on_springs = !case.foundation.is_empty();
    let default = match layout.treatment.covers() && !on_springs {
        true => LoadSharing::Consistent,
        false => LoadSharing::Lumped,
    };
    let sharing = *beam.distributed_loads.get_or_insert(default);
    if sharing == LoadSharing::Consistent && !layout.treatment.covers() {
        faults
            .error(
                super::beam_path().key("distributed_loads"),
                "`consistent` loads need bonds whose weights sum to one across every cell",
            )
            .hint("use `lumped`, or the end treatment `cover`");
    }
    if sharing == LoadSharing::Consistent && on_springs {
        faults
            .error(
                super::beam_path().key("distributed_loads"),
                "`consistent` loads do not fit a foundation, which acts on the points",
            )
            .hint("leave `distributed_loads` out: errors of loads and foundation on the points cancel in part, with `consistent` loads they do not");
    }
    let lumped = sharing == LoadSharing::Lumped;
    let resolve = |name: &str, loads: &[Load], path: &JsonPath, faults: &mut Faults| {
        let mut resolved = ResolvedLoads { name: name.into(), ..Default::default() };
        resolved.loads.lumped = lumped;
        for (k, load) in loads.iter().enumerate() {
            match load {
                Load::Point(load) => {
                    point_load::add(load, layout, &path.index(k).key("point"), &mut resolved, faults)
                }
                Load::Distributed(load) => {
                    let path = path.index(k).key("distributed");
                    distributed_load::add(load, layout, &path, &mut resolved, faults);
                }
            }
        }
        resolved
    };
    if case.load_cases.is_empty() {
        return vec![resolve("loads", &case.loads, &root("loads"), faults)];
    }
    let mut names = HashSet::new();
    let each = case.load_cases.iter().enumerate().map(|(k, c)| {
        let path = root("load_cases").index(k);
        if !names.insert(c.name.clone()) {
            faults.error(path.key("name"), format!("there are two load cases `{}`", c.name));
        }
        resolve(&c.name, &c.loads, &path.key("loads"), faults)
    });
    each.collect()
}

/// The right-hand sides: load steps, or load cases followed by their combinations.
pub(super) fn states(case: &Case, cases: Vec<ResolvedLoads>, faults: &mut Faults) -> Vec<State> {
    if let Some(steps) = &case.steps {
        let path = root("steps").key("load_factors");
        if !case.load_cases.is_empty() {
            faults
                .error(root("steps"), "`steps` and `load_cases` are both given")
                .hint("steps apply to plain `loads`; give a load case per step instead");
        }
        if steps.load_factors.is_empty() {
            faults
                .error(path, "`load_factors` is empty")
                .hint("for example [0.5, 1.0]; without `steps` the loads act at once");
        }
        let loads = cases.into_iter().next().unwrap_or_default().loads;
        let step = |(k, &factor): (usize, &f64)| State {
            name: format!("step {}", k + 1),
            load_factor: factor,
            motion_factor: factor,
            loads: loads.scaled(factor),
        };
        return steps.load_factors.iter().enumerate().map(step).collect();
    }
    if case.load_cases.is_empty() && !case.combinations.is_empty() {
        faults
            .error(root("combinations"), "`combinations` need `load_cases`")
            .hint("a combination is a sum of named load cases: move the loads into some");
        return Vec::new();
    }
    let combined: Vec<State> =
        case.combinations.iter().enumerate().map(|(k, _)| combination(case, k, &cases, faults)).collect();
    let single =
        |c: ResolvedLoads| State { name: c.name, load_factor: 1.0, motion_factor: 1.0, loads: c.loads };
    cases.into_iter().map(single).chain(combined).collect()
}

fn combination(case: &Case, index: usize, cases: &[ResolvedLoads], faults: &mut Faults) -> State {
    let combination = &case.combinations[index];
    let path = root("combinations").index(index);
    let name = combination.name.clone();
    let taken =
        cases.iter().any(|c| c.name == name) || case.combinations[..index].iter().any(|c| c.name == name);
    if taken {
        faults
            .error(path.key("name"), format!("the name `{name}` is taken"))
            .hint("load cases and combinations must differ in their names");
    }
    if combination.factors.is_empty() {
        faults.error(path.key("factors"), "a combination needs the factor of at least one load case");
    }
    let lumped = cases.first().is_some_and(|c| c.loads.lumped);
    let mut loads = BeamLoads { lumped, ..Default::default() };
    for (key, &factor) in &combination.factors {
        match cases.iter().find(|c| c.name == *key) {
            Some(found) => loads.extend(found.loads.scaled(factor)),
            None => {
                faults
                    .error(path.key("factors").key(key), format!("there is no load case `{key}`"))
                    .hint(super::words::suggest(key, cases.iter().map(|c| c.name.as_str())));
            }
        }
    }
    State { name, load_factor: 1.0, motion_factor: 1.0, loads }
}
