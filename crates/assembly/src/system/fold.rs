//! The constrained stiffness `TᵀKT` in compressed rows.

use super::System;
use crate::condition::Row;
use sprs::CsMat;

/// Entries of a lower triangle in any order; those of one place add up.
#[derive(Default)]
struct Triplets(Vec<(u32, u32, f64)>);

impl Triplets {
    fn add(&mut self, a: usize, b: usize, value: f64) {
        self.0.push((a.max(b) as u32, a.min(b) as u32, value));
    }

    /// Compressed rows, columns in order; a diagonal entry that is zero becomes one.
    fn compress(self, order: usize) -> CsMat<f64> {
        let mut start = vec![0_usize; order + 1];
        self.0.iter().for_each(|t| start[t.0 as usize + 1] += 1);
        (0..order).for_each(|row| start[row + 1] += start[row]);
        let mut next = start.clone();
        let mut sorted = vec![(0_u32, 0.0); self.0.len()];
        for (row, column, value) in self.0 {
            let slot = &mut next[row as usize];
            sorted[*slot] = (column, value);
            *slot += 1;
        }
        let (mut indices, mut values, mut pointers) =
            (Vec::with_capacity(sorted.len()), Vec::with_capacity(sorted.len()), vec![0]);
        for row in 0..order {
            let entries = &mut sorted[start[row]..start[row + 1]];
            // In a fixed order, so that sums do not depend on the sort.
            entries.sort_by_key(|e| e.0);
            let begin = indices.len();
            for &(column, value) in entries.iter() {
                if indices.len() > begin && indices.last() == Some(&(column as usize)) {
                    *values.last_mut().expect("as long as the indices") += value;
                } else {
                    indices.push(column as usize);
                    values.push(value);
                }
            }
            // The diagonal is the last entry of a row, and every row has one.
            if let Some(diagonal) = values.last_mut().filter(|d| **d == 0.0) {
                *diagonal = 1.0;
            }
            pointers.push(indices.len());
        }
        CsMat::new((order, order), pointers, indices, values)
    }
}

/// Independent unknowns behind an unknown, with their coefficients.
struct Masters<'a> {
    /// Per unknown: number of its row plus one, zero if it is independent.
    row: Vec<u32>,
    rows: &'a [Row],
}

impl<'a> Masters<'a> {
    fn new(size: usize, rows: &'a [Row]) -> Self {
        let mut row = vec![0; size];
        rows.iter().zip(1..).for_each(|(r, number)| row[r.unknown] = number);
        Self { row, rows }
    }

    fn is_free(&self, unknown: usize) -> bool {
        self.row[unknown] == 0
    }

    fn each(&self, unknown: usize, mut visit: impl FnMut(usize, f64)) {
        match self.row[unknown] {
            0 => visit(unknown, 1.0),
            row => self.rows[row as usize - 1].masters.iter().for_each(|&(m, c)| visit(m, c)),
        }
    }
}

impl<const D: usize> System<D> {
    /// The lower triangle of the constrained stiffness `TᵀKT` in compressed rows; unknowns that are constrained or that
    /// nothing reads keep a positive diagonal and couple to nothing.
    pub fn assemble_sparse(&self) -> CsMat<f64> {
        if !self.constraints.has_slaves() {
            return self.scatter();
        }
        let size = self.size();
        let masters = Masters::new(size, self.constraints.rows());
        let mut triplets = Triplets::default();
        let mut inert = vec![0.0; size];
        self.stiffness().for_each_entry(|[i, r], [j, c], value| {
            let (a, b) = (r * self.points + i, c * self.points + j);
            if a == b {
                match masters.is_free(a) {
                    true => triplets.add(a, a, value),
                    false => inert[a] = value,
                }
            }
            if value != 0.0 && !(a == b && masters.is_free(a)) {
                masters.each(a, |ma, ca| {
                    masters.each(b, |mb, cb| {
                        // Of a symmetric pair only one entry is visited; both fall on one diagonal place.
                        let both = if ma == mb && a != b { 2.0 } else { 1.0 };
                        if a != b || mb <= ma {
                            triplets.add(ma, mb, both * ca * cb * value);
                        }
                    });
                });
            }
        });
        for row in self.constraints.rows() {
            let diagonal = inert[row.unknown];
            triplets.add(row.unknown, row.unknown, if diagonal > 0.0 { diagonal } else { 1.0 });
        }
        triplets.compress(size)
    }
}
