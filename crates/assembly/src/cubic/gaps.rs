//! Bonds of a level that are not there although both of their points are: cut by cracks, or broken.
//!
//! A bond of the coarser level stands for the pairs of bonds of the finer one that lead from the cells that its one point covers to
//! those of the other, on the sides of cracks on which the first of these cells are. It is missing if most of them are broken: of a
//! ligament half a cell wide all is left, so that what hangs on it does not come off.

use super::cells::Cells;
use super::stencil::Stencil;
use std::collections::HashSet;

/// A cell of a grid and a step of half of the stencil.
type Bond = ([i32; 3], [i32; 3]);

/// A bond by the places of its points and the index of its step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap {
    pub(super) ends: [usize; 2],
    pub(super) step: usize,
}

/// The missing bonds of a level.
#[derive(Clone, Debug, Default)]
pub(super) struct Gaps {
    bonds: HashSet<Bond>,
    /// The same, in order.
    list: Vec<Gap>,
    /// `√k n` of every step.
    rows: Vec<[f32; 3]>,
}

impl Gaps {
    /// Those of a level, by the cells of their lower points and their steps, as far as both of their points are there.
    pub(super) fn new(mut bonds: HashSet<Bond>, cells: &Cells, stencil: &Stencil) -> Self {
        let ends = |(cell, step): &Bond| {
            let upper = [0, 1, 2].map(|k| cell[k] + step[k]);
            let place = |cell: [i32; 3]| {
                let inside = (0..3).all(|k| (0..cells.grid.cells[k] as i32).contains(&cell[k]));
                inside.then(|| cells.grid.at(cell.map(i64::from))).filter(|at| cells.is_solid(*at))
            };
            Some([place(*cell)?, place(upper)?])
        };
        bonds.retain(|bond| ends(bond).is_some());
        let gap = |bond: &Bond| {
            let step = stencil.steps.iter().position(|own| *own == bond.1)?;
            Some(Gap { ends: ends(bond)?, step })
        };
        let mut list: Vec<Gap> = bonds.iter().filter_map(gap).collect();
        list.sort_unstable_by_key(|gap| (gap.ends, gap.step));
        let rows = stencil.rows.iter().map(|row| row.map(|x| x as f32)).collect();
        Self { bonds, list, rows }
    }

    pub(super) fn list(&self) -> &[Gap] {
        &self.list
    }

    /// Whether the bond between two cells is missing.
    pub(super) fn has(&self, from: [i32; 3], to: [i32; 3]) -> bool {
        let step = [0, 1, 2].map(|k| to[k] - from[k]);
        self.bonds.contains(&(from, step)) || self.bonds.contains(&(to, step.map(|k| -k)))
    }

    /// Both cells of all missing bonds between cells that touch.
    pub(super) fn beside(&self) -> HashSet<[i32; 3]> {
        let touch = self.bonds.iter().filter(|(_, step)| step.iter().all(|k| k.abs() <= 1));
        touch.flat_map(|&(cell, step)| [cell, [0, 1, 2].map(|k| cell[k] + step[k])]).collect()
    }

    /// The bonds that the coarser level lacks, whose cells begin `shift` cells before those of this one.
    pub(super) fn coarser(&self, shift: [usize; 3]) -> HashSet<Bond> {
        let shift = shift.map(|s| s as i32);
        let mut candidates = HashSet::new();
        for &(cell, step) in &self.bonds {
            for before in [0, 1] {
                let start = [0, 1, 2].map(|k| cell[k] - before * step[k] + shift[k]);
                candidates.insert((start.map(|k| k.div_euclid(2)), step));
            }
        }
        candidates.retain(|bond| self.breaks_most(*bond, shift));
        candidates
    }

    /// Whether most of what a bond of the coarser level stands for is broken.
    fn breaks_most(&self, (parent, step): Bond, shift: [i32; 3]) -> bool {
        let plus = |a: [i32; 3], b: [i32; 3]| [0, 1, 2].map(|k| a[k] + b[k]);
        let first = |parent: [i32; 3]| [0, 1, 2].map(|k| 2 * parent[k] - shift[k]);
        let ends = [first(parent), first(plus(parent, step))];
        let [mut broken, mut whole] = [0; 2];
        for corner in 0..8 {
            let start = plus(ends[0], [0, 1, 2].map(|k| corner >> k & 1));
            let [middle, end] = [plus(start, step), plus(plus(start, step), step)];
            if self.has(ends[0], start) || self.has(ends[1], end) {
                continue;
            }
            match self.has(start, middle) || self.has(middle, end) {
                true => broken += 1,
                false => whole += 1,
            }
        }
        broken > whole
    }

    /// Calls `take` with the places of the points of all missing bonds, and with the forces that these would have.
    pub(super) fn for_each_force(
        &self,
        len: usize,
        (v, inverse_scale): (&[f32], &[f32]),
        mut take: impl FnMut(usize, [f32; 3]),
    ) {
        for &Gap { ends: [p, q], step } in &self.list {
            let row = &self.rows[step];
            let [of_p, of_q] = [p, q].map(|at| (0..3).map(|c| row[c] * v[c * len + at]).sum::<f32>());
            // A bond has the part s_p s_q of its stiffness.
            let ratio = inverse_scale[p] / inverse_scale[q];
            let [at_p, at_q] = [ratio * of_p - of_q, of_q / ratio - of_p];
            take(p, row.map(|r| r * at_p));
            take(q, row.map(|r| r * at_q));
        }
    }
}
