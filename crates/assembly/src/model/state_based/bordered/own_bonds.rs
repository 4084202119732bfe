//! The bonds that points have, and the points that have not all.

use super::super::super::plane::near_points;
use super::border::follows;
use super::reach::Lacking;
use super::rings::weight;
use super::sources::{ANY, Bonded, Kind, Source, Sources};
use crate::body::{Cell, SquareLattice, plus};
use crate::stiffness::{Exception, FamilyRows};
use std::collections::{BTreeSet, HashSet};

/// Bonds of the points of a plate.
pub(super) struct PointBonds<'a> {
    plate: &'a Bonded,
    /// From a point to its neighbours.
    pub(super) steps: Vec<Cell>,
    /// `c ξ/|ξ|²` of the bonds there, 1/m.
    pub(super) rows: FamilyRows,
    /// Bonds that are not there although both of their points are, by these.
    gaps: HashSet<[usize; 2]>,
    follows: bool,
}

/// A neighbour, the step to it, and the row of the bond.
type Neighbour = (usize, Cell, [f64; 2]);

impl<'a> PointBonds<'a> {
    pub(super) fn new(plate: &'a Bonded, shear_modulus: f64) -> Self {
        let (mut steps, mut rows) = (Vec::new(), Vec::new());
        for sign in [1, -1] {
            for k in plate.neighbourhood.bonded() {
                let step = plate.neighbourhood.offsets[k].map(|o| sign * o);
                let [x, y, _] = plate.lattice.vector(step);
                let part = plate.neighbourhood.weights[k][0] / (8.0 * shear_modulus * (x * x + y * y));
                steps.push(step);
                rows.push([part * x, part * y]);
            }
        }
        let ends = |gap: &Exception| {
            let (cell, step) = (plate.lattice.cell(gap.lower), plate.neighbourhood.offsets[gap.offset]);
            let upper = plate.lattice.number(plus(cell, step))?;
            Some([gap.lower.min(upper), gap.lower.max(upper)])
        };
        let gaps = plate.border.gaps.iter().filter_map(ends).collect();
        Self { plate, steps, rows, gaps, follows: follows(plate) }
    }

    /// The neighbours to which a point has bonds.
    fn of(&self, point: usize) -> impl Iterator<Item = Neighbour> + '_ {
        let (lattice, cell) = (&self.plate.lattice, self.plate.lattice.cell(point));
        self.steps.iter().zip(&self.rows).filter_map(move |(step, row)| {
            let other = lattice.number(plus(cell, *step))?;
            let part = match self.follows {
                true => 1.0,
                false => lattice.fraction(point).min(lattice.fraction(other)),
            };
            let is_there = !self.gaps.contains(&[point.min(other), point.max(other)]);
            is_there.then(|| (other, *step, row.map(|r| part * r)))
        })
    }

    /// The real points that have not all bonds; by blocks of two by two cells, all of a block.
    pub(super) fn lacking(&self, by_blocks: bool) -> Vec<Lacking> {
        let Bonded { lattice, mirrors, neighbourhood, .. } = self.plate;
        let near = near_points(lattice, neighbourhood.reach() + 1).into_iter();
        let candidates: BTreeSet<usize> = near.chain(self.gaps.iter().flatten().copied()).collect();
        let is_real = |p: &usize| mirrors.is_none() || mirrors.is_real(lattice.cell(*p));
        let of = |point: usize| {
            let part = |(_, step, row): Neighbour| {
                let [x, y, _] = lattice.vector(step);
                0.5 * (row[0] * x + row[1] * y)
            };
            let present: f64 = self.of(point).map(part).sum();
            let (weight, part) = (weight(self.plate, point), lattice.fraction(point));
            let present = weight * present;
            Lacking { point, cell: lattice.cell(point), weight, volume: weight * part, present }
        };
        let is_whole = |l: &Lacking| l.present > l.volume.max(l.weight) - 1e-9 * l.weight;
        let lacking: Vec<Lacking> =
            candidates.into_iter().filter(is_real).map(of).filter(|l| !is_whole(l)).collect();
        if !by_blocks {
            return lacking;
        }
        let block = |l: &Lacking| {
            let [i, j, layer] = SquareLattice::parent(l.cell).map(|k| 2 * k);
            [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]].map(|[i, j]| [i, j, layer])
        };
        let mates = lacking.iter().flat_map(block).filter_map(|cell| lattice.number(cell));
        let mates: BTreeSet<usize> = mates.filter(is_real).collect();
        mates.into_iter().map(of).collect()
    }

    /// Adds the bonds of some points.
    pub(super) fn add_sources(&self, points: &[Lacking], to: &mut Sources) {
        for lacking in points {
            for (other, step, row) in self.of(lacking.point) {
                let [x, y, _] = self.plate.lattice.vector(step);
                // The part of a point has all of the bond: its middle is that of the bond.
                let middle = if self.follows { 0.5 } else { 0.0 };
                let at = [0, 1].map(|k| f64::from(lacking.cell[k]) + middle * f64::from(step[k]));
                let row = row.map(|r| lacking.weight * r);
                let tensor = [row[0] * x, row[1] * y, row[0] * y];
                let mut source = Source { at, tensor, ..Source::default() };
                source.add_row(other as u32, row);
                source.add_row(lacking.point as u32, row.map(|r| -r));
                to.add(Kind::Bonds, lacking.cell, if self.follows { step } else { ANY }, &source);
            }
        }
    }
}
