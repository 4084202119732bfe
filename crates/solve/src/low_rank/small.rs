//! The small system of the columns whose change is not zero.

use crate::FactorError;
use crate::blocks::{Block, blocks};
use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::cholesky::lblt::factor::{
    LbltParams, PivotingStrategy, cholesky_in_place, cholesky_in_place_scratch,
};
use faer::linalg::cholesky::lblt::solve::{solve_in_place, solve_in_place_scratch};
use faer::perm::PermRef;
use faer::{Auto, Mat, MatMut, Par, Spec};

/// Pivots below this part of the largest entry of their row are rounding, per row of the system.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// `L B L^T` of `S`, pivots sought in the whole matrix.
pub(super) struct Small {
    /// Indices of the columns and the entries of `D`.
    scales: Vec<(usize, f64)>,
    factor: Mat<f64>,
    below: Diag<f64>,
    forward: Vec<usize>,
    inverse: Vec<usize>,
    scratch: MemBuffer,
    /// The position of the first pivot that is useless and whether it is finite.
    flaw: Option<(usize, bool)>,
    positive: usize,
    y: Vec<f64>,
}

impl Small {
    /// From the indices and changes of columns, ascending, and `product(i, j)`, the entries of `V^T Z` for `i >= j`.
    pub(super) fn new(changes: &[(usize, f64)], product: impl Fn(usize, usize) -> f64) -> Self {
        let scale = |(i, c): &(usize, f64)| (*i, (c.abs().recip() + product(*i, *i).abs()).sqrt().recip());
        let scales: Vec<(usize, f64)> = changes.iter().map(scale).collect();
        let rank = scales.len();
        let mut factor = Mat::zeros(rank, rank);
        let mut largest = vec![0.0_f64; rank];
        for (row, (i, d)) in scales.iter().enumerate() {
            for (column, (j, e)) in scales[..=row].iter().enumerate() {
                let mut entry = d * product(*i, *j) * e;
                if row == column {
                    let c = changes[row].1;
                    entry += c.signum() / (1.0 + (c * product(*i, *i)).abs());
                }
                factor[(row, column)] = entry;
                largest[row] = largest[row].max(entry.abs());
                largest[column] = largest[column].max(entry.abs());
            }
        }
        let mut small = Self {
            scales,
            factor,
            below: Diag::zeros(rank),
            forward: vec![0; rank],
            inverse: vec![0; rank],
            scratch: MemBuffer::new(need(rank)),
            flaw: None,
            positive: 0,
            y: vec![0.0; rank],
        };
        if rank > 0 {
            small.factor(&largest);
        }
        small
    }

    /// Factors `S`, given the largest entries of its rows.
    fn factor(&mut self, largest: &[f64]) {
        cholesky_in_place(
            self.factor.as_mut(),
            self.below.as_mut(),
            &mut self.forward,
            &mut self.inverse,
            Par::Seq,
            MemStack::new(&mut self.scratch),
            parameters(),
        );
        let diagonal: Vec<f64> = self.factor.diagonal().column_vector().iter().copied().collect();
        let below: Vec<f64> = self.below.column_vector().iter().copied().collect();
        let rounding = ROUNDING * largest.len() as f64;
        let found: Vec<Block> = blocks(&diagonal, &below).collect();
        self.positive = found.iter().map(|block| block.positive).sum();
        let bad = found.iter().find(|block| {
            let scale = largest[self.forward[block.first]];
            !block.pivot.is_finite() || block.pivot <= rounding * scale
        });
        self.flaw = bad.map(|block| (block.first, block.pivot.is_finite()));
    }

    /// Number of positive eigenvalues of `S`.
    pub(super) fn positive(&self) -> usize {
        self.positive
    }

    /// Why there is no solution; `unknown` says which unknown stands for a column.
    pub(super) fn solvable(&self, unknown: impl Fn(usize) -> usize) -> Result<(), FactorError> {
        let Some((position, finite)) = self.flaw else { return Ok(()) };
        let index = unknown(self.scales[self.forward[position]].0);
        Err(if finite { FactorError::Singular { index } } else { FactorError::NotFinite { index } })
    }

    /// Solves with the products of the columns and a vector on the right.
    pub(super) fn solve(&mut self, dot: impl Fn(usize) -> f64) {
        let rank = self.scales.len();
        if rank == 0 {
            return;
        }
        for (y, (index, scale)) in self.y.iter_mut().zip(&self.scales) {
            *y = scale * dot(*index);
        }
        solve_in_place(
            self.factor.as_ref(),
            self.factor.diagonal(),
            self.below.as_ref(),
            PermRef::new_checked(&self.forward, &self.inverse, rank),
            MatMut::from_column_major_slice_mut(&mut self.y, rank, 1),
            Par::Seq,
            MemStack::new(&mut self.scratch),
        );
    }

    /// Indices of the columns and how much of their solved columns is to be taken away.
    pub(super) fn solution(&self) -> impl Iterator<Item = (usize, f64)> {
        self.scales.iter().zip(&self.y).map(|((index, scale), y)| (*index, scale * y))
    }
}

impl std::fmt::Debug for Small {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Small").field("rank", &self.scales.len()).field("positive", &self.positive).finish()
    }
}

fn parameters() -> Spec<LbltParams, f64> {
    let mut parameters = <LbltParams as Auto<f64>>::auto();
    parameters.pivoting = PivotingStrategy::Full;
    parameters.into()
}

fn need(rank: usize) -> StackReq {
    let factor = cholesky_in_place_scratch::<usize, f64>(rank, Par::Seq, parameters());
    factor.or(solve_in_place_scratch::<usize, f64>(rank, 1, Par::Seq))
}
