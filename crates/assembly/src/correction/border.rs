//! The true border: what is known at places on it.

use super::grid::Grid;
use crate::body::{BorderPart, around};
use crate::quadrature::{GAUSS, GAUSS_3};
use std::ops::RangeInclusive;

/// Places of the rule of eight points, which elsewhere leaves rounding alone, that are enough for fits.
const ENOUGH: [usize; 4] = [0, 1, 4, 5];
/// Parts of a piece that are shorter, relative to it, are rounding.
const LEAST: f64 = 1e-9;
/// How far inside of the border the square is looked for that a place belongs to, in spacings.
const INSIDE: f64 = 1e-6;

/// A piece of the border of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BorderPiece {
    /// Where it runs.
    pub part: BorderPart,
    /// Along which axes its displacement is prescribed; along the others its traction is.
    pub held: [bool; 2],
}

/// A place on the border at which something is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Index of its piece.
    pub piece: usize,
    /// Part of the length of the piece, 0 to 1.
    pub share: f64,
    /// Position, m.
    pub at: [f64; 2],
    /// Unit normal that points out of the body.
    pub normal: [f64; 2],
    /// Length that it stands for, m.
    pub length: f64,
}

/// A sample or its image.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    pub(super) sample: u32,
    /// Place, in spacings.
    pub(super) at: [f64; 2],
    pub(super) normal: [f64; 2],
    /// Signs of vectors along x and y.
    pub(super) signs: [i8; 2],
    pub(super) held: [bool; 2],
    /// Whether fits are made of it.
    pub(super) is_fitted: bool,
}

/// The samples of a border with their images.
#[derive(Clone, Debug)]
pub(super) struct Border {
    pub(super) samples: Vec<Sample>,
    pub(super) marks: Vec<Mark>,
    /// Row and column of the square of every mark, and its number, in order.
    by_square: Vec<([i32; 2], u32)>,
}

impl Border {
    pub(super) fn new(pieces: &[BorderPiece], grid: &Grid) -> Self {
        let (mut samples, mut marks) = (Vec::new(), Vec::new());
        for (piece, BorderPiece { part, held }) in pieces.iter().enumerate() {
            // Along rows and columns of points all is a polynomial of degree five at most.
            let rule = if is_along(part) { &GAUSS_3[..] } else { &GAUSS[..] };
            for ends in breaks(part, grid).windows(2) {
                for (k, (share, weight)) in rule.iter().enumerate() {
                    let share = ends[0] + share * (ends[1] - ends[0]);
                    let length = weight * (ends[1] - ends[0]) * part.length();
                    let sample =
                        Sample { piece, share, at: part.at(share), normal: part.normal(share), length };
                    let number = samples.len() as u32;
                    marks.extend(grid.images(grid.place(sample.at)).into_iter().map(|(at, signs)| Mark {
                        sample: number,
                        at,
                        normal: [0, 1].map(|k| f64::from(signs[k]) * sample.normal[k]),
                        signs,
                        held: *held,
                        is_fitted: rule.len() == GAUSS_3.len() || ENOUGH.contains(&k),
                    }));
                    samples.push(sample);
                }
            }
        }
        let squares = marks.iter().map(Mark::square).map(|[column, row]| [row, column]);
        let mut by_square: Vec<([i32; 2], u32)> = squares.zip(0..).collect();
        by_square.sort_unstable();
        Self { samples, marks, by_square }
    }

    /// Along which axes the displacement is known, by samples.
    pub(super) fn held(&self) -> Vec<[bool; 2]> {
        let mut held = vec![[false; 2]; self.samples.len()];
        self.marks.iter().for_each(|mark| held[mark.sample as usize] = mark.held);
        held
    }

    /// Numbers of the marks within a distance of a place, in spacings, that fits are made of.
    pub(super) fn near(&self, place: [f64; 2], reach: f64) -> Vec<u32> {
        let [columns, rows] = place.map(|x| (x - reach).floor() as i32..=(x + reach).floor() as i32);
        let all = rows.flat_map(|row| self.in_row(row, columns.clone()));
        let is_near = |mark: &u32| {
            let Mark { at: [x, y], is_fitted, .. } = self.marks[*mark as usize];
            is_fitted && (x - place[0]).hypot(y - place[1]) <= reach
        };
        all.filter(is_near).collect()
    }

    /// Numbers of the marks in some columns of a row of squares.
    fn in_row(&self, row: i32, columns: RangeInclusive<i32>) -> impl Iterator<Item = u32> + '_ {
        let first = self.by_square.partition_point(|(square, _)| *square < [row, *columns.start()]);
        let last = [row, *columns.end()];
        self.by_square[first..].iter().take_while(move |(square, _)| *square <= last).map(|(_, mark)| *mark)
    }

    /// Whether some of the border lies in a square of four points, given by its lower left one.
    pub(super) fn crosses(&self, [column, row]: [i32; 2]) -> bool {
        self.in_row(row, column..=column).next().is_some()
    }
}

impl Mark {
    /// The square just inside of the border.
    pub(super) fn square(&self) -> [i32; 2] {
        [0, 1].map(|k| (self.at[k] - INSIDE * self.normal[k]).floor() as i32)
    }
}

/// Whether a part runs along rows or columns.
fn is_along(part: &BorderPart) -> bool {
    matches!(part, BorderPart::Straight { normal, .. } if normal.contains(&0.0))
}

/// Shares of a part at which it crosses rows and columns of points, with its ends.
fn breaks(part: &BorderPart, grid: &Grid) -> Vec<f64> {
    let mut shares = vec![0.0, 1.0];
    let box_around = around(std::slice::from_ref(part), 0.0);
    let [low, high] = box_around.map(|at| grid.place(at));
    for axis in 0..2 {
        for line in low[axis].ceil() as i32..=high[axis].floor() as i32 {
            let [mut from, mut to] = box_around;
            (from[axis], to[axis]) = (grid.along(axis, line), grid.along(axis, line));
            // The box of a segment along the other axis has no height.
            to[1 - axis] = from[1 - axis] + grid.spacing;
            shares.extend(part.crossings(&BorderPart::Straight { from, to, normal: [0.0; 2] }));
        }
    }
    shares.retain(|share| (0.0..=1.0).contains(share));
    shares.sort_by(f64::total_cmp);
    shares.dedup_by(|later, share| *later - *share < LEAST);
    shares
}
