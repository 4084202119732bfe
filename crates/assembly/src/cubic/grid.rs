//! Cells of a box with a rim around it, one after the other in memory.

use std::array::from_fn;
use std::ops::Range;

/// Entries behind the last cell: a stretch of points may go on beyond it.
const SLACK: usize = 64;

/// The places of cells in a plane of numbers. Where nothing is mirrored, the rim behind a row is the one before the next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Grid {
    /// Columns, rows and layers of cells.
    pub(super) cells: [usize; 3],
    /// Cells of the rim on every side.
    pub(super) rim: usize,
    /// Along every axis, whether images of the cells are before the first and behind the last.
    pub(super) mirrored: [[bool; 2]; 3],
    /// From a cell to the next column, row and layer.
    pub(super) strides: [usize; 3],
    start: usize,
    len: usize,
}

impl Grid {
    pub(super) fn new(cells: [usize; 3], rim: usize, mirrored: [[bool; 2]; 3]) -> Self {
        let wide = |k: usize| cells[k] + if mirrored[k].contains(&true) { 2 * rim } else { rim };
        let strides = [1, wide(0), wide(0) * wide(1)];
        let across: usize = strides.iter().map(|s| s * rim).sum();
        let last: usize = (0..3).map(|k| strides[k] * (cells[k] - 1)).sum();
        Self { cells, rim, mirrored, strides, start: across, len: across + last + across + 1 + SLACK }
    }

    /// Entries of a plane.
    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// Number of cells.
    pub(super) fn count(&self) -> usize {
        self.cells.iter().product()
    }

    /// Place of a cell, which may be one of the rim.
    pub(super) fn at(&self, cell: [i64; 3]) -> usize {
        let away: i64 = (0..3).map(|k| cell[k] * self.strides[k] as i64).sum();
        (self.start as i64 + away) as usize
    }

    /// Place of the first cell of a row.
    pub(super) fn row(&self, row: usize, layer: usize) -> usize {
        self.start + row * self.strides[1] + layer * self.strides[2]
    }

    /// Places of a layer, from its first to its last cell, the rim between its rows included.
    pub(super) fn layer(&self, layer: usize) -> Range<usize> {
        let first = self.row(0, layer);
        first..self.row(self.cells[1] - 1, layer) + self.cells[0]
    }

    /// Calls `visit` with every cell and its place.
    pub(super) fn for_each(&self, mut visit: impl FnMut([usize; 3], usize)) {
        for layer in 0..self.cells[2] {
            for row in 0..self.cells[1] {
                let first = self.row(row, layer);
                (0..self.cells[0]).for_each(|column| visit([column, row, layer], first + column));
            }
        }
    }

    /// Difference of the places of two cells.
    pub(super) fn away(&self, step: [i32; 3]) -> isize {
        (0..3).map(|k| step[k] as isize * self.strides[k] as isize).sum()
    }

    /// The layers of the planes of a vector, each from its first cell on.
    pub(super) fn layers_mut<'a>(&self, v: &'a mut [f32]) -> Vec<[&'a mut [f32]; 3]> {
        let mut planes = v.chunks_exact_mut(self.len);
        let mut layers: [_; 3] = from_fn(|_| {
            let plane = planes.next().unwrap_or_default();
            let from = self.start.min(plane.len());
            plane[from..].chunks_mut(self.strides[2])
        });
        (0..self.cells[2]).map(|_| from_fn(|c| layers[c].next().unwrap_or_default())).collect()
    }

    /// Writes images of the cells into the rim: `sign(component, axis)` times what their cell has, `v` of one or more planes.
    pub(super) fn mirror<T: Copy>(&self, plane: &mut [T], image: impl Fn(T, usize) -> T) {
        for axis in (0..3).filter(|&axis| self.mirrored[axis].contains(&true)) {
            let n = self.cells[axis];
            // Axes that are done have their images already.
            let span = |other: usize| match other {
                _ if other == axis => 0..1,
                _ if other < axis => -(self.rim as i64)..(self.cells[other] + self.rim) as i64,
                _ => 0..self.cells[other] as i64,
            };
            let stride = self.strides[axis];
            for k in span(2) {
                for j in span(1) {
                    for i in span(0) {
                        let first = self.at([i, j, k]);
                        for depth in 0..self.rim.min(n) {
                            if self.mirrored[axis][0] {
                                plane[first - (depth + 1) * stride] =
                                    image(plane[first + depth * stride], axis);
                            }
                            if self.mirrored[axis][1] {
                                plane[first + (n + depth) * stride] =
                                    image(plane[first + (n - 1 - depth) * stride], axis);
                            }
                        }
                    }
                }
            }
        }
    }

    /// Writes the images of a displacement: its component across a plane of symmetry changes its sign there.
    pub(super) fn mirror_vector(&self, v: &mut [f32]) {
        if self.mirrored == [[false; 2]; 3] {
            return;
        }
        for (c, plane) in v.chunks_exact_mut(self.len).enumerate() {
            self.mirror(plane, |value, axis| if axis == c { -value } else { value });
        }
    }
}
