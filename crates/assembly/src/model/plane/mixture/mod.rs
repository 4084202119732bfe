//! Bodies of several materials: how stiff every point is, and what a bond through several of them has.
//!
//! A bond that passes the cells of its path with the parts l_q of its length is as stiff as these in series,
//! `f = 1/Σ(l_q/E_q)`, but no stiffer than the mean of its ends. Where materials differ in weights a_q, its parts stretch by 1/C_q
//! of what these resist along it: `f = Σ(l_q a_q/C_q)/Σ(l_q/C_q)`, measure by measure. Each end would have half of a bond of its
//! own material: the softer one gets that at most, the stiffer one the rest, and what an end lacks then, `E_i/2 − share_i >= 0`,
//! it gets back in triangles.

mod coarser;

pub(in super::super) use coarser::Blend;

use super::Mirrors;
use super::neighbourhood::OfMaterial;
use crate::body::{Cell, SquareLattice};
use std::array::from_fn;
use std::sync::Arc;

/// Modulus of a neighbour, over that of a point, below which it is of another material.
const MUCH: f64 = 0.9;

/// Cells between a triangle that a border cuts and the next point, at most.
const FAR: i32 = 4;

/// Moduli of the points of a lattice over those of the base material or, where the bonds of points have weights of their own, over
/// those of these.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Mixture {
    factors: Vec<f64>,
    /// Which table has the weights of the bonds of a point; none where all have one.
    tables: Vec<u8>,
    /// What the last tables are made of, those of coarser lattices.
    blends: Vec<Blend>,
}

/// A bond, or the part of one that lies in the body, through the materials of its cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct Through<const M: usize> {
    /// Its weights.
    pub(in super::super) weights: [f64; M],
    /// What its ends have of these.
    pub(in super::super) shares: [[f64; M]; 2],
    /// What its ends lack of half a bond of their own material, >= 0.
    pub(in super::super) lacks: [[f64; M]; 2],
}

impl Mixture {
    /// One modulus per point of a lattice, over that of the base material and > 0; images have that of their point. None where
    /// all points are of the base material.
    pub(in super::super) fn new(factors: Vec<f64>) -> Option<Arc<Self>> {
        Self::of_tables(factors, Vec::new())
    }

    /// The same of points with tables of weights, zero that of the base material; no table where all have this one.
    pub(in super::super) fn of_tables(mut factors: Vec<f64>, mut tables: Vec<u8>) -> Option<Arc<Self>> {
        if tables.iter().all(|table| *table == 0) {
            tables.clear();
        }
        if factors.is_empty() {
            factors = vec![1.0; tables.len()];
        }
        let is_mixed = !tables.is_empty() || factors.iter().any(|factor| *factor != 1.0);
        is_mixed.then(|| Arc::new(Self { factors, tables, blends: Vec::new() }))
    }

    /// Modulus of a point over that of its table.
    pub(in super::super) fn of(&self, point: usize) -> f64 {
        self.factors[point]
    }

    /// Which table has the weights of the bonds of a point.
    pub(in super::super) fn table(&self, point: usize) -> usize {
        self.tables.get(point).map_or(0, |table| usize::from(*table))
    }

    /// The tables of all points; none where they have one.
    pub(in super::super) fn tables(&self) -> &[u8] {
        &self.tables
    }

    /// What the last tables are made of.
    pub(in super::super) fn blends(&self) -> &[Blend] {
        &self.blends
    }

    /// Whether two points are of one material.
    pub(in super::super) fn are_alike(&self, [a, b]: [usize; 2]) -> bool {
        self.of(a) == self.of(b) && self.table(a) == self.table(b)
    }

    /// Whether the strains of a point are not those of another, as it is much softer or has other weights. Points of a modulus that
    /// varies smoothly are not so, and not by rounding alone: their triangles lie on all sides.
    pub(in super::super) fn strains_apart(&self, point: usize, from: usize) -> bool {
        self.table(point) != self.table(from) || self.of(point) < MUCH * self.of(from)
    }

    /// Root of the largest over the smallest one.
    pub(in super::super) fn contrast(&self) -> f64 {
        let of = |best: fn(f64, f64) -> f64| self.factors.iter().copied().reduce(best).unwrap_or(1.0);
        (of(f64::max) / of(f64::min)).sqrt()
    }

    /// The point of a cell, stored or not; none where there is none.
    pub(in super::super) fn point(
        &self,
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        cell: Cell,
    ) -> Option<usize> {
        let image = || if mirrors.is_none() { None } else { lattice.number(mirrors.image(cell).0) };
        lattice.number(cell).or_else(image)
    }

    /// The table that all cells of a path have; the first one if none of them has a point.
    pub(in super::super) fn table_along(
        &self,
        body: (&SquareLattice, &Mirrors),
        mut path: impl Iterator<Item = (Cell, f64)>,
    ) -> Option<usize> {
        if self.tables.is_empty() {
            return Some(0);
        }
        let table = |cell| Some(self.table(self.point(body, cell)?));
        let first = path.find_map(|(cell, _)| table(cell)).unwrap_or(0);
        path.all(|(cell, _)| table(cell).is_none_or(|other| other == first)).then_some(first)
    }

