//! Materials of regions: which points they have, and whether the model knows them.

use super::ground::Ground;
use super::model_inputs::ModelInputs;
use crate::case::RegionMaterial;
use crate::diagnostic::{Faults, JsonPath, positive, root, tidy};
use crate::memory;
use crate::model::{Mixture, OtherMaterial, admissible};
use peristat_assembly::body::{SquareLattice, plus};

/// How many times stiffer or softer than the base a material may be: beyond it forces of the one are rounding beside the other.
const MOST_RATIO: f64 = 1e9;

/// Memory of a bond with a factor of its own, bytes, while it is made and on coarser lattices.
const OWN: f64 = 65.0;

/// The materials of a case; faults of those that are none.
pub(crate) fn mixture(
    ground: &Ground,
    inputs: &ModelInputs,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Mixture {
    let case = ground.case;
    if case.materials.is_empty() {
        return Mixture::default();
    }
    let takes = match inputs.material.other_materials() {
        Ok(takes) => takes,
        Err((why, hint)) => {
            faults.error(root("materials"), why).hint(hint);
            return Mixture::default();
        }
    };
    if inputs.body.cells().is_none() {
        faults.error(root("materials"), "listed points and meshes have one material").hint(
            "several materials need a body that fills a lattice, such as a `rectangle` or an `outline`",
        );
        return Mixture::default();
    }
    refuse_beside(ground, inputs, faults);
    let mut mixture = Mixture { others: Vec::new(), numbers: vec![0; inputs.body.points()] };
    for (name, given) in &case.materials {
        let path = root("materials").key(name);
        let at = ground.region(&given.at, &path.key("at"), faults).unwrap_or_default();
        let RegionMaterial { youngs_modulus, poisson_ratio, shear_modulus, thermal_expansion, .. } = *given;
        let name = name.clone();
        let other = OtherMaterial { name, youngs_modulus, poisson_ratio, shear_modulus, thermal_expansion };
        check(&other, &takes, &path, faults);
        if case.fracture.is_none() {
            refuse_unbroken(given, &path, faults);
        }
        mixture.others.push(other);
        let number = mixture.others.len() as u32;
        let taken = at.iter().find_map(|&p| mixture.of(p as usize)).map(|other| other.name.clone());
        if let Some(other) = taken {
            faults
                .error(path.key("at"), format!("some of its points are of `{other}` already"))
                .hint("a point has one material: let regions not overlap");
            break;
        }
        at.into_iter().for_each(|p| mixture.numbers[p as usize] = number);
    }
    // Every bond of another material has a factor of its own.
    let offsets = inputs.material.offsets().map_or(0, |offsets| offsets.len());
    let others = mixture.numbers.iter().filter(|number| **number > 0).count();
    let what = ("bonds of other materials", "use a larger spacing or smaller regions");
    memory::fits(OWN * (offsets * others) as f64, what, max_memory, root("materials"), faults);
    mixture
}

/// Adds a fault for every key beside `materials` that knows one material alone.
fn refuse_beside(ground: &Ground, inputs: &ModelInputs, faults: &mut Faults) {
    let case = ground.case;
    let breaks = inputs.material.interface_factor([1.0; 2]).is_some();
    let keys = [
        (
            "fracture",
            case.fracture.is_some() && !breaks,
            "bodies of several materials do not break in this model",
        ),
        ("path", case.path.is_some(), "bonds of several materials do not soften yet"),
        ("density", case.density.is_some(), "the density is that of one material"),
        ("strengths", case.strengths.is_some(), "strengths are those of one material"),
        ("stress_intensity", !case.stress_intensity.is_empty(), "stress intensities are of one material"),
    ];
    for (key, _, why) in keys.into_iter().filter(|key| key.1) {
        faults.error(root(key), why).hint(format!("leave out `{key}` or `materials`"));
    }
}

/// Adds a fault for everything that a material says of how it breaks, in a body that does not.
fn refuse_unbroken(given: &RegionMaterial, path: &JsonPath, faults: &mut Faults) {
    let keys = [("critical", given.critical.is_some()), ("interface", given.interface.is_some())];
    for (key, _) in keys.into_iter().filter(|key| key.1) {
        let message = format!("`{key}` is for bodies that break, and this case has no `fracture`");
        faults.error(path.key(key), message).hint("give `fracture`, or remove it");
    }
}

/// Checks the numbers of a material of which a model takes some, with their values in the base material.
fn check(other: &OtherMaterial, takes: &[(&'static str, f64)], path: &JsonPath, faults: &mut Faults) {
    for (key, value) in other.keys() {
        let Some(value) = value else { continue };
        let Some((_, base)) = takes.iter().find(|of| of.0 == key) else {
            let all: Vec<String> = takes.iter().map(|of| format!("`{}`", of.0)).collect();
            faults
                .error(path.key(key), format!("`{key}` is nothing that materials of this model differ in"))
                .hint(format!("they differ in {}", all.join(", ")));
            continue;
        };
        if key == "poisson_ratio" {
            admissible(value, path, faults);
            continue;
        }
        let ratio = value / base;
        if positive(value, key, path.key(key), faults) && !(1.0 / MOST_RATIO..=MOST_RATIO).contains(&ratio) {
            faults
                .error(
                    path.key(key),
                    format!("it differs from that of `model` by more than a factor of {}", tidy(MOST_RATIO)),
                )
                .hint("leave voids out of the body, and hold what is rigid by `rigid`");
        }
    }
}

/// Warns of materials that are nowhere as wide as bonds reach, and of families in the plane that pass an interface.
pub(crate) fn warn(inputs: &ModelInputs, faults: &mut Faults) {
    let Some(lattice) = inputs.body.cells() else { return };
    let axes = &[[1, 0, 0], [0, 1, 0], [0, 0, 1]][..inputs.body.axes()];
    let rows = inputs.material.about().horizon_ratio as i32;
    if !inputs.materials.is_one() && inputs.material.about().has_families && lattice.is_plane() {
        faults
            .warning(
                root("materials"),
                "strains and stresses of families are off by some tenths in the rows beside interfaces",
            )
            .hint(format!(
                "read them {} rows away, or take a model of bonds, which has them there",
                rows + 1
            ));
    }
    for (k, other) in inputs.materials.others.iter().enumerate() {
        let is_own = |point: &usize| inputs.materials.numbers[*point] == k as u32 + 1;
        let own: Vec<usize> = (0..lattice.points()).filter(is_own).collect();
        let is_wide =
            |&point: &usize| axes.iter().all(|step| width(inputs, lattice, point, *step, rows) >= rows);
        if !own.is_empty() && !own.iter().any(is_wide) {
            faults
                .warning(
                    root("materials").key(&other.name).key("at"),
                    format!("`{}` is nowhere {rows} rows wide, as far as bonds reach", other.name),
                )
                .hint("use a smaller spacing: the moduli of layers of a row or two are off by some per cent");
        }
    }
}

/// How many points of one material follow each other through a point along a step, images among them; no more than it takes.
fn width(inputs: &ModelInputs, lattice: &SquareLattice, point: usize, step: [i32; 3], most: i32) -> i32 {
    let (mirrors, numbers) = (&inputs.symmetry.mirrors, &inputs.materials.numbers);
    let is_alike = |cell: [i32; 3]| {
        let cell = if mirrors.is_none() { cell } else { mirrors.image(cell).0 };
        lattice.number(cell).is_some_and(|other| numbers[other] == numbers[point])
    };
    let along = |sign: i32| {
        let at = |k: i32| plus(lattice.cell(point), step.map(|s| sign * k * s));
        (1..most).take_while(|&k| is_alike(at(k))).count() as i32
    };
    1 + along(1) + along(-1)
}
