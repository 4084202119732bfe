//! Squares between four points, each with one fit, and what they share of the body.

use super::border::Border;
use super::grid::{Frame, Grid, Node};
use super::holes::HoleZone;
use crate::body::Outline;

/// How far a square that lacks points may be from the one that takes it, in spacings.
const FARTHEST: i32 = 3;

/// Lower left place of a square.
pub(super) type Square = [i32; 2];

/// Steps from the lower left point of a square to its points.
pub(super) const CORNERS: [[i32; 2]; 4] = [[0, 0], [1, 0], [0, 1], [1, 1]];

/// The squares whose points all exist, and which of them takes the part of the body in any other.
#[derive(Clone, Debug)]
pub(super) struct Squares {
    /// Those that act on points of the body.
    pub(super) all: Vec<Square>,
    owners: Owners,
    /// Whether a square takes others or has a part of the border, or one beside it has.
    pub(super) is_plain: Vec<bool>,
    /// The hole whose fields a square has in place of its own fit.
    pub(super) holes: Vec<Option<u32>>,
}

/// Which square has the part of the body in any other, by the places of a grid.
#[derive(Clone, Debug)]
struct Owners {
    frame: Frame,
    numbers: Vec<Option<u32>>,
}

/// A common side of two squares, or the part of it in the body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    /// Number of the squares before and behind it.
    pub(super) squares: [u32; 2],
    /// Axis that it is across.
    pub(super) axis: usize,
    /// Its ends, as places.
    pub(super) ends: [[f64; 2]; 2],
}

impl Squares {
    pub(super) fn new(grid: &Grid, border: &Border, zones: &[HoleZone]) -> Self {
        let mut owners = Owners::none(grid);
        let is_whole = |square: &Square| corners(grid, *square).is_some();
        let (whole, rest): (Vec<Square>, Vec<Square>) = grid.frame().places().partition(is_whole);
        whole.iter().zip(0..).for_each(|(square, number)| owners.set(*square, number));
        let taken = rest.into_iter().filter_map(|square| Some((square, owners.nearest(square)?)));
        let taken: Vec<(Square, u32)> = taken.collect();
        let centre = |square: &Square| grid.position(square.map(|low| f64::from(low) + 0.5));
        let holes: Vec<Option<u32>> =
            whole.iter().map(|square| HoleZone::at(zones, centre(square))).collect();
        let mut is_plain: Vec<bool> = whole
            .iter()
            .zip(&holes)
            .map(|(square, hole)| {
                let beside = [[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]].map(|step| moved(*square, step));
                hole.is_none()
                    && beside.iter().all(|other| owners.of(*other).is_some() && !border.crosses(*other))
            })
            .collect();
        for (square, owner) in taken {
            is_plain[owner as usize] = false;
            owners.set(square, owner);
        }
        Self { all: whole, owners, is_plain, holes }
    }

    /// Number of the square that has the part of the body in this one.
    pub(super) fn owner(&self, square: Square) -> Option<u32> {
        self.owners.of(square)
    }

    /// The faces between squares of which one at least is not plain; within the fields of a hole there are none.
    pub(super) fn faces(&self, grid: &Grid, border: &Border, outline: &Outline) -> Vec<Face> {
        let mut faces = Vec::new();
        for square in grid.frame().places() {
            let Some(first) = self.owner(square) else { continue };
            for axis in 0..2 {
                let step = if axis == 0 { [1, 0] } else { [0, 1] };
                let next = moved(square, step);
                let Some(second) = self.owner(next).filter(|second| *second != first) else { continue };
                let [own, other] = [first, second].map(|k| self.holes[k as usize]);
                let is_within_one = own.is_some() && own == other;
                if is_within_one || [first, second].iter().all(|k| self.is_plain[*k as usize]) {
                    continue;
                }
                let from = next.map(f64::from);
                let to = [0, 1].map(|k| from[k] + if k == axis { 0.0 } else { 1.0 });
                let is_cut = border.crosses(square) || border.crosses(next);
                let inside = |place: [f64; 2]| outline.contains(grid.real_position(place));
                let middle = [0, 1].map(|k| 0.5 * (from[k] + to[k]));
                let parts = match is_cut {
                    true => parts_inside([from, to], &inside),
                    false => Vec::from_iter(inside(middle).then_some([from, to])),
                };
                faces.extend(parts.into_iter().map(|ends| Face { squares: [first, second], axis, ends }));
            }
        }
        faces
    }
}

impl Owners {
    fn none(grid: &Grid) -> Self {
        let frame = grid.frame();
        Self { frame, numbers: vec![None; frame.count()] }
    }

    fn of(&self, square: Square) -> Option<u32> {
        self.numbers[self.frame.index(square)?]
    }

    fn set(&mut self, square: Square, number: u32) {
        if let Some(k) = self.frame.index(square) {
            self.numbers[k] = Some(number);
        }
    }

    /// The owner that is nearest to a square.
    fn nearest(&self, square: Square) -> Option<u32> {
        let steps = (-FARTHEST..=FARTHEST).flat_map(|j| (-FARTHEST..=FARTHEST).map(move |i| [i, j]));
        let found = steps.filter_map(|step| Some((step, self.of(moved(square, step))?)));
        found.min_by_key(|([i, j], _)| i * i + j * j).map(|(_, number)| number)
    }
}

/// The points of a square.
pub(super) fn corners(grid: &Grid, square: Square) -> Option<[Node; 4]> {
    let [a, b, c, d] = CORNERS.map(|step| grid.node(moved(square, step)));
    Some([a?, b?, c?, d?])
}

pub(super) fn moved(square: Square, step: [i32; 2]) -> Square {
    [square[0] + step[0], square[1] + step[1]]
}

/// Shares of the points of a square in the displacement of a place, bilinear within it and beyond.
pub(super) fn shares(square: Square, at: [f64; 2]) -> [f64; 4] {
    let [x, y] = [0, 1].map(|k| at[k] - f64::from(square[k]));
    CORNERS.map(|[i, j]| (if i == 1 { x } else { 1.0 - x }) * (if j == 1 { y } else { 1.0 - y }))
}

/// Steps along a face at which it is asked whether it is in the body.
const STEPS: usize = 16;
/// Halvings that find where the border crosses it: to rounding.
const HALVINGS: usize = 48;

/// The parts of a segment that are inside.
fn parts_inside([from, to]: [[f64; 2]; 2], inside: &dyn Fn([f64; 2]) -> bool) -> Vec<[[f64; 2]; 2]> {
    let at = |share: f64| [0, 1].map(|k| from[k] + share * (to[k] - from[k]));
    let share = |k: usize| k as f64 / STEPS as f64;
    let known: Vec<bool> = (0..=STEPS).map(|k| inside(at(share(k)))).collect();
    let mut ends = Vec::new();
    ends.extend(known[0].then_some(0.0));
    for k in (0..STEPS).filter(|k| known[*k] != known[*k + 1]) {
        let (mut low, mut high) = (share(k), share(k + 1));
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if inside(at(middle)) == known[k] { low = middle } else { high = middle }
        }
        ends.push(0.5 * (low + high));
    }
    ends.extend(known[STEPS].then_some(1.0));
    ends.chunks_exact(2).map(|part| [at(part[0]), at(part[1])]).collect()
}
