//! Breaking bonds of a lattice.

use super::body::LatticeBody;
use super::bond::PlaneBond;
use super::critical::CriticalStretch;
use super::critical_along::CriticalAlong;
use super::edges::{By, Completion, overlay};
use super::geometry;
use super::near::at;
use crate::body::SquareLattice;
use crate::stiffness::{Bond, Bonds, Families, Family, GridBonds, Term};
use std::collections::HashSet;
use std::sync::Arc;

impl<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>> LatticeBody<D, M, S, B> {
    /// Prepares for bonds that break: what a border leaves to the triangles that it cuts is taken apart into springs by the
    /// directions of bonds. It resists as before.
    pub(in super::super) fn prepare_to_break(&mut self) {
        if self.border.is_cut() {
            let cuts = self.cuts.iter().copied().collect();
            let (body, bonds) = ((&*self.lattice, &self.mirrors), (&self.neighbourhood, &self.kind.bond));
            let mixture = self.interface.as_ref().map(|interface| interface.mixture.clone());
            let of_points = mixture.as_deref();
            self.border = Completion::breaking(body, bonds, (&cuts, of_points));
            // Strains that follow from both sides of a crack are forgotten: then triangles tell the stress.
            let told: Vec<usize> = self.border.strains.iter().flat_map(|strains| strains.points()).collect();
            let gaps = &self.border.gaps;
            let whole = SquareLattice::clone(&self.lattice).with_whole_cells();
            let own = overlay(&whole, bonds, told.into_iter(), (&cuts, of_points), gaps).triangles;
            let all = self.triangles.list().iter().copied().chain(own).collect();
            self.triangles = Arc::new(Families::new(self.lattice.points(), all));
        }
    }

    /// Above the number of any bond: a bond has the number `offset · points + lower point`, the offset that of the
    /// neighbourhood; behind them are those that end on the border.
    pub(in super::super) fn bond_numbers(&self) -> u64 {
        (self.whole_bonds() + self.border.bonds().map_or(0, |border| border.bonds.count())) as u64
    }

    /// Above the number of any bond between two points.
    fn whole_bonds(&self) -> usize {
        self.neighbourhood.offsets.len() * self.lattice.points()
    }

    /// Bonds between two points, by offset and lower point, and the numbers of those that end on the border.
    fn sorted(&self, bonds: &[u64]) -> (Vec<(usize, usize)>, Vec<usize>) {
        let (whole, points) = (self.whole_bonds(), self.lattice.points());
        let (between, ended): (Vec<usize>, Vec<usize>) =
            bonds.iter().map(|&bond| bond as usize).partition(|&bond| bond < whole);
        let between = between.into_iter().map(|bond| (bond / points, bond % points));
        (between.collect(), ended.into_iter().map(|bond| bond - whole).collect())
    }

    pub(in super::super) fn ends(&self, bond: u64) -> [usize; 2] {
        let (bond, points) = (bond as usize, self.lattice.points());
        if let Some(ended) = bond.checked_sub(self.whole_bonds()) {
            let kind = self.border.bonds().and_then(|border| border.kinds.get(ended));
            return kind.map_or([0; 2], |kind| kind.foremost.map(|p| p as usize));
        }
        let (offset, lower) = (bond / points, bond % points);
        let upper =
            self.lattice.number(at(self.lattice.cell(lower), self.neighbourhood.offsets[offset], true));
        [lower, upper.unwrap_or(lower)]
    }

    /// Index of the offset of a bond.
    pub(in super::super) fn offset_of(&self, bond: u64) -> usize {
        let kinds = self.border.bonds().map_or(&[][..], |border| &border.kinds);
        let ended = (bond as usize).checked_sub(self.whole_bonds()).and_then(|ended| kinds.get(ended));
        ended.map_or(bond as usize / self.lattice.points(), |kind| kind.offset as usize)
    }

    pub(in super::super) fn for_each_ratio(
        &self,
        u: &[f64],
        critical: &CriticalStretch,
        visit: &mut dyn FnMut(u64, f64),
    ) {
        let points = self.lattice.points();
        let offsets: Vec<usize> = self.neighbourhood.bonded().collect();
        let ratios: Vec<f64> = offsets
            .iter()
            .map(|&k| {
                let bond = geometry(&self.lattice, self.neighbourhood.offsets[k]);
                self.kind.bond.stretch_per_measure(&bond) / critical.by_offset()[k]
            })
            .collect();
        let mixture = self.mixture().map(Arc::as_ref);
        let body = (&*self.lattice, &self.mirrors);
        let along = CriticalAlong::new(critical, body, mixture, &self.neighbourhood.offsets);
        let free = critical.free().map(|t| self.free_bonds(t));
        self.bonds.for_each_measured(u, |index, ends, s| {
            let (lower, own) = (ends[0], free.as_ref().map_or(0.0, |free| free.measures(index, ends)[0]));
            let ratio = ratios[index] * (s[0] - own);
            if ratio > 0.0 {
                visit((offsets[index] * points + lower) as u64, ratio / along.ratio(offsets[index], lower));
            }
        });
        if let Some(border) = self.border.bonds() {
            let whole = self.whole_bonds() as u64;
            let body = (&*self.lattice, &self.neighbourhood, &self.kind.bond);
            border.for_each_ratio(body, (u, critical.by_offset(), critical.free()), &mut |k, ratio| {
                let bond = whole + k as u64;
                let kind = &border.kinds[k];
                let further = match kind.on_path {
                    Some(part) => along.ratio_of_part(kind.offset as usize, part, kind.factor),
                    None => critical.ratio(self.ends(bond), || kind.factor),
                };
                visit(bond, ratio / further);
            });
        }
    }

