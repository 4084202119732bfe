//! Which places a point can take from, images of places among them.

use super::super::super::plane::Mirrors;
use super::sources::Source;
use super::transport::{Edge, Transport};
use crate::body::Cell;
use std::collections::HashMap;

/// A point without all of its bonds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lacking {
    /// Its number.
    pub(super) point: usize,
    pub(super) cell: Cell,
    /// Its volume, cells, about, and that of the bonds that it has.
    pub(super) volume: f64,
    pub(super) present: f64,
}

/// Least part of a cell that a point is taken to lack: what is next to nothing would need to be known exactly.
const LEAST: f64 = 1e-3;
/// How much dearer its own bonds are to a point than other places.
const OWN: f64 = 10.0;
/// Distance at which wishes have fallen to 1/e, per that to which points reach.
const WIDE: f64 = 0.4;
/// Square of a distance that is none, spacings.
const HERE: f64 = 1e-9;
/// A place or an image of it, where it is and the sign of its shear.
struct Seen {
    place: u32,
    at: [f64; 2],
    sign: f64,
}

/// The transport from sources to points, which reach so far: spacings.
pub(super) fn transport(sources: &[Source], points: &[Lacking], mirrors: &Mirrors, far: f64) -> Transport {
    let wide = WIDE * far;
    let seen = seen(sources, mirrors, far);
    let mut edges = Vec::new();
    let mut ends = Vec::with_capacity(points.len());
    let most = far.ceil() as i32;
    for lacking in points {
        let cells = (-most..=most).flat_map(|j| (-most..=most).map(move |i| [i, j]));
        for [i, j] in cells {
            for seen in seen.get(&[lacking.cell[0] + i, lacking.cell[1] + j]).into_iter().flatten() {
                let square: f64 = (0..2).map(|k| (seen.at[k] - f64::from(lacking.cell[k])).powi(2)).sum();
                if square <= far * far {
                    let source = &sources[seen.place as usize];
                    let is_own = source.owner == Some(lacking.point) && square < HERE;
                    edges.push(edge(seen, source, wish(lacking, square / (wide * wide), is_own)));
                }
            }
        }
        ends.push(edges.len());
    }
    Transport { ends, edges, volumes: sources.iter().map(Source::volume).collect() }
}

/// What a point wishes for, in parts of a place: more where more is missing, from near, and above all what its own bonds have.
fn wish(lacking: &Lacking, square: f64, is_own: bool) -> f64 {
    let missing = (lacking.volume - lacking.present).max(LEAST);
    if is_own { OWN } else { missing * (-square).exp() }
}

fn edge(seen: &Seen, source: &Source, wish: f64) -> Edge {
    let [xx, yy, xy] = source.tensor.map(|t| t / source.volume());
    Edge { place: seen.place, deviator: [xx - yy, 2.0 * seen.sign * xy], wish, volume: 0.0 }
}

/// Places and their images near real points, by cell.
fn seen(sources: &[Source], mirrors: &Mirrors, far: f64) -> HashMap<Cell, Vec<Seen>> {
    let mut seen: HashMap<Cell, Vec<Seen>> = HashMap::new();
    let lines = mirrors.lines();
    for (place, source) in (0..).zip(sources) {
        let along = |k: usize| copies(lines[k], mirrors.joined[k], source.at[k], far);
        for &(x, turned) in &along(0) {
            for &(y, other) in &along(1) {
                let cell = [x, y].map(|x| x.round() as i32);
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
