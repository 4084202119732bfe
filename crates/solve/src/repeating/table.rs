//! A recurrence with constant coefficients for several unknowns at once.
//!
//! One by one, every result would have to wait for the one before. With the
//! dependence among [`LANES`] neighbouring unknowns solved beforehand, they are the
//! product of a small dense matrix with their right-hand sides and the results that
//! are known: more operations, but in parallel.

/// Unknowns at once.
pub(super) const LANES: usize = 8;

/// The small matrices, by columns, for all positions in a group where `LANES`
/// unknowns may begin.
#[derive(Debug, Clone)]
pub(super) struct Table {
    columns: Vec<[f64; LANES]>,
    /// Columns of one matrix.
    size: usize,
    /// Distance of the positions.
    stride: usize,
}

/// Greatest common divisor.
fn common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { common_divisor(b, a % b) }
}

impl Table {
    /// Tabulates a sweep over `size` entries, results and right-hand sides in the
    /// order of the matrix. `sweep` gets the position of the first result in the
    /// group and overwrites right-hand sides by results, which begin at `results`.
    pub(super) fn new(period: usize, size: usize, results: usize, sweep: impl Fn(usize, &mut [f64])) -> Self {
        let stride = common_divisor(period, LANES);
        let mut columns = Vec::with_capacity(period / stride * size);
        let mut values = vec![0.0; size];
        for phase in (0..period).step_by(stride) {
            for unit in 0..size {
                values.fill(0.0);
                values[unit] = 1.0;
                sweep(phase, &mut values);
                let mut column = [0.0; LANES];
                column.copy_from_slice(&values[results..results + LANES]);
                columns.push(column);
            }
        }
        Self { columns, size, stride }
    }

    /// The matrix for unknowns that begin at a position in the group.
    #[inline(always)]
    pub(super) fn at(&self, phase: usize) -> &[[f64; LANES]] {
        &self.columns[phase / self.stride * self.size..][..self.size]
    }

    /// Memory held, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.columns.capacity() * size_of::<[f64; LANES]>()
    }
}

/// Adds columns times values, the newest value last: its term is then the only one
/// that waits for it.
#[inline(always)]
pub(super) fn add<'a>(sum: &mut [f64; LANES], terms: impl Iterator<Item = (&'a [f64; LANES], &'a f64)>) {
    for (column, value) in terms {
        for lane in 0..LANES {
            sum[lane] += column[lane] * value;
        }
    }
}
