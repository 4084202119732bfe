//! Bodies of several materials: how stiff every point is, and what a bond through several of them has.
//!
//! A bond that passes the cells of its path with the parts l_q of its length is as stiff as these in series,
//! `f = 1/Σ(l_q/E_q)`, but no stiffer than the mean of its ends. Each end would have half of a bond of its own material:
//! the softer one gets that at most, the stiffer one the rest, and what an end lacks then, `E_i/2 − share_i >= 0`, it gets
//! back in triangles.

use super::Mirrors;
use crate::body::{Cell, SquareLattice};
use std::sync::Arc;

/// Modulus of a neighbour, over that of a point, below which it is of another material.
const MUCH: f64 = 0.9;

/// Cells between a triangle that a border cuts and the next point, at most.
const FAR: i32 = 4;

/// Moduli of the points of a lattice over those of the base material.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Mixture {
    factors: Vec<f64>,
}

/// A bond, or the part of one that lies in the body, through the materials of its cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct Through {
    /// Its modulus over that of the base material.
    pub(in super::super) factor: f64,
    /// What its ends have of that.
    pub(in super::super) shares: [f64; 2],
    /// What its ends lack of half a bond of their own material, >= 0.
    pub(in super::super) lacks: [f64; 2],
}

impl Mixture {
    /// One modulus per point of a lattice, over that of the base material and > 0; images have that of their point. None where
    /// all points are of the base material.
    pub(in super::super) fn new(factors: Vec<f64>) -> Option<Arc<Self>> {
        factors.iter().any(|factor| *factor != 1.0).then(|| Arc::new(Self { factors }))
    }

    /// That of a point.
    pub(in super::super) fn of(&self, point: usize) -> f64 {
        self.factors[point]
    }

    /// Whether a point is so much softer than another that its strains are not those of that one. Points of a modulus that varies
    /// smoothly are not, and not by rounding alone: their triangles lie on all sides.
    pub(in super::super) fn is_softer(&self, point: usize, than: usize) -> bool {
        self.of(point) < MUCH * self.of(than)
    }

    /// Root of the largest over the smallest one.
    pub(in super::super) fn contrast(&self) -> f64 {
        let of = |best: fn(f64, f64) -> f64| self.factors.iter().copied().reduce(best).unwrap_or(1.0);
        (of(f64::max) / of(f64::min)).sqrt()
    }

    /// That of a cell, stored or not; none where there is no point.
    pub(in super::super) fn at(
        &self,
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        cell: Cell,
    ) -> Option<f64> {
        let image = || if mirrors.is_none() { None } else { lattice.number(mirrors.image(cell).0) };
        Some(self.of(lattice.number(cell).or_else(image)?))
    }

    /// What a bond has that passes some cells, each with a part of its length; cells without a point count for nothing.
    pub(in super::super) fn through(
        &self,
        body: (&SquareLattice, &Mirrors),
        path: impl Iterator<Item = (Cell, f64)>,
    ) -> Through {
        let known = path.filter_map(|(cell, length)| Some((self.at(body, cell)?, length)));
        let (mut length, mut softness) = (0.0, 0.0);
        let (mut ends, mut is_one): (Option<[f64; 2]>, bool) = (None, true);
        for (factor, part) in known {
            length += part;
            softness += part / factor;
            is_one &= ends.is_none_or(|[first, _]| first == factor);
            ends = Some([ends.map_or(factor, |ends| ends[0]), factor]);
        }
        let ends = ends.unwrap_or([1.0; 2]);
        let factor = if is_one { ends[0] } else { (length / softness).min(0.5 * (ends[0] + ends[1])) };
        let mut shares = ends.map(|end| (0.5 * factor).min(0.5 * end));
        let stiffer = usize::from(ends[1] > ends[0]);
        shares[stiffer] += (factor - shares[0] - shares[1]).max(0.0);
        let lacks = [0, 1].map(|k| (0.5 * ends[k] - shares[k]).max(0.0));
        Through { factor, shares, lacks }
    }

    /// What bonds of a direction leave to a triangle by its corners, of which the first has the others beside it along x and
    /// along y: where moduli change along the bonds these are in series, where they change across them beside each other. Corners
    /// that are no points count for nothing.
    pub(in super::super) fn of_triangle(
        &self,
        body: (&SquareLattice, &Mirrors),
        cells: [Cell; 3],
        along: [f64; 2],
    ) -> f64 {
        let corners = cells.map(|cell| self.at(body, cell));
        let known: Vec<f64> = corners.into_iter().flatten().collect();
        let count = known.len() as f64;
        if known.iter().all(|factor| *factor == known[0]) {
            return known.first().copied().unwrap_or_else(|| self.around(body, cells[0]));
        }
        let mean = known.iter().sum::<f64>() / count;
        let series = count / known.iter().map(|factor| 1.0 / factor).sum::<f64>();
        let own = corners[0].unwrap_or(mean);
        let rise =
            |k: usize| f64::from(cells[k + 1][k] - cells[0][k]) * (corners[k + 1].unwrap_or(mean) - own);
        let slope = [rise(0), rise(1)];
        let steep = slope[0].hypot(slope[1]) * along[0].hypot(along[1]);
        let cosine = (slope[0] * along[0] + slope[1] * along[1]) / steep;
        let across = if steep > 0.0 { (cosine * cosine).min(1.0) } else { 0.5 };
        1.0 / (across / series + (1.0 - across) / mean)
    }

    /// That of the points next to a cell that has none, such as in a sharp corner: the mean of the nearest ring of cells with points.
    fn around(&self, body: (&SquareLattice, &Mirrors), [i, j, k]: Cell) -> f64 {
        let ring = |width: i32| {
            let cells = (-width..=width).flat_map(move |a| (-width..=width).map(move |b| [a, b]));
            let own = cells.filter(move |[a, b]| a.abs().max(b.abs()) == width);
            own.filter_map(|[a, b]| self.at(body, [i + a, j + b, k])).collect::<Vec<f64>>()
        };
        let nearest = (1..=FAR).map(ring).find(|known| !known.is_empty());
        nearest.map_or(1.0, |known| known.iter().sum::<f64>() / known.len() as f64)
    }

    /// That of the lattice of twice the spacing: the mean of the points in every cell.
    pub(in super::super) fn coarser(
        &self,
        fine: &SquareLattice,
        (coarse, mirrors): (&SquareLattice, &Mirrors),
    ) -> Option<Arc<Self>> {
        let of = |point: usize| {
            let [i, j, k] =
                if mirrors.is_none() { coarse.cell(point) } else { mirrors.image(coarse.cell(point)).0 };
            let plane = coarse.is_plane();
            let layer = |child: i32| if plane { k } else { 2 * k + (child >> 2) };
            let children = (0..if plane { 4 } else { 8 })
                .map(|child| [2 * i + (child & 1), 2 * j + (child >> 1 & 1), layer(child)]);
            let known: Vec<f64> = children.filter_map(|cell| Some(self.of(fine.number(cell)?))).collect();
            if known.is_empty() { 1.0 } else { known.iter().sum::<f64>() / known.len() as f64 }
        };
        Self::new((0..coarse.points()).map(of).collect())
    }
}
