//! Cells near triangles.

use super::facets::{Facet, dot};
use super::grid::Grid;
use std::ops::Range;

impl Grid {
    /// Calls `visit` with the columns of every row and layer whose centres can be within `reach` of a triangle, m: those of the box
    /// around it that are near its plane.
    pub(super) fn near(&self, facet: &Facet, reach: f64, mut visit: impl FnMut([i32; 2], Range<i32>)) {
        let [x, z] = [0, 2].map(|axis| {
            let [low, high] = facet.range(axis);
            [low - reach, high + reach]
        });
        let (normal, height) = (facet.normal(), dot(facet.normal(), facet.corners[0]));
        let across = normal[1].hypot(normal[2]);
        for layer in self.between(2, z[0], z[1]) {
            let above = height - normal[2] * self.centre(2, layer);
            let at = self.centre(2, layer);
            let Some([low, high]) = span(facet, at - reach, at + reach) else { continue };
            for row in self.between(1, low - reach, high + reach) {
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

/// From where to where along y the part of a triangle reaches that is between two heights, m.
pub(super) fn span(facet: &Facet, below: f64, above: f64) -> Option<[f64; 2]> {
    let mut found: Option<[f64; 2]> = None;
    for k in 0..3 {
        let [a, b] = [facet.corners[k], facet.corners[(k + 1) % 3]];
        let [from, to] = if a[2] <= b[2] { [a, b] } else { [b, a] };
        if to[2] < below || from[2] > above {
            continue;
        }
        for height in [below, above] {
            let part = ((height - from[2]) / (to[2] - from[2])).clamp(0.0, 1.0);
            // An edge along a layer is there as a whole.
            let ends = if part.is_nan() { [from[1], to[1]] } else { [from[1] + part * (to[1] - from[1]); 2] };
            let [low, high] = found.unwrap_or([ends[0]; 2]);
            found = Some(ends.iter().fold([low, high], |[low, high], y| [low.min(*y), high.max(*y)]));
        }
    }
    found
}
