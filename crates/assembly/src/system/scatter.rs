//! The constrained stiffness `TᵀKT` in compressed rows: blocks of independent unknowns go straight to their places, sums of those
//! of unknowns that depend on others are added to them.

use super::System;
use crate::bonds::Mat;
use crate::condition::Row;
use crate::stiffness::BlockMatrix;
use sprs::{CsMat, TriMat};
use std::collections::HashMap;

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

/// Independent unknowns behind an unknown, with their coefficients.
struct Masters<'a> {
    /// Per unknown: number of its row plus one, zero if it is independent.
    row: Vec<u32>,
    rows: &'a [Row],
}

impl<'a> Masters<'a> {
    fn new(size: usize, rows: &'a [Row]) -> Self {
        let mut row = vec![0; size];
        rows.iter().zip(1..).for_each(|(r, number)| row[r.unknown] = number);
        Self { row, rows }
    }

    fn is_free(&self, unknown: usize) -> bool {
        self.row[unknown] == 0
    }

    /// Whether an unknown depends on others.
    fn has_some(&self, unknown: usize) -> bool {
        let row = self.row[unknown];
        row > 0 && !self.rows[row as usize - 1].masters.is_empty()
    }

    /// Adds what an entry of the lower triangle of the stiffness is on independent unknowns.
    fn fold(&self, [row, column]: [usize; 2], value: f64, sums: &mut HashMap<[usize; 2], f64>) {
        self.each(row, |a, ca| {
            self.each(column, |b, cb| {
                // Of a symmetric pair only one entry is visited; both may fall on one diagonal place.
                let both = if a == b && row != column { 2.0 } else { 1.0 };
                if row != column || b <= a {
                    *sums.entry([a.max(b), a.min(b)]).or_insert(0.0) += both * ca * cb * value;
                }
            });
        });
    }

    fn each(&self, unknown: usize, mut visit: impl FnMut(usize, f64)) {
        match self.row[unknown] {
            0 => visit(unknown, 1.0),
            row => self.rows[row as usize - 1].masters.iter().for_each(|&(m, c)| visit(m, c)),
        }
    }
}

impl<const D: usize> System<D> {
    /// The lower triangle of the constrained stiffness `TᵀKT` in compressed rows; unknowns that are constrained or that
    /// nothing reads keep a positive diagonal and couple to nothing.
    pub fn assemble_sparse(&self) -> CsMat<f64> {
        let (n, size) = (self.points, self.size());
        let masters = Masters::new(size, self.constraints.rows());
        let rows = Rows::new(n, &self.stiffness());
        let room: usize = rows.entries.len() * D * (D + 1) / 2;
        let (mut pointers, mut indices, mut values) =
            (Vec::with_capacity(size + 1), Vec::with_capacity(room), Vec::with_capacity(room));
        // Every entry once: dependent unknowns share their masters, and each pair of these is met many times.
        let mut folded: HashMap<[usize; 2], f64> = HashMap::new();
        pointers.push(0);
        for (c, j) in (0..D).flat_map(|c| (0..n).map(move |j| (c, j))) {
            let row = c * n + j;
            let mut diagonal = 0.0;
            for r in 0..=c {
                for (i, block) in rows.of(j).iter().take_while(|(i, _)| r < c || *i as usize <= j) {
                    let (column, value) = (r * n + *i as usize, block[c][r]);
                    if column == row {
                        diagonal = value;
                    } else if masters.is_free(row) && masters.is_free(column) {
                        indices.push(column);
                        values.push(value);
                    }
                    if value != 0.0 && (masters.has_some(row) || masters.has_some(column)) {
                        masters.fold([row, column], value, &mut folded);
                    }
                }
            }
            // An unknown that nothing reads has no stiffness.
            indices.push(row);
            values.push(if diagonal == 0.0 { 1.0 } else { diagonal });
            pointers.push(indices.len());
        }
        let direct = CsMat::new((size, size), pointers, indices, values);
        if folded.is_empty() {
            return direct;
        }
        // The order of the map does not matter: compressed rows are sorted.
        let mut sums = TriMat::with_capacity((size, size), folded.len());
        folded.into_iter().for_each(|([row, column], value)| sums.add_triplet(row, column, value));
        &direct + &sums.to_csr()
    }

    /// The same among the unknowns of some points that are not constrained: these, in order, and the lower triangle by their
    /// places among them. All other unknowns rest.
    pub fn assemble_among(&self, points: &[usize]) -> (Vec<usize>, CsMat<f64>) {
        let (n, size) = (self.points, self.size());
        let mut kept = vec![false; n];
        points.iter().for_each(|&p| kept[p] = true);
        let mut place: Vec<Option<usize>> = (0..size).map(|k| kept[k % n].then_some(0)).collect();
        self.constraints.rows().iter().for_each(|row| place[row.unknown] = None);
        let unknowns: Vec<usize> = (0..size).filter(|&k| place[k].is_some()).collect();
        unknowns.iter().enumerate().for_each(|(k, &unknown)| place[unknown] = Some(k));
        let mut moved = TriMat::new((size, unknowns.len()));
        unknowns.iter().enumerate().for_each(|(k, &unknown)| moved.add_triplet(unknown, k, 1.0));
        for row in self.constraints.rows() {
            for &(master, share) in &row.masters {
                if let Some(k) = place[master] {
                    kept[row.unknown % n] = true;
                    moved.add_triplet(row.unknown, k, share);
                }
            }
        }
        let mut stiffness = BlockMatrix::among(n, &self.terms, &|p| kept[p]);
        self.terms.iter().for_each(|t| t.add_tangent(&mut stiffness));
        let moved: CsMat<f64> = moved.to_csr();
        let forces = &stiffness.to_csr(|point, c| c * n + point) * &moved;
        let all = &moved.transpose_view().to_csr() * &forces;
        let mut lower = TriMat::new((unknowns.len(), unknowns.len()));
        for (row, entries) in all.outer_iterator().enumerate() {
            let own = entries.iter().filter(|(column, value)| *column <= row && **value != 0.0);
            own.for_each(|(column, value)| lower.add_triplet(row, column, *value));
            // An unknown that nothing reads has no stiffness.
            if entries.get(row).is_none_or(|own| *own == 0.0) {
                lower.add_triplet(row, row, 1.0);
            }
        }
        (unknowns, lower.to_csr())
    }
}
