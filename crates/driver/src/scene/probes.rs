//! Probes of a case, whatever its model.

use super::root;
use crate::case::{Case, Probe};
use crate::diagnostic::{Faults, JsonPath};
use std::collections::HashSet;

/// Probes of the case, which must differ in their names; `resolve` says what answers for one.
pub(super) fn probes<P>(
    case: &Case,
    resolve: impl Fn(&Probe, &JsonPath, &mut Faults) -> Option<P>,
    faults: &mut Faults,
) -> Vec<P> {
    let mut probes = Vec::new();
    let mut names = HashSet::new();
    for (k, probe) in case.probes.iter().enumerate() {
        let path = root("probes").index(k);
        if !names.insert(&probe.name) {
            faults.error(path.key("name"), format!("there are two probes `{}`", probe.name));
        }
        if probe.at.is_nowhere() && probe.of.is_none() {
            faults.error(path, "no place is given").hint(
                "write where it is as `at`, or as `of` what is made of all points: `largest`, `smallest`, `largest_magnitude`, `mean` or `integral`",
            );
            continue;
        }
        probes.extend(resolve(probe, &path, faults));
    }
    probes
}
