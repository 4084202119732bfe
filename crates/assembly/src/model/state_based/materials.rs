//! Bodies of several materials: of which the points are, and what of an elongation belongs to a point's own one.
//!
//! A bond that passes the cells of its path with the parts l_q of its length has the modulus of these in series,
//! `E = 1/Σ(l_q/E_q)`. Of its elongation e the point k sees `g e` with `g = E/E_k`: that of a bond under the same force which is of
//! its own material alone. With it in its dilatation and in its stretches a family knows layers in series, and no energy is
//! negative. Along an interface the softer side sees too much and the stiffer one too little: together they have what bonds in
//! series have.

use super::super::plane::{Mirrors, Path};
use super::StateParameters;
use super::ghosts::nearest;
use crate::body::{Cell, SquareLattice, plus};
use std::sync::Arc;

/// The materials of a body without ghosts and images.
#[derive(Clone, Debug, PartialEq)]
pub struct StateMaterials {
    /// The base material, then others.
    pub(super) of: Vec<StateParameters>,
    /// By material, the parts that the points have of it; they sum to one.
    parts: Vec<Vec<f64>>,
}

impl StateMaterials {
    /// A base material and others, by Young's modulus and Poisson's ratio; `numbers` are those of the points, 0 for the base
    /// material, else places among the others, from 1 on. None where all points are of the base material.
    pub fn new(base: &StateParameters, others: &[[f64; 2]], numbers: &[u32]) -> Option<Arc<Self>> {
        let other = |&[youngs_modulus, poisson_ratio]: &[f64; 2]| StateParameters {
            youngs_modulus,
            poisson_ratio,
            ..*base
        };
        let of: Vec<StateParameters> = std::iter::once(*base).chain(others.iter().map(other)).collect();
        let is_other = |number: &u32| of[*number as usize] != *base;
        let part =
            |k: usize| numbers.iter().map(|number| f64::from(u8::from(*number as usize == k))).collect();
        numbers.iter().any(is_other).then(|| Arc::new(Self { parts: (0..of.len()).map(part).collect(), of }))
    }

    /// The material that a point has most of.
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
}

/// The materials of a lattice with ghosts and images.
#[derive(Clone, Debug)]
pub(super) struct Mixture {
    pub(super) materials: Arc<StateMaterials>,
    /// The point of the body whose material a point has: of an image its own, of a ghost the nearest.
    source: Vec<u32>,
    /// Young's moduli of the points, Pa.
    moduli: Vec<f64>,
}

impl Mixture {
    pub(super) fn new(
        materials: &Arc<StateMaterials>,
        real: &SquareLattice,
        (lattice, mirrors): (&SquareLattice, &Mirrors),
    ) -> Self {
        let source = |point: usize| {
            let cell = mirrors.image(lattice.cell(point)).0;
            let own = real.number(cell).or_else(|| real.number(nearest(real, cell)?));
            own.unwrap_or_default() as u32
        };
        let mut mixture = Self {
            materials: materials.clone(),
            source: (0..lattice.points()).map(source).collect(),
            moduli: Vec::new(),
        };
        mixture.moduli = (0..lattice.points()).map(|p| mixture.mean(p, |of| of.youngs_modulus)).collect();
        mixture
    }

    /// The part that a point has of a material.
    pub(super) fn part(&self, material: usize, point: usize) -> f64 {
        self.materials.parts[material][self.source[point] as usize]
    }

    /// The material of a point.
    pub(super) fn number(&self, point: usize) -> usize {
        self.materials.number(self.source[point] as usize)
    }

    /// The mean of a modulus over what a point has of the materials.
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
