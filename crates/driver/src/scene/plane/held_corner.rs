//! Doubts about stresses in corners where an edge that is held on its line meets a free one.
//!
//! The shares with which an edge is held are those of a row far from its ends, and the rows at a free edge need others: what
//! holds them is 1 % off along the free edge and 4 to 5 % in the corner, on any grid. Tractions have no such error. An edge held in
//! both directions has infinite stresses in its corners, so nothing is said there.

use super::super::ExpectationKind;
use super::{PlaneScene, Quantity, root};
use crate::case::Load;
use crate::diagnostic::Faults;
use peristat_assembly::body::Edge;

/// Adds a warning if a stress or strain is asked for in such a corner.
pub(super) fn warn(scene: &PlaneScene, faults: &mut Faults) {
    let is_lattice = scene.model.lattice().is_some_and(|(lattice, _)| !lattice.is_turned());
    if !scene.bonds().is_exact_at_edges() || !is_lattice || has_one_stress(scene) {
        return;
    }
    let Some((corner, held)) =
        corners(scene).into_iter().find_map(|(at, edge)| Some((asked(scene, at)?, edge)))
    else {
        return;
    };
    faults
        .warning(
            root("supports"),
            format!(
                "{corner} reads stresses where the held edge `{held}` meets a free one: they are up to 5 % off within a horizon of the corner, 1 % along the free edge"
            ),
        )
        .hint("load the edge by a traction, which is exact, or read stresses a horizon away from edges");
}

/// Whether tractions alone act, which have one stress in all of the body: that is exact beside what is held, too.
fn has_one_stress(scene: &PlaneScene) -> bool {
    let (case, rests) = (&scene.case, |hold: &super::HeldPoints| hold.value == 0.0);
    let mut loads = case.loads.iter().chain(case.load_cases.iter().flat_map(|c| &c.loads));
    let one = scene.load_cases.iter().all(|loads| loads.carry_ends);
    one && scene.conditions.holds.iter().all(rests) && loads.all(|load| matches!(load, Load::Traction(_)))
}

/// The ends of edges held in one direction that are ends of free edges, too, and the names of the held ones.
fn corners(scene: &PlaneScene) -> Vec<([f64; 2], &str)> {
    let Some(outline) = scene.outline() else { return Vec::new() };
    let named = |edge: &Edge| {
        scene.case.supports.iter().filter(|s| s.at.region.as_ref() == Some(&edge.name)).collect::<Vec<_>>()
    };
    let symmetry = &scene.recipe.symmetry;
    let is_free =
        |edge: &Edge| named(edge).is_empty() && !symmetry.replaces(&edge.name) && !symmetry.joins(&edge.name);
    let mut corners = Vec::new();
    for edge in outline.edges() {
        let holds = named(edge);
        let [x, y] = [holds.iter().any(|s| s.ux.is_some()), holds.iter().any(|s| s.uy.is_some())];
        let is_aligned = edge.normal.iter().any(|n| n.abs() > 1.0 - 1e-12);
        if x == y || !is_aligned {
            continue;
        }
        for end in [edge.from, edge.to] {
            let meets = |other: &&Edge| other.name != edge.name && (other.from == end || other.to == end);
            if outline.edges().iter().filter(meets).any(is_free) {
                corners.push((end, edge.name.as_str()));
            }
        }
    }
    corners
}

/// What reads stresses or strains within a horizon of a place, in words.
fn asked(scene: &PlaneScene, [x, y]: [f64; 2]) -> Option<String> {
    let reach = scene.horizon() * (1.0 + 1e-9);
    let is_near = |at: [f64; 2]| (at[0] - x).abs() <= reach && (at[1] - y).abs() <= reach;
    let by_probe = scene.probes.iter().find(|probe| {
        let of_stress = matches!(&probe.quantity, Quantity::Field { field, .. } if field.is_recovered());
        of_stress && probe.position.is_some_and(is_near)
    });
    let by_line =
        scene.lines.iter().find(|l| l.points.iter().any(|p| p.weights.is_some() && is_near(p.position)));
    let by_check = scene.expectations.iter().find(|e| match &e.kind {
        ExpectationKind::Points(points) => points.field.is_recovered(),
        _ => false,
    });
    let probe = by_probe.map(|p| format!("the probe `{}`", p.name));
    probe
        .or_else(|| by_line.map(|l| format!("the line `{}`", l.name)))
        .or_else(|| by_check.map(|e| format!("the check `{}`", e.name)))
}
