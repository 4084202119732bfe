//! Line cover: the pieces of the bonds of the infinite lattice that lie in the body.
//!
//! * An oblique bond is cut where it crosses lines of the lattice; every longest run of its segments in cells of the body is one
//!   piece.
//! * Of a bond along a line of the lattice a half lies in the cells on either side. What all of its segments have is one bond,
//!   what a segment has beyond that a bond between next points.
//!
//! The lengths of all pieces add up to the area of the body.

use super::nodes::{Inside, PlateNodes, part_along};
use crate::body::Cell;

/// Coordinates nearer to a line of the lattice are on it, spacings.
const ON_LINE: f64 = 1e-9;

/// An end of a piece: a part of the way from one point to the next one on its edge; on the first point if that is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PieceEnd {
    pub(super) points: [usize; 2],
    pub(super) fraction: f64,
}

/// A piece of a bond that is not a whole bond of the lattice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Piece {
    /// Index of the offset.
    pub(super) offset: usize,
    /// Where the bond would start, which may be outside of the body.
    pub(super) node: [i32; 2],
    /// Where the piece starts and ends, in parts of the bond.
    pub(super) range: [f64; 2],
    pub(super) ends: [PieceEnd; 2],
    /// Part of it in the body: 1, or 1/2 along edges.
    pub(super) weight: f64,
}

impl Piece {
    /// Its length per that of the bond.
    pub(super) fn part(&self) -> f64 {
        self.range[1] - self.range[0]
    }
}

/// Part in cells that are `inside` of the bond at an offset from a point, as a whole.
pub(super) fn whole(inside: Inside, node: [i32; 2], [p, q, _]: Cell) -> f64 {
    match (p, q) {
        (0, _) | (_, 0) => {
            let parts = unit_parts(inside, node, [p, q]);
            parts.into_iter().fold(1.0, f64::min)
        }
        _ => {
            let is_in = crossed([p, q]).1.into_iter().all(|cell| inside(sum(node, cell)));
            f64::from(u8::from(is_in))
        }
    }
}

/// All pieces of the bonds at some offsets that are no whole bonds, in cells that are `inside`.
pub(super) fn pieces(nodes: &PlateNodes, inside: Inside, steps: &[Cell]) -> Vec<Piece> {
    let lattice = nodes.lattice();
    let (columns, rows) = (lattice.columns(), lattice.rows());
    let mut pieces = Vec::new();
    for (offset, &[p, q, _]) in steps.iter().enumerate() {
        let [left, right] = [p.min(0), p.max(0)];
        for row in rows.start - q..rows.end {
            for column in columns.start - right..columns.end - left {
                match p * q {
                    0 => along((nodes, inside), offset, [column, row], [p, q], &mut pieces),
                    _ => oblique((nodes, inside), offset, [column, row], [p, q], &mut pieces),
                }
            }
        }
    }
    pieces
}

