//! How large a body is, so that lengths and turns, forces and moments can be compared whatever their units.

use peristat_assembly::bonds::Point;
use peristat_assembly::model::Model;

/// Some of the points, the first and the last among them: enough to see how large a body is.
fn samples(points: usize) -> impl Iterator<Item = usize> {
    const COUNT: usize = 256;
    (0..=COUNT).map(move |k| k * (points - 1) / COUNT)
}

/// Largest displacement of a unit rigid motion of a kind, m or m per rad.
pub(super) fn displacement<const D: usize>(model: &dyn Model<D>, kind: usize, centre: Point) -> f64 {
    samples(model.points()).map(|point| model.displacement(kind, point, centre)).fold(0.0, f64::max)
}

/// Amounts of each component that count as equally large: a turn of one, and the largest displacement that it makes
/// about the middle of the body. Without turns all components have one unit.
pub(super) fn scales<const D: usize>(model: &dyn Model<D>) -> [f64; D] {
    let along = |k: usize| samples(model.points()).map(move |point| model.position(point)[k]);
    let middle = std::array::from_fn(|k| {
        0.5 * (along(k).fold(f64::INFINITY, f64::min) + along(k).fold(f64::NEG_INFINITY, f64::max))
    });
    let turns = |kind: &usize| {
        let motion = model.rigid_motion(*kind, 0, middle);
        motion.iter().zip(model.components()).any(|(value, of)| of.is_rotation && *value != 0.0)
    };
    let rotations = (0..model.rigid_motions().len()).filter(turns);
    let length = rotations.map(|kind| displacement(model, kind, middle)).fold(0.0, f64::max);
    let is_scaled = |c: usize| !model.components()[c].is_rotation && length > 0.0;
    std::array::from_fn(|c| if is_scaled(c) { length } else { 1.0 })
}
