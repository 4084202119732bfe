//! The assembled stiffness: blocks of coupled points, in one of two layouts.
//!
//! The assembled matrix is a preconditioner. Rounding its entries breaks `K · rigid = 0`, which alone costs a slender
//! body all digits; answers are finished with the element-wise operator.

use super::Term;
use crate::bonds::Mat;
use sprs::CsMat;
use std::ops::Range;

/// Upper triangle of a symmetric matrix of D × D blocks, one per coupled pair of points `i <= j`.
#[derive(Clone, Debug)]
pub struct BlockMatrix<const D: usize> {
    points: usize,
    layout: Layout,
    values: Vec<f64>,
    /// Whether blocks outside of the pattern are forgotten.
    is_part: bool,
}

#[derive(Clone, Debug)]
enum Layout {
    /// All blocks with `j − i <= reach`. Scalars are kept as LAPACK keeps a lower band: column `D·i + r` of the
    /// interleaved matrix is contiguous and starts with its diagonal.
    Band { reach: usize },
    /// Block rows; blocks are row-major.
    Rows { start: Vec<usize>, column: Vec<u32> },
}

impl<const D: usize> BlockMatrix<D> {
    /// A zero band matrix whose points couple over at most `reach` numbers.
    pub fn band(points: usize, reach: usize) -> Self {
        // Columns come into being as they are added to: memory that is written first is faulted in once, not twice.
        let values = Vec::with_capacity(D * points * D * (reach + 1));
        Self { points, layout: Layout::Band { reach }, values, is_part: false }
    }

    /// A zero matrix with the pattern of `terms`.
    pub fn sparse(points: usize, terms: &[Box<dyn Term<D>>]) -> Self {
        Self { is_part: false, ..Self::among(points, terms, &|_| true) }
    }

    /// The same of the points that are `kept`: blocks of others that are added are forgotten.
    pub fn among(points: usize, terms: &[Box<dyn Term<D>>], kept: &dyn Fn(usize) -> bool) -> Self {
        let both = |i: usize, j: usize| kept(i) && kept(j);
        let mut count = vec![0_usize; points + 1];
        (0..points).for_each(|p| count[p + 1] = usize::from(kept(p)));
        for term in terms {
            term.couplings(&mut |i, j| count[i.min(j) + 1] += usize::from(both(i, j)));
        }
        for p in 0..points {
            count[p + 1] += count[p];
        }
        let mut next = count.clone();
        let mut raw = vec![0_u32; count[points]];
        let mut push = |i: usize, j: usize| {
            raw[next[i]] = j as u32;
            next[i] += 1;
        };
        (0..points).filter(|&p| kept(p)).for_each(|p| push(p, p));
        for term in terms {
            term.couplings(&mut |i, j| {
                if both(i, j) {
                    push(i.min(j), i.max(j));
                }
            });
        }
        let (mut start, mut column) = (vec![0], Vec::with_capacity(raw.len()));
        for p in 0..points {
            let row = &mut raw[count[p]..count[p + 1]];
            row.sort_unstable();
            for (k, &c) in row.iter().enumerate() {
                if k == 0 || row[k - 1] != c {
                    column.push(c);
                }
            }
            start.push(column.len());
        }
        let values = vec![0.0; column.len() * D * D];
        Self { points, layout: Layout::Rows { start, column }, values, is_part: true }
    }

    /// Adds a block at points `i <= j`.
    ///
    /// # Panics
    /// The pair is not in the pattern, and this is no part of a matrix.
    pub fn add(&mut self, i: usize, j: usize, block: &Mat<D, D>) {
        match &self.layout {
            Layout::Band { reach } => {
                let width = D * (reach + 1);
                assert!(i <= j && j - i <= *reach, "pair ({i}, {j}) is outside the band");
                if self.values.len() < D * (i + 1) * width {
                    self.values.resize(D * (i + 1) * width, 0.0);
                }
                for r in 0..D {
                    let column = (D * i + r) * width;
                    // Only c >= r of a diagonal block belongs to the triangle.
                    let begin = if i == j { r } else { 0 };
                    for c in begin..D {
                        self.values[column + D * (j - i) + c - r] += block[r][c];
                    }
                }
            }
            Layout::Rows { start, column } => {
                let row = &column[start[i]..start[i + 1]];
                let found = row.binary_search(&(j as u32));
                assert!(self.is_part || found.is_ok(), "the pair ({i}, {j}) is in the pattern");
                let Ok(k) = found else { return };
                let slot = (start[i] + k) * D * D;
                for r in 0..D {
                    for c in 0..D {
                        self.values[slot + D * r + c] += block[r][c];
                    }
                }
            }
        }
    }

