//! Which points have the ordinary weights, and the weights of the others.

use super::{Share, Side, Stretch};
use crate::body::lattice::{Cell, SquareLattice};
use std::array::from_fn;
use std::ops::Range;

/// Coarse cells that a fine cell looks at, with their weights: the parent, its neighbours along x and y and across both; of a
/// solid then those in the other layer.
pub(super) fn candidates(cell: Cell, is_plane: bool) -> Vec<(Cell, f64)> {
    let parent = SquareLattice::parent(cell);
    let beside = |k: usize| parent[k] + if cell[k].rem_euclid(2) == 0 { -1 } else { 1 };
    let axes = if is_plane { 2 } else { 3 };
    let candidate = |which: usize| {
        let is_beside = |k: usize| (which >> k) & 1 == 1;
        let at = from_fn(|k| if is_beside(k) { beside(k) } else { parent[k] });
        (at, (0..axes).map(|k| if is_beside(k) { 0.25 } else { 0.75 }).product())
    };
    (0..1 << axes).map(candidate).collect()
}

/// Everything that fine points take.
pub(super) fn fine_side(
    fine: &SquareLattice,
    coarse: &SquareLattice,
    near_crack: &dyn Fn(usize) -> bool,
    weights: &dyn Fn(usize, Cell) -> Vec<(u32, f64)>,
) -> Side {
    let mut side = Side::new(fine.points(), if fine.is_plane() { 2 } else { 4 });
    for run in fine.runs() {
        let begin = side.stretches.len();
        let mut next = run.columns.start;
        let special = |side: &mut Side, columns: Range<i32>| {
            columns.for_each(|i| side.push_special(run.number(i), weights(run.number(i), run.cell(i))));
        };
        // Every other candidate is in the column of the parent: one of each line.
        let near = candidates(run.cell(run.columns.start), fine.is_plane());
        let lines: Vec<[i32; 2]> = near.iter().step_by(2).map(|(cell, _)| [cell[1], cell[2]]).collect();
        // Whole pairs whose parents and both of their neighbours exist in all coarse lines.
        let pairs = (run.columns.start + 1).div_euclid(2)..run.columns.end.div_euclid(2);
        for (both, numbers) in common(coarse, &lines, pairs.start - 1..pairs.end + 1) {
            if both.len() <= 2 {
                continue;
            }
            let pairs = both.start + 1..both.end - 1;
            special(&mut side, next..2 * pairs.start);
            let crossed = |c: &i32| (0..2).any(|k| near_crack(run.number(2 * c + k)));
            let mut from = pairs.start;
            while from < pairs.end {
                let to = (from..pairs.end).find(crossed).unwrap_or(pairs.end);
                if from < to {
                    let shift = (from - both.start) as u32;
                    let others = numbers.iter().map(|number| number + shift);
                    side.push_stretch(run.number(2 * from) as u32, (to - from) as u32, others);
                }
                from = (to..pairs.end).find(|c| !crossed(c)).unwrap_or(pairs.end);
                special(&mut side, 2 * to..2 * from);
            }
            next = 2 * pairs.end;
        }
        special(&mut side, next..run.columns.end);
        side.finish(run.points(), begin);
    }
    side
}

/// Stretches of columns that all of some lines have, each with the number of its first point in every line.
fn common(lattice: &SquareLattice, lines: &[[i32; 2]], columns: Range<i32>) -> Vec<(Range<i32>, Vec<u32>)> {
    let mut found: Vec<(Range<i32>, Vec<u32>)> = vec![(columns, Vec::new())];
    for &line in lines {
        let mut left = Vec::new();
        for (columns, numbers) in found {
            lattice.shifted(line, &columns, [0; 3], |both, first| {
                let shift = (both.start - columns.start) as u32;
                let numbers =
                    numbers.iter().map(|number| number + shift).chain(std::iter::once(first as u32));
                left.push((both, numbers.collect::<Vec<u32>>()));
            });
        }
        found = left;
    }
    found
}

/// Everything that coarse points collect.
pub(super) fn coarse_side(
    fine: &SquareLattice,
    coarse: &SquareLattice,
    ordinary: &[bool],
    weights: &dyn Fn(usize, Cell) -> Vec<(u32, f64)>,
) -> Side {
    let mut side = Side::new(coarse.points(), if fine.is_plane() { 4 } else { 16 });
    for run in coarse.runs() {
        let begin = side.stretches.len();
        let layers = if fine.is_plane() { fine.layers() } else { 2 * run.layer - 1..2 * run.layer + 3 };
        let rows = 2 * run.row - 1..2 * run.row + 3;
        let lines: Vec<[i32; 2]> = layers.flat_map(|l| rows.clone().map(move |row| [row, l])).collect();
        let patch = |i: i32| {
            let line = move |&[row, layer]: &[i32; 2]| (2 * i - 1..2 * i + 3).map(move |c| [c, row, layer]);
            lines.iter().flat_map(line)
        };
        let is_ordinary = |i: i32| patch(i).all(|cell| fine.number(cell).is_some_and(|p| ordinary[p]));
        let mut is_open = false;
        for i in run.columns.clone() {
            let number = run.number(i) as u32;
            if is_ordinary(i) {
                match side.stretches.last_mut().filter(|_| is_open) {
                    Some(stretch) => stretch.cells += 1,
                    None => {
                        let first = |&[row, layer]: &[i32; 2]| fine.number([2 * i, row, layer]);
                        side.push_stretch(number, 1, lines.iter().map(|l| first(l).map_or(0, |p| p as u32)));
                    }
                }
                is_open = true;
                continue;
            }
            is_open = false;
            let mut entries = Vec::new();
            for cell in patch(i) {
                if let Some(p) = fine.number(cell) {
                    let own = weights(p, cell).into_iter().filter(|w| w.0 == number);
                    entries.extend(own.map(|w| (p as u32, w.1)));
                }
            }
            side.push_special(number as usize, entries);
        }
        side.finish(run.points(), begin);
    }
    side
}

impl Side {
    fn new(points: usize, lines: usize) -> Self {
        Self {
            points,
            runs: Vec::new(),
            stretches: Vec::new(),
            others: Vec::new(),
            lines,
            special: Vec::new(),
            entries: Vec::new(),
        }
    }

    fn push_stretch(&mut self, first: u32, cells: u32, others: impl Iterator<Item = u32>) {
        self.stretches.push(Stretch { first, cells, others: self.others.len() as u32 });
        self.others.extend(others);
    }

    fn push_special(&mut self, point: usize, entries: Vec<(u32, f64)>) {
        self.entries.extend(entries);
        self.special.push((point as u32, self.entries.len() as u32));
    }

    fn finish(&mut self, points: Range<usize>, stretches: usize) {
        self.runs.push(Share { points, stretches: stretches..self.stretches.len() });
    }
}
