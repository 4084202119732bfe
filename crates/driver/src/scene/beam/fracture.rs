//! How the bonds of a beam break.

use super::model_path::beam_path;
use super::place::Layout;
use super::probes::BeamProbe;
use super::section::SectionAlong;
use crate::case::FRACTURE_FACTS;
use crate::case::{Case, Check, Fracture};
use crate::diagnostic::root;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::bending_criterion::{self, Criterion};
use crate::scene::fracture::{self, FractureScene};
use peristat_assembly::model::timoshenko_beam::{CriticalStrain, CriticalStrains, TimoshenkoBeam};

/// What the resolution of a fracture looks at.
pub(super) struct BreakingBeam<'a> {
    pub(super) beam: &'a TimoshenkoBeam,
    pub(super) sections: &'a [SectionAlong],
    pub(super) probes: &'a [BeamProbe],
}

/// Names of all that checks can ask for, of a beam that breaks.
pub(super) fn facts(fracture: Option<&FractureScene<CriticalStrains>>) -> &'static [&'static str] {
    if fracture.is_some() { &FRACTURE_FACTS } else { &[] }
}

/// Faults of what a beam that breaks cannot have.
pub(super) fn check(case: &Case, layout: &Layout, faults: &mut Faults) {
    fracture::check(case, faults);
    let Some(fracture) = &case.fracture else { return };
    fracture::check_probes(case, &FRACTURE_FACTS, faults);
    let path = root("fracture");
    let joined = [
        (
            "body",
            layout.frame.is_some(),
            "members of a frame do not break: a part that comes off could still hang in a joint",
        ),
        (
            "links",
            !case.links.is_empty(),
            "beams with `links` do not break: a part that comes off could still hang in one",
        ),
    ];
    let one_way = [
        ("supports", case.supports.iter().any(|support| support.only.is_some())),
        ("foundation", case.foundation.iter().any(|foundation| foundation.only.is_some())),
    ];
    for (key, _) in one_way.iter().filter(|o| o.1) {
        faults
            .error(
                root(key),
                "beams that break have nothing that acts one way: their load factors come from sums of states",
            )
            .hint("leave out `only`, or leave out `fracture`");
    }
    for (key, _, reason) in joined.iter().filter(|j| j.1) {
        faults
            .error(root(key), *reason)
            .hint("take a body of lines that nothing joins, or leave out `fracture`");
    }
    let named = [("no_fail", !fracture.no_fail.is_empty()), ("directions", !fracture.directions.is_empty())];
    for (key, _) in named.iter().filter(|n| n.1) {
        faults
            .error(path.key(*key), format!("`{key}` is for bodies in the plane"))
            .hint("a beam breaks across its line, wherever its sections are strained most");
    }
    for k in (0..case.checks.len()).filter(|&k| matches!(case.checks[k], Check::ClosedForm(_))) {
        faults
            .error(root("checks").index(k).key("closed_form"), "closed forms are for beams that do not break")
            .hint("compare a probe or a fact, such as `peak_load`, with a number by a `value` check");
    }
}

/// The fracture of a case, with its defaults filled in.
pub(super) fn resolve(
    fracture: &mut Fracture,
    context: &BreakingBeam,
    faults: &mut Faults,
) -> Option<FractureScene<CriticalStrains>> {
    let (beam, path) = (context.beam, root("fracture"));
    if beam.chains().iter().any(|chain| chain.ghosts != [0; 2]) {
        let name = beam.parameters().end_treatment.name;
        faults
            .error(
                beam_path().key("end_treatment"),
                format!("the end treatment `{name}` has images of bonds beyond the ends, which do not break"),
            )
            .hint("use `cover`: it needs no bond beyond the end");
    }
    let load = context.probes.iter().find(|p| p.name == fracture.load);
    if let Some(field) = load.map(|p| p.field).filter(|f| f.is_recovered()) {
        faults
            .error(path.key("load"), format!("`{}` does not stand for the load", field.name()))
            .hint("take a probe of a reaction or of a displacement");
    }
    if let Some(of) = load.and_then(BeamProbe::reduction) {
        let what = of.words(load.map_or("", |p| p.field.name()));
        faults
            .error(path.key("load"), format!("the {what} of many points does not stand for the load"))
            .hint("leave `of` out of the probe");
    }
    let critical = critical(fracture, context, &path.key("critical"), faults)?;
    let names: Vec<&str> = context.probes.iter().map(|p| p.name.as_str()).collect();
    // Unlike a body in the plane a beam has no stresses at its supports that are those of the model: it breaks there, too.
    fracture::resolve(fracture, critical, vec![false; beam.points()], &names, faults)
}

/// Critical strains of every line.
fn critical(
    fracture: &Fracture,
    context: &BreakingBeam,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<CriticalStrains> {
    const WHAT: &str = "a beam";
    let given = &fracture.critical;
    let criterion = bending_criterion::given(given, WHAT, path, faults);
    if given.formula.is_some() {
        faults
            .error(path.key("formula"), "`formula` is for bodies in the plane")
            .hint(bending_criterion::hint(WHAT));
    }
    match criterion? {
        Criterion::Energy(rate) => of_energy(rate, context, path, faults),
        Criterion::Strains([curvature, shear_strain]) => {
            let strain = CriticalStrain { curvature, shear_strain };
            Some(CriticalStrains(vec![strain; context.beam.chains().len()]))
        }
    }
}

/// Critical strains of lines whose sections take up so much energy per area.
fn of_energy(
    rate: f64,
    context: &BreakingBeam,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<CriticalStrains> {
    let mut all = Vec::new();
    for (chain, section) in context.beam.chains().iter().zip(context.sections) {
        let strain = CriticalStrain::of_energy(rate, chain).filter(|_| section.area.is_some());
        if strain.is_none() {
            let reason = match section.area {
                None => "`energy_release_rate` needs the area of the section",
                Some(_) => "`energy_release_rate` is for uniform sections and grids",
            };
            faults.error(path.key("energy_release_rate"), reason).hint("give `curvature` and `shear_strain`");
        }
        all.push(strain?);
    }
    Some(CriticalStrains(all))
}