    /// How much stiffer than in the base material a bond is that passes some cells of one table, each with a part of its length.
    pub(in super::super) fn through(
        &self,
        body: (&SquareLattice, &Mirrors),
        path: impl Iterator<Item = (Cell, f64)>,
    ) -> Through<1> {
        self.weights_through(body, path, |_| OfMaterial { weights: [1.0], along: [1.0] })
    }

    /// What a bond has that passes some cells, each with a part of its length and the weights of its table; cells without a point
    /// count for nothing.
    pub(in super::super) fn weights_through<const M: usize>(
        &self,
        body: (&SquareLattice, &Mirrors),
        path: impl Iterator<Item = (Cell, f64)>,
        material: impl Fn(usize) -> OfMaterial<M>,
    ) -> Through<M> {
        let known = path.filter_map(|(cell, length)| Some((self.point(body, cell)?, length)));
        let (mut action, mut stretch) = ([0.0; M], [0.0; M]);
        let (mut ends, mut is_one): (Option<[[f64; M]; 2]>, bool) = (None, true);
        for (point, part) in known {
            let (OfMaterial { weights, along }, factor) = (material(self.table(point)), self.of(point));
            let own = weights.map(|weight| factor * weight);
            for m in 0..M {
                let share = part / (factor * along[m]);
                // Of equal ones it is exactly so.
                action[m] += if weights == along { part } else { share * own[m] };
                stretch[m] += share;
            }
            is_one &= ends.is_none_or(|[first, _]| first == own);
            ends = Some([ends.map_or(own, |ends| ends[0]), own]);
        }
        let ends = ends.unwrap_or_else(|| [material(0).weights; 2]);
        let series = |m: usize| (action[m] / stretch[m]).min(0.5 * (ends[0][m] + ends[1][m]));
        let all: [f64; M] = if is_one { ends[0] } else { from_fn(series) };
        let mut shares = ends.map(|end| from_fn(|m| (0.5 * all[m]).min(0.5 * end[m])));
        for m in 0..M {
            let stiffer = usize::from(ends[1][m] > ends[0][m]);
            shares[stiffer][m] += (all[m] - shares[0][m] - shares[1][m]).max(0.0);
        }
        let lacks = [0, 1].map(|k| from_fn(|m| (0.5 * ends[k][m] - shares[k][m]).max(0.0)));
        Through { weights: all, shares, lacks }
    }

    /// The weights of what bonds of a direction leave to a triangle by its corners, of which the first has the others beside it along
    /// x and along y: where weights change along the bonds these are in series, where they change across them beside each other.
    /// Corners that are no points count for nothing.
    pub(in super::super) fn of_triangle<const M: usize>(
        &self,
        body: (&SquareLattice, &Mirrors),
        cells: [Cell; 3],
        along: [f64; 2],
        weights: impl Fn(usize) -> [f64; M],
    ) -> [f64; M] {
        let own = |point: usize| weights(self.table(point)).map(|weight| self.of(point) * weight);
        let corners = cells.map(|cell| self.point(body, cell).map(own));
        let known: Vec<[f64; M]> = corners.into_iter().flatten().collect();
        match known.first() {
            None => {
                let around = self.around(body, cells[0]);
                let count = around.len() as f64;
                let sum = |m: usize| around.iter().map(|point| own(*point)[m]).sum::<f64>();
                return if around.is_empty() { weights(0) } else { from_fn(|m| sum(m) / count) };
            }
            Some(first) if known.iter().all(|other| other == first) => return *first,
            Some(_) => {}
        }
        from_fn(|m| in_triangle(cells, corners.map(|of| of.map(|weights| weights[m])), along))
    }

    /// The points next to a cell that has none, such as in a sharp corner: those of the nearest ring of cells with points.
    fn around(&self, body: (&SquareLattice, &Mirrors), [i, j, k]: Cell) -> Vec<usize> {
        let ring = |width: i32| {
            let cells = (-width..=width).flat_map(move |a| (-width..=width).map(move |b| [a, b]));
            let own = cells.filter(move |[a, b]| a.abs().max(b.abs()) == width);
            own.filter_map(|[a, b]| self.point(body, [i + a, j + b, k])).collect::<Vec<usize>>()
        };
        (1..=FAR).map(ring).find(|known| !known.is_empty()).unwrap_or_default()
    }
}

/// The weight of what bonds of a direction leave to a triangle whose corners have other ones, as far as they are points.
fn in_triangle(cells: [Cell; 3], corners: [Option<f64>; 3], along: [f64; 2]) -> f64 {
    let known = corners.iter().flatten();
    let count = known.clone().count() as f64;
    let mean = known.clone().sum::<f64>() / count;
    let series = count / known.map(|weight| 1.0 / weight).sum::<f64>();
    let own = corners[0].unwrap_or(mean);
    let rise = |k: usize| f64::from(cells[k + 1][k] - cells[0][k]) * (corners[k + 1].unwrap_or(mean) - own);
    let slope = [rise(0), rise(1)];
    let steep = slope[0].hypot(slope[1]) * along[0].hypot(along[1]);
    let cosine = (slope[0] * along[0] + slope[1] * along[1]) / steep;
    let across = if steep > 0.0 { (cosine * cosine).min(1.0) } else { 0.5 };
    match [across > 0.0, across < 1.0] {
        [true, true] => 1.0 / (across / series + (1.0 - across) / mean),
        [true, false] => series,
        _ => mean,
    }
}
