//! Times the band factor and its sweeps on a million points of two unknowns; for the
//! same columns repeated, the sweeps in blocks that stay in the cache.
//!
//! Run with `cargo run --release -p peristat-solve --example timing [points]`.
//! One line per horizon: nanoseconds per point, median of several runs.
#![allow(clippy::print_stdout)] // the purpose of the program

use peristat_solve::{BandCholesky, BandMatrix, Preconditioner, RepeatingBand, RepeatingCholesky};
use std::time::Instant;

fn main() {
    let points = std::env::args().nth(1).and_then(|a| a.parse().ok()).unwrap_or(1_000_000);
    for half_bandwidth in [1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21] {
        let matrix = diagonally_dominant(2 * points, half_bandwidth);
        let mut spare = matrix.values.clone();
        let (mut factoring, mut solving) = (Vec::new(), Vec::new());
        for _ in 0..7 {
            spare.copy_from_slice(&matrix.values);
            let band = BandMatrix { values: spare, ..matrix };
            let start = Instant::now();
            let Ok(mut factor) = BandCholesky::factor(band, 2) else {
                println!("half bandwidth {half_bandwidth}: no factor");
                return;
            };
            factoring.push(start.elapsed().as_secs_f64());
            let r = vec![1.0; 2 * points];
            let mut z = vec![0.0; 2 * points];
            let start = Instant::now();
            factor.apply(&r, &mut z);
            solving.push(start.elapsed().as_secs_f64());
            spare = factor.into_values();
        }
        let scale = 1.0e9 / points as f64;
        println!(
            "half bandwidth {half_bandwidth:2}: factor {:6.1} ns/point, solve {:6.1} ns/point",
            median(factoring) * scale,
            median(solving) * scale
        );
    }
    for half_bandwidth in [1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21] {
        repeating(points, half_bandwidth);
    }
}

/// The two streaming sweeps over one block again and again: arithmetic only.
fn repeating(points: usize, half_bandwidth: usize) {
    let values = diagonally_dominant(2 * half_bandwidth + 2, half_bandwidth).values;
    let values = values[..2 * (half_bandwidth + 1)].to_vec();
    let matrix = RepeatingBand { half_bandwidth, period: 2, runs: vec![points], values };
    let start = Instant::now();
    let Ok(factor) = RepeatingCholesky::factor(&matrix) else {
        println!("repeating {half_bandwidth}: no factor");
        return;
    };
    let factoring = start.elapsed().as_secs_f64();
    let (mut ahead, mut back) = (Vec::new(), Vec::new());
    for _ in 0..7 {
        let mut block = vec![0.0; 1024];
        let start = Instant::now();
        let mut forward = factor.forward();
        for _ in 0..points / 512 {
            block.fill(1.0); // results of results would over- or underflow
            forward.sweep(&mut block);
        }
        ahead.push(start.elapsed().as_secs_f64());
        let start = Instant::now();
        let mut backward = factor.backward();
        for _ in 0..points / 512 {
            block.fill(1.0);
            backward.sweep(&mut block);
        }
        back.push(start.elapsed().as_secs_f64());
    }
    let scale = 1.0e9 / points as f64;
    println!(
        "repeating {half_bandwidth:2}: forward {:4.2} ns, backward {:4.2} ns per group, {} columns in {:.0} us",
        median(ahead) * scale,
        median(back) * scale,
        factor.columns_kept(),
        factoring * 1.0e6
    );
}

fn diagonally_dominant(order: usize, half_bandwidth: usize) -> BandMatrix {
    let width = half_bandwidth + 1;
    let mut values = vec![0.0; order * width];
    for (j, column) in values.chunks_exact_mut(width).enumerate() {
        for (k, value) in column.iter_mut().enumerate().take(order - j) {
            *value = -1.0 + 0.01 * ((j + k) % 7) as f64;
        }
        column[0] = 2.0 * width as f64;
    }
    BandMatrix { order, half_bandwidth, values }
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
