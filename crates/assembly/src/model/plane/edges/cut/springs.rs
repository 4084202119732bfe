//! Triangles taken apart by the directions of bonds: springs that break and soften as bonds do.
//!
//! A spring has the part of the bonds of one offset that is left to a triangle, and stretches as the triangle does in their
//! direction. A crack that opens a row of cells opens `1/c` of a bond that passes c rows: by `c` times the energy of the spring
//! it takes all of the bond's ([`PartOfBond`]).

use super::super::super::bond::PlaneBond;
use super::super::super::geometry;
use super::super::super::mixture::Mixture;
use super::super::super::neighbourhood::Neighbourhood;
use super::super::border::{BorderBonds, PartOfBond};
use super::corners::Corners;
use super::members::{corner_shares, corners_of};
use super::missing::Missing;
use super::{By, Left, weights_at};
use crate::body::Cell;
use crate::bonds::BondGeometry;
use crate::stiffness::{Place, PlacedBond, PlacedBonds};
use std::array::from_fn;
use std::collections::HashMap;
use std::sync::Arc;

/// Springs of the triangles that bonds leave something to, and the number of triangles whose corners cannot be determined.
pub(super) fn springs<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>>(
    corners: &Corners,
    (neighbourhood, bond): (&Neighbourhood<M>, &B),
    (missing, mixture): (&Missing, Option<&Mixture>),
    left: impl Iterator<Item = Left>,
) -> (By<D, M, S>, usize) {
    let lattice = corners.blocks.lattice;
    let (mut bonds, mut lost) = (PlacedBonds::new(lattice.points()), 0);
    let (mut kinds, mut at) = (Vec::new(), Vec::new());
    for Left { block, triangle, shares } in left {
        let cells = corners_of(block, triangle);
        let Some(places) = corner_shares(corners, cells) else {
            lost += 1;
            continue;
        };
        let all = missing.paths.iter().zip(&shares).enumerate();
        for (path, (&(offset, _), &left)) in all.filter(|(_, (_, left))| **left != 0.0) {
            let step = neighbourhood.offsets[offset];
            let share = 1.0 / f64::from(step[0].abs().max(step[1].abs()));
            let whole = geometry(lattice, step);
            let short = BondGeometry { xi: whole.xi.map(|x| share * x) };
            let unit = bond.part_moduli(&whole, share);
            let (mut weights, mut factor) = (neighbourhood.weights[offset], 1.0);
            if let Some(mixture) = mixture {
                let of = |table| *neighbourhood.weights_of(table, offset);
                weights = weights_at(corners, mixture, (cells, step), of);
                [factor] = weights_at(corners, mixture, (cells, step), |_| [1.0]);
            }
            let moduli = from_fn(|m| left / share * weights[m] * unit[m]);
            let ends = [-0.5, 0.5]
                .map(|half| place(&cells, &places, [0, 1].map(|c| half * share * f64::from(step[c]))));
            let foremost = bonds.push(&PlacedBond { ends, mean: None, rows: bond.rows(&short), moduli });
            let offset = offset as u32;
            kinds.push(PartOfBond { offset, share, of: [None; 3], foremost, factor, on_path: None });
            at.push((cells, path, left));
        }
    }
    stand_for_bonds(&mut kinds, &at, corners, missing);
    (By::Bonds(BorderBonds { bonds: Arc::new(bonds), kinds }), lost)
}

/// Lets springs stand for the missing bonds of the points at their corners: all of one direction around a point together are
/// those that it lacks. `at` are the corners, the path and the part of bonds of every spring.
fn stand_for_bonds(
    kinds: &mut [PartOfBond],
    at: &[([Cell; 3], usize, f64)],
    corners: &Corners,
    missing: &Missing,
) {
    let lattice = corners.blocks.lattice;
    let lacking = |cell: &Cell, path: usize| {
        let point = lattice.number(*cell)? as u32;
        Some((point, missing.lacks(path, *cell))).filter(|of| of.1 > 0)
    };
    let mut around = HashMap::<(u32, usize), f64>::new();
    for (cells, path, left) in at {
        for (point, _) in cells.iter().filter_map(|cell| lacking(cell, *path)) {
            *around.entry((point, *path)).or_default() += left;
        }
    }
    for (kind, (cells, path, _)) in kinds.iter_mut().zip(at) {
        kind.of = cells.map(|cell| {
            let (point, count) = lacking(&cell, *path)?;
            Some((point, around[&(point, *path)] / f64::from(count)))
        });
    }
}

/// Points and their shares in the displacement of a place that lies `off` the middle of a triangle, in spacings.
fn place(cells: &[Cell; 3], corners: &[Place; 3], off: [f64; 2]) -> Place {
    // The sides at the right angle are one spacing along x and one along y.
    let along = |k: usize| off[k] * f64::from(cells[k + 1][k] - cells[0][k]);
    let [x, y] = [1.0 / 3.0 + along(0), 1.0 / 3.0 + along(1)];
    let shares = [1.0 - x - y, x, y];
    let of = |(corner, part): (&Place, f64)| corner.iter().map(move |&(p, s)| (p, part * s)).collect();
    let all: Vec<Place> = corners.iter().zip(shares).map(of).collect();
    all.concat()
}
