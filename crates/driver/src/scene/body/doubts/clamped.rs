//! Doubts about what keeps a part of a cracked body from turning.
//!
//! The parts beside a crack turn as it opens. A region whose points all have the same prescribed displacement cannot, and
//! carries a moment: a compact tension specimen is then 60 to 70 % too stiff. Grips
//! across a whole body turn in no test, so they are left alone.

use crate::diagnostic::{Faults, JsonPath, root};
use crate::scene::body::scene::BodyScene;
use std::collections::BTreeMap;

/// Grips end this close to the sides of a body, in spacings; turned rows are ragged there.
const RAGGED: f64 = 2.0;
/// The rotation in the plane among the motions of rigid regions.
const TURN: usize = 5;
/// Distances below this part of the spacing are rounding.
const ROUNDING: f64 = 1e-6;

/// Adds a warning for every region of a cracked body that is held or moved as a whole and cannot turn.
pub(crate) fn warn(scene: &BodyScene, faults: &mut Faults) {
    if scene.cracks.is_empty() {
        return;
    }
    for (k, region) in scene.conditions.rigid.iter().enumerate() {
        let is_clamped = region.prescribed[TURN] == Some(0.0) && !meets_mirror(scene, &region.points);
        if is_clamped && !is_grip(scene, &region.points) {
            let name = scene.case.rigid.get(k).map_or("", |r| r.region.as_str());
            tell(name, root("rigid").index(k).key("phi"), "leave `phi` out, so that it turns", faults);
        }
    }
    for (k, points) in held_whole(scene) {
        let name = scene.case.supports.get(k).and_then(|s| s.at.region.as_deref());
        if let Some(name) = name.filter(|_| !on_a_line(scene, points) && !is_grip(scene, points)) {
            let path = root("supports").index(k).key("at").key("region");
            tell(name, path, "list the region under `rigid` with `ux` and `uy`, and without `phi`", faults);
        }
    }
}

fn tell(region: &str, path: JsonPath, hint: &str, faults: &mut Faults) {
    faults
        .warning(
            path,
            format!("the region `{region}` cannot turn: a crack specimen that is held like this is up to 70 % too stiff"),
        )
        .hint(hint);
}

/// Points of supports, by their numbers in the case, that hold both displacements.
fn held_whole(scene: &BodyScene) -> BTreeMap<usize, &[u32]> {
    let both = scene.case.supports.iter().enumerate().filter(|(_, s)| s.ux.is_some() && s.uy.is_some());
    let points = |(k, _)| {
        let origin = root("supports").index(k).key("ux").to_string();
        let hold = scene.conditions.holds.iter().find(|h| h.origin == origin)?;
        Some((k, &hold.points[..]))
    };
    both.filter_map(points).collect()
}

/// Whether a mirror halves a region, which then cannot turn anyway.
fn meets_mirror(scene: &BodyScene, points: &[u32]) -> bool {
    let near = |axis: usize, at: f64| {
        let reach = (0.5 + ROUNDING) * scene.spacing();
        points.iter().any(|&p| (scene.model.place(p as usize)[axis] - at).abs() <= reach)
    };
    let at = scene.inputs.symmetry.at;
    (0..4).any(|side| at[side].is_some_and(|at| near(side / 2, at)))
}

/// Whether points reach from one side of the body to the other.
fn is_grip(scene: &BodyScene, points: &[u32]) -> bool {
    let own = extents(scene, points.iter().map(|&p| p as usize));
    let whole = extents(scene, scene.real_points());
    (0..2).any(|axis| own[axis] > whole[axis] - RAGGED * scene.spacing())
}

/// Width and height of the box around points.
fn extents(scene: &BodyScene, points: impl Iterator<Item = usize>) -> [f64; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for at in points.map(|p| scene.model.place(p)) {
        (0..2).for_each(|k| (low[k], high[k]) = (low[k].min(at[k]), high[k].max(at[k])));
    }
    [0, 1].map(|k| high[k] - low[k])
}

/// Whether all points are on one straight line.
fn on_a_line(scene: &BodyScene, points: &[u32]) -> bool {
    let at = |p: u32| scene.model.place(p as usize);
    let [Some(&first), Some(&last)] = [points.first(), points.last()] else { return true };
    let (a, b) = (at(first), at(last));
    let d = [b[0] - a[0], b[1] - a[1]];
    let slack = ROUNDING * scene.spacing() * d[0].hypot(d[1]);
    points.iter().all(|&p| {
        let r = at(p);
        (d[0] * (r[1] - a[1]) - d[1] * (r[0] - a[0])).abs() <= slack
    })
}
