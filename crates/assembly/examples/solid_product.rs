//! Speed and memory of the internal force of a cube, term by term: bonds, what completes faces, families. One thread.
#![allow(clippy::print_stdout)]

use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::bond_plane::{Influence, VolumeFactor, Weights};
use peristat_assembly::model::bond_solid::{BondSolid, BondSolidParameters};
use peristat_assembly::model::plane::Solvable;
use peristat_assembly::model::plane::{Calibration, Mirrors};
use peristat_assembly::model::solid::SolidEdges;
use peristat_assembly::model::state_solid::{StateSolid, StateSolidParameters};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

fn report(name: &str, side: i32, make: &dyn Fn(Arc<SquareLattice>) -> Box<dyn Solvable<3>>) {
    let begin = Instant::now();
    let solid = make(Arc::new(SquareLattice::cuboid(1.0, [0.0; 3], [side; 3])));
    let built = begin.elapsed().as_secs_f64();
    let n = solid.points();
    let u: Vec<f64> = (0..3 * n).map(|i| ((i * 31 % 101) as f64) / 101.0).collect();
    let mut force = vec![0.0; u.len()];
    print!("{side}^3 {name:16} built {:6.0} ns per point;", built / n as f64 * 1e9);
    for term in solid.terms() {
        let time = || {
            let begin = Instant::now();
            term.add_force(black_box(&u), &mut force);
            begin.elapsed().as_secs_f64()
        };
        let best = std::iter::repeat_with(time).take(7).fold(f64::INFINITY, f64::min);
        let bytes = 8 * term.stored_factors() / n;
        print!(" {} elements {:.1} ns {bytes} B per point;", term.elements(), best / n as f64 * 1e9);
    }
    println!();
}

fn main() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread starts");
    pool.install(|| {
        for (side, horizon_ratio) in [(32, 2.0), (64, 2.0), (32, 3.0), (64, 3.0)] {
            for (name, edges) in [("overlay", SolidEdges::Overlay), ("border", SolidEdges::Border)] {
                let parameters = BondSolidParameters {
                    youngs_modulus: 1.0,
                    horizon_ratio,
                    influence: Influence::Constant,
                    calibration: Calibration::Matched,
                    weights: Weights::Nearest,
                    volume_factor: VolumeFactor::Ramp,
                    edges,
                };
                let make = |lattice: Arc<SquareLattice>| -> Box<dyn Solvable<3>> {
                    Box::new(BondSolid::on_lattice(lattice, Mirrors::NONE, parameters, &[]).expect("a solid"))
                };
                report(&format!("bonds {horizon_ratio} {name}"), side, &make);
            }
            for (name, edges) in [("overlay", SolidEdges::Overlay), ("border", SolidEdges::Border)] {
                let parameters = StateSolidParameters {
                    youngs_modulus: 1.0,
                    poisson_ratio: 0.3,
                    horizon_ratio,
                    influence: Influence::Inverse,
                    calibration: Calibration::Matched,
                    volume_factor: VolumeFactor::Ramp,
                    edges,
                };
                report(&format!("state {horizon_ratio} {name}"), side, &|lattice| {
                    Box::new(
                        StateSolid::on_lattice(lattice, Mirrors::NONE, parameters, &[]).expect("a solid"),
                    )
                });
            }
        }
    });
}
