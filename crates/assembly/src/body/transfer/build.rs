//! Which points have the ordinary weights, and the weights of the others.

use super::{Share, Side, Stretch};
use crate::body::lattice::{Cell, SquareLattice};
use std::ops::Range;

/// Coarse cells that a fine cell looks at, with their weights: the parent, its neighbours along x and y, the diagonal.
pub(super) fn candidates([i, j]: Cell) -> [(Cell, f64); 4] {
    let [c, r] = SquareLattice::parent([i, j]);
    let beside = |k: i32| if k.rem_euclid(2) == 0 { -1 } else { 1 };
    let (dx, dy) = (beside(i), beside(j));
    [
        ([c, r], 9.0 / 16.0),
        ([c + dx, r], 3.0 / 16.0),
        ([c, r + dy], 3.0 / 16.0),
        ([c + dx, r + dy], 1.0 / 16.0),
    ]
}

/// Everything that fine points take.
pub(super) fn fine_side(
    fine: &SquareLattice,
    coarse: &SquareLattice,
    near_crack: &dyn Fn(usize) -> bool,
    weights: &dyn Fn(usize, Cell) -> Vec<(u32, f64)>,
) -> Side {
    let mut side = Side::new(fine.points());
    for run in fine.runs() {
        let begin = side.stretches.len();
        let parent = SquareLattice::parent([run.columns.start, run.row]);
        let other = candidates([run.columns.start, run.row])[2].0[1];
        // Whole pairs whose parents and both of their neighbours exist in both coarse rows.
        let pairs = (run.columns.start + 1).div_euclid(2)..run.columns.end.div_euclid(2);
        let mut stretches: Vec<(Range<i32>, [u32; 2])> = Vec::new();
        coarse.shifted(parent[1], &(pairs.start - 1..pairs.end + 1), [0, 0], |near, first| {
            coarse.shifted(other, &near, [0, 0], |both, second| {
                if both.len() > 2 {
                    let offset = (both.start - near.start) as u32;
                    stretches
                        .push((both.start + 1..both.end - 1, [first as u32 + offset + 1, second as u32 + 1]));
                }
            });
        });
        let mut next = run.columns.start;
        let special = |side: &mut Side, columns: Range<i32>| {
            columns.for_each(|i| side.push_special(run.number(i), weights(run.number(i), [i, run.row])));
        };
        for (pairs, [near, far]) in stretches {
            special(&mut side, next..2 * pairs.start);
            let crossed = |c: &i32| (0..2).any(|k| near_crack(run.number(2 * c + k)));
            let mut from = pairs.start;
            while from < pairs.end {
                let to = (from..pairs.end).find(crossed).unwrap_or(pairs.end);
                if from < to {
                    let shift = (from - pairs.start) as u32;
                    side.stretches.push(Stretch {
                        first: run.number(2 * from) as u32,
                        cells: (to - from) as u32,
                        others: [near + shift, far + shift, 0, 0],
                    });
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

/// Everything that coarse points collect.
pub(super) fn coarse_side(
    fine: &SquareLattice,
    coarse: &SquareLattice,
    ordinary: &[bool],
    weights: &dyn Fn(usize, Cell) -> Vec<(u32, f64)>,
) -> Side {
    let mut side = Side::new(coarse.points());
    for run in coarse.runs() {
        let begin = side.stretches.len();
        let patch = |i: i32| {
            let rows = 2 * run.row - 1..2 * run.row + 3;
            rows.flat_map(move |row| (2 * i - 1..2 * i + 3).map(move |column| [column, row]))
        };
        let is_ordinary = |i: i32| patch(i).all(|cell| fine.number(cell).is_some_and(|p| ordinary[p]));
        let first =
            |i: i32| [-1, 0, 1, 2].map(|k| fine.number([2 * i, 2 * run.row + k]).map_or(0, |p| p as u32));
        let mut open: Option<Stretch> = None;
        for i in run.columns.clone() {
            let number = run.number(i) as u32;
            if is_ordinary(i) {
                let stretch =
                    open.get_or_insert_with(|| Stretch { first: number, cells: 0, others: first(i) });
                stretch.cells += 1;
                continue;
            }
            side.stretches.extend(open.take());
            let mut entries = Vec::new();
            for cell in patch(i) {
                if let Some(p) = fine.number(cell) {
                    let own = weights(p, cell).into_iter().filter(|w| w.0 == number);
                    entries.extend(own.map(|w| (p as u32, w.1)));
                }
            }
            side.push_special(number as usize, entries);
        }
        side.stretches.extend(open.take());
        side.finish(run.points(), begin);
    }
    side
}

impl Side {
    fn new(points: usize) -> Self {
        Self { points, runs: Vec::new(), stretches: Vec::new(), special: Vec::new(), entries: Vec::new() }
    }

    fn push_special(&mut self, point: usize, entries: Vec<(u32, f64)>) {
        self.entries.extend(entries);
        self.special.push((point as u32, self.entries.len() as u32));
    }

    fn finish(&mut self, points: Range<usize>, stretches: usize) {
        self.runs.push(Share { points, stretches: stretches..self.stretches.len() });
    }
}
