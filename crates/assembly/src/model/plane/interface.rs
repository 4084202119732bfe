//! What bonds through several materials leave to the points of a body in the plane, and what these get of them.

use super::Mirrors;
use super::bond::PlaneBond;
use super::breaking::{remove_spanning, spans};
use super::edges::{modulus, triangles_of};
use super::mixture::Mixture;
use super::neighbourhood::Neighbourhood;
use super::uneven::{MixedBonds, UnevenBonds};
use crate::body::{Cell, SquareLattice};
use crate::bonds::{Mat, add};
use crate::stiffness::{Between, Exception, Families, Family};
use std::array::from_fn;
use std::collections::{BTreeMap, HashSet};
use std::sync::Arc;

/// The bonds of a body of several materials, as far as they are not those of one.
#[derive(Clone, Debug)]
pub(in super::super) struct Interface<const D: usize, const M: usize, const S: usize> {
    pub(super) mixture: Arc<Mixture>,
    /// Factors of bonds by offset and lower point.
    pub(super) exceptions: Vec<Exception>,
    /// Bonds through several tables of weights.
    pub(super) between: Vec<Between<M>>,
    pub(super) uneven: UnevenBonds<M>,
    /// Triangles that give back what points lack: first of bonds between points, then of those that end on the border.
    pub(super) families: Arc<Families<D, S, 2>>,
    /// Number of the first ones, which tell stresses, too.
    stress_count: usize,
    /// Points that no triangle gives what they lack.
    pub(super) lost: usize,
}

impl<const D: usize, const M: usize, const S: usize> Interface<D, M, S> {
    /// That of a body; `gaps` are bonds that give way to what completes the border, and `beside` is what bonds that end there leave
    /// to points.
    pub(super) fn new<B: PlaneBond<D, M, S>>(
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        (neighbourhood, bond): (&Neighbourhood<M>, &B),
        mixture: Arc<Mixture>,
        (cuts, gaps): (&HashSet<(usize, usize)>, &[Exception]),
        beside: &[(usize, usize, [f64; M])],
    ) -> Self {
        let absent = cuts.iter().copied().chain(gaps.iter().map(|gap| (gap.offset, gap.lower))).collect();
        let bonds = MixedBonds::new((lattice, mirrors), neighbourhood, &mixture, &absent);
        let of = |k: usize| units(lattice, bond, neighbourhood.offsets[k]);
        let units: Vec<[Mat<S, S>; M]> = (0..neighbourhood.offsets.len()).map(of).collect();
        let (mut families, mut stress_count, mut lost): (Vec<Family<D, S, 2>>, _, _) = (Vec::new(), 0, 0);
        for (lacks, tells) in [(&bonds.lacks[..], true), (beside, false)] {
            let mut by_point: BTreeMap<usize, Mat<S, S>> = BTreeMap::new();
            for (point, k, weights) in lacks {
                let sum = by_point.entry(*point).or_insert([[0.0; S]; S]);
                for (unit, weight) in units[*k].iter().zip(weights) {
                    add(sum, &unit.map(|row| row.map(|v| weight * v)));
                }
            }
            for (point, own) in by_point {
                let all = triangles_of(lattice, (neighbourhood, bond), (point, &own), cuts, Some(&mixture));
                lost += usize::from(all.is_empty());
                families.extend(all);
            }
            stress_count = if tells { families.len() } else { stress_count };
        }
        let families = Arc::new(Families::new(lattice.points(), families));
        let MixedBonds { exceptions, between, uneven, .. } = bonds;
        Self { mixture, exceptions, between, uneven, families, stress_count, lost }
    }

    /// The triangles that have one of some pairs of points for a side.
    pub(super) fn beside(&self, pairs: &HashSet<[u32; 2]>) -> Vec<Family<D, S, 2>> {
        self.families.list().iter().filter(|triangle| spans(triangle, pairs)).copied().collect()
    }

    /// Forgets the triangles that have one of some pairs of points for a side.
    pub(super) fn part(&mut self, pairs: &HashSet<[u32; 2]>) {
        self.stress_count -= self.stress_families().iter().filter(|triangle| spans(triangle, pairs)).count();
        remove_spanning(&mut self.families, pairs);
    }

    /// The triangles that tell stresses.
    pub(super) fn stress_families(&self) -> &[Family<D, S, 2>] {
        &self.families.list()[..self.stress_count]
    }

    /// Those that give back what bonds that end on the border leave.
    pub(super) fn beside_border(&self) -> &[Family<D, S, 2>] {
        &self.families.list()[self.stress_count..]
    }
}

/// What each measure of a bond of an offset, at the weight one, resists to uniform states.
fn units<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>>(
    lattice: &SquareLattice,
    bond: &B,
    offset: Cell,
) -> [Mat<S, S>; M] {
    from_fn(|m| modulus(lattice, bond, offset, &from_fn(|k| if k == m { 1.0 } else { 0.0 })))
}
