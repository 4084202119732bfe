//! Lines along the sides of a lattice beyond which cells are images of real ones: mirror images behind lines of symmetry, or
//! copies where two opposite sides are joined.

use crate::body::{Cell, SquareLattice};
use crate::condition::{Equation, Unknown};
use std::array::from_fn;
use std::ops::Range;

/// Lines between columns and between rows of cells, as the number of the first cell behind the line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mirrors {
    /// On the left and on the right: real cells have `left <= column < right`.
    pub columns: [Option<i32>; 2],
    /// Below and above: real cells have `below <= row < above`.
    pub rows: [Option<i32>; 2],
    /// Whether both lines between columns, and both between rows, are one: behind the last cell follows the first. Else they
    /// are lines of symmetry.
    pub joined: [bool; 2],
    /// Along which of both a body whose sides are joined can stretch: from one copy to the next the displacement grows by the
    /// same amount, which is an unknown.
    pub stretches: [bool; 2],
    /// Whether the body is one of revolution: parts of it count by their radius, x, and the line on the left, where there is one,
    /// is its axis, on which the body ends; images beyond it tell how it moves there.
    pub revolved: bool,
}

impl Mirrors {
    /// No images.
    pub const NONE: Self = Self {
        columns: [None; 2],
        rows: [None; 2],
        joined: [false; 2],
        stretches: [false; 2],
        revolved: false,
    };

    /// Whether there is none.
    pub fn is_none(&self) -> bool {
        *self == Self::NONE
    }

    /// Sets a line: that on the left, on the right, below or above.
    ///
    /// # Panics
    /// There are four sides.
    pub fn set_line(&mut self, side: usize, line: i32) {
        let lines = if side < 2 { &mut self.columns } else { &mut self.rows };
        lines[side % 2] = Some(line);
        assert!(side < 4, "a body has four sides");
    }

    /// Whether a cell lies on the real side of all lines.
    pub fn is_real(&self, cell: Cell) -> bool {
        self.lines().iter().zip(cell).all(|(line, k)| inside(*line, k))
    }

    /// The real cell that a cell is an image of, and the signs of the displacements along x and y of the image.
    pub fn image(&self, cell: Cell) -> (Cell, [f64; 2]) {
        let [(column, x), (row, y)] = [0, 1].map(|k| match (self.joined[k], self.lines()[k]) {
            (true, [Some(low), Some(high)]) => (low + (cell[k] - low).rem_euclid(high - low), 1.0),
            (_, lines) => reflected(lines, cell[k]),
        });
        ([column, row], [x, y])
    }

    /// Lines between columns, then between rows.
    pub fn lines(&self) -> [[Option<i32>; 2]; 2] {
        [self.columns, self.rows]
    }

    /// How many periods lie between a cell and its image, along each axis that stretches.
    fn periods(&self, cell: Cell) -> [i32; 2] {
        let (image, _) = self.image(cell);
        from_fn(|k| match (self.stretches[k], self.lines()[k]) {
            (true, [Some(low), Some(high)]) => (cell[k] - image[k]) / (high - low),
            _ => 0,
        })
    }

    /// Two points whose difference is what a body grows by along an axis that stretches: a real one, and its first copy.
    pub fn stretch_points(&self, lattice: &SquareLattice, axis: usize) -> Option<[usize; 2]> {
        let [Some(low), Some(high)] = self.lines()[axis] else { return None };
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
        let (columns, rows) = (clip(self.columns, lattice.columns()), clip(self.rows, lattice.rows()));
        let inside = |cell| lattice.number(cell).is_some();
        let all = SquareLattice::new(lattice.spacing(), lattice.corner(), columns, rows, inside);
        all.with_areas(&cut_cells(lattice)).with_blocks_of(lattice)
    }

    /// A lattice of real cells with `depth` columns or rows of images beyond every line.
    pub fn extended(&self, real: &SquareLattice, depth: i32) -> SquareLattice {
        if self.is_none() {
            return real.clone();
        }
        let widen = |line: [Option<i32>; 2], range: Range<i32>| {
            line[0].map_or(range.start, |l| l - depth)..line[1].map_or(range.end, |l| l + depth)
        };
        let (columns, rows) = (widen(self.columns, real.columns()), widen(self.rows, real.rows()));
        let inside = |cell| real.number(self.image(cell).0).is_some();
        let extended = SquareLattice::new(real.spacing(), real.corner(), columns, rows, inside);
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
        if (0..2).any(|k| self.joined[k] && self.lines()[k].into_iter().any(cut)) {
            return None;
        }
        let halved = |[low, high]: [Option<i32>; 2]| {
            [low.map(|l| l.div_euclid(2)), high.map(|l| (l + 1).div_euclid(2))]
        };
        Some(Self { columns: halved(self.columns), rows: halved(self.rows), ..*self })
    }

