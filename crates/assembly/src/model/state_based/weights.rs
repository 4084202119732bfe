//! Weights of the families of all points of a lattice, and the volumes that their energies have.

use super::super::plane::{half_offsets, is_within};
use super::materials::{Mixture, paths};
use super::sets::Maker;
use super::{StateEdges, StateError, StateParameters};
use crate::body::{Cell, SquareLattice, plus};
use std::collections::HashMap;

/// Weights below this part of the largest one are what rounding leaves of zero.
const ROUNDING: f64 = 1e-14;

/// Weights that points share, in lattice units.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Set {
    /// Per offset; zero where there is no neighbour, or no bond any more.
    pub(super) weights: Vec<f64>,
    /// Weighted volume `Σ w ξ²` of the undamaged family.
    pub(super) q: f64,
    /// Per offset, what of an elongation belongs to the material of the point; empty where that is all.
    pub(super) own: Vec<f64>,
}

impl Set {
    /// What of the elongation towards a neighbour belongs to the material of the point.
    pub(super) fn own(&self, offset: usize) -> f64 {
        self.own.get(offset).copied().unwrap_or(1.0)
    }
}

/// Families of the points of a lattice.
#[derive(Clone, Debug)]
pub(super) struct FamilyWeights {
    /// From a point to its neighbours, cells: a half, then their opposites in the same order.
    pub(super) offsets: Vec<Cell>,
    pub(super) sets: Vec<Set>,
    /// Set of every point; none where a point has no family.
    pub(super) set_of: Vec<Option<u32>>,
    /// Volume that the energy of a point has, per that of a whole cell one spacing from the axis, or in the plane; zero of
    /// points without a family.
    pub(super) energy: Vec<f64>,
    /// The same of the volumes that they have.
    pub(super) volume: Vec<f64>,
    /// Shear moduli of the points over that of the base material; empty where all have that.
    shear: Vec<f64>,
}

/// One of each pair of opposite offsets to the neighbours of a point.
pub(super) fn offsets(parameters: &StateParameters) -> Vec<Cell> {
    let m = parameters.horizon_ratio;
    half_offsets(m, 1).into_iter().filter(|&o| is_within(o, m)).collect()
}

impl FamilyWeights {
    /// The families of the points of a lattice that are `real`; bonds that are `apart`, by offset of the half and lower point,
    /// sorted, are in none.
    ///
    /// # Errors
    /// [`StateError`].
    pub(super) fn new(
        parameters: &StateParameters,
        (lattice, apart): (&SquareLattice, &[(usize, usize)]),
        real: &[bool],
        has_axis: bool,
        mixture: Option<&Mixture>,
    ) -> Result<Self, StateError> {
        if parameters.horizon_ratio < 1.5 {
            return Err(StateError::NoNeighbours(parameters.horizon_ratio));
        }
        let half = offsets(parameters);
        let offsets: Vec<Cell> = half.iter().copied().chain(half.iter().map(|o| o.map(|k| -k))).collect();
        let maker = Maker::new(parameters, lattice, &offsets, has_axis)?.without(apart);
        let n = lattice.points();
        let (mut sets, mut known, mut set_of) = (Vec::new(), HashMap::new(), vec![None; n]);
        let mut negative = Vec::new();
        sets.push(maker.plain());
        known.insert(((0, vec![true; offsets.len()]), Vec::new()), 0);
        let paths = paths(&offsets);
        for (point, set) in set_of.iter_mut().enumerate().filter(|(p, _)| real[*p]) {
            let own = mixture.map_or(Vec::new(), |mixture| mixture.own(lattice, point, &paths));
            let bits: Vec<u64> = own.iter().map(|part| part.to_bits()).collect();
            let number = *known.entry((maker.key(point), bits)).or_insert_with_key(|(key, _)| {
                sets.push(Set { own, ..maker.set(key) });
                sets.len() as u32 - 1
            });
            let own = &sets[number as usize];
            let most = own.weights.iter().fold(0.0, |a: f64, w| a.max(w.abs()));
            if own.weights.iter().any(|w| *w < -ROUNDING * most) {
                negative.push(point);
            }
            *set = Some(number);
        }
        let volume: Vec<f64> = (0..n).map(|p| if real[p] { maker.volume(p, false) } else { 0.0 }).collect();
        let energy: Vec<f64> = (0..n).map(|p| if real[p] { maker.volume(p, true) } else { 0.0 }).collect();
        let base = parameters.shear_modulus();
        let of_base = |mixture: &Mixture| -> Vec<f64> {
            (0..n).map(|p| mixture.mean(p, StateParameters::shear_modulus) / base).collect()
        };
        let shear = mixture.map_or(Vec::new(), of_base);
        let mut families = Self { offsets, sets, set_of, energy, volume, shear };
        match parameters.edges {
            StateEdges::Moment if !negative.is_empty() => {
                return Err(StateError::NegativeWeights(negative.len()));
            }
            StateEdges::MomentPlus | StateEdges::Ghosts => {
                let number = |p: usize| mixture.map_or(0, |mixture| mixture.number(p));
                families.give_away(lattice, &negative, &number);
            }
            _ => {}
        }
        Ok(families)
    }

