//! The elimination, up to the convergence of each run.

use super::{RepeatingBand, RepeatingCholesky, Run};
use crate::FactorError;
use crate::band::Pivots;

/// A change of the matrix that is no more than its rounding, relative to the
/// geometric mean of the diagonal entries in its row and its column. The columns of
/// every sixth matrix of condition 1e6 go round in circles larger than half of it.
const ROUNDING: f64 = 2.0 * f64::EPSILON;
/// Half bandwidth from which on the rounding of that many products, which grows with its root, counts.
const WIDE: f64 = 16.0;

/// Fills in the runs and the kept columns and rows of the factor.
pub(super) fn eliminate(matrix: &RepeatingBand, factor: &mut RepeatingCholesky) -> Result<(), FactorError> {
    let RepeatingBand { half_bandwidth, period, ref runs, ref values } = *matrix;
    let width = half_bandwidth + 1;
    // The rows have converged once all columns that they reach back to have.
    let enough = half_bandwidth.div_ceil(period) + 1;
    let mut window = Window::new(width);
    let mut pivots = Pivots::default();
    let mut before = 0;
    for (group, groups) in values.chunks_exact(period * width).zip(runs) {
        let columns = groups * period;
        let first = factor.columns_kept();
        let (mut kept, mut steady) = (0, 0);
        while kept < columns && steady < enough {
            let mut same = kept > 0;
            for (phase, column) in group.chunks_exact(width).enumerate() {
                let index = before + kept + phase;
                if !window.step(column, index, factor.order - index, &mut pivots) {
                    return pivots.verdict(|k| k);
                }
                // The factor of an indefinite matrix is not needed, only its pivots.
                if pivots.first_bad.is_none() {
                    factor.rows.extend_from_slice(&window.row);
                    factor.columns.extend_from_slice(&window.column);
                }
                same = same && pivots.first_bad.is_none() && has_settled(factor, group, phase);
            }
            steady = if same { steady + 1 } else { 0 };
            kept += period;
        }
        factor.runs.push(Run { columns, kept, first, tables: None });
        before += columns;
    }
    pivots.verdict(|k| k)
}

/// Whether the last kept column is that of the group before but for rounding.
fn has_settled(factor: &RepeatingCholesky, group: &[f64], phase: usize) -> bool {
    let (period, width) = (factor.period, factor.half_bandwidth + 1);
    let last = factor.columns_kept() - 1;
    let (old, new) = (factor.column(last - period), factor.column(last));
    let diagonal = |phase: usize| group[phase % period * width];
    // Entries of L and, for the diagonal, the relative change of the pivot; times
    // the pivot they are entries of the matrix.
    let reciprocal = new[0];
    let rounding = ROUNDING * (width as f64 / WIDE).max(1.0).sqrt();
    (0..width).all(|k| {
        let change = if k == 0 { (old[0] - new[0]) / reciprocal } else { old[k] - new[k] };
        let scale = (diagonal(phase) * diagonal(phase + k)).sqrt();
        change.abs() <= rounding * scale * reciprocal
    })
}

/// What the next columns depend on, and the last results.
struct Window {
    /// Columns so far.
    steps: usize,
    /// The last columns, `L` below the pivot; column `s` in place `s % b`.
    recent: Vec<f64>,
    /// The last column, its reciprocal pivot first.
    column: Vec<f64>,
    /// Its row of `L` left of the diagonal, the oldest entry first.
    row: Vec<f64>,
}

impl Window {
    fn new(width: usize) -> Self {
        let recent = vec![0.0; (width - 1) * width];
        Self { steps: 0, recent, column: vec![0.0; width], row: vec![0.0; width - 1] }
    }

    /// Eliminates one more column, of which `inside` entries are in the matrix.
    /// `false` if there is no way on.
    fn step(&mut self, column: &[f64], index: usize, inside: usize, pivots: &mut Pivots) -> bool {
        let width = column.len();
        let inside = inside.min(width);
        self.column[..inside].copy_from_slice(&column[..inside]);
        self.column[inside..].fill(0.0);
        for (back, entry) in (1..width).rev().zip(&mut self.row) {
            if back > self.steps {
                continue; // zero from the start
            }
            let place = (self.steps - back) % (width - 1);
            let earlier = &self.recent[place * width..][..width];
            *entry = earlier[back];
            let factor = earlier[0] * earlier[back];
            for (target, value) in self.column[..inside].iter_mut().zip(&earlier[back..]) {
                *target -= factor * value;
            }
        }
        let mut pivot = self.column[0];
        if !(pivot > 0.0 && pivot < f64::INFINITY) {
            match pivots.note(index, pivot, &self.column) {
                Some(usable) => pivot = usable,
                None => return false,
            }
        }
        let reciprocal = 1.0 / pivot;
        for value in &mut self.column {
            *value *= reciprocal;
        }
        if width > 1 {
            let place = self.steps % (width - 1);
            self.recent[place * width..][..width].copy_from_slice(&self.column);
            self.recent[place * width] = pivot;
        }
        self.column[0] = reciprocal;
        self.steps += 1;
        true
    }
}
