//! Bonds that end on the border: what leaves the body is cut off there.
//!
//! The cells about the points tile the body. A bond that passes a cell which is not there gives way to the runs of cells
//! that it does pass: each is a bond of its own, of the length of the run and with the weight of the whole one, so that the
//! body has the energy of the material in every uniform strain. Where a run ends on the border, the place moves with the two
//! corners of cells beside it, and these with the nearest whole blocks of four points, continued linearly. Tractions of a
//! uniform stress then act on these corners alone, half of those of a side on either: any such stress, shear too, is in
//! equilibrium, at straight edges, at convex and at re-entrant corners.

mod nodes;
mod path;
mod run;
mod shares;

pub use shares::BorderShares;
pub(in crate::model) use shares::border_shares;

use super::super::bond::LatticeBond;
use super::super::critical_along::PartOfPath;
use super::super::mixture::Mixture;
use super::super::near::at;
use super::super::neighbourhood::Neighbourhood;
use super::super::{Mirrors, geometry};
use super::{By, Completion};
use crate::body::{Cell, SquareLattice, plus};
use crate::bonds::{BondGeometry, Mat};
use crate::stiffness::{Exception, PlacedBond, PlacedBonds};
pub(in super::super::super) use nodes::{Cells, Nodes, around};
pub(in super::super::super) use path::Path;
use run::for_each_run;
pub(in super::super::super) use run::{End, Run};
use std::borrow::Cow;
use std::collections::HashSet;
use std::sync::Arc;

/// The bonds that end on the border.
#[derive(Clone, Debug)]
pub(in super::super::super) struct BorderBonds<const D: usize, const M: usize> {
    pub(in super::super::super) bonds: Arc<PlacedBonds<D, M>>,
    /// What whole bonds they are parts of.
    pub(in super::super::super) kinds: Vec<PartOfBond>,
}

/// What a bond that ends on the border is a part of.
#[derive(Clone, Copy, Debug)]
pub(in super::super::super) struct PartOfBond {
    /// Index of the offset.
    pub(in super::super::super) offset: u32,
    /// Its length over that of the whole one.
    pub(in super::super::super) share: f64,
    /// Points whose missing bonds it stands for, with the part that its energy is of theirs.
    pub(in super::super::super) of: [Option<(u32, f64)>; 3],
    /// The two points that have the largest parts in the relative displacement of its ends, one on either side.
    pub(in super::super::super) foremost: [u32; 2],
    /// Its modulus over that of the base material.
    pub(in super::super::super) factor: f64,
    /// The cells that it passes; none of a spring in what a border leaves of a triangle.
    pub(in super::super::super) on_path: Option<PartOfPath>,
}

/// Reach of bonds, rows or columns, up to which they end on the border: their number grows with its third power.
pub const FARTHEST: i32 = 10;

/// Whether bonds can end on the border of a lattice of whole cells: all belong to blocks of four, in solids of eight.
pub(in super::super::super) fn can_end(lattice: &SquareLattice, mirrors: &Mirrors) -> bool {
    let has = |cell: Cell| {
        let image = if mirrors.is_none() { cell } else { mirrors.image(cell).0 };
        lattice.number(image).is_some()
    };
    let in_block = |cell: Cell| {
        let block = |side: Cell| {
            let third = if lattice.is_plane() { vec![0] } else { vec![0, side[2]] };
            third.into_iter().all(|c| {
                [[0, 0], [side[0], 0], [0, side[1]], [side[0], side[1]]]
                    .iter()
                    .all(|&[a, b]| has(plus(cell, [a, b, c])))
            })
        };
        (0..8).map(|k| [1, 2, 4].map(|bit| if k & bit == 0 { -1 } else { 1 })).any(block)
    };
    let mut near = super::super::near::near_points(lattice, 1).into_iter();
    near.all(|point| in_block(lattice.cell(point)))
}

