//! Counts iterations and products of multigrid cycles on a plate of square cells.
//!
//! Run with `cargo run --release -p peristat-solve --example multigrid [rows] [columns]`.
//! One line per cycle and flaw: iterations to a residual of 1e-10, products with the finest level, seconds.
#![allow(clippy::print_stdout)] // the purpose of the program

#[path = "../tests/lattice/mod.rs"]
mod lattice;

use lattice::{Finest, Flaw, Plate};
use peristat_solve::{Multigrid, MultigridOptions, Pcg, PcgOptions};
use std::time::Instant;

fn main() {
    let mut numbers = std::env::args().skip(1).filter_map(|a| a.parse().ok());
    let rows = numbers.next().unwrap_or(256);
    let columns = numbers.next().unwrap_or(rows);
    for flaw in [Flaw::Nothing, Flaw::Hole(0.2), Flaw::Cut(0.5)] {
        let plate = Plate::new(columns, rows, flaw, 16);
        for (degree, range) in [(1, 2.5), (2, 4.0), (3, 6.0)] {
            for single_visits in [usize::MAX, 1, 0] {
                let options = MultigridOptions { degree, range, single_visits, ..MultigridOptions::STANDARD };
                line(&plate, flaw, &options);
            }
        }
    }
}

fn line(plate: &Plate, flaw: Flaw, options: &MultigridOptions) {
    let mut multigrid = Multigrid::new(plate, plate.coarsest(), options);
    plate.products(0);
    let mut residual = plate.load();
    let mut x = vec![0.0; residual.len()];
    let stop = PcgOptions { residual_drop: 1.0e-10, energy_drop: 0.0, ..PcgOptions::STANDARD };
    let start = Instant::now();
    let report = Pcg::new(x.len()).solve(&Finest(plate), &mut multigrid, &mut residual, &mut x, &stop);
    println!(
        "{flaw:?}, degree {}, {}: {:?} after {} iterations, {} products, {:.3} s",
        options.degree,
        ["twice", "twice but on the second level", "once"][options.single_visits.min(2)],
        report.status,
        report.iterations,
        plate.products(0),
        start.elapsed().as_secs_f64()
    );
}
