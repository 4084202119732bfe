//! The points of a lattice by their places, images in lines of symmetry among them.

use crate::body::SquareLattice;
use crate::model::plane::Mirrors;

/// How far images go beyond a line of symmetry, in spacings: as far as fits and squares beside it see.
const BEYOND: i32 = 8;

/// A point or its image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Node {
    /// Number of the point.
    pub(super) number: u32,
    /// Signs of the displacement along x and y.
    pub(super) signs: [i8; 2],
    /// Whether it is the point itself.
    pub(super) is_real: bool,
}

/// Places are in spacings, those of points whole numbers.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    pub(super) spacing: f64,
    /// Position of the place zero, m.
    origin: [f64; 2],
    /// Lines of symmetry: places across x and y, before the body and behind it.
    lines: [[Option<f64>; 2]; 2],
    frame: Frame,
    nodes: Vec<Option<Node>>,
}

/// Places in rows that begin at a lower left one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    low: [i32; 2],
    size: [i32; 2],
}

impl Frame {
    /// Its places, row by row.
    pub(super) fn places(self) -> impl Iterator<Item = [i32; 2]> {
        let Self { low, size } = self;
        (0..size[1]).flat_map(move |j| (0..size[0]).map(move |i| [low[0] + i, low[1] + j]))
    }

    /// How many places it has.
    pub(super) fn count(self) -> usize {
        (self.size[0] * self.size[1]) as usize
    }

    /// The number of a place among them.
    pub(super) fn index(self, place: [i32; 2]) -> Option<usize> {
        let [i, j] = [0, 1].map(|k| place[k] - self.low[k]);
        let is_within = (0..self.size[0]).contains(&i) && (0..self.size[1]).contains(&j);
        is_within.then_some((i + j * self.size[0]) as usize)
    }
}

impl Grid {
    pub(super) fn new(lattice: &SquareLattice, mirrors: &Mirrors) -> Self {
        let ranges = [lattice.columns(), lattice.rows()];
        let low = [0, 1].map(|k| ranges[k].start - BEYOND);
        let size = [0, 1].map(|k| ranges[k].end + BEYOND - low[k]);
        let frame = Frame { low, size };
        let node = |[i, j]: [i32; 2]| {
            let cell = [i, j, 0];
            let (image, [x, y, _]) = if mirrors.is_none() { (cell, [1.0; 3]) } else { mirrors.image(cell) };
            let number = lattice.number(image)? as u32;
            Some(Node { number, signs: [x, y].map(|sign| sign as i8), is_real: image == cell })
        };
        let nodes = frame.places().map(node).collect();
        let line = |line: Option<i32>| line.map(|first| f64::from(first) - 0.5);
        let lines = [0, 1].map(|k| mirrors.lines[k].map(line));
        Self { spacing: lattice.spacing(), origin: lattice.place_of([0; 3]), lines, frame, nodes }
    }

    /// The point at a place.
    pub(super) fn node(&self, place: [i32; 2]) -> Option<Node> {
        self.nodes[self.frame.index(place)?]
    }

    /// The points of the body with their places.
    pub(super) fn real(&self) -> impl Iterator<Item = (u32, [i32; 2])> + '_ {
        let nodes = self.nodes.iter().zip(self.frame.places());
        nodes.filter_map(|(node, place)| node.filter(|node| node.is_real).map(|node| (node.number, place)))
    }

    /// All places, images and those without a point among them.
    pub(super) fn frame(&self) -> Frame {
        self.frame
    }

    /// The place of a position, m.
    pub(super) fn place(&self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| (at[k] - self.origin[k]) / self.spacing)
    }

    /// Where a row or a column of points is, m.
    pub(super) fn along(&self, axis: usize, line: i32) -> f64 {
        self.origin[axis] + f64::from(line) * self.spacing
    }

    /// The position of a place, m.
    pub(super) fn position(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| self.origin[k] + place[k] * self.spacing)
    }

    /// The position of the real place that a place is an image of, m.
    pub(super) fn real_position(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| {
            let along = match self.lines[k] {
                [Some(line), _] if place[k] < line => 2.0 * line - place[k],
                [_, Some(line)] if place[k] > line => 2.0 * line - place[k],
                _ => place[k],
            };
            self.origin[k] + along * self.spacing
        })
    }

    /// The position where lines of symmetry cross, or on one of them, m.
    pub(super) fn symmetric_origin(&self) -> [f64; 2] {
        [0, 1].map(|k| {
            let line = self.lines[k].into_iter().flatten().next();
            self.origin[k] + line.unwrap_or(0.0) * self.spacing
        })
    }

    /// A place, then its images near it, with the signs of vectors there.
    pub(super) fn images(&self, place: [f64; 2]) -> Vec<([f64; 2], [i8; 2])> {
        let along = |k: usize| {
            let lines = self.lines[k].into_iter().flatten();
            let image = move |line: f64| (2.0 * line - place[k], -1);
            let near = move |line: &f64| (line - place[k]).abs() < f64::from(BEYOND);
            std::iter::once((place[k], 1)).chain(lines.filter(near).map(image))
        };
        along(0).flat_map(|x| along(1).map(move |y| ([x.0, y.0], [x.1, y.1]))).collect()
    }
}
