//! How the bonds of a body in the plane break.

use super::toughness;
use crate::case::{Case, CrackDirection, FRACTURE_FACTS, FieldName, Fracture};
use crate::diagnostic::{Faults, JsonPath};
use crate::model::CriticalStretches;
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::body::load::sums::BodyLoads;
use crate::scene::fracture::{self, FractureScene};
use crate::scene::root;
use peristat_assembly::model::plane::CriticalStretch;

/// How a body in the plane breaks.
#[derive(Clone, Debug)]
pub struct BodyFracture {
    /// Load steps and critical stretches by offset.
    pub steps: FractureScene<CriticalStretch>,
    /// Per offset, whether its bonds lie along the fibres; empty if there are none.
    pub fibres: Vec<bool>,
    /// Where directions of cracks are found.
    pub directions: Vec<CrackDirection>,
}

impl BodyFracture {
    /// Names of all that checks can ask for.
    pub fn facts(&self) -> Vec<String> {
        let general = general_facts(&self.fibres).into_iter();
        general.chain(self.directions.iter().flat_map(CrackDirection::facts)).collect()
    }
}

/// Names of what is known of a body with such fibres wherever cracks run.
fn general_facts(fibres: &[bool]) -> Vec<String> {
    let of_fibres = (!fibres.is_empty()).then_some("broken_fibre_bonds");
    FRACTURE_FACTS.into_iter().chain(of_fibres).map(Into::into).collect()
}

/// The fracture of a case, with its defaults filled in.
pub(crate) fn resolve(
    fracture: &mut Fracture,
    (site, loads): (&HeldBody, &[BodyLoads]),
    probes: &[&str],
    faults: &mut Faults,
) -> Option<BodyFracture> {
    let path = root("fracture");
    let case = site.ground.case;
    if !(case.symmetry.is_empty() && case.periodic.is_empty()) {
        // It is refused already; images have numbers of their own.
        return None;
    }
    if let Some(why) = site.model.unbreakable() {
        faults.error(path, why);
        return None;
    }
    let mut exempt = vec![false; site.model.points()];
    for (k, name) in fracture.no_fail.iter().enumerate() {
        let points = site.ground.region(name, &path.key("no_fail").index(k), faults).unwrap_or_default();
        points.iter().for_each(|&p| exempt[site.inputs.number(site.model, p) as usize] = true);
    }
    site.conditions.held_points().for_each(|p| exempt[p] = true);
    let on = site.inputs.on_ground(case);
    let critical =
        site.inputs.material.critical(&mut fracture.critical, &on, &path.key("critical"), faults)?;
    let critical = toughness::of_materials(critical, &fracture.critical, site, faults)?;
    let CriticalStretches { by_offset: mut critical, fibres } = critical;
    if let Some(own) = loads.first().and_then(|loads| loads.eigenstrain.as_ref()) {
        critical = critical.beyond(own.strains());
    }
    if site.model.as_solid().is_some() && !fracture.directions.is_empty() {
        faults
            .error(
                path.key("directions"),
                "a crack in a solid is a surface, which has no direction in the plane",
            )
            .hint("leave `directions` out: `fields/step_*_crack.vtu` has the surface");
    }
    check_directions(fracture, &general_facts(&fibres), &path.key("directions"), faults);
    check_load(&fracture.load, site.ground.case, &path.key("load"), faults);
    let directions = fracture.directions.clone();
    let steps = fracture::resolve(fracture, critical, exempt, probes, faults)?;
    let fracture = BodyFracture { steps, fibres, directions };
    fracture::check_probes(site.ground.case, &fracture.facts(), faults);
    Some(fracture)
}

/// Fault of a load, the name of a probe, that would take fields of every equilibrium.
pub(crate) fn check_load(load: &str, case: &Case, path: &JsonPath, faults: &mut Faults) {
    use FieldName::{Opening, ReactionX, ReactionY, ReactionZ, Ux, Uy, Uz};
    let probe = case.probes.iter().find(|p| p.name == load);
    if refuse_reduced(load, "load", case, path, faults) {
        return;
    }
    if let Some(probe) =
        probe.filter(|p| !matches!(p.field, ReactionX | ReactionY | ReactionZ | Ux | Uy | Uz | Opening))
    {
        let message = format!("the probe `{load}` is one of `{}`, which is no load", probe.field.name());
        faults
            .error(path.clone(), message)
            .hint("use a probe of a reaction such as `reaction_x`, or of a displacement such as `ux` where forces are given");
    }
}

/// Whether a probe makes one number of many points, which takes fields of every equilibrium; a fault if so. `what` it is to be.
pub(crate) fn refuse_reduced(
    name: &str,
    what: &str,
    case: &Case,
    path: &JsonPath,
    faults: &mut Faults,
) -> bool {
    let probe = case.probes.iter().find(|p| p.name == name);
    let Some((of, field)) = probe.and_then(|p| Some((p.of?, p.field.name()))) else { return false };
    let found = of.words(field);
    faults
        .error(path.clone(), format!("the probe `{name}` is the {found} of many points, which is no {what}"))
        .hint("leave `of` out of the probe");
    true
}

/// Faults of directions, of which none may be known by a name among the `taken` ones.
fn check_directions(fracture: &Fracture, taken: &[String], path: &JsonPath, faults: &mut Faults) {
    for (k, direction) in fracture.directions.iter().enumerate() {
        let path = path.index(k);
        if fracture.directions[..k].iter().any(|d| d.name == direction.name) {
            faults.error(path.key("name"), format!("there are two directions `{}`", direction.name));
        }
        if let Some(name) = direction.facts().iter().find(|name| taken.contains(name)) {
            faults
                .error(path.key("name"), format!("checks know something else by the name `{name}`"))
                .hint("they know a direction as `<name>_direction` and `<name>_bonds`: choose another name");
        }
        if (0..2).any(|axis| direction.from[axis] >= direction.to[axis]) {
            faults
                .error(path.key("to"), "the part is empty: `to` must be above and to the right of `from`")
                .hint("`from` is the lower left corner, `to` the upper right one");
        }
    }
}
