//! Interpolation beside cracks: a point follows those of the coarser level that are on its side.

use super::level::CubicLevel;
use super::transfer::parents;
use std::collections::HashSet;

/// A point of the finer level, and the places of the coarser one that it follows, with their weights.
#[derive(Clone, Debug)]
pub(super) struct Apart {
    pub(super) place: usize,
    pub(super) parents: Vec<(usize, f32)>,
}

/// The points of a level for which missing bonds make a difference.
///
/// A point is on the side of the first cell of its parent unless the bond between them is missing, and so is the parent's
/// neighbour.
pub(super) fn apart(fine: &CubicLevel, coarse: &CubicLevel) -> Vec<Apart> {
    let shift = fine.cells.shift.map(|s| s as i32);
    let first = |parent: [i32; 3]| [0, 1, 2].map(|k| 2 * parent[k] - shift[k]);
    let mut cells: HashSet<[i32; 3]> = fine.gaps.beside();
    for parent in coarse.gaps.beside() {
        cells.extend((0..8).map(|corner| {
            let cell = first(parent);
            [0, 1, 2].map(|k| cell[k] + (corner >> k & 1))
        }));
    }
    let is_inside = |cell: &[i32; 3]| (0..3).all(|k| (0..fine.grid().cells[k] as i32).contains(&cell[k]));
    let mut cells: Vec<[i32; 3]> = cells.into_iter().filter(is_inside).collect();
    cells.sort_unstable();
    let of = |cell: [i32; 3]| {
        let place = fine.grid().at(cell.map(i64::from));
        let along = [0, 1, 2].map(|k| parents(cell[k] as usize, shift[k] as usize));
        let own = [0, 1, 2].map(|k| along[k][0].0 as i32);
        let is_across = fine.gaps.has(first(own), cell);
        let mut kept: Vec<(usize, f32)> = Vec::new();
        for corner in 0..8 {
            let part = |k: usize| along[k][corner >> k & 1];
            let other = [0, 1, 2].map(|k| part(k).0);
            let at = coarse.grid().at(other);
            if coarse.cells.is_solid(at) && coarse.gaps.has(own, other.map(|k| k as i32)) == is_across {
                kept.push((at, (0..3).map(|k| part(k).1).product()));
            }
        }
        let sum: f32 = kept.iter().map(|of| of.1).sum();
        let whole = sum * fine.inverse_scale[place];
        kept.iter_mut().for_each(|of| of.1 *= coarse.inverse_scale[of.0] / whole);
        (fine.cells.is_solid(place), Apart { place, parents: kept })
    };
    cells.into_iter().map(of).filter(|of| of.0).map(|of| of.1).collect()
}