    /// The energies of some points go to the nearest ones of their material, by its number, that are not among them.
    fn give_away(&mut self, lattice: &SquareLattice, from: &[usize], number: &dyn Fn(usize) -> usize) {
        let keeps = |p: usize| self.set_of[p].is_some() && from.binary_search(&p).is_err();
        let mut moved = Vec::new();
        for &point in from {
            let cell = lattice.cell(point);
            // Rings of growing size: corners are a few cells large.
            let found = (1..64).find_map(|reach: i32| {
                let ring = (-reach..=reach).flat_map(|j| (-reach..=reach).map(move |i| [i, j, 0]));
                let near = ring.filter(|[i, j, _]| i * i + j * j <= reach * reach);
                let points =
                    near.filter_map(|s| Some((s[0] * s[0] + s[1] * s[1], lattice.number(plus(cell, s))?)));
                points.filter(|(_, p)| keeps(*p) && number(*p) == number(point)).min()
            });
            moved.extend(found.map(|(_, to)| (point, to)));
        }
        for (from, to) in moved {
            let energy = std::mem::take(&mut self.energy[from]);
            self.energy[to] += energy;
        }
    }

    /// Index of the opposite offset.
    pub(super) fn opposite(&self, offset: usize) -> usize {
        (offset + self.offsets.len() / 2) % self.offsets.len()
    }

    /// Weight over weighted volume of a point's neighbour, per that of the plain family of the base material.
    fn share(&self, point: usize, offset: usize) -> f64 {
        let Some(number) = self.set_of[point] else { return 0.0 };
        let (own, plain) = (&self.sets[number as usize], &self.sets[0]);
        let material = self.shear.get(point).copied().unwrap_or(1.0) * own.own(offset).powi(2);
        material * self.energy[point] * (own.weights[offset] / own.q) / (plain.weights[offset] / plain.q)
    }

    /// Stiffness of the bond at an offset of the half from a lower to an upper point, per that in a plain lattice of cells of the
    /// base material whose energies count one: the mean of what both families give.
    pub(super) fn bond_factor(&self, offset: usize, lower: usize, upper: usize) -> f64 {
        0.5 * (self.share(lower, offset) + self.share(upper, self.opposite(offset)))
    }

    /// Removes bonds, by offset of the half and ends, from the families of both of their points. Weighted volumes stay.
    pub(super) fn remove(&mut self, bonds: &[(usize, [usize; 2])]) {
        let (half, shared) = (self.offsets.len() / 2, self.sets.len());
        for &(offset, [lower, upper]) in bonds {
            for (point, offset) in [(lower, offset), (upper, offset + half)] {
                let Some(number) = self.set_of[point].map(|number| number as usize) else { continue };
                if self.sets[number].weights[offset] == 0.0 {
                    continue;
                }
                // The first bond that a point loses gives it a set of its own.
                let mut own = number;
                if number < shared {
                    own = self.sets.len();
                    self.set_of[point] = Some(own as u32);
                    self.sets.push(self.sets[number].clone());
                }
                self.sets[own].weights[offset] = 0.0;
            }
        }
    }
}
