//! Lines along the sides of a lattice beyond which cells are images of real ones: mirror images behind lines of symmetry, or
//! copies where two opposite sides are joined.

use crate::body::{Cell, Run, SquareLattice};
use crate::condition::{Equation, Unknown};
use std::array::from_fn;
use std::ops::Range;

/// Lines between columns, between rows and between layers of cells, as the number of the first cell behind the line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mirrors {
    /// Along every axis, before the real cells and behind them: these have `low <= column < high`, and so for rows and layers.
    pub lines: [[Option<i32>; 2]; 3],
    /// Whether both lines along an axis are one: behind the last cell follows the first. Else they are lines of symmetry.
    pub joined: [bool; 3],
    /// Along which axes a body whose sides are joined can stretch: from one copy to the next the displacement grows by the same
    /// amount, which is an unknown.
    pub stretches: [bool; 3],
    /// Whether the body is one of revolution: parts of it count by their radius, x, and the line on the left, where there is one,
    /// is its axis, on which the body ends; images beyond it tell how it moves there.
    pub revolved: bool,
}

impl Mirrors {
    /// No images.
    pub const NONE: Self =
        Self { lines: [[None; 2]; 3], joined: [false; 3], stretches: [false; 3], revolved: false };

    /// Lines of symmetry between columns and between rows.
    pub fn in_plane(columns: [Option<i32>; 2], rows: [Option<i32>; 2]) -> Self {
        Self { lines: [columns, rows, [None; 2]], ..Self::NONE }
    }

    /// Whether there is none.
    pub fn is_none(&self) -> bool {
        *self == Self::NONE
    }

    /// Sets a line: that on the left, on the right, below or above, of a solid then in front or behind.
    ///
    /// # Panics
    /// There are six sides.
    pub fn set_line(&mut self, side: usize, line: i32) {
        assert!(side < 6, "a body has six sides");
        self.lines[side / 2][side % 2] = Some(line);
    }

    /// Whether a cell lies on the real side of all lines.
    pub fn is_real(&self, cell: Cell) -> bool {
        self.lines.iter().zip(cell).all(|(line, k)| inside(*line, k))
    }

    /// The real cell that a cell is an image of, and the signs of the displacements along x, y and z of the image.
    pub fn image(&self, cell: Cell) -> (Cell, [f64; 3]) {
        let along: [(i32, f64); 3] = from_fn(|k| match (self.joined[k], self.lines[k]) {
            (true, [Some(low), Some(high)]) => (low + (cell[k] - low).rem_euclid(high - low), 1.0),
            (_, lines) => reflected(lines, cell[k]),
        });
        (along.map(|a| a.0), along.map(|a| a.1))
    }

    /// How many periods lie between a cell and its image, along each axis that stretches.
    fn periods(&self, cell: Cell) -> [i32; 3] {
        let (image, _) = self.image(cell);
        from_fn(|k| match (self.stretches[k], self.lines[k]) {
            (true, [Some(low), Some(high)]) => (cell[k] - image[k]) / (high - low),
            _ => 0,
        })
    }

    /// Two points whose difference is what a body grows by along an axis that stretches: a real one, and its first copy.
    pub fn stretch_points(&self, lattice: &SquareLattice, axis: usize) -> Option<[usize; 2]> {
        let [Some(low), Some(high)] = self.lines[axis] else { return None };
        let is_first = |cell: &Cell| self.stretches[axis] && self.is_real(*cell) && cell[axis] == low;
        let first = (0..lattice.points()).map(|p| lattice.cell(p)).find(is_first)?;
        let mut copy = first;
        copy[axis] += high - low;
        Some([lattice.number(first)?, lattice.number(copy)?])
    }

    /// The real cells of a lattice.
    pub fn real(&self, lattice: &SquareLattice) -> SquareLattice {
        let clip = |line: [Option<i32>; 2], range: Range<i32>| {
            let start = line[0].map_or(range.start, |l| l.max(range.start));
            start..line[1].map_or(range.end, |l| l.min(range.end)).max(start)
        };
        let ranges = ranges(lattice);
        let ranges = from_fn(|k| clip(self.lines[k], ranges[k].clone()));
        let inside = |cell| lattice.number(cell).is_some();
        let all = SquareLattice::new(lattice.spacing(), lattice.corner(), ranges, inside);
        all.with_areas(&cut_cells(lattice)).with_blocks_of(lattice)
    }

    /// A lattice of real cells with `depth` columns, rows or layers of images beyond every line.
    pub fn extended(&self, real: &SquareLattice, depth: i32) -> SquareLattice {
        if self.is_none() {
            return real.clone();
        }
        let widen = |line: [Option<i32>; 2], range: Range<i32>| {
            line[0].map_or(range.start, |l| l - depth)..line[1].map_or(range.end, |l| l + depth)
        };
        let ranges = ranges(real);
        let ranges = from_fn(|k| widen(self.lines[k], ranges[k].clone()));
        let inside = |cell| real.number(self.image(cell).0).is_some();
        let extended = SquareLattice::new(real.spacing(), real.corner(), ranges, inside);
        let mut areas: Vec<(Cell, f64)> = cut_cells(real);
        if !areas.is_empty() {
            let ghosts = self.ghosts(&extended).into_iter().map(|g| extended.cell(g as usize));
            let area = |cell| Some((cell, real.fraction(real.number(self.image(cell).0)?)));
            areas.extend(ghosts.filter_map(area));
        }
        extended.with_areas(&areas).with_blocks_of(real)
    }

