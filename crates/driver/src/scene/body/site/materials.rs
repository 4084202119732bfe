//! Materials of regions: which points they have, and whether the model knows them.

use super::ground::Ground;
use super::model_inputs::ModelInputs;
use super::modulus;
use crate::case::{Case, Expansion, Modulus, RegionMaterial};
use crate::diagnostic::{Faults, JsonPath, fibre_angle, positive, root};
use crate::input::Folder;
use crate::memory;
use crate::model::{Mixture, OtherMaterial, admissible};
use crate::scene::expansion;
use peristat_assembly::body::{SquareLattice, minus, plus};
use peristat_assembly::model::plane::Edges;
use std::collections::BTreeSet;

/// Memory of an offset of a stretch of a row whose bonds reach other fibres, bytes: three factors of two sides of 64 points.
const OF_STRETCH: f64 = 3072.0;
/// Memory of a bond with a factor of its own, bytes, while it is made and on coarser lattices.
const OWN: f64 = 65.0;

/// The materials of a case; faults of those that are none.
pub(crate) fn mixture(
    ground: &Ground,
    inputs: &ModelInputs,
    (folder, max_memory): (&Folder, Option<u64>),
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
    let numbers = numbers(ground, inputs.body.points(), faults);
    let mut mixture = Mixture { others: Vec::new(), factors: vec![1.0; numbers.len()], numbers };
    for ((name, given), number) in case.materials.iter().zip(1..) {
        let path = root("materials").key(name);
        let own = |p: &u32| mixture.numbers[*p as usize] == number;
        let points: Vec<u32> = (0..mixture.numbers.len() as u32).filter(own).collect();
        check(given, &takes, &path, faults);
        if let Some(own) = given.thermal_expansion.filter(|_| inputs.material.fibres().is_none()) {
            expansion::is_one(own, &path.key("thermal_expansion"), faults);
        }
        check_fibre_angle(given, (case, &takes), &path, faults);
        if case.fracture.is_none() {
            refuse_unbroken(given, &path, faults);
        }
        let mut other = OtherMaterial {
            name: name.clone(),
            youngs_modulus: None,
            poisson_ratio: given.poisson_ratio,
            shear_modulus: None,
            stiffness_factor: None,
            fibre_angle: given.fibre_angle,
            thermal_expansion: given.thermal_expansion.map(Expansion::along_and_across),
            density: given.density.filter(|own| positive(*own, "density", path.key("density"), faults)),
        };
        if let Some((key, base)) = takes.first().copied()
            && let (of, Some(modulus)) = modulus_of(key, given, &mut other)
        {
            let (at, of_case) = ((&inputs.body, &points[..]), (folder, max_memory));
            let all = modulus::values(modulus, at, (key, base), &path.key(key), of_case, faults);
            let all = all.unwrap_or_default();
            *of = extremes(&all);
            points.iter().zip(all).for_each(|(p, value)| mixture.factors[*p as usize] = value / base);
        }
        mixture.others.push(other);
    }
    // Every bond of another stiffness has a factor of its own; those of other fibres have a table.
    let offsets = inputs.material.offsets().map_or(0, |offsets| offsets.len());
    let has_factors = |p: &usize| {
        mixture.factors[*p] != 1.0 || mixture.of(*p).is_some_and(|other| other.poisson_ratio.is_some())
    };
    let others = (0..mixture.numbers.len()).filter(has_factors).count();
    let beside = OF_STRETCH * (offsets * stretches_beside(inputs, &mixture)) as f64;
    let what = ("bonds of other materials", "use a larger spacing or smaller regions");
    memory::fits(OWN * (offsets * others) as f64 + beside, what, max_memory, root("materials"), faults);
    mixture
}

/// How many stretches of a row, of 64 points at most, have points from which bonds reach another lamina.
fn stretches_beside(inputs: &ModelInputs, mixture: &Mixture) -> usize {
    let Some(lattice) = inputs.body.cells().filter(|_| mixture.fibre_angles().len() > 1) else { return 0 };
    let reach = inputs.material.about().horizon_ratio as i32;
    let directions = [[1, 0], [0, 1], [1, 1], [1, -1]];
    let is_beside = |point: usize| {
        let (cell, own) = (lattice.cell(point), mixture.fibre_angle(point));
        let steps = (1..=reach).flat_map(|k| directions.map(|[a, b]| [k * a, k * b, 0]));
        let mut others = steps.flat_map(|step| [plus(cell, step), minus(cell, step)]);
        others.any(|cell| lattice.number(cell).is_some_and(|other| mixture.fibre_angle(other) != own))
    };
    let of = |point: usize| {
        let [i, j, _] = lattice.cell(point);
        [j, i.div_euclid(64)]
    };
    let found: BTreeSet<[i32; 2]> = (0..lattice.points()).filter(|point| is_beside(*point)).map(of).collect();
    found.len()
}

/// The modulus of a key that a material gives, and where its extremes belong.
fn modulus_of<'a>(
    key: &str,
    given: &'a RegionMaterial,
    other: &'a mut OtherMaterial,
) -> (&'a mut Option<[f64; 2]>, Option<&'a Modulus>) {
    match key {
        "shear_modulus" => (&mut other.shear_modulus, given.shear_modulus.as_ref()),
        "stiffness_factor" => (&mut other.stiffness_factor, given.stiffness_factor.as_ref()),
        _ => (&mut other.youngs_modulus, given.youngs_modulus.as_ref()),
    }
}

