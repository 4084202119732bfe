//! Breaking bonds of a solid.
//!
//! A bond breaks where its stretch reaches the critical one. One that ends on the border has a part of the length of a whole
//! bond, and a crack that opens it takes the energy of a whole one. What a broken bond between neighbouring points spanned goes
//! with it: tetrahedra, and bonds on the border that would move with points on both sides of a crack. A bond is gone from the
//! dilatations of its points, too; what these lack then makes them softer, and no energy is negative.

use super::super::plane::{CriticalAlong, CriticalStretch, LatticeBond, PartOfPath, at};
use super::body::SolidBody;
use super::border::Whole;
use super::{Solid, SolidMaterial};
use crate::body::minus;
use crate::bonds::BondGeometry;
use crate::model::Breakable;
use crate::stiffness::{Bonds, Families, FamilyRows, GridFamilies, Term};
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::sync::Arc;

/// Offset of the neighbourhood and lower point.
type Place = (usize, usize);

/// What goes when bonds break.
struct Gone {
    between: Vec<Place>,
    /// Bonds that end on the border, ascending.
    ended: Vec<usize>,
    /// Families of tetrahedra, ascending.
    families: Vec<usize>,
    /// Pairs of points, the lower one first, whose tetrahedra at interfaces go.
    parted: HashSet<[u32; 2]>,
}

impl SolidBody {
    /// Above the number of any bond between two points: one has the number `offset · points + lower point`; behind them are those
    /// that end on the border.
    pub(super) fn whole_bonds(&self) -> usize {
        self.law.neighbourhood.offsets.len() * self.lattice.points()
    }

    fn upper(&self, (offset, lower): Place) -> Option<usize> {
        self.lattice.number(at(self.lattice.cell(lower), self.law.neighbourhood.offsets[offset], true))
    }

    /// The points with the largest parts in how a bond that ends on the border moves, one on either side.
    fn foremost(&self, ended: usize) -> [usize; 2] {
        let pair = self.on_border.as_ref().and_then(|known| known.foremost.get(ended));
        pair.map_or([0; 2], |pair| pair.map(|point| point as usize))
    }

    /// The point that one end of a bond that ends on the border is, if it is one.
    pub(super) fn own_end(&self, ended: usize) -> Option<u32> {
        self.on_border.as_ref().and_then(|known| *known.own.get(ended)?)
    }

    /// Bonds between two points, and the numbers of those that end on the border.
    fn sorted(&self, bonds: &[u64]) -> (Vec<Place>, Vec<usize>) {
        let (whole, points) = (self.whole_bonds(), self.lattice.points());
        let (between, ended): (Vec<usize>, Vec<usize>) =
            bonds.iter().map(|&bond| bond as usize).partition(|&bond| bond < whole);
        let between = between.into_iter().map(|bond| (bond / points, bond % points)).collect();
        (between, ended.into_iter().map(|bond| bond - whole).collect())
    }

    /// What goes with some bonds.
    fn gone(&self, bonds: &[u64]) -> Gone {
        let (between, ended) = self.sorted(bonds);
        let pairs = self.neighbours_parted(&between);
        let mut all: BTreeSet<usize> = ended.into_iter().collect();
        if let (Some(border), Some(points)) = (&self.border, &self.on_border) {
            let spanning = pairs.iter().flat_map(|pair| points.moved_by_both(*pair));
            all.extend(spanning.filter(|bond| !border.bonds.is_broken(*bond)));
        }
        let families = self.overlay.families.spanning(&pairs);
        let parted = if self.interface.is_some() { pairs } else { HashSet::new() };
        Gone { between, ended: all.into_iter().collect(), families, parted }
    }

    /// Pairs of points next to each other between which one of some bonds was.
    fn neighbours_parted(&self, bonds: &[Place]) -> HashSet<[u32; 2]> {
        let offsets = &self.law.neighbourhood.offsets;
        let near = bonds.iter().filter(|bond| offsets[bond.0].iter().all(|step| step.abs() <= 1));
        near.filter_map(|&bond| Some([bond.1 as u32, self.upper(bond)? as u32]))
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect()
    }

