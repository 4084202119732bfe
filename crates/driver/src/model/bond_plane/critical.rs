//! At which stretches central bonds break.

use super::super::{Critical, CriticalFormula, OnGround, Refusal, foreign, needed};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::bond_plane::{
    PlaneParameters, critical_stretch, growth_stretch, published_critical_stretch,
};

/// The stretch at which every bond breaks.
pub(super) fn stretch(
    given: &mut Critical,
    parameters: &PlaneParameters,
    on: &OnGround,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<f64> {
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
    let default = if on.is_lattice { CriticalFormula::Growth } else { CriticalFormula::Published };
    match given.formula.get_or_insert(default) {
        CriticalFormula::Published if !parameters.suits_published_formulas() => {
            faults
                .error(
                    path.key("formula"),
                    "the published formula is that of the influence `constant` and the weights `nearest`",
                )
                .hint("use the formula `growth`, which knows the bonds");
            None
        }
        CriticalFormula::Published => Some(published_critical_stretch(rate, parameters, on.horizon)),
        CriticalFormula::Growth | CriticalFormula::Energy if !on.is_lattice => {
            faults
                .error(path.key("formula"), "this formula needs the bonds of a lattice")
                .hint("use `published`, or give `stretch`");
            None
        }
        formula => {
            let of = if *formula == CriticalFormula::Growth { growth_stretch } else { critical_stretch };
            let found = of(rate, parameters, on.spacing).map_err(Refusal::from);
            found.map_err(|refusal| refusal.tell("bond_plane", on.horizon_key, faults)).ok()
        }
    }
}
