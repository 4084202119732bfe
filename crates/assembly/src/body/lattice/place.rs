//! Where the cells of a lattice are in the plane.
//!
//! Cells are known by whole numbers whatever the direction of their rows; only this file knows their axes. A lattice whose
//! rows run along x has the positions that its corner and its spacing give, to the last bit.

use super::super::convex::Convex;
use super::super::geometry::Point;
use super::super::turn::Turn;
use super::{Cell, SquareLattice};

impl SquareLattice {
    /// The same cells in axes turned by an angle, rad, counter-clockwise about the zero of coordinates, which moves to
    /// `origin`, m. Multiples of a right angle leave the lattice as it is.
    pub fn turned(self, angle: f64, origin: [f64; 2]) -> Self {
        match Turn::new(angle, origin) {
            None => self,
            turn => Self { turn, ..self },
        }
    }

    /// Whether rows run along neither x nor y.
    pub fn is_turned(&self) -> bool {
        self.turn.is_some()
    }

    /// Direction of the rows, rad, counter-clockwise from x.
    pub fn angle(&self) -> f64 {
        self.turn.map_or(0.0, |turn| turn.angle())
    }

    /// Unit vectors from column to column and from row to row.
    pub fn axes(&self) -> [[f64; 2]; 2] {
        self.turn.map_or([[1.0, 0.0], [0.0, 1.0]], |turn| turn.axes())
    }

    /// Lower left corner of cell `[0, 0]`, as its axes have it, m.
    pub fn corner(&self) -> [f64; 2] {
        self.outwards(self.corner)
    }

    /// Centre of a cell, m.
    pub fn centre(&self, cell: Cell) -> [f64; 2] {
        self.outwards(self.inner_centre(cell))
    }

    /// Position of a point, m.
    pub fn position(&self, point: usize) -> [f64; 2] {
        self.centre(self.cell(point))
    }

    /// The offset of cells as a vector, m.
    pub fn vector(&self, step: Cell) -> [f64; 2] {
        let along = step.map(|k| self.spacing * f64::from(k));
        self.turn.map_or(along, |turn| turn.vector(along))
    }

    /// A position in cells: cell `[i, j]` reaches from i to i + 1 and from j to j + 1.
    pub fn in_cells(&self, position: [f64; 2]) -> [f64; 2] {
        let inner = self.inwards(position);
        [0, 1].map(|k| (inner[k] - self.corner[k]) / self.spacing)
    }

    /// Where a segment crosses the sides of the triangles that next points make, rows, columns and diagonals, in parts of its
    /// length, in order and with both ends.
    pub fn crossings(&self, from: [f64; 2], to: [f64; 2]) -> Vec<f64> {
        /// Nearer ones are one.
        const SAME: f64 = 1e-12;
        let [a, b] = [from, to].map(|end| self.in_cells(end).map(|x| x - 0.5));
        let lines: [fn([f64; 2]) -> f64; 4] = [|[x, _]| x, |[_, y]| y, |[x, y]| x - y, |[x, y]| x + y];
        let mut places = vec![0.0, 1.0];
        for line in lines {
            let (start, end) = (line(a), line(b));
            let (low, high) = (start.min(end).ceil() as i64, start.max(end).floor() as i64);
            places.extend((low..=high).map(|k| (k as f64 - start) / (end - start)));
        }
        places.retain(|place| (0.0..=1.0).contains(place));
        places.sort_by(f64::total_cmp);
        places.dedup_by(|later, place| *later - *place < SAME);
        places
    }

    /// The corner between the cells of two columns and of two rows, those before `node` and those from it on, m.
    pub fn node(&self, node: Cell) -> [f64; 2] {
        self.outwards([0, 1].map(|k| self.corner[k] + f64::from(node[k]) * self.spacing))
    }

    /// Cell that holds a position, whether or not it belongs to the body.
    pub fn cell_at(&self, position: [f64; 2]) -> Cell {
        self.in_cells(position).map(|x| x.floor() as i32)
    }

    /// Lower left corner of cell `[0, 0]` in the axes of the lattice, m.
    pub(in super::super) fn inner_corner(&self) -> Point {
        self.corner
    }

    /// Centre of a cell in the axes of the lattice, m.
    pub(in super::super) fn inner_centre(&self, cell: Cell) -> Point {
        [0, 1].map(|k| self.corner[k] + (f64::from(cell[k]) + 0.5) * self.spacing)
    }

    /// A part of the plane in the axes of the lattice.
    pub(in super::super) fn inner_part(&self, part: &Convex) -> Convex {
        match self.turn {
            None => part.clone(),
            Some(turn) => part.seen_from(&turn),
        }
    }

    /// Coordinates in the axes of the lattice.
    fn inwards(&self, position: Point) -> Point {
        self.turn.map_or(position, |turn| turn.inwards(position))
    }

    fn outwards(&self, coordinates: Point) -> Point {
        self.turn.map_or(coordinates, |turn| turn.outwards(coordinates))
    }
}
