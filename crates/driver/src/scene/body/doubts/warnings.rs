//! Doubts about a body in the plane that can be solved.

use super::{clamped, gaps, held_corner};
use crate::case::{Support, Units};
use crate::diagnostic::{Faults, JsonPath, root, tidy};
use crate::model::HeldRegion;
use crate::scene::body::scene::BodyScene;

/// Adds all warnings on a scene.
pub(crate) fn collect(scene: &BodyScene, faults: &mut Faults) {
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
    if uncorrected > 0 && scene.material().cylinder_radius().is_none() {
        let (s, verb) = if uncorrected == 1 { ("", "is") } else { ("s", "are") };
        faults
            .warning(
                root("model").key(scene.material().about().name).key("edges"),
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
    let held: Vec<HeldRegion> = scene.case.supports.iter().enumerate().map(held).collect();
    scene.material().warn(&scene.resolved(&held), faults);
    for (key, value) in scene.material().youngs_moduli() {
        modulus(value, root("model").key(scene.material().about().name).key(key), scene.units, faults);
    }
}

/// What a support holds.
fn held((k, support): (usize, &Support)) -> HeldRegion {
    let components = [("ux", support.ux), ("uy", support.uy), ("w", support.w), ("phi", support.phi)];
    HeldRegion {
        region: support.at.region.clone(),
        path: root("supports").index(k),
        components: components.iter().filter(|c| c.1.is_some()).map(|c| c.0).collect(),
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
