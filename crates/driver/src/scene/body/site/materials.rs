//! Materials of regions: which points they have, and whether the model knows them.

use super::ground::Ground;
use super::model_inputs::ModelInputs;
use crate::diagnostic::{Faults, JsonPath, positive, root};
use crate::model::{Mixture, OtherMaterial};
use peristat_assembly::body::{PointBody, SquareLattice, plus};

/// The materials of a case; faults of those that are none.
pub(crate) fn mixture(ground: &Ground, inputs: &ModelInputs, faults: &mut Faults) -> Mixture {
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
        faults
            .error(root("materials"), "listed points and meshes have one material")
            .hint("several materials need a body that fills a lattice, such as a `rectangle` or an `outline`");
        return Mixture::default();
    }
    refuse_beside(ground, faults);
    let mut mixture = Mixture { others: Vec::new(), numbers: vec![0; inputs.body.points()] };
    for (name, given) in &case.materials {
        let path = root("materials").key(name);
        check(given.youngs_modulus, takes, &path, faults);
        let at = ground.region(&given.at, &path.key("at"), faults).unwrap_or_default();
        mixture.others.push(OtherMaterial { name: name.clone(), youngs_modulus: given.youngs_modulus });
        let number = mixture.others.len() as u32;
        let taken = at.iter().find_map(|&p| mixture.of(p as usize)).map(|other| other.name.clone());
        if let Some(other) = taken {
            faults
                .error(path.key("at"), format!("some of its points are of `{other}` already"))
                .hint("a point has one material: let regions not overlap");
        }
        at.into_iter().for_each(|p| mixture.numbers[p as usize] = number);
    }
    mixture
}

/// Adds a fault for every key beside `materials` that knows one material alone.
fn refuse_beside(ground: &Ground, faults: &mut Faults) {
    let case = ground.case;
    let keys = [
        ("fracture", case.fracture.is_some(), "bodies of several materials do not break yet"),
        ("path", case.path.is_some(), "bonds of several materials do not soften yet"),
        ("stress_intensity", !case.stress_intensity.is_empty(), "stress intensities are of one material"),
    ];
    for (key, _, why) in keys.into_iter().filter(|key| key.1) {
        faults.error(root(key), why).hint(format!("leave out `{key}` or `materials`"));
    }
}

/// Checks the numbers of a material of which a model takes some.
fn check(youngs_modulus: Option<f64>, takes: &[&str], path: &JsonPath, faults: &mut Faults) {
    let Some(modulus) = youngs_modulus else { return };
    let key = "youngs_modulus";
    if !takes.contains(&key) {
        let all: Vec<String> = takes.iter().map(|key| format!("`{key}`")).collect();
        faults
            .error(path.key(key), format!("`{key}` is the same in all materials of this model"))
            .hint(format!("its materials differ in {}", all.join(", ")));
        return;
    }
    positive(modulus, key, path.key(key), faults);
}

/// Warns of materials that are nowhere as wide as bonds reach.
pub(crate) fn warn_of_thin(inputs: &ModelInputs, faults: &mut Faults) {
    let PointBody::Lattice(lattice) = &inputs.body else { return };
    let rows = inputs.material.about().horizon_ratio as i32;
    for (k, other) in inputs.materials.others.iter().enumerate() {
        let is_own = |point: &usize| inputs.materials.numbers[*point] == k as u32 + 1;
        let own: Vec<usize> = (0..lattice.points()).filter(is_own).collect();
        let is_wide = |&point: &usize| {
            [[1, 0, 0], [0, 1, 0]].iter().all(|step| width(inputs, lattice, point, *step, rows) >= rows)
        };
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
