//! Values between listed points: linear in the smallest triangle around a position, in space in the smallest tetrahedron. Beside the
//! outermost points they go on linearly from the one that is nearest to enclosing it.

use super::interpolate::Weights;
use nalgebra::Matrix3;
use peristat_assembly::body::{Cloud, PointBody, Region, Regions, SolidRegion};
use std::collections::BTreeMap;

/// Points among which corners are looked for.
const NEAREST: usize = 16;
/// How far they are looked for, spacings.
const REACH: f64 = 4.0;
/// Part of the square or the cube of a spacing below which a triangle or a tetrahedron is flat, and from which it tells how values go on.
const FLAT: [f64; 2] = [1e-3, 0.05];
/// Rounding of shares.
const ROUNDING: f64 = 1e-9;
/// How far values go on, as a share.
const BEYOND: f64 = 1.0;

/// Weights at a position among the points that `sees` tells to be visible from it: of the nearest alone where they do not tell how values
/// go on, none where there are none.
pub(super) fn weights(
    cloud: &Cloud,
    body: &PointBody,
    at: [f64; 3],
    sees: &dyn Fn([f64; 3]) -> bool,
) -> Option<Weights> {
    let radius = REACH * cloud.spacing();
    let region = match cloud.axes() {
        2 => Region::Disc { centre: [at[0], at[1]], radius },
        _ => Region::Solid(SolidRegion::Ball { centre: at, radius }),
    };
    let regions = Regions { body, outline: None, walls: &[], parts: &[], named: &BTreeMap::new() };
    let mut near = regions.select(&region).unwrap_or_default();
    let position = |p: u32| cloud.positions()[p as usize];
    let distance = |p: u32| (0..3).map(|k| (position(p)[k] - at[k]).powi(2)).sum::<f64>().sqrt();
    near.retain(|&p| sees(position(p)));
    near.sort_by(|&a, &b| distance(a).total_cmp(&distance(b)));
    near.truncate(NEAREST);
    let from = |p: u32| [0, 1, 2].map(|k| position(p)[k] - at[k]);
    let around: Vec<([f64; 3], f64)> = near.iter().map(|&p| (from(p), distance(p))).collect();
    let best = match cloud.axes() {
        2 => in_triangle(&around, cloud.spacing()),
        _ => in_tetrahedron(&around, cloud.spacing()),
    };
    let nearest = || near.first().map(|_| vec![(0, 1.0)]);
    Some(best.or_else(nearest)?.into_iter().map(|(k, share)| (near[k], share)).collect())
}

/// Corners, by number, with their shares.
type Shares = Vec<(usize, f64)>;

/// The best so far: how far beside it the position lies, as a share, and the sum of the distances of its corners.
type Best = Option<([f64; 2], Shares)>;

/// The triangle around the origin whose corners are nearest in the sum of their distances.
fn in_triangle(around: &[([f64; 3], f64)], spacing: f64) -> Option<Shares> {
    let cross = |[ax, ay, _]: [f64; 3], [bx, by, _]: [f64; 3]| ax * by - ay * bx;
    let mut best: Best = None;
    for (i, &(a, near)) in around.iter().enumerate() {
        for (j, &(b, farther)) in around.iter().enumerate().skip(i + 1) {
            for (k, &(c, farthest)) in around.iter().enumerate().skip(j + 1) {
                let parts = [cross(b, c), cross(c, a), cross(a, b)];
                let area: f64 = parts.iter().sum();
                let size = area.abs() / spacing.powi(2);
                let far = near + farther + farthest;
                keep_better(&mut best, (size, far), &[i, j, k], &parts.map(|part| part / area));
            }
        }
    }
    best.map(|best| best.1)
}

/// The tetrahedron around the origin whose corners are nearest in the sum of their distances.
fn in_tetrahedron(around: &[([f64; 3], f64)], spacing: f64) -> Option<Shares> {
    let volume = |a: usize, b: usize, c: usize| {
        Matrix3::from_fn(|row, column| around[[a, b, c][row]].0[column]).determinant()
    };
    let mut best: Best = None;
    for i in 0..around.len() {
        for j in i + 1..around.len() {
            for k in j + 1..around.len() {
                for l in k + 1..around.len() {
                    // Of the tetrahedra that the origin makes with the sides, with the signs of one orientation.
                    let parts = [volume(j, k, l), -volume(i, k, l), volume(i, j, l), -volume(i, j, k)];
                    let whole: f64 = parts.iter().sum();
                    let size = whole.abs() / spacing.powi(3);
                    let far = [i, j, k, l].map(|corner| around[corner].1).iter().sum();
                    keep_better(&mut best, (size, far), &[i, j, k, l], &parts.map(|part| part / whole));
                }
            }
        }
    }
    best.map(|best| best.1)
}

/// Keeps what has the origin less far beside it, or is as far from enclosing it and smaller; `size` is in spacings.
fn keep_better(best: &mut Best, (size, far): (f64, f64), corners: &[usize], shares: &[f64]) {
    let least = shares.iter().copied().fold(f64::INFINITY, f64::min);
    let beside = if least >= -ROUNDING { 0.0 } else { -least };
    let flat = FLAT[usize::from(beside > 0.0)];
    if size < flat || !(0.0..=BEYOND).contains(&beside) {
        return;
    }
    if best.as_ref().is_none_or(|(known, _)| [beside, far] < *known) {
        *best = Some(([beside, far], corners.iter().copied().zip(shares.iter().copied()).collect()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_values_are_met_between_points_in_space() {
        // A cube of points that lie up to a quarter of a spacing off their places.
        let shift = |k: usize| 0.25 * (37.0 * k as f64).sin();
        let at = |k: usize| {
            let [x, y, z] = [k % 4, k / 4 % 4, k / 16].map(|i| i as f64);
            [x + shift(3 * k), y + shift(3 * k + 1), z + shift(3 * k + 2)]
        };
        let cloud = Cloud::in_space((0..64).map(at).collect(), vec![1.0; 64], Vec::new()).unwrap();
        let body = PointBody::Cloud(cloud.clone());
        let value = |[x, y, z]: [f64; 3]| 1.0 + 2.0 * x - 3.0 * y + 0.5 * z;
        // Inside, at a point, and beside the outermost ones.
        for place in [[1.5, 1.2, 1.7], [1.0, 2.0, 1.0], at(21), [-0.4, 1.3, 1.6], [3.3, 3.4, 1.0]] {
            let weights = weights(&cloud, &body, place, &|_| true).unwrap();
            let found: f64 = weights.iter().map(|(p, w)| w * value(at(*p as usize))).sum();
            assert!((found - value(place)).abs() < 1e-12, "{place:?}: {weights:?}");
            assert_eq!(weights.len(), 4);
        }
        // What is not visible does not count.
        let beyond = weights(&cloud, &body, [1.5, 1.5, 1.9], &|[_, _, z]| z > 2.2).unwrap();
        assert!(beyond.iter().all(|(p, _)| at(*p as usize)[2] > 2.2), "{beyond:?}");
    }
}
