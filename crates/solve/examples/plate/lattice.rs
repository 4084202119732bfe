//! Stiffness of a square plate of a bond-based material, one column of points clamped.

use sprs::CsMat;
use std::io::{BufWriter, Write};
use std::path::Path;

/// A plate of `side` by `side` points; unknowns in component planes, `c · points + p`.
pub(crate) struct Plate {
    /// Positions of the points, in units of the spacing.
    pub(crate) positions: Vec<[f64; 2]>,
    /// Lower triangle; the clamped points have rows of the identity.
    pub(crate) matrix: CsMat<f64>,
}

impl Plate {
    /// Bonds up to `reach` spacings, of stiffness 1 over their length.
    pub(crate) fn new(side: usize, reach: f64) -> Self {
        let span = reach.floor() as isize;
        let offsets: Vec<[isize; 2]> = (-span..=span)
            .flat_map(|dy| (-span..=span).map(move |dx| [dx, dy]))
            .filter(|[dx, dy]| (1..=(reach * reach) as isize).contains(&(dx * dx + dy * dy)))
            .collect();
        let points = side * side;
        let positions = (0..points).map(|p| [(p % side) as f64, (p / side) as f64]).collect();
        let bond = |p: usize, [dx, dy]: [isize; 2]| {
            let x = (p % side).checked_add_signed(dx).filter(|x| *x < side)?;
            let y = (p / side).checked_add_signed(dy).filter(|y| *y < side)?;
            let length = ((dx * dx + dy * dy) as f64).sqrt();
            let n = [dx as f64 / length, dy as f64 / length];
            Some((y * side + x, move |r: usize, c: usize| n[r] * n[c] / length))
        };
        let clamped = |p: usize| p.is_multiple_of(side);
        let (mut starts, mut columns, mut values) = (vec![0], Vec::new(), Vec::new());
        for r in 0..2 {
            for p in 0..points {
                for c in 0..=r {
                    let mut own = 0.0;
                    let start = columns.len();
                    for (q, k) in offsets.iter().filter_map(|offset| bond(p, *offset)) {
                        own += k(r, c);
                        // Couplings to clamped points are no entries at all.
                        if (q < p || c < r) && !clamped(p) && !clamped(q) {
                            columns.push(c * points + q);
                            values.push(-k(r, c));
                        }
                    }
                    if clamped(p) && c < r {
                        continue;
                    }
                    let place = start + columns[start..].partition_point(|j| *j < c * points + p);
                    columns.insert(place, c * points + p);
                    values.insert(place, if clamped(p) { 1.0 } else { own });
                }
                starts.push(columns.len());
            }
        }
        let order = 2 * points;
        Self { positions, matrix: CsMat::new((order, order), starts, columns, values) }
    }
}

impl Plate {
    /// Whether an unknown belongs to a clamped point.
    pub(crate) fn clamped(&self, unknown: usize) -> bool {
        self.positions[unknown % self.positions.len()][0] == 0.0
    }

    /// Backward error of a solution, `|A x - b| / (|A| |x| + |b|)` in the largest row sum and
    /// entries.
    pub(crate) fn residual(&self, x: &[f64], b: &[f64]) -> f64 {
        let (mut left, mut sums) = (b.to_vec(), vec![0.0; b.len()]);
        for (value, (i, j)) in &self.matrix {
            left[i] -= value * x[j];
            sums[i] += value.abs();
            if i != j {
                left[j] -= value * x[i];
                sums[j] += value.abs();
            }
        }
        let largest = |v: &[f64]| v.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        largest(&left) / (largest(&sums) * largest(x) + largest(b))
    }
}

/// Writes `order` and `entries` (u64), row starts (u64), columns (u32), values (f64), little
/// endian.
pub(crate) fn write(matrix: &CsMat<f64>, path: &Path) -> std::io::Result<()> {
    let mut file = BufWriter::new(std::fs::File::create(path)?);
    for number in [matrix.rows(), matrix.nnz()].iter().chain(matrix.proper_indptr().iter()) {
        file.write_all(&(*number as u64).to_le_bytes())?;
    }
    for column in matrix.indices() {
        file.write_all(&(*column as u32).to_le_bytes())?;
    }
    for value in matrix.data() {
        file.write_all(&value.to_le_bytes())?;
    }
    file.flush()
}
