//! The factorisation of a band of any width, in squares of four by four.
//!
//! Four columns are eliminated together. Two of their squares at a time stay in
//! registers while everything before is subtracted from them, so that an entry of an
//! earlier column is loaded once for four columns; and squares never straddle, so
//! that nothing is loaded across what was just stored.

use super::pivots::Pivots;
use peristat_vector::vectorised;

/// Rows and columns of a square.
const SIDE: usize = 4;

/// The columns of a square.
type Square = [[f64; SIDE]; SIDE];

/// Factors the band in place; `values` has whole columns of `half_bandwidth + 1`.
pub(super) fn factor(values: &mut [f64], half_bandwidth: usize) -> Pivots {
    let mut pivots = Pivots::default();
    let mut window = Window::new(half_bandwidth);
    vectorised(
        #[inline(always)]
        || {
            for (at, columns) in values.chunks_mut(SIDE * (half_bandwidth + 1)).enumerate() {
                if !window.eliminate(at, columns, &mut pivots) {
                    return;
                }
            }
        },
    );
    pivots
}

/// The last columns of the factor, by fours, as columns of squares that begin with
/// the one on the diagonal.
struct Window {
    width: usize,
    /// Squares below the diagonal that are not zero, and fours of columns that have
    /// some in the rows of the next.
    reach: usize,
    /// Squares of four columns: those that may not be zero and one that is.
    stride: usize,
    /// Entries of `L`; four columns in place `at % (reach + 1)`.
    scaled: Vec<Square>,
    /// The same times the pivots.
    plain: Vec<Square>,
}

/// A square on the diagonal, factored.
struct Corner {
    plain: Square,
    reciprocals: [f64; SIDE],
}

impl Window {
    fn new(half_bandwidth: usize) -> Self {
        let reach = half_bandwidth.div_ceil(SIDE);
        let stride = reach + 2;
        let empty = vec![[[0.0; SIDE]; SIDE]; (reach + 1) * stride];
        Self { width: half_bandwidth + 1, reach, stride, scaled: empty.clone(), plain: empty }
    }

    /// Eliminates the next four columns, or fewer at the end. `false` if there is no
    /// way on.
    #[inline(always)]
    fn eliminate(&mut self, at: usize, columns: &mut [f64], pivots: &mut Pivots) -> bool {
        let place = at % (self.reach + 1);
        let mut corner = Corner { plain: [[0.0; SIDE]; SIDE], reciprocals: [0.0; SIDE] };
        for top in (0..=self.reach).step_by(2) {
            let mut pair = [load(columns, self.width, top), load(columns, self.width, top + 1)];
            self.subtract(place, top, &mut pair);
            if top == 0 {
                match Corner::new(pair[0], columns, self.width, at, pivots) {
                    Some(square) => corner = square,
                    None => return false,
                }
            }
            for (square, ahead) in pair.iter().zip(top..=self.reach) {
                let (plain, scaled) = corner.finish(square);
                self.plain[place * self.stride + ahead] = plain;
                self.scaled[place * self.stride + ahead] = scaled;
                store(&scaled, columns, self.width, ahead);
            }
        }
        for (column, reciprocal) in columns.chunks_exact_mut(self.width).zip(corner.reciprocals) {
            column[0] = reciprocal;
        }
        true
    }

    /// Subtracts what the earlier columns take from two squares, the oldest first.
    #[inline(always)]
    fn subtract(&self, place: usize, top: usize, pair: &mut [Square; 2]) {
        for back in (1..=self.reach - top).rev() {
            let earlier = if place >= back { place - back } else { place + self.reach + 1 - back };
            let plain = &self.plain[earlier * self.stride..][..self.stride];
            let scaled = &self.scaled[earlier * self.stride..][..self.stride];
            let factors = &plain[back];
            let below = &scaled[back + top..back + top + 2];
            for k in 0..SIDE {
                for c in 0..SIDE {
                    for r in 0..SIDE {
                        pair[0][c][r] -= factors[k][c] * below[0][k][r];
                        pair[1][c][r] -= factors[k][c] * below[1][k][r];
                    }
                }
            }
        }
    }
}

impl Corner {
    /// `None` if there is no way on.
    #[inline(always)]
    fn new(mut plain: Square, columns: &[f64], width: usize, at: usize, pivots: &mut Pivots) -> Option<Self> {
        let mut reciprocals = [0.0; SIDE];
        for (c, column) in columns.chunks_exact(width).enumerate() {
            let mut pivot = plain[c][c];
            if !(pivot > 0.0 && pivot < f64::INFINITY) {
                // Of the column only the corner is known yet; the matrix gives the scale.
                pivot = pivots.note(at * SIDE + c, pivot, column)?;
            }
            reciprocals[c] = 1.0 / pivot;
            for after in c + 1..SIDE {
                let factor = plain[c][after] * reciprocals[c];
                for r in 0..SIDE {
                    plain[after][r] -= factor * plain[c][r];
                }
            }
        }
        Some(Self { plain, reciprocals })
    }

    /// Eliminates the four columns from each other in another square: its entries
    /// times the pivots, and those of `L`.
    #[inline(always)]
    fn finish(&self, square: &Square) -> (Square, Square) {
        let (mut plain, mut scaled) = (*square, *square);
        for c in 0..SIDE {
            scaled[c] = plain[c].map(|v| v * self.reciprocals[c]);
            for after in c + 1..SIDE {
                for r in 0..SIDE {
                    plain[after][r] -= self.plain[c][after] * scaled[c][r];
                }
            }
        }
        (plain, scaled)
    }
}

/// The square `below` the diagonal of four columns of a matrix.
#[inline(always)]
fn load(columns: &[f64], width: usize, below: usize) -> Square {
    let mut square = [[0.0; SIDE]; SIDE];
    for (c, column) in columns.chunks_exact(width).enumerate() {
        let from = (SIDE * below).wrapping_sub(c);
        if let Some(entries) = column.get(from..from.wrapping_add(SIDE)) {
            square[c].copy_from_slice(entries);
        } else {
            for r in 0..SIDE {
                square[c][r] = column.get(from.wrapping_add(r)).copied().unwrap_or(0.0);
            }
        }
    }
    square
}

/// Writes a square down.
#[inline(always)]
fn store(square: &Square, columns: &mut [f64], width: usize, below: usize) {
    for (c, column) in columns.chunks_exact_mut(width).enumerate() {
        let from = (SIDE * below).wrapping_sub(c);
        if let Some(entries) = column.get_mut(from..from.wrapping_add(SIDE)) {
            entries.copy_from_slice(&square[c]);
        } else {
            for r in 0..SIDE {
                if let Some(entry) = column.get_mut(from.wrapping_add(r)) {
                    *entry = square[c][r];
                }
            }
        }
    }
}
