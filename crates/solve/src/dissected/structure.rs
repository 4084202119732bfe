//! The lower triangle of a principal submatrix in a given order.

use sprs::CsMat;

/// No place.
const NONE: u32 = u32::MAX;

/// Compressed columns; rows in ascending order.
pub(super) struct Structure {
    pub(super) starts: Vec<usize>,
    pub(super) rows: Vec<usize>,
    /// Where in the values of the whole matrix an entry is.
    pub(super) sources: Vec<u32>,
}

impl Structure {
    /// Rows and columns of the given unknowns, in their order.
    pub(super) fn new(pattern: &CsMat<f64>, unknowns: &[u32]) -> Self {
        let upper = Self::upper(pattern, unknowns);
        upper.transposed()
    }

    /// Pattern of the upper triangle in compressed columns: starts and rows, ascending.
    pub(super) fn upper_pattern(&self) -> (Vec<usize>, Vec<usize>) {
        let upper = self.transposed();
        (upper.starts, upper.rows)
    }

    /// Entries of the last rows and columns, counted from the first of them, and their sources.
    pub(super) fn last(&self, count: usize) -> Vec<[u32; 3]> {
        let order = self.starts.len() - 1;
        let first = order - count;
        let entries = (first..order).flat_map(|j| (self.starts[j]..self.starts[j + 1]).map(move |k| (j, k)));
        entries.map(|(j, k)| [(self.rows[k] - first) as u32, (j - first) as u32, self.sources[k]]).collect()
    }

    /// Compressed columns of the upper triangle; rows in no order.
    fn upper(pattern: &CsMat<f64>, unknowns: &[u32]) -> Self {
        let mut place = vec![NONE; pattern.rows()];
        for (k, unknown) in unknowns.iter().enumerate() {
            place[*unknown as usize] = k as u32;
        }
        let (rows, columns) = (pattern.proper_indptr(), pattern.indices());
        let each = |mut entry: Box<dyn FnMut(usize, usize, usize) + '_>| {
            for (k, unknown) in unknowns.iter().enumerate() {
                let row = *unknown as usize;
                for at in rows[row]..rows[row + 1] {
                    if columns[at] > row {
                        break;
                    }
                    let other = place[columns[at]];
                    if other != NONE {
                        entry(k.min(other as usize), k.max(other as usize), at);
                    }
                }
            }
        };
        let mut starts = vec![0; unknowns.len() + 1];
        each(Box::new(|_, column, _| starts[column + 1] += 1));
        for k in 0..unknowns.len() {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let count = starts[unknowns.len()];
        let (mut upper, mut sources) = (vec![0; count], vec![0; count]);
        each(Box::new(|row, column, at| {
            upper[next[column]] = row;
            sources[next[column]] = at as u32;
            next[column] += 1;
        }));
        Self { starts, rows: upper, sources }
    }

    fn transposed(&self) -> Self {
        let order = self.starts.len() - 1;
        let mut starts = vec![0; order + 1];
        for row in &self.rows {
            starts[row + 1] += 1;
        }
        for k in 0..order {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let (mut rows, mut sources) = (vec![0; self.rows.len()], vec![0; self.rows.len()]);
        for column in 0..order {
            for k in self.starts[column]..self.starts[column + 1] {
                let to = &mut next[self.rows[k]];
                rows[*to] = column;
                sources[*to] = self.sources[k];
                *to += 1;
            }
        }
        Self { starts, rows, sources }
    }
}

/// Whether two submatrices that share their last `common` rows have all entries of the lower triangle of a matrix.
pub(super) fn covers(pattern: &CsMat<f64>, parts: [&Structure; 2], common: usize) -> bool {
    let (rows, columns) = (pattern.proper_indptr(), pattern.indices());
    let lower = |row: usize| columns[rows[row]..rows[row + 1]].partition_point(|j| *j <= row);
    let all: usize = (0..pattern.rows()).map(lower).sum();
    parts.iter().map(|part| part.rows.len()).sum::<usize>() - parts[0].last(common).len() == all
}
