//! Bodies of several materials: of which the points are, and what of an elongation belongs to a point's own one.
//!
//! A bond that passes the cells of its path with the parts l_q of its length has the modulus of these in series,
//! `E = 1/Σ(l_q/E_q)`. Of its elongation e the point k sees `g e` with `g = E/E_k`: that of a bond under the same force which is of
//! its own material alone. With it in its dilatation and in its stretches a family knows layers in series, and no energy is
//! negative. Along an interface the softer side sees too much and the stiffer one too little: together they have what bonds in
//! series have.

use super::super::plane::{Mirrors, Path};
use super::StateParameters;
use super::ghosts::{Fit, nearest};
use crate::body::{Cell, SquareLattice, plus};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The materials of a body without ghosts and images.
#[derive(Clone, Debug, PartialEq)]
pub struct StateMaterials {
    /// The base material, then others with its Young's modulus.
    pub(super) of: Vec<StateParameters>,
    /// By material, Young's moduli of the points that are of it over that of the base material; zero where they are of others.
    /// On coarser lattices means of those.
    parts: Vec<Vec<f64>>,
}

impl StateMaterials {
    /// A base material and others by their Poisson's ratios. `numbers` are those of the points, 0 for the base material, else
    /// places among the others, from 1 on; `factors` their Young's moduli over that of the base material, > 0. None where all
    /// points are of the base material.
    pub fn new(
        base: &StateParameters,
        poisson_ratios: &[f64],
        numbers: &[u32],
        factors: &[f64],
    ) -> Option<Arc<Self>> {
        let other = |&poisson_ratio: &f64| StateParameters { poisson_ratio, ..*base };
        let of: Vec<StateParameters> =
            std::iter::once(*base).chain(poisson_ratios.iter().map(other)).collect();
        let points = || numbers.iter().zip(factors);
        let is_other = |(number, factor): (&u32, &f64)| of[*number as usize] != *base || *factor != 1.0;
        let part = |k: usize| {
            let own = |(number, factor): (&u32, &f64)| if *number as usize == k { *factor } else { 0.0 };
            points().map(own).collect()
        };
        points().any(is_other).then(|| Arc::new(Self { parts: (0..of.len()).map(part).collect(), of }))
    }

    /// The material that makes up most of the stiffness of a point.
    pub(super) fn number(&self, point: usize) -> usize {
        let part = |k: &usize| self.parts[*k][point];
        (0..self.of.len()).max_by(|a, b| part(a).total_cmp(&part(b)).then(b.cmp(a))).unwrap_or_default()
    }

    /// Those of the lattice of twice the spacing: the mean of the points in every cell.
    pub(super) fn coarser(&self, fine: &SquareLattice, coarse: &SquareLattice) -> Arc<Self> {
        let below = |point: usize| -> Vec<usize> {
            let [i, j, k] = coarse.cell(point);
            let children = (0..4).map(|child| [2 * i + (child & 1), 2 * j + (child >> 1), k]);
            children.filter_map(|cell| fine.number(cell)).collect()
        };
        let below: Vec<Vec<usize>> = (0..coarse.points()).map(below).collect();
        let mean = |part: &Vec<f64>| -> Vec<f64> {
            let of = |own: &Vec<usize>| own.iter().map(|&p| part[p]).sum::<f64>() / own.len().max(1) as f64;
            below.iter().map(of).collect()
        };
        Arc::new(Self { of: self.of.clone(), parts: self.parts.iter().map(mean).collect() })
    }

    /// What the modulus of a ghost is over that of the nearest point, where this is of a graded material: its logarithm goes on as
    /// displacements do, so that it is positive. One where all points of the fit are alike or not all of one material.
    fn beyond(&self, real: &SquareLattice, nearest: usize, fit: &Fit) -> f64 {
        let number = self.number(nearest);
        let parts = &self.parts[number];
        let points = || fit.iter().filter_map(|&(cell, share)| Some((real.number(cell)?, share)));
        if points().all(|(p, _)| parts[p] == parts[nearest])
            || points().any(|(p, _)| self.number(p) != number)
        {
            return 1.0;
        }
        points().map(|(p, share)| share * (parts[p] / parts[nearest]).ln()).sum::<f64>().exp()
    }
}

