//! At which stretches beam bonds break.

use super::super::{Critical, CriticalFormula, CriticalStretches, OnGround, foreign, needed};
use super::{NAME, refusal};
use crate::diagnostic::{Faults, JsonPath, root};
use peristat_assembly::model::beam_bond_orthotropic::{
    BeamNeighbourhood, CriticalStretches as Of, OrthotropicError, OrthotropicParameters, ReleaseRates, Start,
};
use peristat_assembly::model::plane::CriticalStretch;

/// The stretches at which bonds along the fibres and all others break.
pub(super) fn stretches(
    given: &mut Critical,
    parameters: &OrthotropicParameters,
    on: &OnGround,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<CriticalStretches> {
    let refuse = |error: OrthotropicError, faults: &mut Faults| {
        refusal(&error, parameters.calibration).tell(NAME, on.horizon_key, faults);
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
        match given.formula.get_or_insert(CriticalFormula::Energy) {
            CriticalFormula::Growth => {
                faults
                    .error(path.key("formula"), "the formula `growth` is of central bonds")
                    .hint("use `energy`: what the lattice adds is not known of beam bonds");
                return None;
            }
            CriticalFormula::Published => Of::published(rates, &parameters.material, on.horizon),
            CriticalFormula::Energy => {
                let found = Of::by_energy(rates, &bonds, on.spacing);
                found.map_err(|error| refuse(error, faults)).ok()?
            }
        }
    } else {
        if given.formula.is_some() {
            faults.error(path.key("formula"), "`formula` is for energy release rates");
        }
        let fibre = needed(stretches[0], "fibre_stretch", path, faults);
        let matrix = needed(stretches[1], "matrix_stretch", path, faults);
        Of { fibre: fibre?, matrix: matrix? }
    };
    let fibres = bonds.is_fibre().to_vec();
    let by_offset = fibres.iter().map(|&along| if along { critical.fibre } else { critical.matrix });
    Some(CriticalStretches { by_offset: CriticalStretch::new(by_offset.collect()), fibres })
}
