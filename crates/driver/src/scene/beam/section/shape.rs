//! Sections of a given shape and material.

use super::taper::{self, Taper};
use super::{Resolved, SectionAlong, scaled, shear_modulus};
use crate::diagnostic::{Faults, JsonPath, positive};
use crate::model::Beam;
use crate::units::Units;
use peristat_assembly::material::{Profile, Section, SectionError, SectionProperties, SectionStiffness};

/// A section with its lengths in the units of a case.
fn in_units(section: Section, units: Units, path: &JsonPath, faults: &mut Faults) -> Option<Section> {
    let Section::Rolled(rolled) = section else { return Some(section) };
    if units.millimetre().is_none() {
        faults
            .error(path.key("rolled"), format!("`{}` has millimetres, and this case no units", rolled.name()))
            .hint("set `units` to \"mm-N-MPa\" or \"m-N-Pa\"");
    }
    units.millimetre().map(|millimetre| rolled.section(millimetre))
}

/// Sections of a shape, which may vary linearly to that at the end.
pub(super) fn resolve(
    beam: &Beam,
    units: Units,
    section: Section,
    length: f64,
    [path, own]: [&JsonPath; 2],
    faults: &mut Faults,
) -> Option<Resolved> {
    let section = in_units(section, units, &own.key("section"), faults);
    let end_section = beam.end_section.map(|end| in_units(end, units, &own.key("end_section"), faults));
    let (section, end_section) = (section?, end_section.map_or(Some(None), |end| end.map(Some))?);
    let e = match beam.youngs_modulus {
        Some(e) => positive(e, "youngs_modulus", path.key("youngs_modulus"), faults).then_some(e),
        None => {
            faults
                .error(path.clone(), "`youngs_modulus` is missing")
                .hint("a section of given shape needs the modulus of its material");
            None
        }
    };
    let g = shear_modulus(beam, e, path, faults);
    let nu = beam.poisson_ratio.or(e.zip(g).map(|(e, g)| e / (2.0 * g) - 1.0)).unwrap_or(0.0);
    let correction = beam.shear_correction.unwrap_or_default();
    let mut properties = |section: Section, key: &str| {
        let found = section.properties(correction, nu);
        found.map_err(|error| section_fault(section, key, &error, [path, own], faults)).ok()
    };
    let start = properties(section, "section");
    let taper = match end_section {
        None => start.map(|s| Taper::uniform(&s)),
        Some(end) if end == section => start.map(|s| Taper::uniform(&s)),
        Some(end) => {
            let end_properties = properties(end, "end_section");
            if let (Some(start), Some(end)) = (&start, &end_properties) {
                check_ends([start, end], own, faults);
            }
            let taper = Taper::between(section, end, length, own, correction, faults);
            start.zip(end_properties).and(taper)
        }
    };
    let (start, taper, e, g) = (start?, taper?, e?, g?);
    let times = |profile: &Profile, factor: f64| scaled(profile, factor);
    let stiffness = SectionStiffness {
        bending: times(&taper.second_moment, e),
        shear: times(&taper.area, start.kappa * g),
        axial: times(&taper.area, e),
        coupling: Profile::Uniform(0.0),
        area: start.area,
    };
    let section = SectionAlong {
        area: Some(taper.area),
        second_moment: Some(taper.second_moment),
        height: taper.height,
        kappa: Some(start.kappa),
    };
    Some(Resolved { stiffness, section, has_axial: true })
}

/// A second moment of area is a polynomial along the line: at an end that is next to nothing only its rounding is left.
fn check_ends(ends: [&SectionProperties; 2], own: &JsonPath, faults: &mut Faults) {
    const LEAST: f64 = 1e-10;
    let [a, b] = ends.map(|section| section.second_moment);
    let part = a.min(b) / a.max(b);
    if part < LEAST {
        faults
            .error(
                own.key("end_section"),
                format!("the second moment of area at one end is {part:.1e} of that at the other"),
            )
            .hint("below 1e-10 nothing but rounding is left; end at a hundredth of the height");
    }
}

fn section_fault(
    section: Section,
    key: &str,
    error: &SectionError,
    [path, own]: [&JsonPath; 2],
    faults: &mut Faults,
) {
    let place = match error {
        SectionError::NotPositive { name: "shear_correction", .. } | SectionError::NoCowper => {
            path.key("shear_correction")
        }
        SectionError::NotPositive { name, .. } | SectionError::DoesNotFit { name, .. } => {
            own.key(key).key(taper::shape(section)).key(*name)
        }
    };
    let fault = faults.error(place, error.to_string());
    if *error == SectionError::NoCowper {
        fault.hint("leave `shear_correction` out: the section gives its own `kappa`");
    }
}
