//! Times what follows a change of the matrix: another factor, or a few terms more.

use crate::COMPONENTS;
use crate::lattice::Plate;
use peristat_solve::{
    FactorError, LowRank, Ordering, PointGraph, Preconditioner, SparseCholesky, SparseIndefinite,
    nested_dissection,
};
use std::time::Instant;

/// Bonds that soften.
const RANK: usize = 16;

/// Prints the medians of several rounds, in seconds.
pub(crate) fn time(plate: &Plate, rounds: usize) -> Result<(), FactorError> {
    let matrix = &plate.matrix;
    let dissection = nested_dissection(&plate.positions, &PointGraph::from_matrix(matrix, COMPONENTS));
    let ordering = Ordering::Points { order: dissection.order(), components: COMPONENTS };
    let mut cholesky = SparseCholesky::analyse(matrix, ordering)?;
    let mut indefinite = SparseIndefinite::of(&cholesky, matrix)?;
    let shifted = shifted(plate, 0.05);
    let b: Vec<f64> = (0..matrix.rows()).map(|i| f64::from(!plate.clamped(i))).collect();
    let bonds: Vec<[(usize, f64); 2]> = (0..RANK).map(|k| bond(plate, k)).collect();
    let mut x = vec![0.0; b.len()];
    let mut times: [Vec<f64>; 6] = Default::default();
    for _ in 0..rounds {
        times[0].push(seconds(|| cholesky.refactor(matrix))?);
        times[1].push(seconds(|| {
            cholesky.apply(&b, &mut x);
            Ok(())
        })?);
        let mut low_rank = LowRank::new(b.len());
        times[2].push(seconds(|| {
            for bond in &bonds {
                low_rank.push(&mut cholesky, bond);
            }
            Ok(())
        })?);
        (0..RANK).for_each(|index| low_rank.set(index, -0.3));
        times[3].push(seconds(|| low_rank.apply(&mut cholesky, &b, &mut x))?);
        times[4].push(seconds(|| indefinite.refactor(&shifted.matrix))?);
        times[5].push(seconds(|| {
            indefinite.apply(&b, &mut x);
            Ok(())
        })?);
    }
    let [cholesky, solve, columns, changed, lblt, solve_lblt] = times.map(median);
    println!(
        "{{\"unknowns\": {}, \"cholesky\": {cholesky:.5}, \"solve\": {solve:.5}, \"columns\": {columns:.5}, \
         \"solve_low_rank\": {changed:.5}, \"indefinite\": {lblt:.5}, \"solve_indefinite\": {solve_lblt:.5}, \
         \"negative_pivots\": {}, \"residual_indefinite\": {:.2e}}}",
        b.len(),
        indefinite.negative_pivots(),
        shifted.residual(&x, &b)
    );
    Ok(())
}

/// The plate with less on the diagonal where it is not clamped.
fn shifted(plate: &Plate, shift: f64) -> Plate {
    let mut matrix = plate.matrix.clone();
    for i in (0..matrix.rows()).filter(|i| !plate.clamped(*i)) {
        if let Some(diagonal) = matrix.get_mut(i, i) {
            *diagonal -= shift;
        }
    }
    Plate { positions: plate.positions.clone(), matrix }
}

/// One of the bonds along the rows, spread over the plate: entries of its elongation.
fn bond(plate: &Plate, k: usize) -> [(usize, f64); 2] {
    let points = plate.positions.len();
    let p = (k + 1) * points / (RANK + 2);
    let y = plate.positions[p][1];
    let q = if plate.positions.get(p + 1).is_some_and(|x| x[1] == y) { p + 1 } else { p - 1 };
    [(p, 1.0), (q, -1.0)]
}

fn seconds(run: impl FnOnce() -> Result<(), FactorError>) -> Result<f64, FactorError> {
    let begin = Instant::now();
    run()?;
    Ok(begin.elapsed().as_secs_f64())
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
