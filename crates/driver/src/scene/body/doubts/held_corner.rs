//! Doubts about stresses in corners where an edge that is held on its line meets a free one, and points near edges are
//! completed by triangles.
//!
//! The shares with which an edge is held are those of a row far from its ends, and the rows at a free edge need others: what
//! holds them is 1 % off along the free edge and 4 to 5 % in the corner, on any grid. Tractions have no such error. An edge held in
//! both directions has infinite stresses in its corners in theory: what is read there is a matter of the grid alone.

use crate::case::Load;
use crate::diagnostic::{Faults, root};
use crate::scene::ExpectationKind;
use crate::scene::body::read::probes::Quantity;
use crate::scene::body::scene::BodyScene;
use crate::scene::body::site::held_angle::is_at;
use peristat_assembly::body::Edge;
use peristat_assembly::model::plane::Edges;

/// Adds a warning if a stress or strain is asked for in such a corner.
pub(crate) fn warn(scene: &BodyScene, faults: &mut Faults) {
    let is_lattice = scene.model.lattice().is_some_and(|(lattice, _)| !lattice.is_turned());
    if !scene.material().about().is_exact_at_edges || !is_lattice || has_one_stress(scene) {
        return;
    }
    let found = corners(scene).into_iter().find_map(|corner| Some((asked(scene, corner.at)?, corner)));
    let Some((reader, Corner { held, is_clamped, .. })) = found else { return };
    let (is, costs, hint) = match is_clamped {
        false => (
            "held",
            "they are up to 5 % off within a horizon of the corner, 1 % along the free edge",
            "load the edge by a traction, which is exact, or read stresses a horizon away from edges",
        ),
        true => (
            "clamped",
            "in theory they are infinite in this corner, so the value is a matter of the spacing",
            "read stresses away from the corner, or hold the edge across its line only, with one point held along it",
        ),
    };
    faults
        .warning(
            root("supports"),
            format!("{reader} reads stresses where the {is} edge `{held}` meets a free one: {costs}"),
        )
        .hint(hint);
}

/// Where an edge that is held meets a free one.
struct Corner<'a> {
    at: [f64; 2],
    /// Name of the edge that is held.
    held: &'a str,
    /// Whether it is held in both directions.
    is_clamped: bool,
}

/// Whether tractions alone act, which have one stress in all of the body: that is exact beside what is held, too.
fn has_one_stress(scene: &BodyScene) -> bool {
    let (case, rests) = (&scene.case, |hold: &crate::scene::body::hold::held_points::HeldPoints| {
        hold.values.iter().all(|value| *value == 0.0)
    });
    let mut loads = case.loads.iter().chain(case.load_cases.iter().flat_map(|c| &c.loads));
    let one = scene.load_cases.iter().all(|loads| loads.carry_ends);
    one && scene.conditions.holds.iter().all(rests) && loads.all(|load| matches!(load, Load::Traction(_)))
}

/// The ends of edges that are held and that are ends of free edges, too.
fn corners(scene: &BodyScene) -> Vec<Corner<'_>> {
    let Some(outline) = scene.outline() else { return Vec::new() };
    let named =
        |edge: &Edge| scene.case.supports.iter().filter(|s| is_at(&s.at, edge, outline)).collect::<Vec<_>>();
    let symmetry = &scene.inputs.symmetry;
    // Where bonds end on the border, so do the points that hold an edge.
    let is_exact = scene.model.edges() == Some(Edges::Border);
    let is_free =
        |edge: &Edge| named(edge).is_empty() && !symmetry.replaces(&edge.name) && !symmetry.joins(&edge.name);
    let mut corners = Vec::new();
    for edge in outline.edges() {
        let holds = named(edge);
        let [x, y] = [holds.iter().any(|s| s.ux.is_some()), holds.iter().any(|s| s.uy.is_some())];
        let is_aligned = edge.normal.iter().any(|n| n.abs() > 1.0 - 1e-12);
        if !(x || y) || !is_aligned || (is_exact && x != y) {
            continue;
        }
        for end in [edge.from, edge.to] {
            let meets = |other: &&Edge| other.name != edge.name && (other.from == end || other.to == end);
            if outline.edges().iter().filter(meets).any(is_free) {
                corners.push(Corner { at: end, held: &edge.name, is_clamped: x && y });
            }
        }
    }
    corners
}

/// What reads stresses or strains within a horizon of a place, in words.
fn asked(scene: &BodyScene, [x, y]: [f64; 2]) -> Option<String> {
    let reach = scene.horizon() * (1.0 + 1e-9);
    let is_near = |at: [f64; 3]| (at[0] - x).abs() <= reach && (at[1] - y).abs() <= reach;
    let by_probe = scene.probes.iter().find(|probe| {
        if !probe.is_recovered() {
            return false;
        }
        match &probe.quantity {
            // Means and integrals have a limit.
            Quantity::Reduced { of, .. } if !of.is_extreme() => false,
            Quantity::Reduced { points: Some(points), .. } => {
                points.iter().any(|&p| is_near(scene.body().position(p as usize)))
            }
            Quantity::Reduced { points: None, .. } => true,
            _ => probe.position.is_some_and(is_near),
        }
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
