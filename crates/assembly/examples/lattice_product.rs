//! Speed of the internal force of a plane lattice: millions of points per second, one thread and all.
#![allow(clippy::print_stdout)]

use peristat_assembly::body::SquareLattice;
use peristat_assembly::bonds::{BondGeometry, BondModel, Rows};
use peristat_assembly::stiffness::{GridBonds, Offset, Term};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

struct Central;

impl BondModel<2, 1> for Central {
    const DIFFERENCE: [[bool; 2]; 1] = [[true, true]];
    const MEAN: [[bool; 2]; 1] = [[false, false]];

    fn rows(&self, bond: &BondGeometry) -> Rows<2, 1> {
        let l = bond.length();
        Rows { difference: [[bond.xi[0] / l, bond.xi[1] / l]], mean: [[0.0; 2]] }
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 1] {
        [1.0 / bond.length()]
    }
}

fn main() {
    let side = 1000;
    let lattice = Arc::new(SquareLattice::rectangle(1.0, [0.0; 2], [side, side]));
    let half = |[a, b]: [i32; 2]| (b > 0 || a > 0) && a * a + b * b <= 9;
    let steps = (0..=3).flat_map(|b| (-3..=3).map(move |a| [a, b]));
    let offsets: Vec<Offset<1>> =
        steps.filter(|&step| half(step)).map(|[a, b]| Offset { step: [a, b, 0], weights: [1.0] }).collect();
    let grid = GridBonds::new(lattice.clone(), &Central, &offsets, &[]);
    let u: Vec<f64> = (0..2 * lattice.points()).map(|i| ((i * 31 % 101) as f64) / 101.0).collect();
    let mut force = vec![0.0; u.len()];
    for threads in [1, std::thread::available_parallelism().map_or(1, usize::from)] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads start");
        let mut times: Vec<f64> = (0..15)
            .map(|_| {
                let begin = Instant::now();
                pool.install(|| grid.add_force(black_box(&u), &mut force));
                begin.elapsed().as_secs_f64()
            })
            .collect();
        times.sort_by(f64::total_cmp);
        let speed = |t: f64| lattice.points() as f64 / t / 1e6;
        println!(
            "{} offsets, {} bonds, {threads} thread(s): median {:.1}, best {:.1} million points per second",
            offsets.len(),
            grid.elements(),
            speed(times[times.len() / 2]),
            speed(times[0])
        );
    }
}
