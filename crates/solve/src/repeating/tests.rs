use super::*;
use crate::band::tests::Noise;
use crate::{BandCholesky, BandMatrix, Preconditioner};

/// Diagonally dominant groups, hence positive definite.
fn random(half_bandwidth: usize, period: usize, runs: &[usize], seed: u64) -> RepeatingBand {
    let mut noise = Noise(seed);
    let width = half_bandwidth + 1;
    let mut values: Vec<f64> = (0..width * period * runs.len()).map(|_| noise.next()).collect();
    for diagonal in values.iter_mut().step_by(width) {
        *diagonal += 2.0 * half_bandwidth as f64 + 1.5;
    }
    RepeatingBand { half_bandwidth, period, runs: runs.to_vec(), values }
}

/// The same matrix with all its columns.
fn expanded(matrix: &RepeatingBand) -> BandMatrix {
    let RepeatingBand { half_bandwidth, period, ref runs, ref values } = *matrix;
    let width = half_bandwidth + 1;
    let groups = values.chunks_exact(period * width).zip(runs);
    let mut values: Vec<f64> = groups.flat_map(|(group, groups)| group.repeat(*groups)).collect();
    let order = values.len() / width;
    for (j, column) in values.chunks_exact_mut(width).enumerate() {
        column[width.min(order - j)..].fill(0.0);
    }
    BandMatrix { order, half_bandwidth, values }
}

/// Both sweeps in blocks whose numbers of groups repeat.
fn solve(factor: &RepeatingCholesky, load: &[f64], blocks: &[usize]) -> Vec<f64> {
    let mut x = load.to_vec();
    let sizes = || blocks.iter().cycle().map(|groups| groups * factor.period);
    let (mut forward, mut rest, mut size) = (factor.forward(), &mut x[..], sizes());
    while !rest.is_empty() {
        let (block, after) = rest.split_at_mut(size.next().unwrap().min(rest.len()));
        forward.sweep(block);
        rest = after;
    }
    let (mut backward, mut rest, mut size) = (factor.backward(), &mut x[..], sizes());
    while !rest.is_empty() {
        let (before, block) = rest.split_at_mut(rest.len().saturating_sub(size.next().unwrap()));
        backward.sweep(block);
        rest = before;
    }
    x
}

fn load(order: usize) -> Vec<f64> {
    let mut noise = Noise(7);
    (0..order).map(|_| noise.next()).collect()
}

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |m, v| if v.is_nan() { f64::NAN } else { m.max(v.abs()) })
}

/// Largest difference from the ordinary factor, relative to the largest unknown.
fn error(matrix: &RepeatingBand, blocks: &[usize]) -> f64 {
    let factor = RepeatingCholesky::factor(matrix).unwrap();
    let mut ordinary = BandCholesky::factor(expanded(matrix), 1).unwrap();
    let load = load(factor.order());
    let mut expected = vec![0.0; load.len()];
    ordinary.apply(&load, &mut expected);
    let found = solve(&factor, &load, blocks);
    let differences = found.iter().zip(&expected).map(|(x, y)| x - y);
    largest(differences) / largest(expected.iter().copied())
}