/// The least and the greatest of some values, where there are any.
fn extremes(values: &[f64]) -> Option<[f64; 2]> {
    let best = |of: fn(f64, f64) -> f64| values.iter().copied().reduce(of);
    Some([best(f64::min)?, best(f64::max)?])
}

/// Per point the number of its material; faults of points that have two.
fn numbers(ground: &Ground, points: usize, faults: &mut Faults) -> Vec<u32> {
    let materials = &ground.case.materials;
    let name = |number: u32| materials.keys().nth(number as usize - 1).map_or("", String::as_str);
    let mut numbers = vec![0; points];
    let mut rest: Option<u32> = None;
    for ((own, given), number) in materials.iter().zip(1..) {
        let path = root("materials").key(own);
        let Some(at) = &given.at else {
            if let Some(other) = rest.replace(number) {
                faults
                    .error(
                        path,
                        format!(
                            "`{own}` and `{}` are both of all that no other material claims",
                            name(other)
                        ),
                    )
                    .hint("say `at` which region one of them is");
            }
            continue;
        };
        let points = ground.region(at, &path.key("at"), faults).unwrap_or_default();
        if let Some(p) = points.iter().find(|p| numbers[**p as usize] > 0) {
            let other = name(numbers[*p as usize]);
            faults
                .error(path.key("at"), format!("some of its points are of `{other}` already"))
                .hint("a point has one material: let regions not overlap");
            break;
        }
        points.into_iter().for_each(|p| numbers[p as usize] = number);
    }
    if let Some(rest) = rest {
        if numbers.iter().all(|number| *number > 0) {
            let message = format!("other materials claim all points, and leave none to `{}`", name(rest));
            faults
                .error(root("materials").key(name(rest)), message)
                .hint("leave it out, or say `at` where it is");
        }
        numbers.iter_mut().filter(|number| **number == 0).for_each(|number| *number = rest);
    }
    numbers
}

/// Adds a fault for every key beside `materials` that knows one material alone.
fn refuse_beside(ground: &Ground, inputs: &ModelInputs, faults: &mut Faults) {
    let case = ground.case;
    let breaks = inputs.material.crossing_bonds().is_some();
    let keys = [
        (
            "fracture",
            case.fracture.is_some() && !breaks,
            "bodies of several materials do not break in this model",
        ),
        ("path", case.path.is_some(), "bonds of several materials do not soften yet"),
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

/// Adds a fault for an angle of fibres that is none, and for one in a body that breaks.
fn check_fibre_angle(
    given: &RegionMaterial,
    (case, takes): (&Case, &[(&'static str, f64)]),
    path: &JsonPath,
    faults: &mut Faults,
) {
    let Some(angle) = given.fibre_angle else { return };
    let path = path.key("fibre_angle");
    fibre_angle(angle, path.clone(), faults);
    let is_other = takes.iter().any(|(key, base)| *key == "fibre_angle" && (angle - base) % 180.0 != 0.0);
    if case.fracture.is_some() && is_other {
        faults
            .error(path, "bodies whose fibres run at several angles do not break")
            .hint("remove it, or leave out `fracture`");
    }
}

/// Adds a fault for every key of a material in which those of the model do not differ, and for a Poisson's ratio that is none.
fn check(given: &RegionMaterial, takes: &[(&'static str, f64)], path: &JsonPath, faults: &mut Faults) {
    let keys = [
        ("youngs_modulus", given.youngs_modulus.is_some()),
        ("poisson_ratio", given.poisson_ratio.is_some()),
        ("shear_modulus", given.shear_modulus.is_some()),
        ("stiffness_factor", given.stiffness_factor.is_some()),
        ("fibre_angle", given.fibre_angle.is_some()),
    ];
    for (key, _) in keys.into_iter().filter(|key| key.1) {
        if takes.iter().all(|of| of.0 != key) {
            let all: Vec<String> = takes.iter().map(|of| format!("`{}`", of.0)).collect();
            faults
                .error(path.key(key), format!("`{key}` is nothing that materials of this model differ in"))
                .hint(format!("they differ in {}", all.join(", ")));
        } else if let Some(ratio) = given.poisson_ratio.filter(|_| key == "poisson_ratio") {
            admissible(ratio, path, faults);
        }
    }
}

/// Warns of materials that are nowhere as wide as bonds reach, and of families in the plane that pass an interface.
pub(crate) fn warn(inputs: &ModelInputs, faults: &mut Faults) {
    let Some(lattice) = inputs.body.cells() else { return };
    let axes = &[[1, 0, 0], [0, 1, 0], [0, 0, 1]][..inputs.body.axes()];
    let rows = inputs.material.about().horizon_ratio as i32;
    let numbers = &inputs.materials.numbers;
    let has_interface = numbers.iter().any(|number| *number != numbers[0]);
    if has_interface && inputs.material.about().has_families && lattice.is_plane() {
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
    let about = inputs.material.about();
    if about.edges == Some(Edges::Overlay) && inputs.materials.fibre_angles().len() > 1 {
        faults
            .warning(
                root("model"),
                "with the edges `overlay` sides are held as fibres of the model ask, also where theirs run otherwise",
            )
            .hint("leave out `edges`: `border` holds all of them exactly");
    }
    for (k, other) in inputs.materials.others.iter().enumerate() {
        let is_own = |point: &usize| numbers[*point] == k as u32 + 1;
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
