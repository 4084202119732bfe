//! Which places a point can take from, images of places among them.

use super::super::super::plane::Mirrors;
use super::sources::Source;
use super::transport::{Edge, Transport};
use crate::body::{Cell, plus};
use std::collections::HashMap;

/// A point without all of its bonds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lacking {
    /// Its number.
    pub(super) point: usize,
    pub(super) cell: Cell,
    /// What it counts by: in a body of revolution its radius, spacings.
    pub(super) weight: f64,
    /// Its volume, cells, about, and that of the bonds that it has.
    pub(super) volume: f64,
    pub(super) present: f64,
}

/// Least part of a cell that a point is taken to lack: what is next to nothing would need to be known exactly.
const LEAST: f64 = 1e-3;
/// A place or an image of it, where it is and the sign of its shear.
struct Seen {
    place: u32,
    at: [f64; 2],
    sign: f64,
}

/// What points need.
#[derive(Clone, Copy)]
pub(super) enum Need<'a> {
    /// As much of all directions, from places as near as a spline of a degree reaches.
    Directions(i32),
    /// These volumes.
    Volumes(&'a [f64]),
}

/// How far points reach for volumes, as a degree, and how little they wish for what is not next to them.
const REACHING: (i32, f64) = (9, 1e-2);

impl Need<'_> {
    fn degree(self) -> i32 {
        match self {
            Self::Directions(degree) => degree,
            Self::Volumes(_) => REACHING.0,
        }
    }

    /// What is measured of a place: its deviator, or its volume alone.
    fn measured(self, seen: &Seen, source: &Source) -> [f64; 2] {
        let [xx, yy, xy] = source.tensor.map(|t| t / source.volume());
        match self {
            Self::Directions(_) => [xx - yy, 2.0 * seen.sign * xy],
            Self::Volumes(_) => [1.0, 0.0],
        }
    }

    /// How much of a place a point wishes for that is so far away.
    fn wish(self, away: [f64; 2]) -> f64 {
        let of = |degree: i32| spline(degree, away[0]) * spline(degree, away[1]);
        match self {
            Self::Directions(degree) => of(degree),
            // A place at a point is for that alone, if it can be.
            Self::Volumes(_) => of(1) + REACHING.1 * of(REACHING.0),
        }
    }
}

/// The transport from sources to points of what these need, volumes times a scale.
pub(super) fn transport(
    sources: &[Source],
    points: &[Lacking],
    mirrors: &Mirrors,
    (need, scale): (Need, f64),
    slack: f64,
) -> Transport {
    let far = (need.degree() + 1) / 2;
    let seen = seen(sources, mirrors, f64::from(far));
    let mut edges = Vec::new();
    let mut ends = Vec::with_capacity(points.len());
    for lacking in points {
        // More where more is missing.
        let missing = match need {
            Need::Directions(_) => scale * (lacking.volume - lacking.present).max(LEAST * lacking.weight),
            Need::Volumes(_) => scale * lacking.volume,
        };
        for step in (-far..=far).flat_map(|j| (-far..=far).map(move |i| [i, j, 0])) {
            for seen in seen.get(&plus(lacking.cell, step)).into_iter().flatten() {
                let wish = missing * need.wish([0, 1].map(|k| seen.at[k] - f64::from(lacking.cell[k])));
                if wish > 0.0 {
                    let place = &sources[seen.place as usize];
                    edges.push(Edge {
                        place: seen.place,
                        measured: need.measured(seen, place),
                        wish,
                        volume: 0.0,
                    });
                }
            }
        }
        ends.push(edges.len());
    }
    let wanted = match need {
        Need::Directions(_) => vec![[0.0; 2]; points.len()],
        Need::Volumes(volumes) => volumes.iter().map(|v| [scale * v, 0.0]).collect(),
    };
    Transport {
        ends,
        edges,
        wanted,
        volumes: sources.iter().map(|s| scale * s.volume()).collect(),
        slack,
        slacks: Vec::new(),
    }
}

