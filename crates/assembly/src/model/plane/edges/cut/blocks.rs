//! How much of the triangles of blocks lies in the body, images among them.

use super::super::super::Mirrors;
use crate::body::{Cell, SquareLattice, TriangleParts, middle, plus};
use std::array::from_fn;
use std::cell::RefCell;
use std::collections::HashMap;

/// Corners of a block from its lower left one, in the order of [`TriangleParts`].
pub(super) const CORNERS: [Cell; 4] = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]];

/// Parts nearer to none or all are that.
const WHOLE: f64 = 1e-9;

/// Part of a triangle that lies in the body, and its first moments in cells from the first point of the block.
type Moments = [f64; 3];

/// The blocks of a body with its images. A block has the name of its lower left cell.
pub(super) struct Blocks<'a> {
    pub(super) lattice: &'a SquareLattice,
    pub(super) mirrors: &'a Mirrors,
    /// Lines in which parts of the body are mirrored: on the axis of a body of revolution it ends.
    lines: [[Option<i32>; 2]; 2],
    known: RefCell<HashMap<Cell, [Moments; 4]>>,
}

impl<'a> Blocks<'a> {
    pub(super) fn new(lattice: &'a SquareLattice, mirrors: &'a Mirrors) -> Self {
        let [mut columns, rows, _] = mirrors.lines;
        if mirrors.revolved {
            columns[0] = None;
        }
        Self { lattice, mirrors, lines: [columns, rows], known: RefCell::default() }
    }

    /// Whether there is a point in a cell, stored or not.
    pub(super) fn has(&self, cell: Cell) -> bool {
        let image = if self.mirrors.is_none() { cell } else { self.mirrors.image(cell).0 };
        self.lattice.number(image).is_some()
    }

    /// Parts in the body of the triangles of a block.
    pub(super) fn parts(&self, block: Cell) -> TriangleParts {
        self.moments(block).map(|moments| moments[0])
    }

    /// Centre of the part in the body of a triangle, in cells from the first point of its block.
    pub(super) fn centre(&self, block: Cell, triangle: usize) -> [f64; 2] {
        match self.moments(block)[triangle] {
            [part, x, y] if part > 0.0 => [x / part, y / part],
            _ => middle(triangle),
        }
    }

    /// What a place counts by, columns from the point of cell `[0, 0]`: in a body of revolution its radius in spacings.
    pub(super) fn weight(&self, column: f64) -> f64 {
        if self.mirrors.revolved { column + 0.5 - self.lattice.in_cells([0.0; 2])[0] } else { 1.0 }
    }

    fn moments(&self, block: Cell) -> [Moments; 4] {
        if let Some(known) = self.known.borrow().get(&block) {
            return *known;
        }
        let found = self.with_images(block);
        let moments = from_fn(|t| match found[t] {
            [p, ..] if p < WHOLE => [0.0; 3],
            [p, ..] if p > 1.0 - WHOLE => [1.0, middle(t)[0], middle(t)[1]],
            moments => moments,
        });
        self.known.borrow_mut().insert(block, moments);
        moments
    }

    /// Whether all of a block lies in the body.
    pub(super) fn is_whole(&self, block: Cell) -> bool {
        self.parts(block) == [1.0; 4]
    }

    /// Part of the energy of a block that counts: half of one that a line of symmetry runs through, nothing beyond.
    pub(super) fn counted(&self, block: Cell) -> f64 {
        let along = |(lines, k): ([Option<i32>; 2], i32)| match lines {
            [Some(low), _] if k < low => 0.5 * f64::from(u8::from(k == low - 1)),
            [_, Some(high)] if k >= high - 1 => 0.5 * f64::from(u8::from(k == high - 1)),
            _ => 1.0,
        };
        self.lines.into_iter().zip(block).map(along).product()
    }