    /// Places with indices among the offsets that have bonds.
    fn in_grid(&self, bonds: &[Place]) -> Vec<Place> {
        let bonded: Vec<usize> = self.law.neighbourhood.bonded().collect();
        let index = |k: usize| bonded.iter().position(|b| *b == k);
        bonds.iter().filter_map(|&(k, lower)| Some((index(k)?, lower))).collect()
    }

    /// Rows of the dilatations of the points that lose bonds, without these.
    fn rows_without(&self, gone: &Gone) -> Vec<(usize, FamilyRows<3>)> {
        let (Some(families), Some(law)) = (&self.families, &self.law.dilatation) else { return Vec::new() };
        let mut changed: BTreeMap<usize, FamilyRows<3>> = BTreeMap::new();
        let spacing = self.lattice.spacing();
        let mut take = |point: usize, other: usize, part: [f64; 3]| {
            let step = minus(self.lattice.cell(other), self.lattice.cell(point));
            let (Some(rows), Some(step)) = (families.rows(point), families.step(step)) else { return };
            let row = &mut changed.entry(point).or_insert_with(|| rows.clone())[step];
            (0..3).for_each(|c| row[c] -= part[c]);
        };
        for &(offset, lower) in &gone.between {
            let Some(upper) = self.upper((offset, lower)) else { continue };
            let row =
                self.law.neighbourhood.offsets[offset].map(|x| law.shares[offset] / spacing * f64::from(x));
            take(lower, upper, row);
            take(upper, lower, row.map(|x| -x));
        }
        if let Some(border) = &self.border {
            border.bonds.for_each_of(&gone.ended, |kind, own, bond| {
                let (Some(own), Whole { offset, share, .. }) = (own, border.wholes[kind]) else { return };
                let step = self.law.neighbourhood.offsets[offset];
                // Shares in the relative displacement have the sign of the side that the point is on, and so has the bond.
                for (end, sign) in bond.ends.iter().zip([-1.0, 1.0]) {
                    for &(other, part) in end.iter().filter(|of| of.0 as usize != own) {
                        let scale = sign * part * law.shares[offset] / (spacing * share);
                        take(own, other as usize, step.map(|x| scale * f64::from(x)));
                    }
                }
            });
        }
        changed.into_iter().collect()
    }

