//! What strains that need no stress do to the elements of a lattice: the measures at which these are free of force.
//!
//! A bond that both ends have parts p of is free at the measures `s* = U (p_i t_i + p_j t_j)` of the free strains t of its points, what
//! completes the border at those of its places, a triangle at those of its point. The load of
//! [`LatticeBody::add_strain_work`] is that of the forces `Bᵀ C s*`, so that the energy of a state is
//! `Σ ½ C (s − s*)² = ½ u·K u − f·u + Σ ½ C s*²`.

use super::body::LatticeBody;
use super::bond::PlaneBond;
use super::edges::By;
use crate::bonds::Mat;
use crate::stiffness::Family;
use std::array::from_fn;
use std::collections::HashMap;

/// The measures at which bonds between points are free, of strains `t` of these, three planes.
pub(super) struct FreeBonds<'a, const M: usize> {
    t: &'a [f64],
    /// Halves of the measures in uniform strains, by offset that has bonds.
    halves: Vec<Mat<3, M>>,
    /// What lower points have beyond halves, by offset and lower point.
    beyond: HashMap<(usize, usize), [f64; M]>,
}

impl<const M: usize> FreeBonds<'_, M> {
    /// Those of a bond, by index of its offset among those that have bonds, and its points.
    pub(super) fn measures(&self, class: usize, [i, j]: [usize; 2]) -> [f64; M] {
        let n = self.t.len() / 3;
        let beyond = self.beyond.get(&(class, i)).unwrap_or(&[0.0; M]);
        let strain =
            |q: usize, more: f64| (1.0 + more) * self.t[q * n + i] + (1.0 - more) * self.t[q * n + j];
        from_fn(|m| (0..3).map(|q| self.halves[class][q][m] * strain(q, 2.0 * beyond[m])).sum())
    }
}

impl<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>> LatticeBody<D, M, S, B> {
    /// The measures at which bonds between points are free.
    pub(super) fn free_bonds<'a>(&self, t: &'a [f64]) -> FreeBonds<'a, M> {
        let beyond = self.interface.iter().flat_map(|interface| interface.uneven.beyond()).collect();
        FreeBonds { t, halves: self.virial_shares(1.0), beyond }
    }

    /// Energy `Σ ½ C s*²` of the body where nothing moves, of free strains `t` of its points, three planes; it has no images.
    pub(in super::super) fn energy_at_rest(&self, t: &[f64]) -> f64 {
        let (free, mut energy) = (self.free_bonds(t), 0.0);
        let of = |moduli: &[f64; M], s: [f64; M]| (0..M).map(|m| 0.5 * moduli[m] * s[m] * s[m]).sum::<f64>();
        self.bonds.for_each_with_moduli(|class, ends, moduli| {
            energy += of(&moduli, free.measures(class, ends));
        });
        match &self.border.by {
            By::Points => energy += of_triangles(self.triangles.list(), t),
            By::Bonds(border) => {
                let body = (&*self.lattice, &self.neighbourhood, &self.kind.bond);
                let bonds = 0..border.kinds.len();
                energy += bonds.map(|k| of(border.bonds.moduli(k), border.free(body, t, k))).sum::<f64>();
            }
            // Bodies whose border is of these do not break.
            By::Triangles(_) => {}
        }
        energy + self.interface.as_ref().map_or(0.0, |interface| of_triangles(interface.families.list(), t))
    }
}

/// The energy of triangles where nothing moves.
fn of_triangles<const D: usize, const S: usize>(triangles: &[Family<D, S, 2>], t: &[f64]) -> f64 {
    let n = t.len() / 3;
    let of = |triangle: &Family<D, S, 2>| {
        let own: [f64; S] = from_fn(|q| if q < 3 { t[q * n + triangle.point as usize] } else { 0.0 });
        own.iter().zip(triangle.stress(&own)).map(|(e, s)| 0.5 * e * s).sum::<f64>()
    };
    triangles.iter().map(of).sum()
}
