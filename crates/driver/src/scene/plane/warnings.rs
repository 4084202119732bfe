//! Doubts about a body in the plane that can be solved.

use super::{PlaneBonds, PlaneScene, clamped, gaps, held_corner, orthotropic, root, shell, state_based};
use crate::case::Units;
use crate::diagnostic::{Faults, JsonPath, tidy};

/// Adds all warnings on a scene.
pub(super) fn collect(scene: &PlaneScene, faults: &mut Faults) {
    let horizon = root(if scene.case.horizon.is_some() { "horizon" } else { "horizon_ratio" });
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    match scene.outline() {
        Some(outline) => [low, high] = outline.bounds(),
        None => {
            for point in scene.real_points() {
                let at = scene.model.place(point);
                (0..2).for_each(|k| (low[k], high[k]) = (low[k].min(at[k]), high[k].max(at[k])));
            }
        }
    }
    // Joined sides are no ends of the body.
    let joined = scene.recipe.symmetry.mirrors.joined;
    let across = |k: usize| if joined[k] { f64::INFINITY } else { high[k] - low[k] };
    let width = across(0).min(across(1));
    if scene.horizon() > width * (1.0 + 1e-9) {
        faults
            .warning(
                horizon,
                format!(
                    "the horizon {} is longer than the body is wide, {}",
                    tidy(scene.horizon()),
                    tidy(width)
                ),
            )
            .hint("use a smaller spacing or a shorter horizon");
    }
    let uncorrected = scene.model.uncorrected();
    if uncorrected > 0 && !scene.bonds().has("w") {
        let (s, verb) = if uncorrected == 1 { ("", "is") } else { ("s", "are") };
        faults
            .warning(
                root("model").key(scene.bonds().name()).key("edges"),
                format!(
                    "{uncorrected} point{s} {verb} too soft, and stresses there are too small: nothing completes the bonds that are missing"
                ),
            )
            .hint("such points stand in single rows or between cracks: use a smaller spacing");
    }
    if let Some(([x, y], width)) = gaps::narrow(scene) {
        let cells = if width == 1 { "one spacing" } else { "less than the horizon" };
        faults
            .warning(
                root("body"),
                format!(
                    "bonds reach across a gap of the body {cells} wide, near ({}, {}): it acts as if it were filled",
                    tidy(x),
                    tidy(y)
                ),
            )
            .hint("draw a crack along the gap, which cuts these bonds, or use a smaller spacing");
    }
    clamped::warn(scene, faults);
    held_corner::warn(scene, faults);
    match scene.bonds() {
        PlaneBonds::Central(_) => {}
        PlaneBonds::Beams(parameters) => orthotropic::warn(parameters, faults),
        PlaneBonds::State(parameters) => state_based::warn(parameters, scene, faults),
        PlaneBonds::Shell(parameters) => {
            shell::warn(parameters, uncorrected, faults);
            shell::warn_of_held_ends(scene, faults);
        }
    }
    for (key, value) in scene.bonds().youngs_moduli() {
        modulus(value, root("model").key(scene.bonds().name()).key(key), scene.units, faults);
    }
}

/// Young's moduli that no material has in these units.
fn modulus(e: f64, path: JsonPath, units: Units, faults: &mut Faults) {
    if units.usual_moduli().is_some_and(|usual| !usual.contains(&e)) {
        faults
            .warning(path, format!("{e} {} is an unusual Young's modulus", units.stress()))
            .hint("steel has 2.1e11 Pa or 2.1e5 MPa; `units` only labels, it converts nothing, and \"none\" is for numbers without units");
    }
}
