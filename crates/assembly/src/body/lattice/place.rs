//! Where the cells of a lattice are.
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

    /// Unit vectors from column to column, from row to row and from layer to layer.
    pub fn axes(&self) -> [[f64; 3]; 3] {
        let [along, across] = self.turn.map_or([[1.0, 0.0], [0.0, 1.0]], |turn| turn.axes());
        [[along[0], along[1], 0.0], [across[0], across[1], 0.0], [0.0, 0.0, 1.0]]
    }

    /// Lowest corner of cell `[0, 0, 0]`, as its axes have it, m.
    pub fn corner(&self) -> [f64; 3] {
        at_height(self.outwards(self.inner_corner()), self.corner[2])
    }

    /// Centre of a cell, m.
    pub fn centre(&self, cell: Cell) -> [f64; 3] {
        let height = self.corner[2] + (f64::from(cell[2]) + 0.5) * self.spacing;
        at_height(self.place_of(cell), height)
    }

    /// Position of a point, m.
    pub fn position(&self, point: usize) -> [f64; 3] {
        self.centre(self.cell(point))
    }

    /// Centre of a cell in the plane, m.
    pub fn place_of(&self, cell: Cell) -> [f64; 2] {
        self.outwards(self.inner_centre(cell))
    }

    /// Position of a point in the plane, m.
    pub fn place(&self, point: usize) -> [f64; 2] {
        self.place_of(self.cell(point))
    }

    /// The offset of cells as a vector, m.
    pub fn vector(&self, step: Cell) -> [f64; 3] {
        let [x, y, z] = step.map(|k| self.spacing * f64::from(k));
        at_height(self.turn.map_or([x, y], |turn| turn.vector([x, y])), z)
    }

    /// A place in cells of the plane: cell `[i, j, 0]` reaches from i to i + 1 and from j to j + 1.
    pub fn in_cells(&self, place: [f64; 2]) -> [f64; 2] {
        let inner = self.inwards(place);
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

    /// The corner between the cells of two columns and of two rows of a plane, those before `node` and those from it on, m.
    pub fn node(&self, node: [i32; 2]) -> [f64; 2] {
        self.outwards([0, 1].map(|k| self.corner[k] + f64::from(node[k]) * self.spacing))
    }

    /// Cell of the plane that holds a place, whether or not it belongs to the body.
    pub fn cell_at(&self, place: [f64; 2]) -> Cell {
        let [column, row] = self.in_cells(place).map(|x| x.floor() as i32);
        [column, row, 0]
    }

    /// Cell of a solid that holds a position, whether or not it belongs to the body.
    pub fn cell_around(&self, at: [f64; 3]) -> Cell {
        let layer = ((at[2] - self.corner[2]) / self.spacing).floor() as i32;
        let [column, row, _] = self.cell_at([at[0], at[1]]);
        [column, row, layer]
    }

    /// Lower left corner of cell `[0, 0, 0]` in the plane, in the axes of the lattice, m.
    pub(in super::super) fn inner_corner(&self) -> Point {
        let [x, y, _] = self.corner;
        [x, y]
    }

    /// Centre of a cell in the plane, in the axes of the lattice, m.
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

fn at_height([x, y]: Point, z: f64) -> [f64; 3] {
    [x, y, z]
}