#[test]
fn every_width_period_and_run_agrees_with_the_ordinary_factor() {
    for half_bandwidth in (0..=25).chain([33]) {
        for period in [1, 2, 3, 4, 7, 12] {
            for runs in [&[1][..], &[2], &[600], &[1, 1, 1, 5], &[300, 1, 700, 2, 90], &[40, 3, 41, 41, 1]] {
                let seed = (61 * half_bandwidth + 7 * period + runs.len()) as u64;
                let matrix = random(half_bandwidth, period, runs, seed);
                for blocks in [&[10_000][..], &[1], &[512], &[3, 1, 200, 5, 77]] {
                    let error = error(&matrix, blocks);
                    assert!(error < 2.0e-15, "b {half_bandwidth} p {period} {runs:?} {blocks:?}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn a_long_run_keeps_a_few_columns() {
    let short = RepeatingCholesky::factor(&random(5, 2, &[1000, 1000], 1)).unwrap();
    let long = RepeatingCholesky::factor(&random(5, 2, &[1_000_000_000_000, 1000], 1)).unwrap();
    assert_eq!(long.order(), 2_000_000_002_000);
    assert_eq!(long.columns_kept(), short.columns_kept());
    assert!(long.columns_kept() < 200, "{} columns", long.columns_kept());
    // Columns and rows of 6 and 5 doubles, tables of 13 times 8 doubles for two
    // sweeps of two runs, and two runs of a few words each.
    let kept = long.columns_kept() * 11 * 8 + 4 * 13 * 64;
    assert!((kept..kept + 500).contains(&long.bytes()), "{} bytes", long.bytes());
}

#[test]
fn units_of_the_unknowns_do_not_matter() {
    // Powers of two change no digit.
    for other in [2.0_f64.powi(40), 2.0_f64.powi(-40)] {
        let matrix = nearly_singular(5, 2, 1.0e-2, 3);
        let mut scaled = matrix.clone();
        let unit = |k: usize| if k.is_multiple_of(2) { 1.0 } else { other };
        for (k, value) in scaled.values.iter_mut().enumerate() {
            *value *= unit(k / 6) * unit(k / 6 + k % 6);
        }
        let plain = RepeatingCholesky::factor(&matrix).unwrap();
        let factor = RepeatingCholesky::factor(&scaled).unwrap();
        assert_eq!(factor.columns_kept(), plain.columns_kept());
        let mut load = load(plain.order());
        let expected = solve(&plain, &load, &[500]);
        for (k, value) in load.iter_mut().enumerate() {
            *value *= unit(k);
        }
        for (k, value) in solve(&factor, &load, &[500]).iter().enumerate() {
            assert_eq!(value * unit(k), expected[k], "unknown {k}");
        }
    }
}

#[test]
fn a_run_that_does_not_converge_is_kept() {
    // The second difference: the pivots are 1 + 1/j, exactly solvable. Unit loads at
    // all 3000 unknowns give the parabola k (3001 - k) / 2.
    let matrix = RepeatingBand { half_bandwidth: 1, period: 1, runs: vec![3000], values: vec![2.0, -1.0] };
    let factor = RepeatingCholesky::factor(&matrix).unwrap();
    assert_eq!(factor.columns_kept(), 3000);
    for (k, x) in solve(&factor, &[1.0; 3000], &[7]).iter().enumerate() {
        let k = (k + 1) as f64;
        let expected = 0.5 * k * (3001.0 - k);
        assert!((x - expected).abs() < 1.0e-10 * expected, "{k}: {x} for {expected}");
    }
}

#[test]
fn a_sweep_can_be_continued_where_it_was_copied() {
    let factor = RepeatingCholesky::factor(&random(7, 2, &[300], 5)).unwrap();
    let mut first = load(600);
    let mut forward = factor.forward();
    forward.sweep(&mut first[..200]);
    let mut second = first[200..].to_vec();
    forward.clone().sweep(&mut second);
    forward.sweep(&mut first[200..]);
    assert_eq!(first[200..], second[..]);
}

#[test]
fn bad_pivots_are_counted_as_by_the_ordinary_factor() {
    for half_bandwidth in [0, 1, 2, 5, 9, 24] {
        for (bad, runs) in [(0, [90, 1, 50]), (1, [90, 1, 50]), (1, [70, 80, 1]), (2, [100, 4, 80])] {
            let mut matrix = random(half_bandwidth, 2, &runs, half_bandwidth as u64);
            // Definite but for one phase of one run, whose diagonal is very negative.
            let column = (2 * bad + 1) * (half_bandwidth + 1);
            matrix.values[column] *= -5.0;
            let found = RepeatingCholesky::factor(&matrix).unwrap_err();
            assert_eq!(found, BandCholesky::factor(expanded(&matrix), 1).unwrap_err());
            let index = 2 * runs[..bad].iter().sum::<usize>() + 1;
            assert_eq!(found, FactorError::NonPositivePivot { index, count: runs[bad] });
        }
    }
}

#[test]
fn entries_that_are_not_finite_are_reported_by_row() {
    for half_bandwidth in [2, 7, 16] {
        for bad in [f64::NAN, f64::INFINITY] {
            let mut matrix = random(half_bandwidth, 2, &[20, 30, 40], 3);
            // Two rows below the first column of the second run, unknown 40.
            matrix.values[2 * (half_bandwidth + 1) + 2] = bad;
            let found = RepeatingCholesky::factor(&matrix).unwrap_err();
            assert_eq!(found, FactorError::NotFinite { index: 42 });
        }
    }
}

#[test]
fn entries_past_the_end_are_ignored() {
    for bad in [f64::NAN, f64::INFINITY, 1.0e300] {
        let mut matrix = random(5, 2, &[40, 1], 3);
        for past in [14, 17, 19, 23] {
            matrix.values[past] = bad; // the last two columns hold two entries and one
        }
        assert!(error(&matrix, &[7]) < 1.0e-15);
    }
}

#[test]
fn shapes_that_do_not_fit_are_errors() {
    let good = random(3, 2, &[4, 5], 1);
    let short = RepeatingBand { values: good.values[1..].to_vec(), ..good.clone() };
    let no_groups = RepeatingBand { runs: vec![4, 0], ..good.clone() };
    let no_period = RepeatingBand { period: 0, values: Vec::new(), ..good.clone() };
    let endless = RepeatingBand { runs: vec![usize::MAX, 1], ..good.clone() };
    let wide = RepeatingBand { half_bandwidth: usize::MAX, ..good };
    for matrix in [short, no_groups, no_period, endless, wide] {
        assert!(matches!(RepeatingCholesky::factor(&matrix), Err(FactorError::Shape { .. })), "{matrix:?}");
    }
}

#[test]
fn an_empty_matrix_has_an_empty_solution() {
    let factor = RepeatingCholesky::factor(&random(3, 2, &[], 1)).unwrap();
    factor.forward().sweep(&mut []);
    factor.backward().sweep(&mut []);
    assert_eq!((factor.order(), factor.columns_kept()), (0, 0));
}

#[test]
#[should_panic(expected = "no more unknowns than there are")]
fn a_sweep_ends_with_the_matrix() {
    let factor = RepeatingCholesky::factor(&random(3, 2, &[100], 1)).unwrap();
    let mut backward = factor.backward();
    backward.sweep(&mut [0.0; 198]);
    backward.sweep(&mut [0.0; 4]);
}

/// `G^T G + lift` for an upper triangular band `G` with random groups of rows.
fn nearly_singular(half_bandwidth: usize, period: usize, lift: f64, seed: u64) -> RepeatingBand {
    let mut noise = Noise(seed);
    let width = half_bandwidth + 1;
    let g: Vec<f64> = (0..period * width).map(|_| noise.next()).collect();
    let entry = |phase: usize, k: usize| {
        // Rows of G from that of the column upwards; the phases repeat.
        let row = |up: usize| &g[(phase + width * period - up) % period * width..][..width];
        let sum: f64 = (0..width - k).map(|up| row(up)[up] * row(up)[up + k]).sum();
        if k == 0 { sum + lift } else { sum }
    };
    let values = (0..period).flat_map(|phase| (0..width).map(move |k| (phase, k)));
    let values = values.map(|(phase, k)| entry(phase, k)).collect();
    RepeatingBand { half_bandwidth, period, runs: vec![5000], values }
}

#[test]
fn rounding_does_not_keep_a_run_from_converging() {
    for (half_bandwidth, period) in [(1, 1), (5, 1), (5, 2), (9, 2), (15, 3)] {
        for seed in 0..20 {
            let matrix = nearly_singular(half_bandwidth, period, 1.0e-2, seed);
            let factor = RepeatingCholesky::factor(&matrix).unwrap();
            assert!(factor.columns_kept() < 2000 * period, "b {half_bandwidth}, seed {seed}");
            // The condition is below 1e4, the rounding of the matrix 2e-16.
            let error = error(&matrix, &[512]);
            assert!(error < 1.0e-12, "b {half_bandwidth}, seed {seed}: {error:e}");
        }
    }
}
