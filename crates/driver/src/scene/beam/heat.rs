//! Changes of temperature of lines and members.
//!
//! A section that is warmer by T at its axis and by D more on the side of +w than on that of −w stretches by αT and bends by −αD/h
//! without a section force.

use super::eigenstrain::{self, Eigenstrain, Load};
use super::extent::{self, GivenExtent, Words};
use super::member_material;
use super::place::Layout;
use super::resolved_loads::ResolvedLoads;
use super::section::Resolved;
use crate::case::{Amount, Case, Temperature, number};
use crate::diagnostic::{Faults, JsonPath};

/// What messages say of what becomes warmer.
const WORDS: Words = Words {
    what: "temperature",
    on_a_line: "all of a line becomes warmer",
    of_a_line: "all of a line becomes warmer",
    of_a_member: "of a frame name the member that becomes warmer",
};

/// What messages call the load.
const LOAD: Load = Load { name: "a `temperature`", line: "a line that becomes warmer" };

/// Adds a change of temperature.
pub(super) fn add(
    load: &Temperature,
    (case, layout): (&Case, &Layout),
    sections: Option<&[Resolved]>,
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    if load.region.is_some() {
        faults
            .error(path.key("region"), "`region` is for bodies")
            .hint("of a frame name the `member` that becomes warmer; all of a line does");
    }
    if case.fracture.is_some() {
        faults.error(path.clone(), "beams that break have no `temperature`").hint("remove `fracture`");
    }
    let given = GivenExtent { member: load.member.as_deref(), from: None, to: None };
    let extent = extent::find(&given, layout, path, &WORDS, faults);
    let Some(alpha) = member_material::expansion(case, load.member.as_deref(), path, faults) else { return };
    let mut kelvin = |given: &Option<Amount>, key: &str| uniform(given.as_ref(), &path.key(key), faults);
    let (change, difference) = (kelvin(&load.change, "change"), kelvin(&load.difference, "difference"));
    let (Some(change), Some(difference)) = (change, difference) else { return };
    if change == 0.0 && difference == 0.0 {
        faults.error(path.clone(), "this load is zero").hint("give `change`, `difference`, or both");
    }
    let (Some(extent), Some(sections)) = (extent, sections) else { return };
    let section = &sections[extent.chain];
    let key = (change != 0.0).then_some("change");
    let Some(stiffness) = eigenstrain::stiffness(section, key, &LOAD, path, faults) else { return };
    let mut strains = [alpha * change, 0.0];
    if difference != 0.0 {
        let Some(height) = section.section.height.as_ref().and_then(|height| height.uniform()) else {
            faults
                .error(path.key("difference"), "the height of the section is not known")
                .hint("give a `section`, which has one, in place of the stiffness");
            return;
        };
        strains[1] = -alpha * difference / height;
    }
    let forces = [0, 1].map(|k| stiffness[k] * strains[k]);
    eigenstrain::add(Eigenstrain { chain: extent.chain, forces, strains }, layout, &LOAD, path, to, faults);
}

/// Kelvin, zero where nothing is given.
fn uniform(given: Option<&Amount>, path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    if matches!(given, Some(Amount::Formula(_))) {
        faults
            .error(path.clone(), "formulas are for bodies: a line is as warm all along")
            .hint("give a number, and members of their own where the temperature differs");
        return None;
    }
    Some(number(given).unwrap_or(0.0))
}
