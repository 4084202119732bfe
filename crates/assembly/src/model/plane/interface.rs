//! What bonds through several materials leave to the points of a body in the plane, and what these get of them.

use super::Mirrors;
use super::bond::PlaneBond;
use super::breaking::{remove_spanning, spans};
use super::edges::{modulus, triangles_of};
use super::mixture::Mixture;
use super::neighbourhood::Neighbourhood;
use super::uneven::{MixedBonds, UnevenBonds};
use crate::body::SquareLattice;
use crate::bonds::{Mat, add};
use crate::stiffness::{Exception, Families, Family};
use std::collections::{BTreeMap, HashSet};
use std::sync::Arc;

/// The bonds of a body of several materials, as far as they are not those of one.
#[derive(Clone, Debug)]
pub(in super::super) struct Interface<const D: usize, const S: usize> {
    pub(super) mixture: Arc<Mixture>,
    /// Factors of bonds by offset and lower point.
    pub(super) exceptions: Vec<Exception>,
    pub(super) uneven: UnevenBonds,
    /// Triangles that give back what points lack: first of bonds between points, then of those that end on the border.
    pub(super) families: Arc<Families<D, S, 2>>,
    /// Number of the first ones, which tell stresses, too.
    stress_count: usize,
    /// Points that no triangle gives what they lack.
    pub(super) lost: usize,
}

impl<const D: usize, const S: usize> Interface<D, S> {
    /// That of a body; `gaps` are bonds that give way to what completes the border, and `beside` is what bonds that end there leave
    /// to points.
    pub(super) fn new<const M: usize, B: PlaneBond<D, M, S>>(
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        (neighbourhood, bond): (&Neighbourhood<M>, &B),
        mixture: Arc<Mixture>,
        (cuts, gaps): (&HashSet<(usize, usize)>, &[Exception]),
        beside: &[(usize, usize, f64)],
    ) -> Self {
        let absent = cuts.iter().copied().chain(gaps.iter().map(|gap| (gap.offset, gap.lower))).collect();
        let bonds = MixedBonds::new((lattice, mirrors), neighbourhood, &mixture, &absent);
        let whole: Vec<Mat<S, S>> =
            (0..neighbourhood.offsets.len()).map(|k| modulus(lattice, neighbourhood, bond, k)).collect();
        let (mut families, mut stress_count, mut lost): (Vec<Family<D, S, 2>>, _, _) = (Vec::new(), 0, 0);
        for (lacks, tells) in [(&bonds.lacks[..], true), (beside, false)] {
            let mut by_point: BTreeMap<usize, Mat<S, S>> = BTreeMap::new();
            for &(point, k, part) in lacks {
                let own = whole[k].map(|row| row.map(|v| part * v));
                add(by_point.entry(point).or_insert([[0.0; S]; S]), &own);
            }
            for (point, own) in by_point {
                let all = triangles_of(lattice, (neighbourhood, bond), (point, &own), cuts, Some(&mixture));
                lost += usize::from(all.is_empty());
                families.extend(all);
            }
            stress_count = if tells { families.len() } else { stress_count };
        }
        let families = Arc::new(Families::new(lattice.points(), families));
        let MixedBonds { exceptions, uneven, .. } = bonds;
        Self { mixture, exceptions, uneven, families, stress_count, lost }
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
