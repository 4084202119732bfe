//! Regions of a plate that are thicker or thinner than the rest, or of another material.

use crate::case::{Case, Modulus, RegionMaterial};
use crate::diagnostic::{Faults, JsonPath, root, tidy};
use crate::memory;
use crate::model::Bending;
use crate::scene::body::site::ground::Ground;
use crate::scene::expansion;
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::plate_bending::{CellSections, PlateSection};

/// How many times stiffer or softer in bending than the base a region may be: beyond it moments of the one are rounding beside the
/// other.
const MOST_RATIO: f64 = 1e9;
/// Memory of an offset at a point, of every part with a section, bytes: factors of its bonds.
const OWN: f64 = 16.0;

/// A region with a section of its own.
#[derive(Clone, Debug)]
pub struct PlateMaterial {
    /// Name.
    pub name: String,
    /// What the case would write for a plate that is all of it.
    pub keys: Bending,
    /// Its stiffness.
    pub section: PlateSection,
    /// Strain per kelvin, where it is other than that of the base.
    pub thermal_expansion: Option<f64>,
    /// How many cells are of it.
    pub cells: usize,
}

/// The regions of a case, and the sections of all cells.
pub(super) fn of(
    case: &Case,
    base: &Bending,
    (ground, cells): (&Ground, &SquareLattice),
    (horizon_ratio, max_memory): (f64, Option<u64>),
    faults: &mut Faults,
) -> (Vec<PlateMaterial>, CellSections) {
    let mut found = (Vec::new(), CellSections::default());
    if case.materials.is_empty() {
        return found;
    }
    let offsets = (2.0 * horizon_ratio + 1.0).powi(2) / 2.0;
    let bytes = OWN * offsets * (cells.points() * case.materials.len()) as f64;
    let what = ("bonds of several sections", "use a larger spacing or fewer materials");
    if !memory::fits(bytes, what, max_memory, root("materials"), faults) {
        return found;
    }
    let (materials, sections) = &mut found;
    sections.numbers = vec![0; cells.points()];
    for (name, given) in &case.materials {
        let path = root("materials").key(name);
        check_keys(given, &path, faults);
        let modulus = given.youngs_modulus.as_ref().and_then(Modulus::number);
        let keys = base.of_region(modulus, given.poisson_ratio, given.thickness);
        let parameters = keys.parameters_at(&path, horizon_ratio, faults);
        let own = region(given, ground, &path, faults);
        let (Some(parameters), Some(own)) = (parameters, own) else { continue };
        check_ratio(base, &parameters.section, &path, faults);
        sections.others.push(parameters.section);
        let number = sections.others.len() as u32;
        if let Some(&taken) = own.iter().find(|cell| sections.numbers[**cell as usize] > 0) {
            let taken: &PlateMaterial = &materials[sections.numbers[taken as usize] as usize - 1];
            faults
                .error(path.key("at"), format!("some of its cells are of `{}` already", taken.name))
                .hint("a cell has one material: let regions not overlap");
            break;
        }
        own.iter().for_each(|&cell| sections.numbers[cell as usize] = number);
        let thermal_expansion = given.thermal_expansion.filter(|given| {
            // One along and one across fibres is a fault.
            expansion::is_one(*given, &path.key("thermal_expansion"), faults)
        });
        let thermal_expansion = thermal_expansion.map(|given| given.along_and_across()[0]);
        let (name, section, cells) = (name.clone(), parameters.section, own.len());
        materials.push(PlateMaterial { name, keys, section, thermal_expansion, cells });
    }
    found
}

/// The cells with their middles in a region.
fn region(given: &RegionMaterial, ground: &Ground, path: &JsonPath, faults: &mut Faults) -> Option<Vec<u32>> {
    let Some(at) = &given.at else {
        faults
            .error(path.clone(), "`at` is missing")
            .hint("name the region that differs; all others are as `model` says");
        return None;
    };
    let before = faults.errors();
    let found = ground.region(at, &path.key("at"), faults);
    if found.is_none() && faults.errors() == before {
        faults
            .error(path.key("at"), format!("no cell has its middle in the region `{}`", &**at))
            .hint("use a larger region, or a smaller spacing");
    }
    found
}

fn check_keys(given: &RegionMaterial, path: &JsonPath, faults: &mut Faults) {
    let foreign = [
        ("shear_modulus", given.shear_modulus.is_some(), "that of a plate follows from its other moduli"),
        ("fibre_angle", given.fibre_angle.is_some(), "leave it out"),
        ("stiffness_factor", given.stiffness_factor.is_some(), "give the `youngs_modulus` of the region"),
        ("density", given.density.is_some(), "give the weight of a region as a `pressure` on it"),
        ("strengths", given.strengths.is_some(), "put a `limit` on a probe of `von_mises`, or of `M_1`"),
        ("critical", given.critical.is_some(), "all of a plate breaks by `fracture.critical`"),
        ("interface", given.interface.is_some(), "all of a plate breaks by `fracture.critical`"),
    ];
    for (key, _, hint) in foreign.iter().filter(|key| key.1) {
        let message = format!("`{key}` is nothing that regions of a plate in bending differ in");
        faults.error(path.key(*key), message).hint(*hint);
    }
    if given.youngs_modulus.as_ref().is_some_and(|modulus| modulus.number().is_none()) {
        faults
            .error(path.key("youngs_modulus"), "`youngs_modulus` of a plate in bending is a number")
            .hint("divide the plate into regions that have one each");
    }
    let is_base =
        given.thickness.is_none() && given.youngs_modulus.is_none() && given.poisson_ratio.is_none();
    if is_base && given.thermal_expansion.is_none() {
        faults
            .error(path.clone(), "this region is as `model` says")
            .hint("give its `thickness`, `youngs_modulus`, `poisson_ratio` or `thermal_expansion`");
    }
}

fn check_ratio(base: &Bending, section: &PlateSection, path: &JsonPath, faults: &mut Faults) {
    let ratio = section.bending / base.section().bending;
    if !(1.0 / MOST_RATIO..=MOST_RATIO).contains(&ratio) {
        faults
            .error(
                path.clone(),
                format!(
                    "it is stiffer in bending than the rest, or softer, by more than a factor of {}",
                    tidy(MOST_RATIO)
                ),
            )
            .hint("leave voids out of the plate, and hold what is rigid");
    }
}
