//! Borders that meet a line of symmetry at a slant.
//!
//! Points beside the place where they meet move with the border on both sides of the line. So a part of what acts on one side is
//! taken by a point of the other one, and its image gives back as much: into the line goes twice that, beyond what points bear.

use super::on_border::OnBorder;
use crate::scene::Resultant;
use crate::scene::body::load::asked;
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::load::stress_field::StressField;
use crate::scene::body::load::sums::Forces;
use crate::scene::body::site::resultants;
use peristat_assembly::body::Outline;

/// A normal with less along a line is straight across it.
const STRAIGHT: f64 = 1e-9;

/// What a stress with some tractions, and what acts beyond it, do at once to the lines of symmetry that borders meet at a slant, by
/// images beyond them.
pub(crate) fn into_lines(
    (stress, beyond): (&StressField, &Forces),
    tractions: &[OnBorder],
    context: &LoadContext,
) -> Forces {
    let (Some(model), Some(outline)) = (context.model, context.ground.outline) else { return Vec::new() };
    let Some((lattice, mirrors)) = model.lattice() else { return Vec::new() };
    let slanted: Vec<(usize, u32)> = (0..2)
        .filter(|&axis| !mirrors.joined[axis])
        .filter_map(|axis| {
            let side = (0..2).find(|&side| {
                mirrors.lines[axis][side].is_some_and(|line| {
                    let at = lattice.corner()[axis] + f64::from(line) * lattice.spacing();
                    meets(outline, context, axis, at, lattice.spacing())
                })
            })?;
            let line = mirrors.lines[axis][side]?;
            let is_beyond = |ghost: &u32| match (side, lattice.cell(*ghost as usize)[axis]) {
                (0, k) => k < line,
                (_, k) => k >= line,
            };
            Some((axis, model.ghosts().iter().copied().find(is_beyond)?))
        })
        .collect();
    if slanted.is_empty() {
        return Vec::new();
    }
    let mut rest = Resultant::default();
    tractions.iter().for_each(|t| rest.add_multiple(1.0, &asked::of_traction(t, context)));
    let mut through = vec![0.0; model.components().len() * model.points()];
    stress.add_to(model, 1.0, &mut through);
    rest.add_multiple(-1.0, &resultants::resultant(model, context.material, &through));
    for (point, force) in beyond {
        let at = context.ground.body.position(*point as usize);
        resultants::add_force(context.material, &mut rest, force.map(|f| -f), at);
    }
    let alone = |axis: usize| [0, 1, 2].map(|k| if k == axis { rest.force()[k] } else { 0.0 });
    slanted.into_iter().map(|(axis, ghost)| (ghost, alone(axis))).collect()
}

/// Whether a border meets a line across an axis at a slant.
fn meets(outline: &Outline, context: &LoadContext, axis: usize, at: f64, spacing: f64) -> bool {
    outline.edges().iter().filter(|edge| !context.symmetry.replaces(&edge.name)).any(|edge| {
        let touches = [edge.from, edge.to].iter().any(|end| (end[axis] - at).abs() < 1e-6 * spacing);
        touches && edge.normal[axis].abs() > STRAIGHT
    })
}
