//! Fields and section forces of members.

use super::{Run, error};
use peristat::case::FieldName;
use serde_json::{Value, json};

/// A field at a real point of a member.
pub(crate) fn at(run: &Run, field: FieldName, member: usize, point: usize) -> f64 {
    run.states[0].value(field, member, point).expect("the field is there")
}

/// N, V, M at the two ends of a member, from inside it.
pub(crate) fn ends(run: &Run, member: usize) -> [[f64; 3]; 2] {
    let forces = run.states[0].lines[member].forces.as_ref().expect("recovered");
    let (first, last) = (0, forces.moment.len() - 1);
    [(first, 0), (last, 1)].map(|(cell, side)| {
        let axial = forces.axial.get(cell).map_or(0.0, |n| n[side]);
        [axial, forces.shear[cell][side], forces.moment[cell][side]]
    })
}

/// Largest difference of all section forces relative to the largest one.
pub(crate) fn difference(a: &[[[f64; 3]; 2]], b: &[[[f64; 3]; 2]]) -> f64 {
    let (a, b) = (a.as_flattened().as_flattened(), b.as_flattened().as_flattened());
    error(a, b)
}

/// The same of all members.
pub(crate) fn all_ends(run: &Run) -> Vec<[[f64; 3]; 2]> {
    (0..run.states[0].lines.len()).map(|m| ends(run, m)).collect()
}

/// Uniform stiffness as a case writes it.
pub(crate) fn stiffness(bending: f64, shear: f64, axial: f64) -> Value {
    json!({ "bending": { "uniform": bending }, "shear": { "uniform": shear }, "axial": { "uniform": axial } })
}

/// EI = 1, κGA = 50, EA = 200.
pub(crate) fn model(law: &str) -> Value {
    json!({ "timoshenko_beam": { "stiffness": stiffness(1.0, 50.0, 200.0), "bond_law": law } })
}
