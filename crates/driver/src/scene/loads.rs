//! Loads of a scene: load cases, combinations and steps as right-hand sides.

use super::place::{Layout, LayoutLine, Place};
use super::{State, root};
use crate::case::{Case, DistributedForce, Load, LoadSharing, Model, PointLoad};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::timoshenko_beam::{Along, BeamLoads, Distributed, Intensity, PointAction};
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
    let default = if layout.treatment.covers() { LoadSharing::Consistent } else { LoadSharing::Lumped };
    let sharing = *beam.distributed_loads.get_or_insert(default);
    if sharing == LoadSharing::Consistent && !layout.treatment.covers() {
        faults
            .error(
                super::material::beam_path().key("distributed_loads"),
                "`consistent` loads need bonds whose weights sum to one across every cell",
            )
            .hint("use `lumped`, or the end treatment `cover`");
    }
    let lumped = sharing == LoadSharing::Lumped;
    let resolve = |name: &str, loads: &[Load], path: &JsonPath, faults: &mut Faults| {
        let mut resolved = ResolvedLoads { name: name.into(), ..Default::default() };
        resolved.loads.lumped = lumped;
        for (k, load) in loads.iter().enumerate() {
            match load {
                Load::Point(load) => {
                    add_point(load, layout, &path.index(k).key("point"), &mut resolved, faults)
                }
                Load::Distributed(load) => {
                    add_distributed(load, layout, &path.index(k).key("distributed"), &mut resolved, faults);
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

fn add_point(
    load: &PointLoad,
    layout: &Layout,
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    if load.force == 0.0 && load.moment == 0.0 {
        faults.error(path.clone(), "this load is zero").hint("give `force`, `moment`, or both");
    }
    let at = path.key("at").key("x");
    let Some(place) = layout.place(load.at.x, &at, "the load", faults) else {
        return;
    };
    let covers = layout.treatment.covers();
    let (chain, x, spread) = match place {
        Place::Point { chain, point } => {
            let inside = point > 0 && point + 1 < layout.lines[chain].points();
            if load.spread && !covers {
                faults
                    .error(
                        path.key("spread"),
                        "a spread load needs bonds whose weights sum to one across every cell",
                    )
                    .hint("use the end treatment `cover`");
            }
            if inside && !load.spread && covers {
                to.splits.push((chain, point));
            }
            (chain, layout.lines[chain].position(point), load.spread && inside)
        }
        Place::Between { chain, x } if covers => (chain, x, true),
        // The literature puts a load at the end of a grid of cells on the last point.
        Place::End { chain, .. } => (chain, load.at.x, false),
        Place::Between { chain, x } => {
            layout.needs_point(chain, x, &at, "the load", faults);
            return;
        }
    };
    to.loads.point.push(PointAction { chain, x, force: load.force, moment: load.moment, axial: 0.0, spread });
}

fn add_distributed(
    load: &crate::case::Distributed,
    layout: &Layout,
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    let single = layout.lines.len() == 1;
    if !single && (load.from.is_none() || load.to.is_none()) {
        faults
            .error(path.clone(), "`from` and `to` are needed where the body has several lines")
            .hint("a distributed load acts on one line");
        return;
    }
    let from = load.from.unwrap_or(layout.lines[0].from);
    let end = load.to.unwrap_or(layout.lines[0].to());
    let keys = ["from", "to"].map(|k| path.key(k));
    let places = [from, end]
        .into_iter()
        .zip(&keys)
        .map(|(x, key)| layout.place(x, key, "the end of the load", faults));
    let places: Vec<Option<Place>> = places.collect();
    let [Some(a), Some(b)] = places[..] else { return };
    if a.chain() != b.chain() {
        faults
            .error(path.clone(), format!("a load from x = {from} to {end} spans a gap between lines"))
            .hint("give one load per line");
        return;
    }
    if from >= end {
        faults.error(keys[1].clone(), format!("`to` must be greater than `from`, found {from} to {end}"));
        return;
    }
    if load.force.is_none() && load.moment.is_none() {
        faults.error(path.clone(), "this load has neither `force` nor `moment`");
    }
    for (value, along) in [(load.force, Along::Transverse), (load.moment, Along::Rotation)] {
        let name = if along == Along::Rotation { "moment" } else { "force" };
        let intensity = match value {
            None => continue,
            Some(DistributedForce::Uniform(q)) => Intensity::Linear { start: q, end: q },
            Some(DistributedForce::Linear([start, end])) => Intensity::Linear { start, end },
            Some(DistributedForce::Sine(sine)) if sine.half_waves == 0 => {
                let key = path.key(name).key("sine").key("half_waves");
                faults.error(key, "`half_waves` must be at least 1, found 0");
                continue;
            }
            Some(DistributedForce::Sine(sine))
                if f64::from(sine.half_waves) > waves(&layout.lines[a.chain()], from, end) =>
            {
                let key = path.key(name).key("sine").key("half_waves");
                faults
                    .error(
                        key,
                        format!(
                            "{} half waves are more than the grid has cells under the load",
                            sine.half_waves
                        ),
                    )
                    .hint("use more cells; a wave needs several to be seen");
                continue;
            }
            Some(DistributedForce::Sine(sine)) => {
                Intensity::Sine { amplitude: sine.amplitude, half_waves: sine.half_waves }
            }
        };
        to.loads.distributed.push(Distributed { chain: a.chain(), from, to: end, intensity, along });
    }
}

/// Cells of a line under a load: more half waves than these look like fewer.
fn waves(line: &LayoutLine, from: f64, to: f64) -> f64 {
    ((to - from) / line.spacing()).ceil()
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
                    .hint(super::material::suggest(key, cases.iter().map(|c| c.name.as_str())));
            }
        }
    }
    State { name, load_factor: 1.0, motion_factor: 1.0, loads }
}
