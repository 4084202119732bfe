//! Materials of members of a frame.

use crate::case::{Case, Expansion, Frame, Modulus, Names, RegionMaterial};
use crate::diagnostic::{Faults, JsonPath, positive, root, suggest};
use crate::model::Beam;
use crate::scene::expansion;
use std::collections::HashMap;

/// The material of a member, if it is not that of the model.
fn of<'a>(case: &'a Case, member: &str) -> Option<&'a RegionMaterial> {
    case.materials.values().find(|material| members(material).iter().any(|name| name == member))
}

/// The members that a material names.
fn members(material: &RegionMaterial) -> &[String] {
    material.at.as_ref().map_or(&[], Names::each)
}

/// Adds faults of materials that are none, and of members that cannot have one.
pub(super) fn check(case: &Case, frame: &Frame, beam: &Beam, faults: &mut Faults) {
    let mut owners: HashMap<&str, &str> = HashMap::new();
    for (name, material) in &case.materials {
        let path = root("materials").key(name);
        let moduli =
            [("youngs_modulus", &material.youngs_modulus), ("shear_modulus", &material.shear_modulus)];
        for (key, value) in moduli.iter().filter_map(|(key, value)| Some((key, value.as_ref()?))) {
            match value.number() {
                Some(value) => drop(positive(value, key, path.key(*key), faults)),
                None => drop(
                    faults
                        .error(path.key(*key), format!("`{key}` of members is a number"))
                        .hint("what varies along a member is its `stiffness`, or its `section`"),
                ),
            }
        }
        if let Some(own) = material.thermal_expansion {
            expansion::is_one(own, &path.key("thermal_expansion"), faults);
        }
        if material.stiffness_factor.is_some() {
            faults
                .error(path.key("stiffness_factor"), "`stiffness_factor` is of plates with fibres")
                .hint("give the `youngs_modulus` of the members");
        }
        if material.fibre_angle.is_some() {
            faults
                .error(path.key("fibre_angle"), "`fibre_angle` is of plates with fibres")
                .hint("leave it out");
        }
        if material.density.is_some() {
            faults
                .error(path.key("density"), "`density` is that of all members, beside `model`")
                .hint("give what a member weighs more or less as a `distributed` load along it");
        }
        if material.strengths.is_some() {
            faults
                .error(path.key("strengths"), "`strengths` judge the stresses of plates, shells and solids")
                .hint("put a `limit` on a probe of `stress`");
        }
        if material.at.is_none() {
            faults
                .error(path.clone(), "`at` is missing")
                .hint("name the members of this material; all others are of that of `model`");
        }
        let has_moduli = moduli.iter().any(|(_, value)| value.is_some());
        if !has_moduli && material.thermal_expansion.is_none() {
            faults
                .error(path.clone(), format!("the material `{name}` is that of `model`"))
                .hint("give `youngs_modulus`, `shear_modulus` or `thermal_expansion`");
        }
        for member in members(material) {
            let Some(given) = frame.members.iter().find(|given| given.name == *member) else {
                faults
                    .error(path.key("at"), format!("there is no member `{member}`"))
                    .hint(suggest(member, frame.members.iter().map(|given| given.name.as_str())));
                continue;
            };
            if let Some(other) = owners.insert(&given.name, name) {
                faults.error(path.key("at"), format!("the member `{member}` is of the material `{other}`"));
            }
            let by_numbers = given.stiffness.is_some() || given.section.is_none() && beam.section.is_none();
            if has_moduli && by_numbers {
                faults
                    .error(
                        path.key("at"),
                        format!("the member `{member}` has no `section` that moduli could make stiff"),
                    )
                    .hint("give it a `section`, or all of its `stiffness` by numbers");
            }
        }
    }
}

/// Gives a beam the moduli of a member.
pub(super) fn apply(case: &Case, member: &str, beam: &mut Beam) {
    let Some(material) = of(case, member) else { return };
    let number = |modulus: &Option<Modulus>| modulus.as_ref().and_then(Modulus::number);
    beam.youngs_modulus = number(&material.youngs_modulus).or(beam.youngs_modulus);
    if material.shear_modulus.is_some() {
        (beam.shear_modulus, beam.poisson_ratio) = (number(&material.shear_modulus), None);
    }
}

/// Whether a member has moduli of its own.
pub(super) fn has_moduli(case: &Case, member: &str) -> bool {
    of(case, member).is_some_and(|m| m.youngs_modulus.is_some() || m.shear_modulus.is_some())
}

/// How much a line or a member stretches by heat, with a fault at the load that needs it where that is not known.
pub(super) fn expansion(
    case: &Case,
    member: Option<&str>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<f64> {
    let own = member.and_then(|member| of(case, member)?.thermal_expansion);
    match own.or_else(|| expansion::of(case, false, path, faults))? {
        Expansion::Alike(alpha) => Some(alpha),
        Expansion::Fibres(_) => None,
    }
}