    /// The lines on a lattice of twice the spacing. A line of symmetry that runs through cells moves outwards; joined sides
    /// cannot move, so that there are no coarser ones.
    pub fn coarser(&self) -> Option<Self> {
        let cut = |line: Option<i32>| line.is_some_and(|l| l.rem_euclid(2) == 1);
        if (0..3).any(|k| self.joined[k] && self.lines[k].into_iter().any(cut)) {
            return None;
        }
        let halved = |[low, high]: [Option<i32>; 2]| {
            [low.map(|l| l.div_euclid(2)), high.map(|l| (l + 1).div_euclid(2))]
        };
        Some(Self { lines: self.lines.map(halved), ..*self })
    }

    /// Numbers of the points that are images.
    pub(in super::super) fn ghosts(&self, lattice: &SquareLattice) -> Vec<u32> {
        if self.is_none() {
            return Vec::new();
        }
        let of = |run: &Run| {
            let ghosts = run.columns.clone().filter(|&column| !self.is_real(run.cell(column)));
            ghosts.map(|column| run.number(column) as u32).collect::<Vec<_>>()
        };
        lattice.runs().iter().flat_map(of).collect()
    }

    /// What ties the unknowns of the images to those of real points; `signs_of` makes
    /// their signs of those of the displacements along x, y and z.
    pub(in super::super) fn relations<const D: usize>(
        &self,
        lattice: &SquareLattice,
        ghosts: &[u32],
        signs_of: impl Fn([f64; 3]) -> [f64; D],
    ) -> Vec<Equation> {
        let growth: [Option<[usize; 2]>; 3] = from_fn(|axis| match self.stretches[axis] {
            true => self.stretch_points(lattice, axis),
            false => None,
        });
        let tie = |&ghost: &u32| {
            let (point, cell) = (ghost as usize, lattice.cell(ghost as usize));
            let (image, signs) = self.image(cell);
            let real = lattice.number(image).expect("an image has a real cell");
            let (signs, periods) = (signs_of(signs), self.periods(cell));
            from_fn::<Equation, D, _>(|component| {
                let mut terms = vec![
                    (Unknown { component, point }, 1.0),
                    (Unknown { component, point: real }, -signs[component]),
                ];
                if let Some([first, copy]) = growth.get(component).copied().flatten() {
                    let grown = f64::from(periods[component]);
                    match point == copy {
                        // The amount itself: nothing ties it.
                        true => terms.clear(),
                        false => add_growth(&mut terms, component, [first, copy], grown),
                    }
                }
                let origin = if self.joined == [false; 3] { "symmetry" } else { "periodic" };
                Equation { terms, value: 0.0, origin: origin.into() }
            })
        };
        ghosts.iter().flat_map(tie).collect()
    }
}

/// Takes `times` the difference of two points from a sum.
fn add_growth(terms: &mut Vec<(Unknown, f64)>, component: usize, [first, copy]: [usize; 2], times: f64) {
    for (point, share) in [(copy, -times), (first, times)].into_iter().filter(|s| s.1 != 0.0) {
        let unknown = Unknown { component, point };
        match terms.iter_mut().find(|t| t.0 == unknown) {
            Some(term) => term.1 += share,
            None => terms.push((unknown, share)),
        }
    }
}

/// Cells of a lattice that are not whole, and their areas.
fn cut_cells(lattice: &SquareLattice) -> Vec<(Cell, f64)> {
    lattice.cut_cells().iter().map(|&(p, area)| (lattice.cell(p as usize), area)).collect()
}

/// Columns, rows and layers of a lattice.
fn ranges(lattice: &SquareLattice) -> [Range<i32>; 3] {
    [lattice.columns(), lattice.rows(), lattice.layers()]
}

fn inside([low, high]: [Option<i32>; 2], k: i32) -> bool {
    low.is_none_or(|l| k >= l) && high.is_none_or(|h| k < h)
}

/// The real index behind `k`, and −1 after an odd number of reflections. Two lines reflect as often as it takes.
fn reflected(line: [Option<i32>; 2], mut k: i32) -> (i32, f64) {
    let mut sign = 1.0;
    while !inside(line, k) {
        let at = match line {
            [Some(low), _] if k < low => low,
            [_, Some(high)] => high,
            _ => break,
        };
        k = 2 * at - 1 - k;
        sign = -sign;
    }
    (k, sign)
}

#[cfg(test)]
mod tests;
