//! A matrix in compressed rows, with numbers of 32 bits for its columns.

use rayon::prelude::*;
use sprs::{CsMat, CsMatI};

/// Rows that a thread takes at a time.
const ROWS: usize = 512;

/// A matrix in compressed rows.
pub(super) struct Matrix(CsMatI<f64, u32, usize>);

impl Matrix {
    /// The whole of a symmetric matrix, from its lower triangle.
    pub(super) fn symmetric(lower: &CsMat<f64>) -> Self {
        let entries = || lower.iter().filter(|(value, (row, column))| **value != 0.0 && column <= row);
        let mut pointers = vec![0; lower.rows() + 1];
        for (_, (row, column)) in entries() {
            pointers[row + 1] += 1;
            pointers[column + 1] += usize::from(column < row);
        }
        (1..pointers.len()).for_each(|row| pointers[row] += pointers[row - 1]);
        let mut next = pointers.clone();
        let all = pointers[lower.rows()];
        let (mut indices, mut values) = (vec![0; all], vec![0.0; all]);
        // What comes from rows below goes behind what is to the left of the diagonal, in the order of these rows.
        for (value, (row, column)) in entries() {
            let places = [(row, column), (column, row)];
            for (row, column) in places.into_iter().take(1 + usize::from(column < row)) {
                let at = next[row];
                (indices[at], values[at]) = (column as u32, *value);
                next[row] += 1;
            }
        }
        Self(CsMatI::new(lower.shape(), pointers, indices, values))
    }

    /// A matrix of rows of columns and their values.
    pub(super) fn from_rows(rows: impl Iterator<Item = Vec<(u32, f64)>>, columns: usize) -> Self {
        let (mut pointers, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
        for mut row in rows {
            row.sort_unstable_by_key(|(column, _)| *column);
            indices.extend(row.iter().map(|(column, _)| *column));
            values.extend(row.iter().map(|(_, value)| *value));
            pointers.push(indices.len());
        }
        Self(CsMatI::new((pointers.len() - 1, columns), pointers, indices, values))
    }

    pub(super) fn transposed(&self) -> Self {
        Self(self.0.transpose_view().to_csr())
    }

    /// `Pᵀ A P` with this interpolation `P`, whose transpose is `restriction`.
    pub(super) fn product_around(&self, restriction: &Self, matrix: &Self) -> Self {
        let columns = self.0.cols();
        // Unknowns take shares of two coarse ones at most.
        let shares: Vec<[(u32, f64); 2]> = (0..self.rows()).map(|row| self.pair(row)).collect();
        let starts: Vec<usize> = (0..columns).step_by(ROWS).collect();
        let rows = starts.par_iter().map_init(
            || Row::new(columns),
            |sum, &start| {
                let mut rows = Vec::new();
                for coarse in start..(start + ROWS).min(columns) {
                    for (fine, share) in restriction.row(coarse) {
                        for (column, value) in matrix.row(fine) {
                            shares[column].iter().for_each(|(to, part)| sum.add(*to, share * value * part));
                        }
                    }
                    rows.push(sum.take());
                }
                rows
            },
        );
        let rows: Vec<_> = rows.collect();
        Self::from_rows(rows.into_iter().flatten(), columns)
    }

    pub(super) fn rows(&self) -> usize {
        self.0.rows()
    }

    pub(super) fn entries(&self) -> usize {
        self.0.nnz()
    }

    /// The entries of a row.
    pub(super) fn row(&self, row: usize) -> impl Iterator<Item = (usize, f64)> {
        let range = self.0.indptr().outer_inds_sz(row);
        let columns = self.0.indices()[range.clone()].iter();
        columns.map(|column| *column as usize).zip(self.0.data()[range].iter().copied())
    }

    /// The entries of a row of two at most, the others zero.
    fn pair(&self, row: usize) -> [(u32, f64); 2] {
        let mut entries = self.row(row).map(|(column, value)| (column as u32, value));
        [0; 2].map(|_| entries.next().unwrap_or_default())
    }

    /// The lower triangle, as factors take it.
    pub(super) fn lower(&self) -> CsMat<f64> {
        let (mut pointers, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
        for row in 0..self.rows() {
            self.row(row).filter(|(column, _)| *column <= row).for_each(|(column, value)| {
                indices.push(column);
                values.push(value);
            });
            pointers.push(indices.len());
        }
        CsMat::new(self.0.shape(), pointers, indices, values)
    }

    /// Writes `A x` over `y`.
    pub(super) fn multiply(&self, x: &[f64], y: &mut [f64]) {
        self.each_row(x, y, |y, product| *y = product);
    }

    /// Adds `A x` to `y`.
    pub(super) fn multiply_add(&self, x: &[f64], y: &mut [f64]) {
        self.each_row(x, y, |y, product| *y += product);
    }

    fn each_row(&self, x: &[f64], y: &mut [f64], take: impl Fn(&mut f64, f64) + Sync) {
        let (columns, values) = (self.0.indices(), self.0.data());
        let pointers = self.0.indptr();
        let pointers = pointers.raw_storage();
        y.par_chunks_mut(ROWS).enumerate().for_each(|(k, y)| {
            for (i, y) in y.iter_mut().enumerate() {
                let range = pointers[k * ROWS + i]..pointers[k * ROWS + i + 1];
                take(y, dot(&columns[range.clone()], &values[range], x));
            }
        });
    }
}

/// A row that is summed up.
struct Row {
    values: Vec<f64>,
    is_there: Vec<bool>,
    columns: Vec<u32>,
}

impl Row {
    fn new(columns: usize) -> Self {
        Self { values: vec![0.0; columns], is_there: vec![false; columns], columns: Vec::new() }
    }

    fn add(&mut self, column: u32, value: f64) {
        let is_there = &mut self.is_there[column as usize];
        if !*is_there && value != 0.0 {
            *is_there = true;
            self.columns.push(column);
        }
        self.values[column as usize] += value;
    }

    /// The sum, which is empty afterwards.
    fn take(&mut self) -> Vec<(u32, f64)> {
        let Self { values, is_there, columns } = self;
        let entry = |column: u32| {
            is_there[column as usize] = false;
            (column, std::mem::take(&mut values[column as usize]))
        };
        columns.drain(..).map(entry).collect()
    }
}

/// The product of a row, in partial sums that need not wait for each other.
fn dot(columns: &[u32], values: &[f64], x: &[f64]) -> f64 {
    const SUMS: usize = 4;
    let (columns, last_columns) = columns.as_chunks::<SUMS>();
    let (values, last_values) = values.as_chunks::<SUMS>();
    let mut sums = [0.0; SUMS];
    for (columns, values) in columns.iter().zip(values) {
        (0..SUMS).for_each(|k| sums[k] += values[k] * x[columns[k] as usize]);
    }
    let last = last_columns.iter().zip(last_values).map(|(column, value)| value * x[*column as usize]);
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + last.sum::<f64>()
}
