//! Doubts about a body that can be solved.

use super::{bridges, clamped, held_corner, scattered, stairs};
use crate::case::{Support, Units};
use crate::diagnostic::{Faults, JsonPath, root, tidy};
use crate::model::HeldRegion;
use crate::scene::body::scene::BodyScene;
use crate::scene::words;
use peristat_assembly::body::in_space;

/// Adds all warnings on a scene.
pub(crate) fn collect(scene: &BodyScene, faults: &mut Faults) {
    let horizon = root(if scene.case.horizon.is_some() { "horizon" } else { "horizon_ratio" });
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    match scene.outline() {
        Some(outline) => [low, high] = outline.bounds().map(in_space),
        None => {
            for point in scene.real_points() {
                let at = scene.model.position(point);
                (0..3).for_each(|k| (low[k], high[k]) = (low[k].min(at[k]), high[k].max(at[k])));
            }
        }
    }
    // Points of a solid are the middles of its cells.
    let is_solid = scene.body().axes() > 2;
    let cell = if is_solid { scene.body().spacing() } else { 0.0 };
    let whole = scene.inputs.symmetry.whole([0, 1, 2].map(|k| high[k] - low[k] + cell));
    let width = whole[..scene.body().axes()].iter().copied().fold(f64::INFINITY, f64::min);
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
    if let Some(bridge) = bridges::narrow(scene) {
        let place = words::place(bridge.place, scene.body());
        let between: Vec<String> = bridge.between.iter().take(2).map(|name| format!("`{name}`")).collect();
        let between = match between.as_slice() {
            [] => String::new(),
            [one] => format!(" beside {one}"),
            all => format!(" between {}", all.join(" and ")),
        };
        let s = if bridge.points == 1 { "" } else { "s" };
        faults
            .warning(
                root("body"),
                format!(
                    "the body is one cell wide{between}, near {place}: bonds of its {} point{s} reach across what is beside them",
                    bridge.points
                ),
            )
            .hint("use a smaller spacing: such a part needs two cells at least, and several to bend as it should");
    }
    clamped::warn(scene, faults);
    held_corner::warn(scene, faults);
    stairs::warn(scene, faults);
    scattered::warn(scene, faults);
    let held: Vec<HeldRegion> = scene.case.supports.iter().enumerate().flat_map(held).collect();
    scene.material().warn(&scene.resolved(&held), faults);
    for (key, value) in scene.material().youngs_moduli() {
        modulus(value, root("model").key(scene.material().about().name).key(key), scene.units, faults);
    }
}

/// What a support holds.
fn held((k, support): (usize, &Support)) -> Vec<HeldRegion> {
    let components = [
        ("ux", &support.ux),
        ("uy", &support.uy),
        ("uz", &support.uz),
        ("w", &support.w),
        ("phi", &support.phi),
    ];
    let of = |region: Option<&String>| HeldRegion {
        region: region.cloned(),
        path: root("supports").index(k),
        components: components.iter().filter(|c| c.1.is_some()).map(|c| c.0).collect(),
    };
    match &support.at.region {
        Some(names) => names.each().iter().map(|name| of(Some(name))).collect(),
        None => vec![of(None)],
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
