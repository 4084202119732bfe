//! Where a set of points is cut.

use super::directions::Direction;

/// Most intervals in which points are counted.
const BINS: usize = 512;
/// Largest difference of the two sides over their sum.
const UNEVEN: f64 = 0.15;
/// Gain below which a later direction is not preferred.
const GAIN: f64 = 0.999;

/// A line: points with a smaller projection are on its left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cut {
    pub(super) direction: Direction,
    pub(super) at: f64,
}

/// Price of a separator: its size, raised where the sides differ.
pub(super) fn price(left: f64, separator: f64, right: f64) -> f64 {
    let uneven = (left - right) / (left + right).max(1.0);
    (separator.max(1.0)) * (1.0 + 4.0 * uneven * uneven)
}

/// The cheapest cut of points, by counts of points in strips; `None` if no direction has one of even sides.
pub(super) fn cheapest(points: &[u32], positions: &[[f64; 2]], directions: &[Direction]) -> Option<Cut> {
    let mut best: Option<(f64, Cut)> = None;
    for direction in directions {
        if let Some((price, at)) = along(points, positions, direction)
            && best.is_none_or(|(least, _)| price < GAIN * least)
        {
            best = Some((price, Cut { direction: *direction, at }));
        }
    }
    best.map(|(_, cut)| cut)
}

/// Price and place of the cheapest cut in one direction.
fn along(points: &[u32], positions: &[[f64; 2]], direction: &Direction) -> Option<(f64, f64)> {
    let project = |p: &u32| direction.along(positions[*p as usize]);
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = points.iter().map(project).fold(ends, |(low, high), x| (low.min(x), high.max(x)));
    if high.partial_cmp(&low) != Some(std::cmp::Ordering::Greater) {
        return None;
    }
    let bins = points.len().clamp(64, BINS);
    let scale = bins as f64 / (high - low);
    // Points before the end of each interval.
    let mut before = [0_u32; BINS + 1];
    for p in points {
        before[(((project(p) - low) * scale) as usize).min(bins - 1) + 1] += 1;
    }
    for bin in 0..bins {
        before[bin + 1] += before[bin];
    }
    let width = ((direction.width * scale).round() as usize).max(1);
    let all = points.len() as f64;
    let mut best: Option<(f64, f64)> = None;
    for bin in 1..bins {
        let left = f64::from(before[bin]);
        let separator = f64::from(before[(bin + width).min(bins)]) - left;
        let right = all - left - separator;
        let price = price(left, separator, right);
        if (left - right).abs() <= UNEVEN * (left + right) && best.is_none_or(|(least, _)| price < least) {
            best = Some((price, low + bin as f64 / scale));
        }
    }
    best
}

/// A cut with half of the points on either side, for points that strips do not resolve.
pub(super) fn median(points: &[u32], positions: &[[f64; 2]], directions: &[Direction]) -> Option<Cut> {
    directions.iter().find_map(|direction| {
        let mut places: Vec<f64> = points.iter().map(|p| direction.along(positions[*p as usize])).collect();
        places.sort_unstable_by(f64::total_cmp);
        let (first, middle) = (places[0], places[places.len() / 2]);
        // Points in the middle may coincide with the first ones.
        let at = places.into_iter().find(|x| *x > first && *x >= middle)?;
        Some(Cut { direction: *direction, at })
    })
}