fn sum(a: [i32; 2], b: [i32; 2]) -> [i32; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

/// Parts in the body of the unit segments of a bond along a line of the lattice.
fn unit_parts(inside: Inside, node: [i32; 2], [p, q]: [i32; 2]) -> Vec<f64> {
    let axis = usize::from(p == 0);
    let unit = [p.signum(), q.signum()];
    (0..p + q).map(|k| part_along(inside, sum(node, unit.map(|c| c * k)), axis)).collect()
}

/// What the segments of a bond along a line have beyond what all of them have.
fn along(
    (nodes, inside): (&PlateNodes, Inside),
    offset: usize,
    node: [i32; 2],
    [p, q]: [i32; 2],
    pieces: &mut Vec<Piece>,
) {
    let parts = unit_parts(inside, node, [p, q]);
    let least = parts.iter().copied().fold(1.0, f64::min);
    let unit = [p.signum(), q.signum()];
    for (k, part) in (0..).zip(&parts).filter(|(_, part)| **part > least) {
        let from = sum(node, unit.map(|c| c * k));
        let ends = [from, sum(from, unit)].map(|node| nodes.number(node));
        if let [Some(a), Some(b)] = ends {
            let ends = [a, b].map(|point| PieceEnd { points: [point; 2], fraction: 0.0 });
            let range = [k, k + 1].map(|k| f64::from(k) / f64::from(p + q));
            pieces.push(Piece { offset, node, range, ends, weight: part - least });
        }
    }
}

/// The runs of the segments of an oblique bond that lie in the body, but for that of all of them.
fn oblique(
    (nodes, inside): (&PlateNodes, Inside),
    offset: usize,
    node: [i32; 2],
    step: [i32; 2],
    pieces: &mut Vec<Piece>,
) {
    let (cuts, cells) = crossed(step);
    let is_in: Vec<bool> = cells.iter().map(|&cell| inside(sum(node, cell))).collect();
    let mut first = 0;
    while first < is_in.len() {
        let count = is_in[first..].iter().take_while(|is_in| **is_in).count();
        if count > 0 && count < is_in.len() {
            let range = [cuts[first], cuts[first + count]];
            let ends = range.map(|t| end(nodes, node, step.map(|c| t * f64::from(c))));
            if let [Some(a), Some(b)] = ends {
                pieces.push(Piece { offset, node, range, ends: [a, b], weight: 1.0 });
            }
        }
        first += count.max(1);
    }
}

/// A bond with its segments in cells, relative to its first point.
pub(super) struct Crossed {
    step: [i32; 2],
    cuts: Vec<f64>,
    cells: Vec<[i32; 2]>,
}

impl Crossed {
    /// Of an offset.
    pub(super) fn new([p, q, _]: Cell) -> Self {
        let (cuts, cells) = crossed([p, q]);
        Self { step: [p, q], cuts, cells }
    }

    /// `∫ c sᵏ ds` for k = 0, 1 and 2 along the bond from a place, s = 0, to another one, s = 1, given in parts of its length: c is the part
    /// of what the bond has there in `all` cells that is in `some` of them.
    pub(super) fn moments(
        &self,
        (some, all): (Inside, Inside),
        node: [i32; 2],
        [from, to]: [f64; 2],
    ) -> [f64; 3] {
        let mut moments = [0.0; 3];
        for (ends, &cell) in self.cuts.windows(2).zip(&self.cells) {
            let cell = sum(node, cell);
            let beside = match self.step {
                // Along a line of the lattice a half lies on either side.
                [_, 0] => Some(sum(cell, [0, -1])),
                [0, _] => Some(sum(cell, [-1, 0])),
                _ => None,
            };
            let known = || [Some(cell), beside].into_iter().flatten().filter(|&cell| all(cell));
            let part = known().filter(|&cell| some(cell)).count() as f64 / (known().count() as f64).max(1.0);
            let [a, b] = [ends[0], ends[1]].map(|cut| ((cut - from) / (to - from)).clamp(0.0, 1.0));
            (1..)
                .zip(&mut moments)
                .for_each(|(k, sum)| *sum += part * (b.powi(k) - a.powi(k)) / f64::from(k));
        }
        moments
    }
}

/// Where a bond crosses lines of the lattice, in parts of its length with both ends, and the cells between.
fn crossed([p, q]: [i32; 2]) -> (Vec<f64>, Vec<[i32; 2]>) {
    let lines = |n: i32| (1..n.abs()).map(move |k| f64::from(k) / f64::from(n.abs()));
    let mut cuts: Vec<f64> = [0.0, 1.0].into_iter().chain(lines(p)).chain(lines(q)).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|later, cut| *later - *cut < ON_LINE);
    let middle = |pair: &[f64]| [p, q].map(|c| (0.5 * (pair[0] + pair[1]) * f64::from(c)).floor() as i32);
    let cells = cuts.windows(2).map(middle).collect();
    (cuts, cells)
}

/// The end of a piece at a place relative to a point, spacings.
fn end(nodes: &PlateNodes, node: [i32; 2], place: [f64; 2]) -> Option<PieceEnd> {
    let lower = place.map(|c| (c + ON_LINE).floor());
    let rest = [0, 1].map(|k| place[k] - lower[k]);
    let from = sum(node, lower.map(|c| c as i32));
    let on_line = rest.map(|r| r.abs() < ON_LINE);
    let (to, fraction) = match on_line {
        [true, true] => (from, 0.0),
        [true, false] => (sum(from, [0, 1]), rest[1]),
        _ => (sum(from, [1, 0]), rest[0]),
    };
    Some(PieceEnd { points: [nodes.number(from)?, nodes.number(to)?], fraction })
}
