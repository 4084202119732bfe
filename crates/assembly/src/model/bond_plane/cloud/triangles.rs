//! Overlay triangles of a cloud.

use super::super::super::plane::strain_rows;
use super::Pair;
use crate::bonds::Mat;
use crate::stiffness::Family;

/// Neighbours of a point among which triangles are looked for.
const NEAREST: usize = 10;
/// Triangles are taken if they are as good as the best up to this factor.
const AS_GOOD: f64 = 4.0;
/// Triangles and the number of points that lack stiffness but have none.
#[derive(Clone, Debug, Default)]
pub(super) struct Overlay {
    pub(super) triangles: Vec<Family<2, 3, 2>>,
    pub(super) uncorrected: usize,
}

/// A triangle of a point with two others.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    others: [u32; 2],
    /// (Sum of the squared sides)²/area: small where it is near and well shaped.
    badness: f64,
}

/// Gives every point its deficit back, in equal parts by at most one triangle per quadrant around it.
pub(super) fn overlay(
    positions: &[[f64; 2]],
    pairs: &[Pair],
    deficits: &[Mat<3, 3>],
    volumes: &[f64],
    cut: &dyn Fn([f64; 2], [f64; 2]) -> bool,
) -> Overlay {
    let mut near: Vec<Vec<(f64, u32)>> = vec![Vec::new(); positions.len()];
    for pair in pairs {
        let [i, j] = pair.points;
        near[i as usize].push((pair.length, j));
        near[j as usize].push((pair.length, i));
    }
    let mut overlay = Overlay::default();
    for (point, mut near) in near.into_iter().enumerate() {
        near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut chosen = best(positions, point, &near[..near.len().min(NEAREST)]);
        if chosen.is_empty() {
            chosen = best(positions, point, beside(positions, point, &near));
        }
        chosen.retain(|candidate| {
            let [a, b] = candidate.others.map(|p| positions[p as usize]);
            !(cut(positions[point], a) || cut(positions[point], b) || cut(a, b))
        });
        overlay.uncorrected += usize::from(chosen.is_empty());
        let share = volumes[point] / chosen.len().max(1) as f64;
        let modulus = deficits[point].map(|row| row.map(|v| v * share));
        overlay.triangles.extend(chosen.iter().map(|candidate| {
            let [a, b] = candidate.others.map(|p| relative(positions, point, p));
            Family {
                point: point as u32,
                others: candidate.others,
                rows: strain_rows(a, b),
                own: [[0.0; 2]; 3],
                modulus,
            }
        }));
    }
    overlay
}

fn relative(positions: &[[f64; 2]], point: usize, other: u32) -> [f64; 2] {
    [0, 1].map(|k| positions[other as usize][k] - positions[point][k])
}

/// Where the nearest lie in a line: the neighbours that are about as far as the one that makes the best triangle with the
/// nearest. All on the line are flat with each other, and there may be very many.
fn beside<'a>(positions: &[[f64; 2]], point: usize, near: &'a [(f64, u32)]) -> &'a [(f64, u32)] {
    let to = |&(_, other): &(f64, u32)| relative(positions, point, other);
    let with_nearest = |k: usize| Some((badness(to(&near[0]), to(&near[k]))?, k));
    let first = (1..near.len()).filter_map(with_nearest).min_by(|a, b| a.0.total_cmp(&b.0));
    first.map_or(&[], |(_, k)| &near[k.saturating_sub(NEAREST)..near.len().min(k + NEAREST)])
}

/// How bad the triangle of a point and two others is, `None` for one that is flat.
fn badness(a: [f64; 2], b: [f64; 2]) -> Option<f64> {
    let area = (a[0] * b[1] - a[1] * b[0]).abs();
    let squared = |v: [f64; 2]| v[0] * v[0] + v[1] * v[1];
    let sides = squared(a) + squared(b) + squared([b[0] - a[0], b[1] - a[1]]);
    // Flatter ones are collinear but for rounding.
    (area >= 1e-6 * sides).then(|| sides * sides / area)
}

/// The best triangle of each quadrant that its centre can lie in, where it is about as good as the best of all.
fn best(positions: &[[f64; 2]], point: usize, near: &[(f64, u32)]) -> Vec<Candidate> {
    let mut found: [Option<Candidate>; 4] = [None; 4];
    for (k, &(_, first)) in near.iter().enumerate() {
        for &(_, second) in &near[k + 1..] {
            let (a, b) = (relative(positions, point, first), relative(positions, point, second));
            let Some(badness) = badness(a, b) else { continue };
            let quadrant = usize::from(a[0] + b[0] < 0.0) + 2 * usize::from(a[1] + b[1] < 0.0);
            // By more than rounding: ties go to the nearer points.
            if found[quadrant].is_none_or(|c| badness < c.badness * (1.0 - 1e-9)) {
                found[quadrant] = Some(Candidate { others: [first, second], badness });
            }
        }
    }
    let least = found.iter().flatten().map(|c| c.badness).fold(f64::INFINITY, f64::min);
    found.into_iter().flatten().filter(|c| c.badness <= AS_GOOD * least).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_of_a_dense_line_finds_its_triangles_beside_the_line() {
        // Two lines of points 0.01 apart, at a distance of 0.3, about the origin.
        let on = |y: f64| (-100..=100).map(move |k| [0.01 * f64::from(k), y]);
        let positions: Vec<[f64; 2]> = on(0.0).chain(on(0.3)).collect();
        let point = 100;
        let distance = |p: usize| positions[p][0].hypot(positions[p][1]);
        let others = (0..positions.len()).filter(|&p| p != point);
        let mut near: Vec<(f64, u32)> = others.map(|p| (distance(p), p as u32)).collect();
        near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        assert!(best(&positions, point, &near[..NEAREST]).is_empty());
        let few = beside(&positions, point, &near);
        let (found, all) = (best(&positions, point, few), best(&positions, point, &near));
        assert!(few.len() == 2 * NEAREST && found.len() == 2, "{} {found:?}", few.len());
        let worst = |of: &[Candidate]| of.iter().map(|c| c.badness).fold(0.0, f64::max);
        // Measured 1.18.
        assert!(worst(&found) < 1.5 * worst(&all), "{found:?} {all:?}");
        // Nothing is beside a line alone.
        near.retain(|&(_, p)| p <= 200);
        assert!(beside(&positions, point, &near).is_empty());
    }
}
