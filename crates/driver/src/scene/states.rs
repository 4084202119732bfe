//! Load steps, load cases and combinations as sums of load cases, whatever the loads are.

use super::root;
use crate::case::{Case, Load};
use crate::diagnostic::{Faults, JsonPath, suggest};
use std::collections::HashSet;

/// One right-hand side.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sum {
    /// Name in results.
    pub(super) name: String,
    /// Factor on the loads as written; 1 for load cases and combinations.
    pub(super) load_factor: f64,
    /// Load cases by number, and their factors.
    pub(super) terms: Vec<(usize, f64)>,
}

/// Loads that act together.
pub(super) struct Group<'a> {
    /// Where they stand in the case.
    pub(super) path: JsonPath,
    /// With their numbers there.
    pub(super) loads: Vec<(usize, &'a Load)>,
    /// The load factor of a step, of loads that know it.
    pub(super) factor: Option<f64>,
}

/// Every load case of the case, as `resolve` makes it of its loads; plain `loads` are one load case, followed by one per step of
/// those whose formulas know the load factor, if there are such.
pub(super) fn load_cases<L>(
    case: &Case,
    mut resolve: impl FnMut(&Group, &mut Faults) -> L,
    faults: &mut Faults,
) -> Vec<L> {
    if !case.loads.is_empty() && !case.load_cases.is_empty() {
        faults
            .error(root("loads"), "`loads` and `load_cases` are both given")
            .hint("move the loads into a load case");
    }
    if case.load_cases.is_empty() {
        let is_by_step = |(_, load): &(usize, &Load)| case.steps.is_some() && load.knows_load_factor();
        let (by_step, proportional): (Vec<_>, Vec<_>) = case.loads.iter().enumerate().partition(is_by_step);
        let group = |loads, factor| Group { path: root("loads"), loads, factor };
        let mut all = vec![resolve(&group(proportional, None), faults)];
        for &factor in case.steps.iter().filter(|_| !by_step.is_empty()).flat_map(|s| &s.load_factors) {
            // What is wrong in one step is so in others.
            let mut own = Faults::default();
            all.push(resolve(&group(by_step.clone(), Some(factor)), &mut own));
            if all.len() == 2 || own.has_errors() && !faults.has_errors() {
                faults.append(own);
            }
        }
        return all;
    }
    let mut names = HashSet::new();
    let each = case.load_cases.iter().enumerate().map(|(k, c)| {
        let path = root("load_cases").index(k);
        if !names.insert(&c.name) {
            faults.error(path.key("name"), format!("there are two load cases `{}`", c.name));
        }
        let loads = c.loads.iter().enumerate().collect();
        resolve(&Group { path: path.key("loads"), loads, factor: None }, faults)
    });
    each.collect()
}

/// The right-hand sides: load steps, or load cases followed by their combinations.
pub(super) fn sums(case: &Case, faults: &mut Faults) -> Vec<Sum> {
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
        let by_step = case.loads.iter().any(Load::knows_load_factor);
        let step = |(k, &factor): (usize, &f64)| Sum {
            name: format!("step {}", k + 1),
            load_factor: factor,
            terms: std::iter::once((0, factor)).chain(by_step.then_some((k + 1, 1.0))).collect(),
        };
        return steps.load_factors.iter().enumerate().map(step).collect();
    }
    if case.load_cases.is_empty() && !case.combinations.is_empty() {
        faults
            .error(root("combinations"), "`combinations` need `load_cases`")
            .hint("a combination is a sum of named load cases: move the loads into some");
        return Vec::new();
    }
    let names: Vec<&str> = match case.load_cases.is_empty() {
        true => vec!["loads"],
        false => case.load_cases.iter().map(|c| c.name.as_str()).collect(),
    };
    let single =
        |(k, name): (usize, &&str)| Sum { name: (*name).into(), load_factor: 1.0, terms: vec![(k, 1.0)] };
    let mut sums: Vec<Sum> = names.iter().enumerate().map(single).collect();
    sums.extend((0..case.combinations.len()).map(|k| combination(case, k, &names, faults)));
    sums
}

fn combination(case: &Case, index: usize, cases: &[&str], faults: &mut Faults) -> Sum {
    let combination = &case.combinations[index];
    let path = root("combinations").index(index);
    let name = combination.name.clone();
    if cases.contains(&name.as_str()) || case.combinations[..index].iter().any(|c| c.name == name) {
        faults
            .error(path.key("name"), format!("the name `{name}` is taken"))
            .hint("load cases and combinations must differ in their names");
    }
    if combination.factors.is_empty() {
        faults.error(path.key("factors"), "a combination needs the factor of at least one load case");
    }
    let mut terms = Vec::new();
    for (key, &factor) in &combination.factors {
        match cases.iter().position(|c| c == key) {
            Some(found) => terms.push((found, factor)),
            None => {
                faults
                    .error(path.key("factors").key(key), format!("there is no load case `{key}`"))
                    .hint(suggest(key, cases.iter().copied()));
            }
        }
    }
    Sum { name, load_factor: 1.0, terms }
}