    /// Indices of the offsets among those that have bonds.
    fn classes(&self) -> Vec<Option<usize>> {
        let mut next = 0..;
        (0..self.neighbourhood.offsets.len())
            .map(|k| if self.neighbourhood.has_bonds(k) { next.next() } else { None })
            .collect()
    }

    pub(in super::super) fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<D>>> {
        let (between, ended) = self.sorted(bonds);
        let listed = self.listed(&between);
        let parted = self.parted(&ended, &listed);
        let n = self.lattice.points();
        let completing: Box<dyn Term<D>> = match self.border.bonds() {
            Some(border) => Box::new(border.bonds.part(&self.with_spanning(ended, &listed))),
            None => Box::new(Families::new(n, spanning(&self.triangles, &listed))),
        };
        let mut gone: Vec<Box<dyn Term<D>>> = vec![Box::new(Bonds::new(n, listed.into_iter())), completing];
        if let Some(interface) = &self.interface {
            gone.push(Box::new(Families::new(n, interface.beside(&parted))));
        }
        gone
    }

    /// Removes bonds of a body without images; bits of other bonds do not change.
    ///
    /// # Panics
    /// The body has images.
    pub(in super::super) fn break_bonds(&mut self, bonds: &[u64]) {
        assert!(self.ghosts.is_empty(), "the image of a bond would not break with it");
        let (between, ended) = self.sorted(bonds);
        let broken = self.listed(&between);
        let parted = self.parted(&ended, &broken);
        let ended = self.with_spanning(ended, &broken);
        if let Some(strains) = &mut self.border.strains {
            strains.forget(&parted);
        }
        if let By::Bonds(border) = &mut self.border.by
            && !ended.is_empty()
        {
            Arc::make_mut(&mut border.bonds).remove(&ended);
        }
        let classes = self.classes();
        let of_grid = |&(offset, lower): &(usize, usize)| Some((classes[offset]?, lower));
        let grid: Vec<(usize, usize)> = between.iter().filter_map(of_grid).collect();
        Arc::<GridBonds<D, M, B>>::make_mut(&mut self.bonds).break_bonds(grid);
        remove_spanning(&mut self.triangles, &parted);
        if let Some(interface) = &mut self.interface {
            interface.part(&parted);
        }
        self.cuts.extend(between);
    }

    /// The bonds between points that there are, with their measures.
    fn listed(&self, bonds: &[(usize, usize)]) -> Vec<Bond<D, M>> {
        let classes = self.classes();
        bonds.iter().filter_map(|&(offset, lower)| self.bonds.bond(classes[offset]?, lower)).collect()
    }

    /// Pairs of points that some bonds between them joined, or beside a border springs of the same length.
    fn parted(&self, ended: &[usize], broken: &[Bond<D, M>]) -> HashSet<[u32; 2]> {
        let kinds = self.border.bonds().map_or(&[][..], |border| &border.kinds);
        let springs = ended.iter().map(|&bond| &kinds[bond]).filter(|kind| kind.share == 1.0);
        let joined = springs.map(|kind| kind.foremost).map(|[a, b]| [a.min(b), a.max(b)]);
        broken.iter().map(|bond| bond.points).chain(joined).collect()
    }

    /// Some bonds that end on the border, and those that broken ones take with them.
    fn with_spanning(&self, mut ended: Vec<usize>, broken: &[Bond<D, M>]) -> Vec<usize> {
        if let Some(border) = self.border.bonds() {
            ended.extend(border.spanning(&self.lattice, &self.parted(&ended, broken)));
            ended.sort_unstable();
            ended.dedup();
        }
        ended
    }
}

/// The triangles that span one of some bonds.
pub(in super::super) fn spanning<const D: usize, const M: usize, const S: usize>(
    triangles: &Families<D, S, 2>,
    bonds: &[Bond<D, M>],
) -> Vec<Family<D, S, 2>> {
    if triangles.list().is_empty() {
        return Vec::new();
    }
    let pairs: HashSet<[u32; 2]> = bonds.iter().map(|b| b.points).collect();
    triangles.list().iter().filter(|t| spans(t, &pairs)).copied().collect()
}

/// Removes the triangles that have one of some pairs of points for a side.
pub(in super::super) fn remove_spanning<const D: usize, const S: usize>(
    triangles: &mut Arc<Families<D, S, 2>>,
    pairs: &HashSet<[u32; 2]>,
) {
    if !triangles.list().is_empty() {
        Arc::make_mut(triangles).retain(|t| !spans(t, pairs));
    }
}

/// Whether a side of a triangle is one of some pairs, the lower point first.
pub(super) fn spans<const D: usize, const S: usize>(
    triangle: &Family<D, S, 2>,
    pairs: &HashSet<[u32; 2]>,
) -> bool {
    let ([a, b], p) = (triangle.others, triangle.point);
    [[p, a], [p, b], [a, b]].into_iter().any(|[i, j]| pairs.contains(&[i.min(j), i.max(j)]))
}