/// Builds the bonds that end on the border; `near` are the points within reach of it.
pub(super) fn completed<const D: usize, const M: usize, const S: usize, B: LatticeBond<D, M, S>>(
    (lattice, mirrors): (&SquareLattice, &Mirrors),
    (neighbourhood, bond): (&Neighbourhood<M>, &B),
    near: &[usize],
    (cuts, mixture): (&HashSet<(usize, usize)>, Option<&Mixture>),
) -> Completion<D, M, S> {
    let nodes = Nodes::new(Cells { lattice, mirrors, neighbourhood, cuts: Cow::Borrowed(cuts) });
    let mut bonds = PlacedBonds::new(lattice.points());
    let (mut kinds, mut lost, mut lacks) = (Vec::new(), HashSet::new(), Vec::new());
    let gaps = for_each_part(&nodes, near, &mut |offset, run, part| {
        let Some(ends) = run.ends(&nodes) else {
            lost.insert(run.first());
            return;
        };
        let (whole, share) = (geometry(lattice, neighbourhood.offsets[offset]), run.share());
        let short = BondGeometry { xi: whole.xi.map(|x| share * x) };
        let unit = bond.part_moduli(&whole, share);
        let (mut weights, mut factor) = (neighbourhood.weights[offset], 1.0);
        if let Some(mixture) = mixture {
            let of = |table| neighbourhood.of_material(table, offset);
            let through = mixture.weights_through((lattice, mirrors), run.cells(), of);
            [factor] = mixture.through((lattice, mirrors), run.cells()).weights;
            weights = through.weights;
            let own = run.ends_of(mirrors).into_iter().zip(through.lacks).filter(|own| own.1 != [0.0; M]);
            let own = own.filter_map(|(cell, lack)| Some((lattice.number(cell?)?, lack)));
            lacks.extend(own.map(|(point, lack)| (point, offset, lack.map(|lack| share * lack))));
        }
        let moduli = std::array::from_fn(|m| part * weights[m] * unit[m]);
        // Only rotations are read on the mean.
        let mean = if B::MEAN == [[false; D]; M] { None } else { run.mean(&nodes) };
        let foremost = bonds.push(&PlacedBond { ends, mean, rows: bond.rows(&short), moduli });
        let of = [run.point(&nodes.cells).map(|point| (point, share)), None, None];
        let (offset, on_path) = (offset as u32, run.on_path(lattice));
        kinds.push(PartOfBond { offset, share, of, foremost, factor, on_path });
    });
    let by = By::Bonds(BorderBonds { bonds: Arc::new(bonds), kinds });
    Completion { by, gaps, lost: lost.len(), strains: None, lacks }
}

/// Calls `visit` with every part of a bond that ends on the border: the index of its offset, its run of cells, and the part of it
/// that is real; cracks cut none of them. Returns the bonds between points that give way; `near` are the points within reach of
/// the border.
pub(in super::super::super) fn for_each_part<const M: usize>(
    nodes: &Nodes<M>,
    near: &[usize],
    visit: &mut dyn FnMut(usize, &Run, f64),
) -> Vec<Exception> {
    let (cells, mut gaps) = (&nodes.cells, Vec::new());
    for offset in cells.neighbourhood.bonded() {
        let path = Path::of(cells.neighbourhood.offsets[offset]);
        for_each_run(cells, &path, near, &mut |run| {
            let upper = cells.lattice.number(at(run.start, cells.neighbourhood.offsets[offset], true));
            if run.has_points()[0]
                && let (Some(lower), Some(_)) = (cells.lattice.number(run.start), upper)
            {
                gaps.push(Exception { offset, lower, factor: 0.0 });
            }
            let part = run.counted(cells.mirrors);
            if part != 0.0 && !run.is_cut(cells) {
                visit(offset, run, part);
            }
        });
    }
    gaps
}

