//! Material, section and calibration of a scene.

use super::member_material;
use super::model_path::beam_path;
use super::section::{Resolved, stiffness};
use crate::case::{Body, Case, Frame, Member};
use crate::diagnostic::root;
use crate::diagnostic::{Faults, JsonPath, suggest};
use crate::model::Beam;
use peristat_assembly::model::timoshenko_beam::{
    BeamParameters, Grid,
    bond_law::{self, BondLaw},
    end_treatment::{self, EndTreatment},
};

/// The default: the bond law whose bonds are the exact elements of their spans.
const EXACT: &str = "exact";

/// Calibration, and the sections of every line of the body, filling in the defaults of the model.
pub(super) fn material(
    case: &Case,
    beam: &mut Beam,
    faults: &mut Faults,
) -> Option<(BeamParameters, Vec<Resolved>)> {
    let path = beam_path();
    let lines = case.body.lines();
    let grids: Vec<Grid> = lines.iter().map(|l| l.grid).collect();
    let graded = lines.iter().any(|l| l.grading.is_some());
    if beam.stiffness.is_none() {
        beam.shear_correction.get_or_insert_default();
    }
    let sections: Option<Vec<Resolved>> = match &case.body {
        Body::Frame(frame) => of_members(beam, frame, case, &path, faults),
        _ => lines
            .iter()
            .map(|l| stiffness(beam, case.units, usable(l.length), &path, &path, faults))
            .collect(),
    };
    let peculiarity = sections.iter().flatten().find_map(Resolved::peculiarity);
    let law = law(beam, peculiarity, &path, faults);
    // A frame says itself what its ends need.
    let on_lines = !matches!(case.body, Body::Frame(_));
    let treatment = treatment(beam, &grids, peculiarity.filter(|_| on_lines), graded, &path, faults);
    let volume_factor = beam.volume_factor;
    let (bond_law, end_treatment) = law.zip(treatment)?;
    Some((BeamParameters { volume_factor, bond_law, end_treatment }, sections?))
}

/// A length to go on with: one that cannot be gets its fault where the grid is laid out.
fn usable(length: f64) -> f64 {
    if length > 0.0 && length.is_finite() { length } else { 1.0 }
}

/// Sections of the members of a frame.
fn of_members(
    beam: &Beam,
    frame: &Frame,
    case: &Case,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Vec<Resolved>> {
    let before = faults.errors();
    member_material::check(case, frame, beam, faults);
    if faults.errors() > before {
        return None;
    }
    let of = |(k, member): (usize, &Member)| {
        let length = usable(frame.ends(member).map_or(1.0, |[a, b]| (b[0] - a[0]).hypot(b[1] - a[1])));
        let own_section = with_own_section(beam, member);
        let own_path = root("body").key("frame").key("members").index(k);
        let own = if own_section.is_some() { &own_path } else { path };
        match own_section.or_else(|| member_material::has_moduli(case, &member.name).then(|| beam.clone())) {
            None => stiffness(beam, case.units, length, path, path, faults),
            Some(mut beam) => {
                member_material::apply(case, &member.name, &mut beam);
                stiffness(&beam, case.units, length, path, own, faults)
            }
        }
    };
    let all: Vec<Option<Resolved>> = frame.members.iter().enumerate().map(of).collect();
    all.into_iter().collect()
}

/// The beam with the section of a member, where that has one of its own.
fn with_own_section(beam: &Beam, member: &Member) -> Option<Beam> {
    let (section, end_section, given) = (member.section, member.end_section, member.stiffness.clone());
    if section.is_none() && end_section.is_none() && given.is_none() {
        return None;
    }
    let mut beam = Beam { power_law: None, end_section, ..beam.clone() };
    if given.is_some() {
        // Moduli are for members of given shape.
        (beam.youngs_modulus, beam.poisson_ratio, beam.shear_modulus) = (None, None, None);
        beam.shear_correction = None;
    }
    if given.is_some() || section.is_some() {
        (beam.section, beam.stiffness) = (section, given);
    }
    Some(beam)
}

/// The bond law; `peculiarity` says in words what sets the sections apart from uniform ones.
fn law(
    beam: &mut Beam,
    peculiarity: Option<&str>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<&'static BondLaw> {
    let name = beam.bond_law.get_or_insert_with(|| EXACT.into()).as_str();
    let Some(law) = bond_law::find(name) else {
        faults
            .error(path.key("bond_law"), format!("there is no bond law `{name}`"))
            .hint(suggest(name, bond_law::TABLE.iter().map(|l| l.name)));
        return None;
    };
    if let Some(peculiarity) = peculiarity.filter(|_| law.name != EXACT) {
        faults
            .error(
                path.key("bond_law"),
                format!("the bond law `{name}` is for uniform sections, and this one {peculiarity}"),
            )
            .hint(
                "use `exact`: a bond over such a section is the exact element of its span; `corrected` and `published` have one shear stiffness for all bonds",
            );
        return None;
    }
    Some(law)
}

/// The end treatment; `graded` says whether some grid is.
fn treatment(
    beam: &mut Beam,
    grids: &[Grid],
    peculiarity: Option<&str>,
    graded: bool,
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
    let obstacle = match (peculiarity, graded) {
        (Some(peculiarity), _) => format!("this section {peculiarity}"),
        (None, true) => "this grid is graded".into(),
        (None, false) => return Some(treatment),
    };
    if on_cells {
        // A graded grid of cells is refused as a grid.
        if peculiarity.is_some() {
            faults
                .error(
                    root("body"),
                    format!("a grid of cells needs bonds beyond its ends, for uniform sections only, and {obstacle}"),
                )
                .hint("use the grid `nodes`");
        }
        return None;
    }
    if !treatment.covers() {
        faults
            .error(
                path.key("end_treatment"),
                format!("the end treatment `{name}` is for uniform sections and grids, and {obstacle}"),
            )
            .hint("use `cover`: it needs no bond beyond the end");
        return None;
    }
    Some(treatment)
}
