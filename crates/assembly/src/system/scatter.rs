//! The constrained stiffness in compressed rows where no unknown depends on others: blocks go straight to their places.

use super::System;
use crate::bonds::Mat;
use crate::stiffness::BlockMatrix;
use sprs::CsMat;

/// Blocks of every point with all points that it is coupled to, itself among them, in order.
struct Rows<const D: usize> {
    start: Vec<usize>,
    /// The other point and the block with the rows of this one.
    entries: Vec<(u32, Mat<D, D>)>,
}

impl<const D: usize> Rows<D> {
    fn new(points: usize, upper: &BlockMatrix<D>) -> Self {
        let mut start = vec![0_usize; points + 1];
        upper.for_each_block(|i, j, _| {
            start[i + 1] += 1;
            start[j + 1] += usize::from(i != j);
        });
        (0..points).for_each(|p| start[p + 1] += start[p]);
        let mut next = start.clone();
        let mut entries = vec![(0, [[0.0; D]; D]); start[points]];
        // Rows come in order, so in every row lower points come before it and higher ones after it.
        upper.for_each_block(|i, j, block| {
            let mut put = |at: usize, other: usize, block: Mat<D, D>| {
                entries[next[at]] = (other as u32, block);
                next[at] += 1;
            };
            if i == j {
                // Of a diagonal block only the upper triangle is sure to be filled.
                put(i, i, std::array::from_fn(|r| std::array::from_fn(|c| block[r.min(c)][r.max(c)])));
            } else {
                put(i, j, *block);
                put(j, i, std::array::from_fn(|r| std::array::from_fn(|c| block[c][r])));
            }
        });
        Self { start, entries }
    }

    fn of(&self, point: usize) -> &[(u32, Mat<D, D>)] {
        &self.entries[self.start[point]..self.start[point + 1]]
    }
}

impl<const D: usize> System<D> {
    /// The lower triangle without the rows and columns of constrained unknowns, which keep a positive diagonal.
    pub(super) fn scatter(&self) -> CsMat<f64> {
        let (n, size) = (self.points, self.size());
        let mut free = vec![true; size];
        self.constraints.rows().iter().for_each(|row| free[row.unknown] = false);
        let rows = Rows::new(n, &self.stiffness());
        let room: usize = rows.entries.len() * D * (D + 1) / 2;
        let (mut pointers, mut indices, mut values) =
            (Vec::with_capacity(size + 1), Vec::with_capacity(room), Vec::with_capacity(room));
        pointers.push(0);
        for c in 0..D {
            for j in 0..n {
                let row = c * n + j;
                let mut diagonal = 0.0;
                for r in 0..=c {
                    for (i, block) in rows.of(j).iter().take_while(|(i, _)| r < c || *i as usize <= j) {
                        let (column, value) = (r * n + *i as usize, block[c][r]);
                        if column == row {
                            diagonal = value;
                        } else if free[row] && free[column] {
                            indices.push(column);
                            values.push(value);
                        }
                    }
                }
                // An unknown that nothing reads has no stiffness.
                indices.push(row);
                values.push(if diagonal == 0.0 { 1.0 } else { diagonal });
                pointers.push(indices.len());
            }
        }
        CsMat::new((size, size), pointers, indices, values)
    }
}
