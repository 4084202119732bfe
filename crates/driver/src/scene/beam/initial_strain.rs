//! Prestress, and members that do not fit: strains that lines have from the beginning.

use super::eigenstrain::{self, Eigenstrain, Load};
use super::extent::{self, GivenExtent, Words};
use super::place::Layout;
use super::resolved_loads::ResolvedLoads;
use super::section::Resolved;
use crate::case::{Case, InitialStrain};
use crate::diagnostic::{Faults, JsonPath};

/// What messages say of what has such a strain.
const WORDS: Words = Words {
    what: "initial strain",
    on_a_line: "all of a line has it",
    of_a_line: "all of a line has it",
    of_a_member: "of a frame name the member that has it",
};

/// What messages call the load.
const LOAD: Load = Load { name: "an `initial_strain`", line: "a line with an initial strain" };

/// Adds an initial strain.
pub(super) fn add(
    load: &InitialStrain,
    (case, layout): (&Case, &Layout),
    sections: Option<&[Resolved]>,
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    if case.fracture.is_some() {
        faults.error(path.clone(), "beams that break have no `initial_strain`").hint("remove `fracture`");
    }
    for (key, _) in load.components().into_iter().filter(|(_, amount)| amount.is_some()) {
        faults
            .error(path.key(key), format!("`{key}` is a component of the strain of bodies"))
            .hint("a line or member has a `strain` of its axis and a `curvature`");
    }
    if load.region.is_some() {
        faults
            .error(path.key("region"), "lines and members have no regions")
            .hint("of a frame name the `member`");
    }
    let given = GivenExtent { member: load.member.as_deref(), from: None, to: None };
    let extent = extent::find(&given, layout, path, &WORDS, faults);
    let stretched = [("strain", load.strain), ("length", load.length), ("force", load.force)];
    let stretched: Vec<(&str, f64)> = stretched.into_iter().filter_map(|(key, v)| Some((key, v?))).collect();
    if let [first, second, ..] = stretched[..] {
        faults
            .error(path.key(second.0), format!("`{}` and `{}` say the same of the axis", first.0, second.0))
            .hint("give one of `strain`, `length` and `force`");
        return;
    }
    let stretched = stretched.first().copied().filter(|(_, value)| *value != 0.0);
    let curvature = load.curvature.unwrap_or(0.0);
    if stretched.is_none() && curvature == 0.0 {
        faults
            .error(path.clone(), "this load is zero")
            .hint("give one of `strain`, `length` and `force`, or `curvature`, or both");
    }
    let (Some(extent), Some(sections)) = (extent, sections) else { return };
    let key = stretched.map(|(key, _)| key);
    let Some(stiffness) = eigenstrain::stiffness(&sections[extent.chain], key, &LOAD, path, faults) else {
        return;
    };
    let strain = match stretched {
        None => 0.0,
        Some(("strain", strain)) => strain,
        Some(("length", length)) => length / layout.lines[extent.chain].length,
        // Held by its ends it has the force −EA ε*.
        Some((_, force)) => -force / stiffness[0],
    };
    let strains = [strain, curvature];
    let forces = [0, 1].map(|k| stiffness[k] * strains[k]);
    eigenstrain::add(Eigenstrain { chain: extent.chain, forces, strains }, layout, &LOAD, path, to, faults);
}