/// The spline of an odd degree about zero whose pieces are one long. Weighted with such splines about points of a row, one
/// place has itself as the mean of their positions: what points of a straight border take from it has as much from the left as
/// from the right.
fn spline(degree: i32, x: f64) -> f64 {
    let half = 0.5 * f64::from(degree + 1);
    let (mut sum, mut binomial) = (0.0, 1.0);
    for j in 0..=degree + 1 {
        // From the nearer end: sums are of a few terms.
        let from = half - x.abs() - f64::from(j);
        if from <= 0.0 {
            break;
        }
        sum += binomial * from.powi(degree);
        binomial *= -f64::from(degree + 1 - j) / f64::from(j + 1);
    }
    // A rounding of zero is none.
    if sum > 1e-6 { sum / (1..=degree).map(f64::from).product::<f64>() } else { 0.0 }
}

/// Places and their images near real points, by cell.
fn seen(sources: &[Source], mirrors: &Mirrors, far: f64) -> HashMap<Cell, Vec<Seen>> {
    let mut seen: HashMap<Cell, Vec<Seen>> = HashMap::new();
    let lines = mirrors.lines;
    for (place, source) in (0..).zip(sources) {
        let along = |k: usize| copies(lines[k], mirrors.joined[k], source.at[k], far);
        for &(x, turned) in &along(0) {
            for &(y, other) in &along(1) {
                let cell = [x.round() as i32, y.round() as i32, 0];
                seen.entry(cell).or_default().push(Seen { place, at: [x, y], sign: turned * other });
            }
        }
    }
    seen
}

/// A place along an axis and its images within reach of the cells between two lines, with their signs.
fn copies(lines: [Option<i32>; 2], joined: bool, at: f64, far: f64) -> Vec<(f64, f64)> {
    // Lines stand before their cells, whose points are at whole numbers.
    let lines = lines.map(|line| line.map(|line| f64::from(line) - 0.5));
    let is_near = |x: f64| {
        lines[0].is_none_or(|low| x > low - far - 1.0) && lines[1].is_none_or(|high| x < high + far + 1.0)
    };
    let mut found = vec![(at, 1.0)];
    let mut next = 0;
    while let Some(&(x, sign)) = found.get(next) {
        next += 1;
        let images: Vec<(f64, f64)> = match (joined, lines) {
            (true, [Some(low), Some(high)]) => vec![(x + high - low, sign), (x - high + low, sign)],
            _ => lines.into_iter().flatten().map(|line| (2.0 * line - x, -sign)).collect(),
        };
        for image in images.into_iter().filter(|image| is_near(image.0)) {
            if found.iter().all(|f| f.1 != image.1 || (f.0 - image.0).abs() > 1e-9) {
                found.push(image);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splines_keep_the_place() {
        for degree in [1, 3, 5, 9] {
            for x in [0.0, 0.31, 0.5, 0.87] {
                let all = |of: &dyn Fn(f64) -> f64| -> f64 {
                    (-7..=7).map(|k| of(f64::from(k)) * spline(degree, x - f64::from(k))).sum()
                };
                assert!((all(&|_| 1.0) - 1.0).abs() < 1e-5 && (all(&|k| k) - x).abs() < 1e-5, "{degree} {x}");
            }
        }
        assert_eq!((spline(3, 0.0), spline(3, 2.0)), (2.0 / 3.0, 0.0));
    }

    #[test]
    fn images_stand_where_mirrors_show_them() {
        assert_eq!(copies([None; 2], false, 3.25, 2.0), [(3.25, 1.0)]);
        assert_eq!(copies([Some(0), None], false, 1.0, 2.0), [(1.0, 1.0), (-2.0, -1.0)]);
        // Two lines of symmetry with two cells between them: every four cells.
        let mut between = copies([Some(0), Some(2)], false, 0.25, 4.0);
        between.sort_by(|a, b| a.0.total_cmp(&b.0));
        assert_eq!(
            between,
            [(-5.25, -1.0), (-3.75, 1.0), (-1.25, -1.0), (0.25, 1.0), (2.75, -1.0), (4.25, 1.0)]
        );
        let joined = copies([Some(0), Some(5)], true, 0.5, 2.0);
        assert_eq!(joined, [(0.5, 1.0), (5.5, 1.0)]);
    }
}