/// The materials of a lattice with ghosts and images.
#[derive(Clone, Debug)]
pub(super) struct Mixture {
    pub(super) materials: Arc<StateMaterials>,
    /// The point of the body whose material a point has: of an image its own, of a ghost the nearest.
    source: Vec<u32>,
    /// What the moduli of ghosts are over those of these points; one elsewhere.
    beyond: Vec<f64>,
    /// Young's moduli of the points, Pa.
    moduli: Vec<f64>,
}

impl Mixture {
    pub(super) fn new(
        materials: &Arc<StateMaterials>,
        real: &SquareLattice,
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        fits: &BTreeMap<Cell, Fit>,
    ) -> Self {
        let source = |point: usize| {
            let cell = mirrors.image(lattice.cell(point)).0;
            let own = real.number(cell).or_else(|| real.number(nearest(real, cell)?));
            own.unwrap_or_default() as u32
        };
        let source: Vec<u32> = (0..lattice.points()).map(source).collect();
        let beyond = |point: usize| {
            let fit = fits.get(&mirrors.image(lattice.cell(point)).0);
            fit.map_or(1.0, |fit| materials.beyond(real, source[point] as usize, fit))
        };
        let beyond = (0..lattice.points()).map(beyond).collect();
        let mut mixture = Self { materials: materials.clone(), source, beyond, moduli: Vec::new() };
        mixture.moduli = (0..lattice.points()).map(|p| mixture.mean(p, |of| of.youngs_modulus)).collect();
        mixture
    }

    /// Young's modulus that a point has of a material over that of the base material.
    pub(super) fn part(&self, material: usize, point: usize) -> f64 {
        self.beyond[point] * self.materials.parts[material][self.source[point] as usize]
    }

    /// The material of a point.
    pub(super) fn number(&self, point: usize) -> usize {
        self.materials.number(self.source[point] as usize)
    }

    /// The material of a point with its Young's modulus.
    pub(super) fn of(&self, point: usize) -> StateParameters {
        let own = self.materials.of[self.number(point)];
        StateParameters { youngs_modulus: self.moduli[point], ..own }
    }

    /// A modulus of a point, as the sum of what it has of the materials.
    pub(super) fn mean(&self, point: usize, of: impl Fn(&StateParameters) -> f64) -> f64 {
        let parts = self.materials.of.iter().enumerate();
        parts
            .map(|(k, material)| (self.part(k, point), material))
            .filter(|(part, _)| *part > 0.0)
            .map(|(part, material)| part * of(material))
            .sum()
    }

    /// What of the elongations towards its neighbours, by the paths to these, belongs to a point's own material; none where that is
    /// all of them.
    pub(super) fn own(&self, lattice: &SquareLattice, point: usize, paths: &[Vec<(Cell, f64)>]) -> Vec<f64> {
        let (cell, own) = (lattice.cell(point), self.moduli[point]);
        let mut is_one = true;
        let seen = |path: &Vec<(Cell, f64)>| {
            let (mut length, mut softness) = (0.0, 0.0);
            for &(step, part) in path {
                let Some(other) = lattice.number(plus(cell, step)) else { continue };
                is_one &= self.moduli[other] == own;
                length += part;
                softness += part * own / self.moduli[other];
            }
            length / softness
        };
        let seen: Vec<f64> = paths.iter().map(seen).collect();
        if is_one { Vec::new() } else { seen }
    }

    /// Root of the largest over the smallest Young's modulus.
    pub(super) fn contrast(&self) -> f64 {
        let of = |best: fn(f64, f64) -> f64| self.moduli.iter().copied().reduce(best).unwrap_or(1.0);
        (of(f64::max) / of(f64::min)).sqrt()
    }
}

/// The cells that bonds of some offsets pass, with the parts of their lengths there.
pub(super) fn paths(offsets: &[Cell]) -> Vec<Vec<(Cell, f64)>> {
    offsets.iter().map(|&offset| Path::of(offset).pieces().collect()).collect()
}
