//! Counts iterations and products of multigrid cycles on plates.
#![allow(clippy::print_stdout)] // the purpose of the program

#[path = "../tests/lattice/mod.rs"]
mod lattice;

use lattice::{Finest, Flaw, Plate};
use peristat_solve::{Multigrid, MultigridOptions, Pcg, PcgOptions};
use std::time::Instant;

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let n: usize = args[1].parse().unwrap();
    let aspect: usize = args[2].parse().unwrap();
    let flaw = match args[3].as_str() { "hole" => Flaw::Hole(0.2), "cut" => Flaw::Cut(0.5), _ => Flaw::Nothing };
    let coarsest: usize = args[4].parse().unwrap();
    let opt = |k: usize, d: f64| args.get(k).map_or(d, |a| a.parse().unwrap());
    let options = MultigridOptions { degree: opt(5, 3.0) as usize, range: opt(6, 8.0), lanczos_steps: opt(7, 12.0) as usize, margin: opt(8, 1.03), measured_size: opt(9, 1e5) as usize };
    let t = Instant::now();
    let plate = Plate::new(n * aspect, n, flaw, coarsest);
    let built = t.elapsed();
    let mut m = Multigrid::new(&plate, plate.coarsest(), &options);
    let bounds: Vec<_> = m.bounds().map(|b| (b * 1e4).round() / 1e4).collect();
    plate.products(0);
    let mut r = plate.load();
    let mut x = vec![0.0; r.len()];
    let t = Instant::now();
    let report = Pcg::new(r.len()).solve(&Finest(&plate), &mut m, &mut r, &mut x, &PcgOptions { residual_drop: 1e-10, energy_drop: 0.0, ..PcgOptions::default() });
    println!("{n}x{aspect} {flaw:?} {options:?} {bounds:?}: {report:?} products {} in {:.2?} (built {built:.2?})", plate.products(0), t.elapsed());
}