impl<const D: usize, const M: usize> BorderBonds<D, M> {
    /// Calls `visit` with every bond and the ratio of its stretch, beyond that at which it is free, to the critical one, where that is
    /// positive. `critical` are the critical stretches of whole bonds by offset, `t` strains that need no stress, three planes, where
    /// there are any. A run has a part of a bond, and a crack that opens it takes the energy of a whole one.
    pub(in super::super) fn for_each_ratio<const S: usize, B: LatticeBond<D, M, S>>(
        &self,
        body: (&SquareLattice, &Neighbourhood<M>, &B),
        (u, critical, t): (&[f64], &[f64], Option<&[f64]>),
        visit: &mut dyn FnMut(usize, f64),
    ) {
        let (lattice, neighbourhood, bond) = body;
        for (k, &PartOfBond { offset, share, .. }) in self.kinds.iter().enumerate() {
            let measure = self.bonds.measures(k, u)[0] - t.map_or(0.0, |t| self.free(body, t, k)[0]);
            if measure > 0.0 {
                let whole = geometry(lattice, neighbourhood.offsets[offset as usize]);
                let short = BondGeometry { xi: whole.xi.map(|x| share * x) };
                let stretch = measure * bond.stretch_per_measure(&short);
                visit(k, stretch * share.sqrt() / critical[offset as usize]);
            }
        }
    }

    /// The bonds that some broken ones between neighbouring points take with them: their ends would move with points on both
    /// sides of a crack.
    pub(in super::super) fn spanning(
        &self,
        lattice: &SquareLattice,
        broken: &HashSet<[u32; 2]>,
    ) -> Vec<usize> {
        let is_next = |pair: &&[u32; 2]| {
            let [a, b] = pair.map(|p| lattice.cell(p as usize));
            (0..3).all(|k| (a[k] - b[k]).abs() <= 1)
        };
        let next: HashSet<[u32; 2]> = broken.iter().filter(is_next).copied().collect();
        if next.is_empty() {
            return Vec::new();
        }
        let ends: HashSet<u32> = next.iter().flatten().copied().collect();
        let spans = |bond: &usize| {
            let met: Vec<u32> =
                self.bonds.middle(*bond).map(|m| m.0 as u32).filter(|p| ends.contains(p)).collect();
            (1..met.len()).any(|k| met[..k].iter().any(|&p| next.contains(&[p.min(met[k]), p.max(met[k])])))
        };
        (0..self.bonds.count()).filter(spans).collect()
    }

    /// Adds the forces that do the work of the bonds in strains `t` of the points, three planes, as far as they move them.
    pub(in super::super) fn add_strain_work<const S: usize, B: LatticeBond<D, M, S>>(
        &self,
        body: (&SquareLattice, &Neighbourhood<M>, &B),
        t: &[f64],
        force: &mut [f64],
    ) {
        for k in 0..self.kinds.len() {
            let free = self.free(body, t, k);
            if free != [0.0; M] {
                let moduli = self.bonds.moduli(k);
                self.bonds.add_work(k, &std::array::from_fn(|m| moduli[m] * free[m]), force);
            }
        }
    }

    /// The measures at which a bond is free, of strains `t` of the points, three planes, as far as they move it.
    pub(in super::super) fn free<const S: usize, B: LatticeBond<D, M, S>>(
        &self,
        (lattice, neighbourhood, bond): (&SquareLattice, &Neighbourhood<M>, &B),
        t: &[f64],
        k: usize,
    ) -> [f64; M] {
        let n = lattice.points();
        let mut strain = [0.0; 3];
        self.bonds.middle(k).for_each(|(p, s)| (0..3).for_each(|q| strain[q] += s * t[q * n + p]));
        if strain == [0.0; 3] {
            return [0.0; M];
        }
        let PartOfBond { offset, share, .. } = self.kinds[k];
        let whole = geometry(lattice, neighbourhood.offsets[offset as usize]);
        let uniform: Mat<M, S> = bond.in_uniform_state(&BondGeometry { xi: whole.xi.map(|x| share * x) });
        std::array::from_fn(|m| (0..3).map(|q| uniform[m][q] * strain[q]).sum())
    }
}
