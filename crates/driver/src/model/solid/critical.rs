//! At which stretches the bonds of solids break.

use super::super::{Critical, CriticalFormula, CriticalStretches, OnGround, Refusal, foreign, needed};
use super::SolidParameters;
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::solid::Solid;
use peristat_assembly::model::solid::toughness::{
    critical_stretch, published_critical_stretch, published_state_stretch,
};

/// Normal of the plane whose bonds have an energy release rate: that of a layer of cells.
const ALONG_LAYERS: [f64; 3] = [0.0, 0.0, 1.0];

/// The stretch at which every bond breaks.
pub(super) fn stretches<P: SolidParameters>(
    given: &mut Critical,
    parameters: P,
    on: &OnGround,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<CriticalStretches> {
    let foreign_keys = [
        ("fibre_stretch", given.fibre_stretch),
        ("matrix_stretch", given.matrix_stretch),
        ("fibre_energy_release_rate", given.fibre_energy_release_rate),
        ("matrix_energy_release_rate", given.matrix_energy_release_rate),
        ("curvature", given.curvature),
        ("shear_strain", given.shear_strain),
    ];
    foreign(&foreign_keys, "bonds of solids break by `stretch`, or by `energy_release_rate`", path, faults);
    let stretch = match (given.stretch, given.energy_release_rate) {
        (Some(_), Some(_)) => {
            faults
                .error(path.key("energy_release_rate"), "`stretch` and `energy_release_rate` are both given")
                .hint("the one follows from the other: remove one of them");
            return None;
        }
        (None, Some(rate)) => of_rate(rate, given, parameters, on, path, faults)?,
        (stretch, None) => {
            if given.formula.is_some() {
                faults.error(path.key("formula"), "`formula` is for energy release rates");
            }
            needed(stretch, "stretch", path, faults)?
        }
    };
    let offsets = Solid::offsets(&parameters).ok()?;
    Some(CriticalStretches::alike(stretch, Some(&offsets)))
}

/// Whether nothing but bonds resists: Poisson's ratio is 1/4.
fn has_no_dilatation(parameters: impl SolidParameters) -> bool {
    (parameters.bulk_modulus() / parameters.shear_modulus() - 5.0 / 3.0).abs() < 1e-3
}

/// The stretch of an energy release rate.
fn of_rate<P: SolidParameters>(
    rate: f64,
    given: &mut Critical,
    parameters: P,
    on: &OnGround,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<f64> {
    needed(Some(rate), "energy_release_rate", path, faults)?;
    match given.formula.get_or_insert(CriticalFormula::Energy) {
        CriticalFormula::Growth => {
            faults
                .error(path.key("formula"), "what the lattice adds to the growth of a crack is known in the plane alone")
                .hint("use `energy`, the default of solids: with three spacings per horizon a long crack grows at that to 3 %");
            None
        }
        CriticalFormula::Published => {
            let (bulk, shear) = (parameters.bulk_modulus(), parameters.shear_modulus());
            Some(match P::HAS_FAMILIES {
                true => published_state_stretch(rate, [bulk, shear], on.horizon),
                false => published_critical_stretch(rate, bulk, parameters.influence(), on.horizon),
            })
        }
        CriticalFormula::Energy if P::HAS_FAMILIES && !has_no_dilatation(parameters) => {
            faults
                .error(
                    path.key("energy_release_rate"),
                    "what a bond releases depends on the others of its points, but for a Poisson's ratio of 1/4: no energy release rate belongs to a stretch",
                )
                .hint("give `stretch`; or take \"formula\": \"published\", which is off by tenths away from 1/4");
            None
        }
        CriticalFormula::Energy => critical_stretch(rate, &parameters, on.spacing, ALONG_LAYERS)
            .map_err(|error| Refusal::from(error).tell(P::NAME, on.horizon_key, faults))
            .ok(),
    }
}
