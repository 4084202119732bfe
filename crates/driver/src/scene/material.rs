//! Material, section and calibration of a scene.

use super::root;
use crate::case::{Beam, Case, Model};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::material::{SectionError, SectionProperties, SectionStiffness};
use peristat_assembly::model::timoshenko_beam::{
    BeamParameters, Grid, bond_law,
    end_treatment::{self, EndTreatment},
};

/// Path of the beam in a case.
pub(super) fn beam_path() -> JsonPath {
    root("model").key("timoshenko_beam")
}

/// A number that must be finite and greater than zero.
pub(super) fn positive(value: f64, name: &str, path: JsonPath, faults: &mut Faults) -> bool {
    let fine = value > 0.0 && value.is_finite();
    if !fine {
        faults.error(path, format!("`{name}` must be greater than zero, found {value}"));
    }
    fine
}

/// The name nearest to `name`, for a hint.
pub(super) fn suggest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    let nearest = known.iter().map(|k| (strsim::jaro_winkler(name, k), k)).max_by(|a, b| a.0.total_cmp(&b.0));
    match nearest {
        Some((likeness, nearest)) if likeness > 0.75 => format!("did you mean `{nearest}`?"),
        Some(_) => format!("known are {}", known.join(", ")),
        None => "there are none".into(),
    }
}

/// Stiffnesses and section, filling in the defaults of the case.
pub(super) fn material(
    case: &mut Case,
    faults: &mut Faults,
) -> Option<(BeamParameters, SectionStiffness, SectionProperties)> {
    let path = beam_path();
    let grids: Vec<Grid> = case.body.lines().iter().map(|l| l.grid).collect();
    let Model::TimoshenkoBeam(beam) = &mut case.model;
    let e = beam.youngs_modulus;
    let mut fine = positive(e, "youngs_modulus", path.key("youngs_modulus"), faults);
    let shear = shear_modulus(beam, &path, faults);
    let law = bond_law::find(&beam.bond_law);
    if law.is_none() {
        faults
            .error(path.key("bond_law"), format!("there is no bond law `{}`", beam.bond_law))
            .hint(suggest(&beam.bond_law, bond_law::TABLE.iter().map(|l| l.name)));
    }
    let treatment = treatment(beam, &grids, &path, faults);
    let nu = beam.poisson_ratio.or(shear.map(|g| e / (2.0 * g) - 1.0)).unwrap_or(0.0);
    let section = match beam.section.properties(beam.shear_correction, nu) {
        Ok(section) => Some(section),
        Err(error) => {
            section_fault(beam, &error, &path, faults);
            None
        }
    };
    fine &= law.is_some() && treatment.is_some();
    let (section, g, law, end_treatment) = (section?, shear?, law?, treatment?);
    let parameters = BeamParameters { volume_factor: beam.volume_factor, bond_law: law, end_treatment };
    let (bending, shear) = (e * section.second_moment, section.kappa * g * section.area);
    let stiffness = SectionStiffness::uniform(bending, shear, e * section.area, section.area);
    if fine && !faults.has_errors() && !((bending * shear).is_normal() && bending.is_normal()) {
        faults
            .error(path.clone(), "the stiffnesses EI and κGA do not fit into double precision")
            .hint(format!("EI = {bending:e}, κGA = {shear:e}; choose units in which they are moderate"));
    }
    fine.then_some((parameters, stiffness, section))
}

fn shear_modulus(beam: &Beam, path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    match (beam.poisson_ratio, beam.shear_modulus) {
        (Some(_), Some(_)) => {
            faults
                .error(path.key("shear_modulus"), "`poisson_ratio` and `shear_modulus` are both given")
                .hint("for an isotropic material one follows from the other: remove one");
            None
        }
        (None, None) => {
            faults
                .error(path.clone(), "`poisson_ratio` is missing")
                .hint("give `poisson_ratio`, or `shear_modulus` for a material that is not isotropic");
            None
        }
        (Some(nu), None) if nu > -1.0 && nu <= 0.5 => Some(beam.youngs_modulus / (2.0 * (1.0 + nu))),
        (Some(nu), None) => {
            faults
                .error(
                    path.key("poisson_ratio"),
                    format!("`poisson_ratio` must be above -1 and at most 0.5, found {nu}"),
                )
                .hint("steel has 0.3, aluminium 0.33, concrete 0.2");
            None
        }
        (None, Some(g)) => positive(g, "shear_modulus", path.key("shear_modulus"), faults).then_some(g),
    }
}

fn section_fault(beam: &Beam, error: &SectionError, path: &JsonPath, faults: &mut Faults) {
    let shape = serde_json::to_value(beam.section).ok();
    let shape = shape.as_ref().and_then(|v| v.as_object()?.keys().next().cloned()).unwrap_or_default();
    let place = match error {
        SectionError::NotPositive { name: "shear_correction", .. } | SectionError::NoCowper => {
            path.key("shear_correction")
        }
        SectionError::NotPositive { name, .. } | SectionError::DoesNotFit { name, .. } => {
            path.key("section").key(shape).key(*name)
        }
    };
    let fault = faults.error(place, error.to_string());
    if *error == SectionError::NoCowper {
        fault.hint("leave `shear_correction` out: the section gives its own `kappa`");
    }
}

fn treatment(
    beam: &mut Beam,
    grids: &[Grid],
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<&'static EndTreatment> {
    let on_cells = grids.contains(&Grid::Cells);
    let default = if on_cells { "ghost" } else { "cover" };
    let name = beam.end_treatment.get_or_insert_with(|| default.into());
    let Some(treatment) = end_treatment::find(name) else {
        faults
            .error(path.key("end_treatment"), format!("there is no end treatment `{name}`"))
            .hint(suggest(name, end_treatment::TABLE.iter().map(|t| t.name)));
        return None;
    };
    if on_cells && treatment.covers() {
        faults
            .error(
                path.key("end_treatment"),
                "the end treatment `cover` needs points on the ends of the beam",
            )
            .hint("use the grid `nodes`, or the treatment `ghost` or `image` with `cells`");
        return None;
    }
    Some(treatment)
}
