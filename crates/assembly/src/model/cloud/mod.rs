//! Bonds of listed points in the plane and in space.
//!
//! No weights are exact at every point of any cloud. So every point has a scale g, the largest with which its bonds are
//! nowhere stiffer than the material, `C − g M >= 0` with the moment M of its bonds; a bond takes the smaller scale of its
//! ends, and the overlay gives every point what it lacks of C: triangles in the plane, tetrahedra in space.

mod overlay;
mod pairs;
mod place;
mod scale;

pub(super) use overlay::{Overlay, overlay};
pub(super) use pairs::{Horizon, Pair, Sites};
pub(super) use place::Place;
pub(super) use scale::{moments, scale};

use super::ModelSizes;
use crate::bonds::Rows;
use crate::stiffness::{Bond, Bonds, Families, Term};
use std::sync::Arc;

/// Whether something separates two positions.
pub(super) type Cut<'a, const D: usize> = dyn Fn([f64; D], [f64; D]) -> bool + 'a;

/// A cloud with its bonds: D coordinates, S components of strain.
#[derive(Clone, Debug)]
pub(super) struct CloudBody<const D: usize, const S: usize> {
    pub(super) sites: Sites<D>,
    horizon: Horizon,
    pub(super) bonds: Arc<Bonds<D, 1>>,
    pub(super) overlay: Arc<Families<D, S, D>>,
    pub(super) uncorrected: usize,
    /// Size of the whole family of every point that counts, and of its cut part.
    family: Vec<f64>,
    lost: Vec<f64>,
}

impl<const D: usize, const S: usize> CloudBody<D, S>
where
    [f64; D]: Place<D, S>,
{
    /// That of pairs and what completes them; the bonds of pairs that are cut are none.
    pub(super) fn new(
        sites: Sites<D>,
        horizon: Horizon,
        pairs: &[Pair<D>],
        overlay: Overlay<D, S>,
        cut: &Cut<D>,
    ) -> Self {
        let n = sites.positions.len();
        let (mut family, mut lost) = (vec![0.0; n], vec![0.0; n]);
        let mut intact = Vec::with_capacity(pairs.len());
        for pair in pairs {
            let [i, j] = pair.ends();
            let is_cut = cut(sites.positions[i], sites.positions[j]);
            for (end, other) in [(i, j), (j, i)] {
                let part = pair.part * sites.sizes[other];
                family[end] += part;
                lost[end] += if is_cut { part } else { 0.0 };
            }
            if !is_cut {
                intact.push(Bond {
                    points: pair.points,
                    rows: Rows { difference: [pair.direction], mean: [[0.0; D]] },
                    moduli: [pair.stiffness],
                });
            }
        }
        Self {
            sites,
            horizon,
            bonds: Arc::new(Bonds::new(n, intact.into_iter())),
            overlay: Arc::new(Families::new(n, overlay.families)),
            uncorrected: overlay.uncorrected,
            family,
            lost,
        }
    }

    /// Terms of the energy.
    pub(super) fn terms(&self) -> Vec<Box<dyn Term<D>>> {
        let mut terms: Vec<Box<dyn Term<D>>> = vec![Box::new(self.bonds.clone())];
        if !self.overlay.list().is_empty() {
            terms.push(Box::new(self.overlay.clone()));
        }
        terms
    }

    /// Their sizes.
    pub(super) fn sizes(&self) -> ModelSizes {
        let bonds = ModelSizes::of(&self.bonds, self.bonds.elements());
        bonds.join(ModelSizes::of(&self.overlay, D * (D + 1) / 2 * self.overlay.elements()))
    }

    /// Length of a bond, m.
    pub(super) fn length(&self, bond: &Bond<D, 1>) -> f64 {
        self.sites.distance(bond.points.map(|p| p as usize))
    }

    /// Cut shares of the family volumes of all points.
    pub(super) fn damage(&self) -> Vec<f64> {
        let share = |(lost, family): (&f64, &f64)| if *lost > 0.0 { lost / family } else { 0.0 };
        self.lost.iter().zip(&self.family).map(share).collect()
    }

    /// Counts a bond as lost by its points.
    pub(super) fn lose(&mut self, [i, j]: [usize; 2]) {
        let part = self.horizon.part(self.sites.distance([i, j]), [i, j].map(|p| self.sites.width(p)));
        self.lost[i] += part * self.sites.sizes[j];
        self.lost[j] += part * self.sites.sizes[i];
    }

    /// Stresses and energy densities from the bonds alone, `σ_k = (1/V_k) ½ Σ_j k ξ N e`: S planes and one.
    pub(super) fn sums(&self, u: &[f64]) -> Vec<f64> {
        let n = self.sites.positions.len();
        let mut sums = vec![0.0; (S + 1) * n];
        for bond in self.bonds.list() {
            let (products, half) = (bond.rows.difference[0].product(), 0.5 * self.length(bond));
            let ([e], [force]) = bond.response(n, u);
            for p in bond.points.map(|p| p as usize) {
                let volume = self.sites.volume(p);
                (0..S).for_each(|q| sums[q * n + p] += half * products[q] * force / volume);
                sums[S * n + p] += 0.25 * e * force / volume;
            }
        }
        sums
    }

    /// Adds the forces that do the work `Σ_k t_k·V_k σ_k` with the strains `t`, S planes.
    pub(super) fn add_strain_work(&self, t: &[f64], force: &mut [f64]) {
        let n = self.sites.positions.len();
        for bond in self.bonds.list() {
            let [i, j] = bond.points.map(|p| p as usize);
            let products = bond.rows.difference[0].product();
            let both: f64 = (0..S).map(|q| products[q] * (t[q * n + i] + t[q * n + j])).sum();
            let action = 0.5 * self.length(bond) * bond.moduli[0] * both;
            for c in 0..D {
                force[c * n + i] -= bond.rows.difference[0][c] * action;
                force[c * n + j] += bond.rows.difference[0][c] * action;
            }
        }
        self.overlay.list().iter().for_each(|family| family.add_strain_work(S, t, force));
    }
}