    /// Adds the same blocks at every point `i` of a range: `blocks[k]` at the pair `(i, i + steps[k])`.
    pub fn add_repeated(&mut self, range: Range<usize>, steps: &[usize], blocks: &[Mat<D, D>]) {
        let Layout::Band { reach } = self.layout else {
            for i in range {
                steps.iter().zip(blocks).for_each(|(s, b)| self.add(i, i + s, b));
            }
            return;
        };
        // One point's columns are assembled once and then added as a whole.
        let mut one = BlockMatrix::<D>::band(1, reach);
        for (&step, block) in steps.iter().zip(blocks) {
            one.add(0, step, block);
        }
        let width = one.values.len();
        if self.values.len() <= range.start * width {
            self.values.resize(range.start * width, 0.0);
            range.for_each(|_| self.values.extend_from_slice(&one.values));
            return;
        }
        if self.values.len() < range.end * width {
            self.values.resize(range.end * width, 0.0);
        }
        for columns in self.values[range.start * width..range.end * width].chunks_exact_mut(width) {
            columns.iter_mut().zip(&one.values).for_each(|(a, b)| *a += b);
        }
    }

    /// Visits the scalar entries of the upper triangle: point and component of the row, those of the column, the value.
    /// A sparse layout visits the zeros of its blocks too.
    pub fn for_each_entry(&self, mut visit: impl FnMut([usize; 2], [usize; 2], f64)) {
        for i in 0..self.points {
            match &self.layout {
                Layout::Band { reach } => {
                    let width = D * (reach + 1);
                    for r in 0..D {
                        for k in 0..width.min(D * (self.points - i) - r) {
                            let value = self.values.get((D * i + r) * width + k).copied().unwrap_or(0.0);
                            if value != 0.0 {
                                visit([i, r], [i + (r + k) / D, (r + k) % D], value);
                            }
                        }
                    }
                }
                Layout::Rows { start, column } => {
                    for slot in start[i]..start[i + 1] {
                        let j = column[slot] as usize;
                        for r in 0..D {
                            for c in if i == j { r } else { 0 }..D {
                                visit([i, r], [j, c], self.values[slot * D * D + D * r + c]);
                            }
                        }
                    }
                }
            }
        }
    }

    /// Visits the blocks of a sparse layout: points `i <= j` and the block.
    ///
    /// # Panics
    /// The layout is a band.
    pub fn for_each_block(&self, mut visit: impl FnMut(usize, usize, &Mat<D, D>)) {
        let Layout::Rows { start, column } = &self.layout else { panic!("only a sparse layout has blocks") };
        let (blocks, _) = self.values.as_chunks::<D>();
        for i in 0..self.points {
            for slot in start[i]..start[i + 1] {
                let block = blocks[D * slot..].first_chunk().expect("a block has D rows");
                visit(i, column[slot] as usize, block);
            }
        }
    }

    /// The full symmetric matrix, `order = D · points`, with unknown `number(point, component)`.
    pub fn to_csr(&self, number: impl Fn(usize, usize) -> usize) -> CsMat<f64> {
        let order = D * self.points;
        let mut triplets = sprs::TriMat::new((order, order));
        self.for_each_entry(|[i, r], [j, c], value| {
            let (a, b) = (number(i, r), number(j, c));
            triplets.add_triplet(a, b, value);
            if a != b {
                triplets.add_triplet(b, a, value);
            }
        });
        triplets.to_csr()
    }

    /// Half bandwidth and values of the lower band, `values[j·(b + 1) + k] = K[j + k, j]`, unknown `D·p + c`.
    ///
    /// # Panics
    /// The layout is not a band.
    pub fn into_band(self) -> (usize, Vec<f64>) {
        match self.layout {
            Layout::Band { reach } => {
                let mut values = self.values;
                values.resize(D * self.points * D * (reach + 1), 0.0);
                (D * (reach + 1) - 1, values)
            }
            Layout::Rows { .. } => panic!("only a band layout has band values"),
        }
    }
}
