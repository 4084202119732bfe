//! How the bonds of a plate break.

use super::probes::{PlateProbe, PlateQuantity};
use super::site::Site;
use super::thickness::Thickness;
use crate::case::{Case, FRACTURE_FACTS, FieldName, Fracture, Load};
use crate::diagnostic::{Faults, JsonPath, root};
use crate::model::{Critical, CriticalFormula};
use crate::scene::bending_criterion::{self, Criterion};
use crate::scene::body::site::of_case::horizon_key;
use crate::scene::fracture::{self, FractureScene};
use peristat_assembly::model::plate_bending::{
    CriticalCurvature, CriticalCurvatures, CriticalShear, PlateBending,
};

/// How a plate breaks.
pub type PlateFracture = FractureScene<CriticalCurvatures>;

/// Horizon ratios from which bonds pass over points.
const LONG: f64 = 2.0;

/// Names of all that checks can ask for, of a plate that breaks.
pub(super) fn facts(fracture: Option<&PlateFracture>) -> &'static [&'static str] {
    if fracture.is_some() { &FRACTURE_FACTS } else { &[] }
}

/// Faults of what a plate that breaks cannot have.
pub(super) fn check(case: &Case, horizon_ratio: f64, faults: &mut Faults) {
    fracture::check(case, faults);
    let Some(fracture) = &case.fracture else { return };
    fracture::check_probes(case, &FRACTURE_FACTS, faults);
    if horizon_ratio >= LONG * (1.0 - 1e-6) {
        faults
            .error(
                root(horizon_key(case)),
                "plates in bending break with bonds to the eight next points alone",
            )
            .hint("take the `horizon_ratio` 1.5, the default");
    }
    if !fracture.directions.is_empty() {
        faults
            .error(
                root("fracture").key("directions"),
                "`directions` is for bodies that are loaded in their plane",
            )
            .hint("look at the field `damage`");
    }
    for (k, load) in case.loads.iter().enumerate() {
        if matches!(load, Load::Temperature(_) | Load::InitialStrain(_)) {
            faults
                .error(
                    root("loads").index(k),
                    "plates in bending that break have no heat and no curvature from the beginning",
                )
                .hint("find the moments of the plate as it is, without `fracture`");
        }
    }
}

/// The fracture of a case, with its defaults filled in.
pub(super) fn resolve(
    fracture: &mut Fracture,
    (site, probes): (&Site, &[PlateProbe]),
    (plate, thickness): (&PlateBending, &Thickness),
    faults: &mut Faults,
) -> Option<PlateFracture> {
    let path = root("fracture");
    let load = probes.iter().find(|probe| probe.name == fracture.load);
    if let Some(load) = load.filter(|load| !stands_for_load(load)) {
        faults
            .error(
                path.key("load"),
                format!("`{}` at {} does not stand for the load", load.field.name(), load.place),
            )
            .hint("take a probe of a reaction or of a deflection at a point");
    }
    let mut exempt = vec![false; site.nodes.points()];
    for (k, name) in fracture.no_fail.iter().enumerate() {
        let points = site.ground.region(name, &path.key("no_fail").index(k), faults);
        points.into_iter().flatten().for_each(|point| exempt[point as usize] = true);
    }
    let critical = critical(&mut fracture.critical, (plate, thickness), &path.key("critical"), faults)?;
    let names: Vec<&str> = probes.iter().map(|probe| probe.name.as_str()).collect();
    fracture::resolve(fracture, critical, exempt, &names, faults)
}

/// Whether what a probe reads follows from unknowns and from what holds the plate.
fn stands_for_load(probe: &PlateProbe) -> bool {
    let is_unknown = [FieldName::W, FieldName::PhiX, FieldName::PhiY].contains(&probe.field);
    match probe.quantity {
        PlateQuantity::Field(_) => is_unknown,
        PlateQuantity::Reaction { .. } => true,
        _ => false,
    }
}

/// Critical strains of every section.
fn critical(
    given: &mut Critical,
    (plate, thickness): (&PlateBending, &Thickness),
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<CriticalCurvatures> {
    const WHAT: &str = "a plate in bending";
    let criterion = bending_criterion::given(given, WHAT, path, faults);
    if given.formula == Some(CriticalFormula::Published) {
        faults
            .error(
                path.key("formula"),
                "plates in bending have no `published` formula of an energy release rate",
            )
            .hint("take `growth`, the default, or `energy`");
    }
    if given.formula.is_some() && given.energy_release_rate.is_none() {
        faults
            .error(path.key("formula"), "`formula` says what follows from an `energy_release_rate`")
            .hint(bending_criterion::hint(WHAT));
    }
    let sections = &thickness.of_sections;
    Some(match criterion? {
        Criterion::Energy(rate) => {
            let energies: Vec<f64> = sections.iter().map(|t| rate * t).collect();
            match given.formula.get_or_insert(CriticalFormula::Growth) {
                CriticalFormula::Energy => plate.critical_of_energy(&energies),
                _ => plate.critical_of_growth(&energies),
            }
        }
        Criterion::Strains([curvature, shear_strain]) => {
            let shear = CriticalShear::Strain(shear_strain);
            CriticalCurvatures(vec![CriticalCurvature { curvature, shear }; sections.len()])
        }
    })
}
