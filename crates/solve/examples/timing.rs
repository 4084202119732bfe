//! Times the band factor and its sweeps on a million points of two unknowns.
//!
//! Run with `cargo run --release -p peristat-solve --example timing [points]`.
//! One line per horizon: nanoseconds per point, median of several runs.
#![allow(clippy::print_stdout)] // the purpose of the program

use peristat_solve::{BandCholesky, BandMatrix, Preconditioner};
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