    /// Numbers of the points that are images.
    pub(in super::super) fn ghosts(&self, lattice: &SquareLattice) -> Vec<u32> {
        if self.is_none() {
            return Vec::new();
        }
        let of = |run: &crate::body::Run| {
            let (row, first, start) = (run.row, run.first, run.columns.start);
            let ghosts = run.columns.clone().filter(move |&column| !self.is_real([column, row]));
            ghosts.map(move |column| (first + (column - start) as usize) as u32).collect::<Vec<_>>()
        };
        lattice.runs().iter().flat_map(of).collect()
    }

    /// What ties the unknowns of the images to those of real points; `signs_of` makes
    /// their signs of those of the displacements along x and y.
    pub(in super::super) fn relations<const D: usize>(
        &self,
        lattice: &SquareLattice,
        ghosts: &[u32],
        signs_of: impl Fn([f64; 2]) -> [f64; D],
    ) -> Vec<Equation> {
        let growth: [Option<[usize; 2]>; 2] = from_fn(|axis| match self.stretches[axis] {
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
                let origin = if self.joined == [false; 2] { "symmetry" } else { "periodic" };
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
mod tests {
    use super::*;

    #[test]
    fn cells_between_two_lines_repeat() {
        let mirrors = Mirrors { columns: [Some(0), Some(2)], ..Mirrors::NONE };
        let images: Vec<(i32, f64)> =
            (-4..6).map(|c| (mirrors.image([c, 7]).0[0], mirrors.image([c, 7]).1[0])).collect();
        let expected = [
            (0, 1.0),
            (1, 1.0),
            (1, -1.0),
            (0, -1.0),
            (0, 1.0),
            (1, 1.0),
            (1, -1.0),
            (0, -1.0),
            (0, 1.0),
            (1, 1.0),
        ];
        assert_eq!(images, expected);
        assert!(mirrors.is_real([1, -3]) && !mirrors.is_real([2, 0]));
    }

    #[test]
    fn behind_a_joined_side_the_other_one_follows() {
        for (from, period) in [(0, 5), (-2, 1), (3, 4)] {
            let joined = [false, true];
            let mirrors = Mirrors { rows: [Some(from), Some(from + period)], joined, ..Mirrors::NONE };
            for row in from - 12..from + 12 {
                let (cell, signs) = mirrors.image([7, row]);
                assert_eq!((cell[0], signs), (7, [1.0, 1.0]));
                assert!(mirrors.is_real(cell) && (cell[1] - row) % period == 0);
                assert_eq!(mirrors.is_real([7, row]), cell[1] == row);
            }
            assert_eq!(mirrors.coarser().is_some(), from % 2 == 0 && period % 2 == 0);
        }
    }

    #[test]
    fn copies_of_a_body_that_stretches_grow_by_whole_periods() {
        let [joined, stretches] = [[true, false]; 2];
        let mirrors = Mirrors { columns: [Some(1), Some(4)], joined, stretches, ..Mirrors::NONE };
        let real = SquareLattice::new(1.0, [0.0; 2], 1..4, 0..2, |_| true);
        let lattice = mirrors.extended(&real, 7);
        let relations = mirrors.relations::<2>(&lattice, &mirrors.ghosts(&lattice), |signs| signs);
        // What repeats, and half a unit more along x per column.
        let value = |Unknown { component, point }: Unknown| {
            let [column, row] = lattice.cell(point);
            let repeated = (column.rem_euclid(3) * 5 + row * 3) % 7 + component as i32;
            f64::from(repeated) + if component == 0 { 0.5 * f64::from(column) } else { 0.0 }
        };
        assert!(relations.iter().any(|relation| relation.terms.len() > 2));
        for Equation { terms, value: right, origin } in relations {
            let left: f64 = terms.iter().map(|(unknown, factor)| factor * value(*unknown)).sum();
            assert!((left - right).abs() < 1e-13, "{terms:?}");
            assert_eq!(origin, "periodic");
        }
    }

    #[test]
    fn images_are_added_and_taken_away() {
        let hole = |c: Cell| c != [1, 1];
        let real = SquareLattice::new(1.0, [0.0; 2], 0..5, 0..4, hole);
        let mirrors = Mirrors { columns: [None, Some(5)], rows: [Some(0), None], ..Mirrors::NONE };
        let extended = mirrors.extended(&real, 4);
        // The hole and its three images.
        assert_eq!(extended.points(), 9 * 8 - 4);
        assert_eq!(extended.number([8, -2]), None);
        assert_eq!(mirrors.real(&extended).runs(), real.runs());
        assert_eq!(mirrors.ghosts(&extended).len(), extended.points() - real.points());
    }
}
