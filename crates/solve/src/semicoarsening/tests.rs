use super::*;
use crate::{Hierarchy, LinearOperator, Multigrid, MultigridOptions, Pcg, PcgOptions};
use sprs::TriMat;

/// A tube of springs, a thousand times as stiff around it as along it, whose ends are held.
struct Tube {
    columns: usize,
    rows: usize,
}

impl Tube {
    fn unknown(&self, column: usize, row: usize) -> usize {
        column * self.rows + row % self.rows
    }

    fn place(&self, unknown: usize) -> Option<LinePlace> {
        let (line, station) = (unknown % self.rows, unknown / self.rows);
        let is_held = station == 0 || station + 1 == self.columns;
        (!is_held).then_some(LinePlace { station: station as u32, line: line as u32 })
    }

    /// Elongations as sums of unknowns.
    fn strains(&self) -> Vec<[(usize, f64); 2]> {
        let cells = (0..self.columns).flat_map(|i| (0..self.rows).map(move |j| (i, j)));
        let strains = cells.flat_map(|(i, j)| {
            let own = self.unknown(i, j);
            let along = (i + 1 < self.columns).then(|| [(self.unknown(i + 1, j), 0.03), (own, -0.03)]);
            [Some([(self.unknown(i, j + 1), 1.0), (own, -1.0)]), along]
        });
        strains.flatten().collect()
    }

    /// The lower triangle of the matrix, one at unknowns that are held.
    fn matrix(&self) -> CsMat<f64> {
        let size = self.rows * self.columns;
        let mut matrix = TriMat::new((size, size));
        let is_free = |unknown: usize| self.place(unknown).is_some();
        for strain in self.strains() {
            for (a, b) in strain.iter().flat_map(|a| strain.iter().map(move |b| (a, b))) {
                if b.0 <= a.0 && is_free(a.0) && is_free(b.0) {
                    matrix.add_triplet(a.0, b.0, a.1 * b.1);
                }
            }
        }
        (0..size).filter(|&k| !is_free(k)).for_each(|k| matrix.add_triplet(k, k, 1.0));
        matrix.to_csr()
    }
}

/// All levels, the finest smoothed by stations, too.
struct Levels {
    finest: Matrix,
    stations: StationFactors,
    below: Semicoarsening,
}

impl Hierarchy for Levels {
    type Real = f64;

    fn depth(&self) -> usize {
        1 + self.below.depth()
    }
    fn size(&self, level: usize) -> usize {
        if level == 0 { self.finest.rows() } else { self.below.size(level - 1) }
    }
    fn apply(&self, level: usize, x: &[f64], y: &mut [f64]) {
        if level == 0 { self.finest.multiply(x, y) } else { self.below.apply(level - 1, x, y) }
    }
    fn smooth(&self, level: usize, scale: f64, r: &[f64], x: &mut [f64]) {
        if level == 0 { self.stations.add(scale, r, x) } else { self.below.smooth(level - 1, scale, r, x) }
    }
    fn restrict(&self, level: usize, fine: &[f64], coarse: &mut [f64]) {
        match level {
            0 => self.below.restrict_finest(fine, coarse),
            _ => self.below.restrict(level - 1, fine, coarse),
        }
    }
    fn prolong_add(&self, level: usize, coarse: &[f64], fine: &mut [f64]) {
        match level {
            0 => self.below.prolong_add_finest(coarse, fine),
            _ => self.below.prolong_add(level - 1, coarse, fine),
        }
    }
}

impl LinearOperator for Levels {
    fn size(&self) -> usize {
        self.finest.rows()
    }
    fn apply(&self, x: &[f64], y: &mut [f64]) {
        self.finest.multiply(x, y);
    }
}

fn levels(tube: &Tube) -> (Levels, SparseCholesky) {
    let lower = tube.matrix();
    let places: Vec<_> = (0..lower.rows()).map(|unknown| tube.place(unknown)).collect();
    let finest = Matrix::symmetric(&lower);
    let (below, factor) = Semicoarsening::new(lower, &places, 6).unwrap();
    let stations = StationFactors::new(&finest, &places).unwrap();
    (Levels { finest, stations, below }, factor)
}

/// Iterations under a load of two waves around.
fn iterations(tube: &Tube) -> usize {
    let (levels, factor) = levels(tube);
    let wave = |row: u32| (2.0 * std::f64::consts::TAU * f64::from(row) / tube.rows as f64).cos();
    let load = |unknown: usize| tube.place(unknown).map_or(0.0, |place| wave(place.line));
    let b: Vec<f64> = (0..tube.rows * tube.columns).map(load).collect();
    let options = MultigridOptions { measured_size: usize::MAX, ..MultigridOptions::STANDARD };
    let mut cycle = Multigrid::new(&levels, Box::new(factor), &options);
    let mut x = vec![0.0; b.len()];
    let wanted = PcgOptions { residual_drop: 1e-10, max_iterations: 400, ..PcgOptions::default() };
    let mut residual = b.clone();
    let report = Pcg::new(b.len()).solve(&levels, &mut cycle, &mut residual, &mut x, &wanted);
    let mut left = vec![0.0; b.len()];
    levels.finest.multiply(&x, &mut left);
    let largest = |v: &[f64]| v.iter().fold(0.0_f64, |largest, v| largest.max(v.abs()));
    left.iter_mut().zip(&b).for_each(|(left, b)| *left -= b);
    assert!(largest(&left) < 1e-8 * largest(&b), "{}", largest(&left));
    report.iterations
}

#[test]
fn finer_tubes_take_no_more_iterations() {
    let found = [32, 64, 128].map(|columns| iterations(&Tube { columns, rows: 2 * columns }));
    // Found: 4, 4, 5.
    assert!(found.iter().all(|&found| found <= 6), "{found:?}");
}
