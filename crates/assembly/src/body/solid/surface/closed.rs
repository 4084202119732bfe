//! Whether triangles make a closed surface that looks outwards.

use super::facets::Facet;
use std::collections::HashMap;
use thiserror::Error;

/// Coordinates beyond this, or extents below its inverse, are no lengths of bodies; squares and cubes of what is between are numbers.
const LARGEST: f64 = 1e60;

/// Why triangles are no surface around a body.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SurfaceError {
    /// There are no triangles.
    #[error("has no triangles")]
    Empty,
    /// A corner is not finite, or absurdly far.
    #[error("has a triangle with a corner that is not finite: number {triangle}")]
    NotFinite {
        /// Which triangle, from one.
        triangle: usize,
    },
    /// All of it lies in a plane, or it is smaller than any body.
    #[error("encloses no volume")]
    Flat,
    /// Edges belong to one triangle.
    #[error("is not closed: {count} edge{} one triangle only, the first between {} and {}", if *.count == 1 { " has" } else { "s have" }, place(.from), place(.to))]
    Open {
        /// How many.
        count: usize,
        /// The first end of the first of them, m.
        from: [f64; 3],
        /// The other end of it, m.
        to: [f64; 3],
    },
    /// Triangles beside each other look to different sides.
    #[error("has triangles that look to different sides: at {count} edge{}, the first between {} and {}", if *.count == 1 { "" } else { "s" }, place(.from), place(.to))]
    Turned {
        /// Edges between them.
        count: usize,
        /// The first end of the first of them, m.
        from: [f64; 3],
        /// The other end of it, m.
        to: [f64; 3],
    },
    /// All of it looks inwards.
    #[error("is inside out: its triangles look into the body")]
    InsideOut,
}

fn place([x, y, z]: &[f64; 3]) -> String {
    format!("({x}, {y}, {z})")
}

/// # Errors
/// [`SurfaceError::Empty`], [`SurfaceError::NotFinite`].
pub(super) fn finite(facets: &[Facet]) -> Result<(), SurfaceError> {
    if facets.is_empty() {
        return Err(SurfaceError::Empty);
    }
    let is_far = |facet: &Facet| facet.corners.iter().flatten().any(|x| x.is_nan() || x.abs() > LARGEST);
    if let Some(k) = facets.iter().position(is_far) {
        return Err(SurfaceError::NotFinite { triangle: k + 1 });
    }
    let extent = |axis: usize| {
        let ends = facets.iter().map(|facet| facet.range(axis));
        let [low, high] = ends.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]).unwrap_or([0.0; 2]);
        high - low
    };
    if (0..3).any(|axis| extent(axis) < 1.0 / LARGEST) { Err(SurfaceError::Flat) } else { Ok(()) }
}

/// Whether every edge is run along as often in one direction as in the other; corners by their numbers.
///
/// # Errors
/// [`SurfaceError::Open`], [`SurfaceError::Turned`].
pub(super) fn check(facets: &[Facet], numbered: &[[u32; 3]]) -> Result<(), SurfaceError> {
    /// How often an edge occurs, by how much more often from its lower corner to its higher one, and where it is met first.
    struct Met {
        times: u32,
        surplus: i32,
        first: (usize, usize),
    }
    let mut edges: HashMap<[u32; 2], Met> = HashMap::with_capacity(3 * numbered.len() / 2);
    for (k, corners) in numbered.iter().enumerate() {
        for side in 0..3 {
            let (a, b) = (corners[side], corners[(side + 1) % 3]);
            if a != b {
                let met = edges.entry([a.min(b), a.max(b)]);
                let met = met.or_insert(Met { times: 0, surplus: 0, first: (k, side) });
                met.times += 1;
                met.surplus += if a < b { 1 } else { -1 };
            }
        }
    }
    let wrong = |is_odd: bool| {
        let all = edges.values().filter(move |met| met.surplus != 0 && (met.times % 2 == 1) == is_odd);
        let (mut count, mut first) = (0, (usize::MAX, 0));
        for met in all {
            count += 1;
            first = first.min(met.first);
        }
        let ends = |(k, side): (usize, usize)| [facets[k].corners[side], facets[k].corners[(side + 1) % 3]];
        (count > 0).then(|| (count, ends(first)))
    };
    if let Some((count, [from, to])) = wrong(true) {
        return Err(SurfaceError::Open { count, from, to });
    }
    match wrong(false) {
        Some((count, [from, to])) => Err(SurfaceError::Turned { count, from, to }),
        None => Ok(()),
    }
}
