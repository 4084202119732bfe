//! The assembled stiffness of a few elements: rows of the points that they touch.

use super::{BlockMatrix, Term};
use crate::bonds::Mat;
use peristat_vector::Real;
use std::array::from_fn;
use std::ops::Range;

/// Symmetric matrix of D × D blocks, most rows of which are zero.
#[derive(Clone, Debug)]
pub struct BlockRows<const D: usize, R = f64> {
    points: usize,
    /// Points with a row, in order, and the ends of their entries.
    rows: Vec<(u32, u32)>,
    entries: Vec<(u32, [[R; D]; D])>,
}

impl<const D: usize, R: Real> BlockRows<D, R> {
    /// The tangent of some terms of a body of `points` points.
    pub fn new(points: usize, terms: &[Box<dyn Term<D>>]) -> Self {
        let mut rows = Self { points, rows: Vec::new(), entries: Vec::new() };
        if terms.iter().all(|t| t.elements() == 0) {
            return rows;
        }
        let mut tangent = BlockMatrix::sparse(points, terms);
        terms.iter().for_each(|t| t.add_tangent(&mut tangent));
        let mut entries: Vec<(u32, u32, Mat<D, D>)> = Vec::new();
        tangent.for_each_block(|i, j, block| {
            if *block != [[0.0; D]; D] {
                let mut block = *block;
                if i == j {
                    // Of a diagonal block only the upper triangle is sure to be filled.
                    (0..D).for_each(|r| (0..r).for_each(|c| block[r][c] = block[c][r]));
                } else {
                    entries.push((j as u32, i as u32, from_fn(|r| from_fn(|c| block[c][r]))));
                }
                entries.push((i as u32, j as u32, block));
            }
        });
        entries.sort_by_key(|e| (e.0, e.1));
        for (row, column, block) in entries {
            match rows.rows.last_mut() {
                Some(last) if last.0 == row => last.1 += 1,
                _ => rows.rows.push((row, rows.entries.len() as u32 + 1)),
            }
            rows.entries.push((column, block.map(|row| row.map(R::of))));
        }
        rows
    }

    /// Subtracts from `r`, the values on the points of a range by component, the product with `x`.
    #[inline]
    pub fn subtract_product<const W: usize>(&self, points: Range<usize>, x: &[R], r: &mut [[R; W]; D]) {
        let begin = self.rows.partition_point(|row| (row.0 as usize) < points.start);
        for k in begin..self.rows.len() {
            let (point, end) = self.rows[k];
            if point as usize >= points.end {
                break;
            }
            let from = if k == 0 { 0 } else { self.rows[k - 1].1 };
            let at = point as usize - points.start;
            for (column, block) in &self.entries[from as usize..end as usize] {
                for c in 0..D {
                    let value = x[c * self.points + *column as usize];
                    (0..D).for_each(|row| r[row][at] = r[row][at] - block[row][c] * value);
                }
            }
        }
    }
}