    /// Why its bonds cannot break.
    pub(super) fn unbreakable(&self) -> Option<&'static str> {
        // What tetrahedra tell of changes of volume across a crack would be left.
        let is_completed = self.border.is_none() && self.overlay.families.count() > 0;
        (self.families.is_some() && is_completed).then_some(
            "solids whose points feel changes of volume do not break where tetrahedra complete them: leave out `edges`, and have the body two cells thick everywhere",
        )
    }

    /// Whether bonds of this body, of the materials that it has, can break.
    pub(super) fn breaks(&self) -> bool {
        // What tetrahedra beside interfaces have of changes of volume would be left.
        let is_mixed = self.families.is_some() && self.interface.is_some();
        self.unbreakable().is_none() && !is_mixed
    }

    /// Finds what breaking bonds ask for again and again.
    pub(super) fn prepare_to_break(&mut self) {
        self.on_border = self.border.as_ref().map(|border| Arc::new(border.bonds.points()));
    }

    fn break_bonds(&mut self, bonds: &[u64]) {
        let gone = self.gone(bonds);
        let (rows, grid) = (self.rows_without(&gone), self.in_grid(&gone.between));
        let Gone { between, ended, families, parted } = gone;
        if let Some(interface) = &mut self.interface {
            interface.part(&parted);
        }
        if let Some(of) = self.families.as_mut().filter(|_| !rows.is_empty()) {
            Arc::make_mut(of).set_rows(&rows);
        }
        for bonds in std::iter::once(&mut self.bonds).chain(&mut self.felt) {
            Arc::make_mut(bonds).break_bonds(grid.iter().copied());
        }
        if let Some(border) = self.border.as_mut().filter(|_| !ended.is_empty()) {
            Arc::make_mut(&mut border.bonds).break_bonds(&ended);
        }
        if !families.is_empty() {
            Arc::make_mut(&mut self.overlay.families).remove(&families);
        }
        self.cuts.extend(between);
    }

    fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<3>>> {
        let gone = self.gone(bonds);
        let rows = self.rows_without(&gone);
        let Gone { between, ended, families, parted } = gone;
        let listed = self.in_grid(&between).into_iter().filter_map(|(k, lower)| self.bonds.bond(k, lower));
        let completing: Box<dyn Term<3>> = match &self.border {
            Some(border) => Box::new(border.bonds.part(&ended)),
            // Beside a border tetrahedra tell of stresses alone.
            None => Box::new(self.overlay.families.part(&families)),
        };
        let mut part: Vec<Box<dyn Term<3>>> =
            vec![Box::new(Bonds::new(self.lattice.points(), listed)), completing];
        if let Some(interface) = &self.interface {
            part.push(Box::new(Families::new(self.lattice.points(), interface.beside(&parted))));
        }
        if let Some(before) = &self.families {
            let mut after = GridFamilies::clone(before);
            after.set_rows(&rows);
            part.extend([Box::new(before.clone()) as Box<dyn Term<3>>, Box::new(after.negated())]);
        }
        part
    }

    fn for_each_ratio(&self, u: &[f64], critical: &CriticalStretch, visit: &mut dyn FnMut(u64, f64)) {
        let (points, offsets) = (self.lattice.points(), &self.law.neighbourhood.offsets);
        let of_whole = |k: usize| {
            let whole = BondGeometry { xi: self.lattice.vector(offsets[k]) };
            self.bond().stretch_per_measure(&whole) / critical.by_offset()[k]
        };
        let per_elongation: Vec<f64> = (0..offsets.len()).map(of_whole).collect();
        let bonded: Vec<usize> = self.law.neighbourhood.bonded().collect();
        let mixture = self.mixture().map(Arc::as_ref);
        let along = CriticalAlong::new(critical, (&*self.lattice, &self.mirrors), mixture, offsets);
        self.bonds.for_each_measured(u, |index, [lower, _], [elongation]| {
            let k = bonded[index];
            if elongation > 0.0 {
                let ratio = per_elongation[k] * elongation / along.ratio(k, lower);
                visit((k * points + lower) as u64, ratio);
            }
        });
        if let Some(border) = &self.border {
            let whole = self.whole_bonds();
            border.bonds.for_each_measured(u, |bond, kind, [elongation]| {
                let Whole { offset, share, factor, pieces } = border.wholes[kind];
                if elongation > 0.0 {
                    let further = match self.own_end(bond) {
                        Some(own) => {
                            // The path of a bond begins at the one point, or ends at the other.
                            let place = if pieces[0] == 0 { 0 } else { pieces[1] - 1 };
                            along.ratio_of_part(offset, PartOfPath { pieces, known: (place, own) }, factor)
                        }
                        None => critical.ratio(self.foremost(bond), || factor),
                    };
                    visit(
                        (whole + bond) as u64,
                        per_elongation[offset] * elongation / share.sqrt() / further,
                    );
                }
            });
        }
    }
}

impl<P: SolidMaterial> Breakable<3> for Solid<P> {
    type Critical = CriticalStretch;

    fn bond_numbers(&self) -> u64 {
        let ended = self.body.border.as_ref().map_or(0, |border| border.bonds.count());
        (self.body.whole_bonds() + ended) as u64
    }

    fn ends(&self, bond: u64) -> [usize; 2] {
        let (bond, points) = (bond as usize, self.body.lattice.points());
        if let Some(ended) = bond.checked_sub(self.body.whole_bonds()) {
            return self.body.foremost(ended);
        }
        let place = (bond / points, bond % points);
        [place.1, self.body.upper(place).unwrap_or(place.1)]
    }

    fn for_each_ratio(&self, u: &[f64], critical: &CriticalStretch, visit: &mut dyn FnMut(u64, f64)) {
        self.body.for_each_ratio(u, critical, visit);
    }

    fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<3>>> {
        self.body.part(bonds)
    }

    /// # Panics
    /// The body has images in planes of symmetry.
    fn break_bonds(&mut self, bonds: &[u64]) {
        assert!(self.body.ghosts.is_empty(), "the image of a bond would not break with it");
        self.body.break_bonds(bonds);
    }
}
