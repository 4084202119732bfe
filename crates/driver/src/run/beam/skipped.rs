//! What a beam was spared, and why.

use super::strain;
use crate::run::RunReport;
use crate::scene::beam::BeamScene;

/// Axial unknowns that nothing reads.
fn spared_axial(scene: &BeamScene) -> Option<String> {
    if !scene.has_axial {
        return Some("axial unknowns: no measure of a straight beam reads them".into());
    }
    let bars = scene.beam.chains().iter().filter(|c| c.stretches_as_bar()).count();
    (bars > 0).then(|| {
        "axial unknowns between the ends of members: without loads between them they stretch as bars".into()
    })
}

/// What the scene was spared.
pub(super) fn skipped(scene: &BeamScene, report: &RunReport, recover: bool) -> Vec<String> {
    let counters = &report.counters;
    let mut skipped = Vec::new();
    if scene.one_way.is_empty() {
        skipped.push("Newton iterations: every term is linear".to_string());
    }
    let is_uniform = scene.beam.chains().iter().all(|c| c.is_uniform());
    if is_uniform {
        skipped.push("bond geometry: bonds of one offset share it".into());
    }
    skipped.extend(spared_axial(scene));
    if is_uniform && counters.stored_bond_factors <= 64 * 64 * scene.beam.chains().len() {
        skipped.push("factors of interior bonds: the lattice is uniform".into());
    }
    if counters.right_hand_sides > counters.factorisations {
        let spared = counters.right_hand_sides - counters.factorisations;
        let s = if spared == 1 { "" } else { "s" };
        skipped.push(format!("{spared} factorisation{s}: the stiffness does not depend on the load"));
    }
    if counters.analyses == 0 {
        skipped.push("symbolic analysis: the stiffness is a band".into());
    }
    if report.solver.method == strain::METHOD {
        skipped.push("stiffness of the displacements and its factor: the unknowns are strains".into());
        if is_uniform {
            skipped.push("most columns of the factor: strains of equal cells have equal equations".into());
        }
        skipped.push("conjugate gradients: strains are well conditioned".into());
    }
    if !recover {
        skipped.push("section forces, stresses, energy densities: no output or check asks for them".into());
    } else if scene.sections.iter().all(|s| !s.has_stress()) {
        skipped.push("bending stresses: the section has no height, or no one modulus".into());
    }
    skipped
}
