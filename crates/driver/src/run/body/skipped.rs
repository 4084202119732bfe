//! What a body in the plane was spared, and why.

use crate::run::RunReport;
use crate::scene::body::BodyScene;
use peristat_assembly::model::plane::Edges;

/// What the scene was spared.
pub(super) fn skipped(scene: &BodyScene, report: &RunReport, recover: bool) -> Vec<String> {
    let (counters, model) = (&report.counters, &scene.model);
    let points = model.points();
    let mut skipped = Vec::new();
    if scene.path.is_none() {
        skipped.push(match scene.fracture {
            None => "Newton iterations: every term is linear".to_string(),
            Some(_) => "Newton iterations: between two breaks the body is linear in the load".into(),
        });
    }
    if model.component("phi").is_none() {
        skipped.push(format!("{points} rotations: bonds along their own direction read none"));
    }
    if model.lattice().is_some() && scene.path.is_none() {
        let bonds = report.sizes.bonds - model.completing() - scene.conditions.springs.len();
        skipped.push(match counters.stored_bond_factors {
            0 => format!("a list of {bonds} bonds and their factors: those of one offset of the lattice are alike"),
            stored => format!(
                "a list of {bonds} bonds: those of one offset are alike; {stored} factors are stored, where images, cracks and corrections make a difference"
            ),
        });
    }
    let (own, triangles) = (points - model.ghosts().len(), model.triangles());
    if model.edges() == Some(Edges::Border) {
        skipped.push(format!(
            "a treatment of edges at most of {own} points: bonds within the body are as they are"
        ));
    } else if triangles > 0 {
        skipped.push(format!(
            "triangles at most of {own} points: {triangles} of them replace all bonds that are missing"
        ));
    }
    if counters.right_hand_sides > counters.factorisations && scene.path.is_none() {
        let spared = counters.right_hand_sides - counters.factorisations;
        let s = if spared == 1 { "" } else { "s" };
        skipped.push(match scene.fracture {
            None => format!("{spared} factorisation{s}: the stiffness does not depend on the load"),
            Some(_) => format!("{spared} factorisation{s}: an old factor is a good preconditioner"),
        });
    }
    if !recover {
        skipped.push(format!(
            "stresses, strains and energy densities of {points} points: no output or check asks for them"
        ));
    } else if scene.cracks.is_empty() && !scene.case.is_traced() {
        skipped.push(format!("damage of {points} points: there are no cracks"));
    }
    skipped
}
