//! Bonds of a lattice with factors of their own: those of cells that are not whole, and those of images.

use super::Mirrors;
use super::mixture::Mixture;
use super::near::at;
use super::neighbourhood::Neighbourhood;
use crate::body::SquareLattice;
use crate::bonds::BondModel;
use crate::stiffness::{Between, Exception, GridBonds, Offset, Tables};
use std::sync::Arc;

/// The bonds of the offsets that have any, with exceptions, and bonds between points of two tables of a mixture, whose offsets are
/// those of the neighbourhood.
pub(in super::super) fn grid<const D: usize, const M: usize, B: BondModel<D, M>>(
    lattice: &Arc<SquareLattice>,
    neighbourhood: &Neighbourhood<M>,
    base: &[f64],
    bond: &B,
    exceptions: &[Exception],
    (mixture, between): (Option<&Mixture>, &[Between<M>]),
) -> GridBonds<D, M, B> {
    let bonded: Vec<usize> = neighbourhood.bonded().collect();
    let mut class = vec![None; neighbourhood.offsets.len()];
    bonded.iter().enumerate().for_each(|(index, &k)| class[k] = Some(index));
    let offset = |&k: &usize| Offset {
        step: neighbourhood.offsets[k],
        weights: neighbourhood.weights[k].map(|w| base[k] * w),
    };
    let offsets: Vec<Offset<M>> = bonded.iter().map(offset).collect();
    let known: Vec<Exception> =
        exceptions.iter().filter_map(|e| Some(Exception { offset: class[e.offset]?, ..*e })).collect();
    let between: Vec<Between<M>> =
        between.iter().filter_map(|e| Some(Between { offset: class[e.offset]?, ..*e })).collect();
    let others: Vec<Vec<[f64; M]>> =
        neighbourhood.others.iter().map(|weights| bonded.iter().map(|&k| weights[k]).collect()).collect();
    let of = mixture.map_or(&[][..], Mixture::tables);
    let tables = Tables { of, others: &others, between: &between };
    GridBonds::of_tables(lattice.clone(), bond, &offsets, &known, tables)
}

/// Factors of the bonds of cells that are not whole: the smaller part of both ends.
pub(super) fn reduced<const M: usize>(
    lattice: &SquareLattice,
    neighbourhood: &Neighbourhood<M>,
) -> Vec<Exception> {
    let mut exceptions = Vec::new();
    for &(point, part) in lattice.cut_cells() {
        let (point, cell) = (point as usize, lattice.cell(point as usize));
        for k in neighbourhood.bonded() {
            for up in [true, false] {
                let Some(other) = lattice.number(at(cell, neighbourhood.offsets[k], up)) else { continue };
                let factor = part.min(lattice.fraction(other));
                // A bond between two such cells is met twice.
                if up || lattice.fraction(other) == 1.0 {
                    let lower = if up { point } else { other };
                    exceptions.push(Exception { offset: k, lower, factor });
                }
            }
        }
    }
    exceptions
}

/// Some points, and those that have a bond to a cell that is not whole, in order.
pub(super) fn with_neighbours<const M: usize>(
    lattice: &SquareLattice,
    neighbourhood: &Neighbourhood<M>,
    mut points: Vec<usize>,
) -> Vec<usize> {
    if lattice.cut_cells().is_empty() {
        return points;
    }
    for &(point, _) in lattice.cut_cells() {
        let cell = lattice.cell(point as usize);
        let steps = neighbourhood
            .bonded()
            .flat_map(|k| [true, false].map(|up| at(cell, neighbourhood.offsets[k], up)));
        points.push(point as usize);
        points.extend(steps.filter_map(|other| lattice.number(other)));
    }
    points.sort_unstable();
    points.dedup();
    points
}

/// Factors of bonds across lines of symmetry, ½, and beyond them, 0. Across a joined side a bond has a copy across the other
/// one, and each is half of it.
pub(in super::super) fn halved<const M: usize>(
    lattice: &SquareLattice,
    mirrors: &Mirrors,
    neighbourhood: &Neighbourhood<M>,
    ghosts: &[u32],
) -> Vec<Exception> {
    let mut exceptions = Vec::new();
    for &ghost in ghosts {
        let cell = lattice.cell(ghost as usize);
        for k in neighbourhood.bonded() {
            for up in [true, false] {
                let other = at(cell, neighbourhood.offsets[k], up);
                let Some(number) = lattice.number(other) else { continue };
                let is_real = mirrors.is_real(other);
                if is_real || up {
                    let lower = if up { ghost as usize } else { number };
                    exceptions.push(Exception { offset: k, lower, factor: if is_real { 0.5 } else { 0.0 } });
                }
            }
        }
    }
    exceptions
}