    /// A block that lies beyond a line of symmetry is the image of a real one, and one that a line runs through is half a real
    /// one and half its image.
    fn with_images(&self, mut block: Cell) -> [Moments; 4] {
        let (mut turned, mut through) = ([false; 2], [false; 2]);
        for k in 0..2 {
            let [low, high] = self.lines[k];
            // Blocks reach from one cell to the next.
            loop {
                block[k] = match (low, high) {
                    (Some(low), _) if block[k] < low - 1 => 2 * low - 2 - block[k],
                    (_, Some(high)) if block[k] > high - 1 => 2 * high - 2 - block[k],
                    _ => break,
                };
                turned[k] = !turned[k];
            }
            through[k] = low == Some(block[k] + 1) || high == Some(block[k] + 1);
        }
        let own = self.own(block);
        let mut sum = [[0.0; 3]; 4];
        for flips in [[false, false], [true, false], [false, true], [true, true]] {
            if (0..2).all(|k| !flips[k] || through[k]) {
                let flip = [0, 1].map(|k| flips[k] != turned[k]);
                for (t, sum) in sum.iter_mut().enumerate() {
                    let [part, x, y] = own[flipped(t, flip)];
                    let turned = |k: usize, moment: f64| if flip[k] { part - moment } else { moment };
                    add(sum, &[part, turned(0, x), turned(1, y)]);
                }
            }
        }
        sum
    }

    /// Parts of a block as the border of the body has them.
    fn own(&self, block: Cell) -> [Moments; 4] {
        let (listed, centres) = (self.lattice.blocks(), self.lattice.centres());
        let found = listed.binary_search_by_key(&block, |b| b.0);
        let is_there = || CORNERS.iter().all(|c| self.has_own(plus(block, *c)));
        from_fn(|t| {
            let part = found.map_or_else(|_| f64::from(u8::from(is_there())), |index| listed[index].1[t]);
            let known = found.ok().and_then(|index| centres.get(index));
            let [x, y] = known.map_or_else(|| middle(t), |centres| centres[t]);
            [part, part * x, part * y]
        })
    }

    /// Whether a real cell has a point.
    fn has_own(&self, cell: Cell) -> bool {
        (self.mirrors.is_none() || self.mirrors.is_real(cell)) && self.lattice.number(cell).is_some()
    }
}

fn add(to: &mut Moments, other: &Moments) {
    to.iter_mut().zip(other).for_each(|(t, o)| *t += o);
}

/// The triangle that takes the place of another in a block that is mirrored.
fn flipped(triangle: usize, [x, y]: [bool; 2]) -> usize {
    triangle ^ usize::from(x) ^ (2 * usize::from(y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{Hole, Outline, Shape};

    fn with_hole(from: [f64; 2], size: [f64; 2]) -> SquareLattice {
        let mut outline = Outline::rectangle(from, size).unwrap();
        outline.cut(Hole { name: None, shape: Shape::Circle { centre: [0.0; 2], radius: 3.3 } }).unwrap();
        outline.fill(1.0).unwrap()
    }

    /// A quarter with its images has the blocks of the whole body.
    #[test]
    fn blocks_of_a_quarter_are_those_of_the_whole() {
        let (whole, quarter) = (with_hole([-8.0; 2], [16.0; 2]), with_hole([0.0; 2], [8.0; 2]));
        let mirrors = Mirrors::in_plane([Some(0), None], [Some(0), None]);
        let (own, mirrored) = (Blocks::new(&whole, &Mirrors::NONE), Blocks::new(&quarter, &mirrors));
        let mut counted = 0.0;
        for block in (-9..8).flat_map(|j| (-9..8).map(move |i| [i, j, 0])) {
            let [found, expected] = [mirrored.parts(block), own.parts(plus(block, [8, 8, 0]))];
            for (a, b) in found.iter().zip(expected) {
                assert!((a - b).abs() < 1e-12, "{block:?} {found:?} {expected:?}");
            }
            counted += mirrored.counted(block) * found.iter().sum::<f64>();
        }
        let all = (-1..16).flat_map(|j| (-1..16).map(move |i| [i, j, 0]));
        let sum: f64 = all.map(|block| own.parts(block).iter().sum::<f64>()).sum();
        assert!((counted / sum - 0.25).abs() < 1e-12);
    }
}
