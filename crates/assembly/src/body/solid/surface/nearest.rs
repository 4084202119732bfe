//! Cells near triangles.

use super::facets::{Facet, dot};
use super::grid::Grid;
use std::ops::Range;

impl Grid {
    /// Calls `visit` with the columns of every row and layer whose centres can be within `reach` of a triangle, m: those of the box
    /// around it that are near its plane.
    pub(super) fn near(&self, facet: &Facet, reach: f64, mut visit: impl FnMut([i32; 2], Range<i32>)) {
        let [x, y, z] = [0, 1, 2].map(|axis| {
            let [low, high] = facet.range(axis);
            [low - reach, high + reach]
        });
        let (normal, height) = (facet.normal(), dot(facet.normal(), facet.corners[0]));
        let across = normal[1].hypot(normal[2]);
        for layer in self.between(2, z[0], z[1]) {
            let above = height - normal[2] * self.centre(2, layer);
            for row in self.between(1, y[0], y[1]) {
                let left = above - normal[1] * self.centre(1, row);
                let [mut from, mut to] = x;
                // Planes along x are near all columns of a row, or none.
                if normal[0].abs() > 1e-12 * across {
                    let ends = [left - reach, left + reach].map(|end| end / normal[0]);
                    (from, to) = (from.max(ends[0].min(ends[1])), to.min(ends[0].max(ends[1])));
                } else if left.abs() > reach * (1.0 + 1e-9) {
                    continue;
                }
                // NaN ends, of planes that are none, leave no columns.
                if from <= to {
                    visit([row, layer], self.between(0, from, to));
                }
            }
        }
    }
}
