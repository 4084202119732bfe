//! At which stretches the bonds of a body in the plane break.

use super::super::fracture::{foreign, needed};
use super::super::root;
use super::bonds::PlaneBonds;
use super::model;
use super::site::Site;
use crate::case::{CriticalFormula, Fracture};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::beam_bond_orthotropic::{
    BeamNeighbourhood, CriticalStretches, OrthotropicError, OrthotropicParameters, ReleaseRates, Start,
};
use peristat_assembly::model::bond_plane::{
    Influence, PlaneParameters, critical_stretch, published_critical_stretch,
};
use peristat_assembly::model::plane::CriticalStretch;

/// Critical stretches by offset, and which offsets are along fibres.
pub(super) fn critical(
    fracture: &mut Fracture,
    site: &Site,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(CriticalStretch, Vec<bool>)> {
    match site.recipe.bonds {
        PlaneBonds::Central(parameters) => {
            let stretch = of_central(fracture, &parameters, site, path, faults)?;
            let offsets = site.recipe.bonds.offsets().map_or(1, |offsets| offsets.len());
            Some((CriticalStretch(vec![stretch; offsets]), Vec::new()))
        }
        PlaneBonds::Beams(parameters) => of_beams(fracture, &parameters, site, path, faults),
        PlaneBonds::State(_) => {
            let stretch = of_families(fracture, path, faults)?;
            let offsets = site.recipe.bonds.offsets().map_or(1, |offsets| offsets.len());
            Some((CriticalStretch(vec![stretch; offsets]), Vec::new()))
        }
        // That they do not break has been said.
        PlaneBonds::Shell(_) => None,
    }
}

fn of_central(
    fracture: &mut Fracture,
    parameters: &PlaneParameters,
    site: &Site,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<f64> {
    let given = &mut fracture.critical;
    foreign(
        &[
            ("fibre_stretch", given.fibre_stretch),
            ("matrix_stretch", given.matrix_stretch),
            ("fibre_energy_release_rate", given.fibre_energy_release_rate),
            ("matrix_energy_release_rate", given.matrix_energy_release_rate),
            ("curvature", given.curvature),
            ("shear_strain", given.shear_strain),
        ],
        "central bonds break by `stretch`, or by `energy_release_rate`",
        path,
        faults,
    );
    if given.stretch.is_some() && given.energy_release_rate.is_some() {
        faults
            .error(path.key("energy_release_rate"), "`stretch` and `energy_release_rate` are both given")
            .hint("the one follows from the other: remove one of them");
        return None;
    }
    let Some(rate) = given.energy_release_rate else {
        if given.formula.is_some() {
            faults.error(path.key("formula"), "`formula` is for energy release rates");
        }
        return needed(given.stretch, "stretch", path, faults);
    };
    needed(Some(rate), "energy_release_rate", path, faults)?;
    let is_lattice = matches!(site.ground.body, peristat_assembly::body::PlaneBody::Lattice(_));
    let default = if is_lattice { CriticalFormula::Energy } else { CriticalFormula::Published };
    match given.formula.get_or_insert(default) {
        CriticalFormula::Published if parameters.influence != Influence::Constant => {
            faults
                .error(path.key("formula"), "the published formula is that of the influence `constant`")
                .hint("use the formula `energy`, which knows the bonds");
            None
        }
        CriticalFormula::Published => Some(published_critical_stretch(rate, parameters, site.recipe.horizon)),
        CriticalFormula::Energy if !is_lattice => {
            faults
                .error(path.key("formula"), "the formula `energy` needs the bonds of a lattice")
                .hint("use `published`, or give `stretch`");
            None
        }
        CriticalFormula::Energy => {
            let spacing = site.recipe.body.spacing();
            let found = critical_stretch(rate, parameters, spacing);
            found.map_err(|error| model::refuse(&error.into(), site.ground.case, faults)).ok()
        }
    }
}

fn of_families(fracture: &Fracture, path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    let given = &fracture.critical;
    let others = [
        ("energy_release_rate", given.energy_release_rate),
        ("fibre_stretch", given.fibre_stretch),
        ("matrix_stretch", given.matrix_stretch),
        ("fibre_energy_release_rate", given.fibre_energy_release_rate),
        ("matrix_energy_release_rate", given.matrix_energy_release_rate),
        ("curvature", given.curvature),
        ("shear_strain", given.shear_strain),
    ];
    foreign(
        &others,
        "bonds of families break by `stretch`: they share the energy of their points",
        path,
        faults,
    );
    needed(given.stretch, "stretch", path, faults)
}

fn of_beams(
    fracture: &mut Fracture,
    parameters: &OrthotropicParameters,
    site: &Site,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(CriticalStretch, Vec<bool>)> {
    let refuse = |error: OrthotropicError, faults: &mut Faults| {
        model::refuse(&error.into(), site.ground.case, faults);
    };
    let bonds = BeamNeighbourhood::new(parameters).map_err(|error| refuse(error, faults)).ok()?;
    if bonds.start() == Some(Start::Oblique) {
        // Why not the other way, unless it is for want of bonds along the fibres.
        let aligned = OrthotropicParameters { start: Some(Start::Aligned), ..*parameters };
        match BeamNeighbourhood::new(&aligned) {
            Err(OrthotropicError::NoFibreBonds { .. }) | Ok(_) => {}
            Err(error) => {
                refuse(error, faults);
                return None;
            }
        }
        faults
            .error(
                root("fracture"),
                "stiff bonds lie beside the fibres, not on them: cracks would run wrong although the moduli are exact",
            )
            .hint("turn the lattice with the fibres: \"lattice\": \"fibre\" in the model");
        return None;
    }
    let given = &mut fracture.critical;
    foreign(
        &[
            ("stretch", given.stretch),
            ("energy_release_rate", given.energy_release_rate),
            ("curvature", given.curvature),
            ("shear_strain", given.shear_strain),
        ],
        "beam bonds break by `fibre_stretch` and `matrix_stretch`, or by the energy release rates of both",
        path,
        faults,
    );
    let rates = [given.fibre_energy_release_rate, given.matrix_energy_release_rate];
    let stretches = [given.fibre_stretch, given.matrix_stretch];
    if stretches.iter().any(Option::is_some) && rates.iter().any(Option::is_some) {
        faults
            .error(path.clone(), "stretches and energy release rates are both given")
            .hint("the ones follow from the others: remove either");
        return None;
    }
    let critical = if rates.iter().any(Option::is_some) {
        let fibre = needed(rates[0], "fibre_energy_release_rate", path, faults);
        let matrix = needed(rates[1], "matrix_energy_release_rate", path, faults);
        let rates = ReleaseRates { fibre: fibre?, matrix: matrix? };
        match given.formula.get_or_insert_default() {
            CriticalFormula::Published => {
                CriticalStretches::published(rates, &parameters.material, site.recipe.horizon)
            }
            CriticalFormula::Energy => {
                let found = CriticalStretches::by_energy(rates, &bonds, site.recipe.body.spacing());
                found.map_err(|error| refuse(error, faults)).ok()?
            }
        }
    } else {
        if given.formula.is_some() {
            faults.error(path.key("formula"), "`formula` is for energy release rates");
        }
        let fibre = needed(stretches[0], "fibre_stretch", path, faults);
        let matrix = needed(stretches[1], "matrix_stretch", path, faults);
        CriticalStretches { fibre: fibre?, matrix: matrix? }
    };
    let fibres = bonds.is_fibre().to_vec();
    let by_offset = fibres.iter().map(|&along| if along { critical.fibre } else { critical.matrix });
    Some((CriticalStretch(by_offset.collect()), fibres))
}
