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
        let (starts, columns) = (pattern.proper_indptr(), pattern.indices());
        // Row, column and source of each entry.
        let entries = || {
            unknowns.iter().enumerate().flat_map(|(k, unknown)| {
                let row = *unknown as usize;
                let lower = (starts[row]..starts[row + 1]).take_while(move |at| columns[*at] <= row);
                let inside = lower.map(|at| (place[columns[at]], at)).filter(|(other, _)| *other != NONE);
                inside.map(move |(other, at)| (k.min(other as usize), k.max(other as usize), at))
            })
        };
        let mut upper = Self::of_counts(unknowns.len(), entries().map(|(_, column, _)| column));
        let mut next = upper.starts.clone();
        for (row, column, at) in entries() {
            upper.rows[next[column]] = row;
            upper.sources[next[column]] = at as u32;
            next[column] += 1;
        }
        upper
    }

    /// Room for entries in the given columns.
    fn of_counts(order: usize, columns: impl Iterator<Item = usize>) -> Self {
        let mut starts = vec![0; order + 1];
        columns.for_each(|column| starts[column + 1] += 1);
        for k in 0..order {
            starts[k + 1] += starts[k];
        }
        Self { rows: vec![0; starts[order]], sources: vec![0; starts[order]], starts }
    }

    fn transposed(&self) -> Self {
        let order = self.starts.len() - 1;
        let mut turned = Self::of_counts(order, self.rows.iter().copied());
        let mut next = turned.starts.clone();
        for column in 0..order {
            for k in self.starts[column]..self.starts[column + 1] {
                let to = &mut next[self.rows[k]];
                turned.rows[*to] = column;
                turned.sources[*to] = self.sources[k];
                *to += 1;
            }
        }
        turned
    }
}

/// Whether two submatrices that share their last `common` rows have all entries of the lower
/// triangle of a matrix.
pub(super) fn covers(pattern: &CsMat<f64>, parts: [&Structure; 2], common: usize) -> bool {
    let (rows, columns) = (pattern.proper_indptr(), pattern.indices());
    let lower = |row: usize| columns[rows[row]..rows[row + 1]].partition_point(|j| *j <= row);
    let all: usize = (0..pattern.rows()).map(lower).sum();
    parts.iter().map(|part| part.rows.len()).sum::<usize>() - parts[0].last(common).len() == all
}
